#include "qvol.h"

#include "fx_unorm.h"

static int points_rise(const qv_control_point *points, uint16_t count)
{
    for (uint16_t i = 1; i < count; i++)
        if (points[i].index <= points[i - 1].index)
            return 0;
    return 1;
}

/* (from * (n - t) + to * t) / n to nearest, ties upwards; 0 <= t < n <= 255. */
static uint16_t between(uint16_t from, uint16_t to, uint32_t t, uint32_t n)
{
    uint32_t sum = from * (n - t) + to * t; /* <= 65535 * 255 < 2^24 */
    return (uint16_t)((2u * sum + n) / (2u * n));
}

/* Entries from one point up to the next, without it. */
static void fill_between(qv_transfer *table, const qv_control_point *from,
                         const qv_control_point *to)
{
    uint32_t n = (uint32_t)to->index - from->index; /* 1 .. 255 */
    for (uint32_t t = 0; t < n; t++)
        for (unsigned channel = 0; channel < 4; channel++)
            table->rgba[from->index + t][channel] =
                between(from->rgba[channel], to->rgba[channel], t, n);
}

/* Entries first <= i < end, all the colour of one point. */
static void fill_constant(qv_transfer *table, const qv_control_point *point, unsigned first,
                          unsigned end)
{
    for (unsigned i = first; i < end; i++)
        for (unsigned channel = 0; channel < 4; channel++)
            table->rgba[i][channel] = point->rgba[channel];
}

qv_status qv_transfer_build(qv_transfer *table, const qv_control_point *points, uint16_t count)
{
    if (!table || !points)
        return QV_ERROR_NULL;
    if (count == 0 || count > QV_PALETTE_ENTRIES || !points_rise(points, count))
        return QV_ERROR_TRANSFER;

    const qv_control_point *last = &points[count - 1];
    fill_constant(table, &points[0], 0, points[0].index);
    for (const qv_control_point *point = points; point < last; point++)
        fill_between(table, point, point + 1);
    fill_constant(table, last, last->index, QV_PALETTE_ENTRIES);
    return QV_OK;
}

void qv_transfer_to_palette8(uint8_t palette[QV_PALETTE_ENTRIES][4], const qv_transfer *table)
{
    for (unsigned i = 0; i < QV_PALETTE_ENTRIES; i++)
        for (unsigned channel = 0; channel < 4; channel++)
            palette[i][channel] = fx_unorm16_to_unorm8(table->rgba[i][channel]);
}
