/*
 * Source: Williams et al., alpha dithering for 8-bit compositing: section 6.
 */
#include "buffer.h"
#include "cell.h"

/* A slice of a table. */
typedef struct slice {
    const qv_dither_table *table;
    fx_period period;
    uint32_t phase; /* of pixels that are not shifted */
    int32_t number;
} slice;

/* The entry R, G, B, A that a pixel reads, for dither values shifted by so much; returns 0 where
   it has no voxel. */
static int look_up(uint8_t entry[4], const slice *of, const qv_context *context, int32_t x,
                   int32_t y, uint32_t shift)
{
    qv_ray ray;
    if (!QV_FIELD(context->scene.camera.projection, ray)(&ray, context, x, y))
        return 0;
    qv_ray_count_from(&ray, of->number);
    if (!qv_ray_hold(&ray, context))
        return 0;
    for (unsigned axis = 0; axis < 3; axis++)
        ray.place[axis] += QV_CENTRED;
    qv_cell cell;
    qv_cell_locate(&cell, &context->scene.volume, &ray);
    uint32_t value = qv_read8(qv_cell_nearest_voxel(&cell));
    uint32_t place = qv_phase_shifted(&of->period, of->phase, shift);
    qv_address from =
        qv_at(of->table->entries, (qv_offset)(4u * (QV_PALETTE_ENTRIES * place + value)));
    for (unsigned c = 0; c < 4; c++)
        entry[c] = qv_read8(qv_at(from, (qv_offset)c));
    return 1;
}

/* Equations 6 and 7. */
static void blend_entry(uint8_t *pixel, const uint8_t entry[4], unsigned channels)
{
    for (unsigned c = 0; c < channels; c++)
        pixel[c] = (uint8_t)fx_blend_associated(pixel[c], entry[c], entry[3], 8);
}

static qv_status check_buffer(const qv_buffer *buffer, const qv_rect *rect)
{
    qv_status status = qv_buffer_check(buffer, rect);
    if (status != QV_OK)
        return status;
    const qv_blend *blend = buffer->blend;
    int of_8_bits = QV_FIELD(blend, bytes) == 3 || QV_FIELD(blend, bytes) == 4;
    return QV_FIELD(blend, kind) == QV_HAND_OUT ||
                   (QV_FIELD(blend, kind) == QV_HARDWARE && of_8_bits)
               ? QV_OK
               : QV_ERROR_BUFFER;
}

static qv_status check_table(const qv_dither_table *table)
{
    if (!table || !table->entries)
        return QV_ERROR_NULL;
    uint32_t bytes = qv_dither_table_bytes(table->period, table->entry_bytes);
    return table->entry_bytes != 4 || bytes == 0 || table->bytes < bytes ? QV_ERROR_SIZE : QV_OK;
}

/* All but the buffer. */
static qv_status check(const qv_dither_table *table, const qv_dither *dither,
                       const qv_context *context, int32_t number)
{
    if (!dither || !context)
        return QV_ERROR_NULL;
    qv_status status = check_table(table);
    if (status != QV_OK)
        return status;
    if (!qv_storage_indexed(context->scene.volume.storage) || !context->scene.volume.voxels)
        return QV_ERROR_STORAGE;
    return number < -QV_GRID_LIMIT || number >= QV_GRID_LIMIT ? QV_ERROR_SLICE : QV_OK;
}

qv_status qv_slice_table(const qv_buffer *buffer, const qv_dither_table *table,
                         const qv_dither *dither, const qv_context *context, const qv_rect *rect,
                         int32_t number)
{
    qv_status status = check_buffer(buffer, rect);
    if (status == QV_OK)
        status = check(table, dither, context, number);
    if (status != QV_OK)
        return status;
    slice of = {table, fx_period_of(table->period), 0, number};
    of.phase = fx_phase(&of.period, qv_slice_number(number, 0) + dither->frame);
    int hands_out = QV_FIELD(buffer->blend, kind) == QV_HAND_OUT;
    for (int32_t y = rect->top; y < rect->bottom; y++)
        for (int32_t x = rect->left; x < rect->right; x++) {
            uint8_t *pixel =
                qv_buffer_pixel(buffer, (unsigned)(x - rect->left), (unsigned)(y - rect->top));
            uint8_t entry[4] = {0, 0, 0, 0};
            int seen = look_up(entry, &of, context, x, y, qv_dither_shift(!dither->still, x, y));
            if (hands_out)
                memcpy(pixel, entry, sizeof entry);
            else if (seen)
                blend_entry(pixel, entry, QV_FIELD(buffer->blend, bytes));
        }
    return QV_OK;
}
