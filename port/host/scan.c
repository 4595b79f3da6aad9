/*
 * scan.c - volumes as files give them.
 */
#include "scan.h"
#include "error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const choice element_names[] = {
    {"u8", ELEMENT_U8},
    {"s8", ELEMENT_S8},
    {"u16", ELEMENT_U16},
    {"s16", ELEMENT_S16},
    {"u32", ELEMENT_U32},
    {"s32", ELEMENT_S32},
    {"f32", ELEMENT_F32},
    {"f64", ELEMENT_F64},
    {"rgba8", ELEMENT_RGBA8},
    {"rgba16", ELEMENT_RGBA16},
    {"rgbt8", ELEMENT_RGBT8},
    {"rgbt16", ELEMENT_RGBT16},
    {"associated8", ELEMENT_ASSOCIATED8},
    {"indexed8", ELEMENT_INDEXED8},
    {NULL, 0},
};

/* RGBA16 and RGBT16 are four words of two bytes. */
unsigned element_word_bytes(element type)
{
    switch (type) {
    case ELEMENT_U16:
    case ELEMENT_S16:
    case ELEMENT_RGBA16:
    case ELEMENT_RGBT16:
        return 2;
    case ELEMENT_U32:
    case ELEMENT_S32:
    case ELEMENT_F32:
        return 4;
    case ELEMENT_F64:
        return 8;
    default:
        return 1;
    }
}

unsigned element_bytes(element type)
{
    bool colour = type >= ELEMENT_RGBA8 && type <= ELEMENT_ASSOCIATED8;
    return element_word_bytes(type) * (colour ? 4 : 1);
}

bool element_is_classified(element type)
{
    return type >= ELEMENT_RGBA8;
}

void scan_free(struct scan *scan)
{
    free(scan->values);
    free(scan->levels);
}

void scan_clear(struct scan *scan, const char *file, const char *format)
{
    memset(scan, 0, sizeof *scan);
    scan->file = file;
    scan->format = format;
    scan->slope = 1;
    for (unsigned a = 0; a < 3; a++) {
        scan->spacing[a] = 1;
        scan->turn.axis[a] = (uint8_t)a;
    }
}

uint64_t scan_data_bytes(const struct scan *scan)
{
    uint64_t voxels = 1;
    for (unsigned a = 0; a < 3; a++) {
        if (scan->size[a] < 1 || scan->size[a] > QV_AXIS_MAX) {
            data_error(scan->file, "size", "%u voxels on axis %u, the limits are 1 and %u",
                       scan->size[a], a + 1, QV_AXIS_MAX);
        }
        if (!isfinite(scan->spacing[a]) || scan->spacing[a] <= 0) {
            data_error(scan->file, "spacing", "%g on axis %u is not a length", scan->spacing[a],
                       a + 1);
        }
        voxels *= scan->size[a];
    }
    return voxels * element_bytes(scan->type);
}

void scan_allocate(struct scan *scan, uint64_t available)
{
    scan->bytes = scan_data_bytes(scan);
    if (scan->bytes > available) {
        data_error(scan->file, "data", "%llu bytes at most, the header implies %llu",
                   (unsigned long long)available, (unsigned long long)scan->bytes);
    }
    scan->values = allocate(scan->bytes, scan->file, "data");
}

uint8_t scan_levels(const struct scan *scan, qv_storage storage)
{
    const uint16_t size[3] = {(uint16_t)scan->size[0], (uint16_t)scan->size[1],
                              (uint16_t)scan->size[2]};
    uint8_t levels = qv_pyramid_levels(size);
    while (levels > 0 && qv_pyramid_bytes(size, (uint8_t)storage, levels) != scan->level_bytes) {
        levels--;
    }
    return levels;
}

void swap_words(void *values, uint64_t bytes, unsigned word_bytes)
{
    unsigned char *word = values;
    unsigned char *end = word + bytes;
    for (; word != end; word += word_bytes) {
        for (unsigned low = 0, high = word_bytes - 1; low < high; low++, high--) {
            unsigned char byte = word[low];
            word[low] = word[high];
            word[high] = byte;
        }
    }
}

/* A double holds each of these types exactly. */
double scan_value(const struct scan *scan, uint64_t place)
{
    double stored = 0;
    switch (scan->type) {
    case ELEMENT_S8:
        stored = ((const int8_t *)scan->values)[place];
        break;
    case ELEMENT_U16:
        stored = ((const uint16_t *)scan->values)[place];
        break;
    case ELEMENT_S16:
        stored = ((const int16_t *)scan->values)[place];
        break;
    case ELEMENT_U32:
        stored = ((const uint32_t *)scan->values)[place];
        break;
    case ELEMENT_S32:
        stored = ((const int32_t *)scan->values)[place];
        break;
    case ELEMENT_F32:
        stored = (double)((const float *)scan->values)[place];
        break;
    case ELEMENT_F64:
        stored = ((const double *)scan->values)[place];
        break;
    default:
        stored = ((const uint8_t *)scan->values)[place];
        break;
    }
    return scan->slope * stored + scan->offset;
}

bool scan_range(const struct scan *scan, double *low, double *high)
{
    uint64_t count = scan->bytes / element_bytes(scan->type);
    bool found = false;
    for (uint64_t place = 0; place < count; place++) {
        double value = scan_value(scan, place);
        if (!isfinite(value)) {
            continue;
        }
        *low = !found || value < *low ? value : *low;
        *high = !found || value > *high ? value : *high;
        found = true;
    }
    return found;
}

/* The spacing in units of the smallest, so that no unit of the file (metres,
   micrometres) leaves the library's range. */
static uint32_t relative_spacing(const struct scan *scan, double spacing, double unit)
{
    double ratio = spacing / unit;
    if (ratio > SPACING_RATIO_MOST) {
        data_error(scan->file, "spacing", "one axis has %g times the spacing of another", ratio);
    }
    return (uint32_t)lround(ratio * QV_ONE_Q16);
}

void scan_layout(struct layout *layout, const struct scan *scan, unsigned voxel_bytes)
{
    int32_t stored_stride[3];
    stored_stride[0] = (int32_t)voxel_bytes;                      /* at most 8 */
    stored_stride[1] = stored_stride[0] * (int32_t)scan->size[0]; /* at most 2^15 */
    stored_stride[2] = stored_stride[1] * (int32_t)scan->size[1]; /* at most 2^27 */
    layout->first = 0;
    layout->world_unit = fmin(scan->spacing[0], fmin(scan->spacing[1], scan->spacing[2]));
    for (unsigned w = 0; w < 3; w++) {
        unsigned a = scan->turn.axis[w];
        int32_t stride = stored_stride[a];
        layout->size[w] = (uint16_t)scan->size[a];
        layout->spacing[w] = relative_spacing(scan, scan->spacing[a], layout->world_unit);
        layout->stride[w] = scan->turn.reversed[w] ? -stride : stride;
        if (scan->turn.reversed[w]) {
            layout->first += (uint64_t)(scan->size[a] - 1) * (uint64_t)stride;
        }
    }
}
