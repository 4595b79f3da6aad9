#include "composite.h"
#include "fx_wide.h"
#include "image.h"
#include "overlap.h"
#include "pixels.h"
#include "splat.h"
#include "sum.h"

static size_t width_of(const qv_sums *sums)
{
    return (size_t)(sums->rect.right - sums->rect.left);
}

static size_t height_of(const qv_sums *sums)
{
    return (size_t)(sums->rect.bottom - sums->rect.top);
}

/* Sums of a rectangle that was checked: at most 4 * 2^32. */
static size_t count_of(const qv_sums *sums)
{
    return QV_SUM_CHANNELS * width_of(sums) * height_of(sums);
}

/* Rows of sums are rows of pixels of 16 bytes, as long as size_t can tell. */
qv_status qv_sums_check(const qv_sums *sums)
{
    const unsigned pixel_bytes = QV_SUM_CHANNELS * sizeof(uint32_t);
    if (!sums)
        return QV_ERROR_NULL;
    ptrdiff_t stride = 0;
    if (sums->rect.left < sums->rect.right) /* else the rectangle is refused */
        stride = (ptrdiff_t)(pixel_bytes * width_of(sums));
    size_t bytes =
        sums->count < (size_t)-1 / sizeof(uint32_t) ? sums->count * sizeof(uint32_t) : (size_t)-1;
    return qv_plane_check(sums->sums, bytes, stride, 8u * pixel_bytes, &sums->rect);
}

/* The background under equation 9: associated, levels with 16 fraction bits. */
static void background_of(uint32_t level[4], const uint8_t background[4])
{
    for (unsigned c = 0; c < 3; c++) /* 65536 c a / 255, where a / 255 = 257 a / 65535 */
        level[c] = fx_high_product((uint32_t)background[c] << 16, 0x01010101u * background[3]);
    level[3] = (uint32_t)background[3] << 16;
}

qv_status qv_sums_clear(const qv_sums *sums, const qv_splats *splats)
{
    uint32_t level[4] = {0, 0, 0, 0};
    qv_status status = splats ? qv_sums_check(sums) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    if (!QV_FIELD(splats->scene.splatting, attenuated))
        background_of(level, splats->scene.background);
    size_t count = count_of(sums);
    for (size_t i = 0; i < count; i++)
        sums->sums[i] = level[i % QV_SUM_CHANNELS];
    return QV_OK;
}

qv_status qv_sums_add(const qv_sums *to, const qv_sums *from)
{
    qv_status status = qv_sums_check(to);
    if (status == QV_OK)
        status = qv_sums_check(from);
    if (status != QV_OK)
        return status;
    if (to->rect.left != from->rect.left || to->rect.top != from->rect.top ||
        to->rect.right != from->rect.right || to->rect.bottom != from->rect.bottom)
        return QV_ERROR_RECT;
    size_t count = count_of(to);
    uintptr_t a = (uintptr_t)to->sums, b = (uintptr_t)from->sums;
    if ((a < b ? b - a : a - b) < count * sizeof(uint32_t))
        return QV_ERROR_OVERLAP;
    for (size_t i = 0; i < count; i++)
        to->sums[i] = qv_sum_of(to->sums[i], from->sums[i]);
    return QV_OK;
}

static int is_full(const qv_sums *sums)
{
    size_t count = count_of(sums);
    for (size_t i = 0; i < count; i++)
        if (sums->sums[i] == QV_SUM_FULL)
            return 1;
    return 0;
}

/* Whether pixels would be written over sums: an image's rows lie between its lowest byte and its
   highest. */
static int is_over(const qv_image *image, const qv_sums *sums)
{
    uint32_t rows = (uint32_t)(height_of(sums) - 1u) >> QV_FIELD(image->format, line_shift);
    uint64_t way = (uint64_t)rows *
                   (image->stride < 0 ? 0u - (uint64_t)image->stride : (uint64_t)image->stride);
    uintptr_t first = (uintptr_t)image->pixels - (image->stride < 0 ? (uintptr_t)way : 0u);
    uint64_t bytes = way + qv_row_bytes(image->format, (uint16_t)width_of(sums));
    return qv_regions_meet((uintptr_t)sums->sums - first, bytes,
                           (uint64_t)count_of(sums) * sizeof(uint32_t));
}

/* Puts the background behind a pixel's sums; of equation 9, it is there already. */
static void finish(qv_pixel *pixel, const uint32_t *sum, const uint32_t behind[4])
{
    uint32_t covered = sum[3] < QV_LEVEL_ONE ? sum[3] : QV_LEVEL_ONE;
    uint32_t clear = qv_part_of_level(QV_LEVEL_ONE - covered);
    uint32_t opacity = covered + fx_high_product(clear, behind[3]);
    for (unsigned c = 0; c < 3; c++) {
        uint32_t light = sum[c] < QV_LEVEL_ONE ? sum[c] : QV_LEVEL_ONE;
        uint32_t level = light + fx_high_product(clear, behind[c]);
        pixel->channel[c] = level < opacity ? level : opacity;
    }
    pixel->channel[3] = opacity;
}

qv_status qv_sums_read_out(const qv_image *image, const qv_sums *sums, const qv_splats *splats)
{
    uint32_t behind[4] = {0, 0, 0, 0};
    qv_status status = splats ? qv_sums_check(sums) : QV_ERROR_NULL;
    if (status == QV_OK)
        status = qv_image_check(image, &sums->rect);
    if (status == QV_OK && is_over(image, sums))
        status = QV_ERROR_OVERLAP;
    if (status == QV_OK && is_full(sums))
        status = QV_ERROR_SUMS;
    if (status != QV_OK)
        return status;
    if (QV_FIELD(splats->scene.splatting, attenuated))
        background_of(behind, splats->scene.background);
    size_t width = width_of(sums), height = height_of(sums);
    const uint32_t *sum = sums->sums;
    for (unsigned line = 0; line < height; line++) {
        ptrdiff_t offset = (ptrdiff_t)(line >> QV_FIELD(image->format, line_shift)) * image->stride;
        for (unsigned column = 0; column < width; column++, sum += QV_SUM_CHANNELS) {
            qv_pixel pixel;
            finish(&pixel, sum, behind);
            pixel.x = (uint32_t)sums->rect.left + column;
            pixel.y = (uint32_t)sums->rect.top + line;
            QV_FIELD(image->format, store)((uint8_t *)image->pixels + offset, column, line, &pixel);
        }
    }
    return QV_OK;
}
