/*
 * scalar_view.c - a scan as the library's scalars.
 */
#include "scalar_view.h"
#include "error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The library's limits of a window. */
#define WINDOW_LEAST (-65536)
#define WINDOW_MOST  131071

/* The file's values are not those that it stores. */
static bool is_scaled(const struct scan *scan)
{
    return scan->slope < 1 || scan->slope > 1 || scan->offset < 0 || scan->offset > 0;
}

/* What fits in the library's scalars without loss. */
static bool is_exact(const struct scan *scan)
{
    return scan->type <= ELEMENT_S16 && !is_scaled(scan);
}

/* Given, or all of 8 bits, or the data's range. */
static void choose_window(double window[2], const struct scan *scan,
                          const struct settings *settings)
{
    if (settings->window_given) {
        memcpy(window, settings->window, 2 * sizeof window[0]);
    } else if (scan->type == ELEMENT_U8 && !is_scaled(scan)) {
        window[0] = 0;
        window[1] = 255;
    } else if (!scan_range(scan, &window[0], &window[1])) {
        data_error(scan->file, "data", "no value is a number");
    }
    if (!(window[0] < window[1])) {
        /* All values are equal; whole numbers stay whole. */
        window[1] = window[0] + ceil(fmax(1, fabs(window[0]) / 4096));
    }
}

/* The library's window is in whole scalars. */
static int32_t whole_window(double value)
{
    if (value < WINDOW_LEAST || value > WINDOW_MOST || value > floor(value)) {
        char text[DECIMAL_BYTES];
        print_decimal(text, value);
        usage_error("--window",
                    "%s is not a whole number from %d to %d; 8- and 16-bit data take no other",
                    text, WINDOW_LEAST, WINDOW_MOST);
    }
    return (int32_t)value;
}

/* Halves, since high - low may exceed the largest double. */
static uint16_t over_window(double value, const double window[2])
{
    double share = (value / 2 - window[0] / 2) / (window[1] / 2 - window[0] / 2);
    if (!(share > 0)) {
        return 0;
    }
    return share < 1 ? (uint16_t)lround(share * 65535) : 65535;
}

static void convert(struct scan *scan, const double window[2])
{
    uint64_t count = scan->bytes / element_bytes(scan->type);
    uint16_t *values = allocate(count * sizeof *values, scan->file, "data");
    for (uint64_t place = 0; place < count; place++) {
        values[place] = over_window(scan_value(scan, place), window);
    }
    free(scan->values);
    scan->values = values;
}

/* The library has no signed bytes: every value keeps its number. */
static void widen(struct scan *scan)
{
    const int8_t *from = scan->values;
    int16_t *values = allocate(scan->bytes * sizeof *values, scan->file, "data");
    for (uint64_t place = 0; place < scan->bytes; place++) {
        values[place] = from[place];
    }
    free(scan->values);
    scan->values = values;
}

/* Values and window, converted together. */
static qv_scalar_type set_values(struct scalar_view *view, struct scan *scan)
{
    view->converted = !is_exact(scan);
    if (view->converted) {
        convert(scan, view->window);
        view->low = 0;
        view->high = 65535;
        return QV_SCALAR_U16;
    }
    view->low = whole_window(view->window[0]);
    view->high = whole_window(view->window[1]);
    if (scan->type == ELEMENT_S8) {
        widen(scan);
        return QV_SCALAR_S16;
    }
    if (scan->type == ELEMENT_U8) {
        return QV_SCALAR_U8;
    }
    return scan->type == ELEMENT_U16 ? QV_SCALAR_U16 : QV_SCALAR_S16;
}

void scalar_view_create(struct scalar_view *view, struct scan *scan,
                        const struct settings *settings)
{
    struct layout layout;
    qv_scalars *scalars = &view->scalars;
    uint64_t count = scan->bytes / element_bytes(scan->type);
    unsigned bytes;
    memset(view, 0, sizeof *view);
    choose_window(view->window, scan, settings);
    scalars->type = (uint8_t)set_values(view, scan);
    bytes = scalars->type == QV_SCALAR_U8 ? 1 : 2;
    scan_layout(&layout, scan, bytes);
    scalars->values = (const unsigned char *)scan->values + layout.first;
    scalars->values_bytes = count * bytes;
    memcpy(scalars->spacing, layout.spacing, sizeof scalars->spacing);
    memcpy(scalars->stride, layout.stride, sizeof scalars->stride);
    memcpy(scalars->size, layout.size, sizeof scalars->size);
    view->world_unit = layout.world_unit;
}
