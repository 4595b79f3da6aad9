#include "buffer.h"

/* A pixel R, G, B, A; or a slice as hardware is given it: colours weighted by the opacity. */
typedef struct levels {
    uint8_t at[4];
} levels;

static levels levels_read(const uint8_t *pixel)
{
    const levels of = {{pixel[0], pixel[1], pixel[2], pixel[3]}};
    return of;
}

static void levels_write(uint8_t *pixel, const levels *of)
{
    for (unsigned c = 0; c < 4; c++)
        pixel[c] = of->at[c];
}

static int levels_equal(const levels *a, const levels *b)
{
    int equal = 1;
    for (unsigned c = 0; c < 4; c++)
        equal &= a->at[c] == b->at[c];
    return equal;
}

static levels slice_of(const uint8_t rgba[4])
{
    levels slice = levels_read(rgba);
    for (unsigned c = 0; c < 3; c++)
        slice.at[c] = (uint8_t)fx_divide_by_ones((uint32_t)rgba[c] * rgba[3], 8);
    return slice;
}

/* Equations 6 and 7; no colour may pass the opacity. */
static levels blended(const levels *state, const levels *front)
{
    levels result;
    for (unsigned c = 0; c < 4; c++) {
        uint8_t colour = front->at[c] < front->at[3] ? front->at[c] : front->at[3];
        result.at[c] = (uint8_t)fx_blend_associated(state->at[c], colour, front->at[3], 8);
    }
    return result;
}

/*
 * What the slices that made `front` out of nothing make of `behind`. Each raises a channel of what
 * is reached, or none does any more: then the front comes of no number of them.
 */
static levels replayed(const levels *behind, const levels *front, const levels *slice)
{
    levels result = *behind, reached = {{0, 0, 0, 0}};
    while (!levels_equal(&reached, front)) {
        levels next = blended(&reached, slice);
        if (levels_equal(&next, &reached))
            return blended(behind, front);
        reached = next;
        result = blended(&result, slice);
    }
    return result;
}

static qv_status check(const qv_buffer *buffer, const qv_rect *rect)
{
    qv_status status = qv_buffer_check(buffer, rect);
    if (status == QV_OK &&
        (QV_FIELD(buffer->blend, kind) != QV_HARDWARE || QV_FIELD(buffer->blend, bytes) != 4))
        status = QV_ERROR_BUFFER;
    return status;
}

qv_status qv_replay(const qv_buffer *behind, const qv_buffer *front, const uint8_t rgba[4],
                    const qv_rect *rect)
{
    qv_status status = rgba ? check(behind, rect) : QV_ERROR_NULL;
    if (status == QV_OK)
        status = check(front, rect);
    if (status != QV_OK)
        return status;
    const levels slice = slice_of(rgba);
    unsigned width = (unsigned)(rect->right - rect->left);
    unsigned height = (unsigned)(rect->bottom - rect->top);
    for (unsigned line = 0; line < height; line++)
        for (unsigned column = 0; column < width; column++) {
            uint8_t *pixel = qv_buffer_pixel(behind, column, line);
            const levels far = levels_read(pixel);
            const levels near = levels_read(qv_buffer_pixel(front, column, line));
            const levels result = replayed(&far, &near, &slice);
            levels_write(pixel, &result);
        }
    return QV_OK;
}
