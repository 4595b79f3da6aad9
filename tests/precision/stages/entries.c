/*
 * entries.c - from scalars to voxels: index, table, normal, light, and entries converted between
 * opacity and extinction.
 */
#include "search.h"

#include "gradient.h"
#include "qvol.h"
#include "unit_vector.h"

#include <string.h>

#define LN_2 0.693147180559945309417232121458176568L

/* ---- Scalars ------------------------------------------------------------------------------ */

/* The index of a scalar, by a volume of one voxel. Numbers: scalar, low, what high is above. */
static double index_error(const uint64_t input[], unsigned unused)
{
    const uint16_t scalar = (uint16_t)input[0];
    const int32_t low = (int32_t)input[1], window = (int32_t)input[2] + 1;
    static const qv_block all = {{0, 0, 0}, {1, 1, 1}};
    qv_classifier c;
    uint8_t index;
    (void)unused;
    if (scalar < low || scalar > low + window)
        return NO_SUCH_INPUT;
    memset(&c, 0, sizeof c);
    c.scalars.values = (qv_address)&scalar;
    c.scalars.values_bytes = sizeof scalar;
    c.scalars.type = QV_SCALAR_U16;
    for (unsigned axis = 0; axis < 3; axis++) {
        c.scalars.size[axis] = 1;
        c.scalars.stride[axis] = sizeof scalar;
    }
    c.low = low;
    c.high = low + window;
    if (qv_classify(&index, sizeof index, QV_STORAGE_INDEXED8, &c, &all) != QV_OK)
        return (double)INFINITY;
    return index - 255. * (scalar - low) / window;
}

/* Entry t of a straight line between entries 0 and n. Numbers: both ends, n - 1, t. */
static double table_error(const uint64_t input[], unsigned unused)
{
    const unsigned n = (unsigned)input[2] + 1, t = (unsigned)input[3];
    qv_transfer table;
    qv_control_point points[2];
    (void)unused;
    if (t >= n)
        return NO_SUCH_INPUT;
    memset(points, 0, sizeof points);
    points[1].index = (uint8_t)n;
    points[0].rgba[0] = (uint16_t)input[0];
    points[1].rgba[0] = (uint16_t)input[1];
    (void)qv_transfer_build(&table, points, 2);
    return table.rgba[t][0] - (double)(input[0] * (n - t) + input[1] * t) / n;
}

static void tell_four(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "%u, %u, %u, %u", (unsigned)input[0], (unsigned)input[1],
                   (unsigned)input[2] + 1, (unsigned)input[3]);
}

static void tell_index(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "scalar %u, low %u, window %u", (unsigned)input[0], (unsigned)input[1],
                   (unsigned)input[2] + 1);
}

static void measure_index(measured *m, unsigned parameter)
{
    static const search s = {index_error, tell_index, 3, {65535, 65535, 65534}};
    search_worst(m, &s, parameter);
}

static void measure_table(measured *m, unsigned parameter)
{
    static const search s = {table_error, tell_four, 4, {65535, 65535, 254, 254}};
    search_worst(m, &s, parameter);
}

/* ---- Normals ------------------------------------------------------------------------------ */

enum { MIDDLE = 65535 };

/* Products of the other two axes' spacings, 1, 1.5 and .6667. */
static const uint64_t scales[3] = {UINT64_C(98304) * 43691, UINT64_C(65536) * 43691,
                                   UINT64_C(65536) * 98304};

static int32_t difference_of(uint64_t number)
{
    return (int32_t)number - MIDDLE;
}

static double normal_error(const uint64_t input[], unsigned unused)
{
    int32_t v[3], unit[3];
    long double along[3], square = 0, worst = 0;
    (void)unused;
    for (unsigned axis = 0; axis < 3; axis++) {
        v[axis] = difference_of(input[axis]);
        along[axis] = v[axis] * (long double)scales[axis];
        square += along[axis] * along[axis];
    }
    if (square <= 0)
        return NO_SUCH_INPUT;
    qv_unit_vector(unit, v, scales);
    for (unsigned axis = 0; axis < 3; axis++)
        worst = fmaxl(worst, fabsl(unit[axis] - ldexpl(along[axis] / sqrtl(square), 30)));
    return (double)worst;
}

static void tell_normal(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "(%d, %d, %d)", (int)difference_of(input[0]), (int)difference_of(input[1]),
                   (int)difference_of(input[2]));
}

static void measure_normal(measured *m, unsigned parameter)
{
    static const search s = {normal_error, tell_normal, 3, {2 * MIDDLE, 2 * MIDDLE, 2 * MIDDLE}};
    search_worst(m, &s, parameter);
}

/* ---- Opacity and extinction --------------------------------------------------------------- */

#define UNIT       65536u        /* of opacities: 1 */
#define EXTINCTION (17u * 65536) /* the full value: what 16 bits of opacity can tell from full */

static qv_entries entry_of(const uint16_t entry[4], uint8_t storage)
{
    const qv_entries from = {(qv_address)entry, 1, UNIT, EXTINCTION, storage};
    return from;
}

/* Depth of a stored opacity, 64 for the full one. */
static long double depth_of(uint64_t opacity)
{
    return opacity == 65535 ? 64 : -log1pl(-(long double)opacity / 65535) / LN_2;
}

static void measure_to_extinction(measured *m, unsigned unused)
{
    (void)unused;
    for (uint32_t a = 0; a <= 65535; a++) {
        const uint16_t entry[4] = {0, 0, 0, (uint16_t)a};
        const qv_entries from = entry_of(entry, QV_STORAGE_RGBA16);
        const long double exact = 65535 * depth_of(a) / 17;
        uint16_t made[4];
        (void)qv_opacity_to_extinction(made, sizeof made, QV_STORAGE_RGBT16, EXTINCTION, &from);
        if (measured_add(m, (double)(made[3] - fminl(exact, 65535))))
            measured_input(m, "%u", a);
    }
}

static void measure_to_opacity(measured *m, unsigned bits)
{
    for (uint32_t v = 0; v <= 65535; v++) {
        const uint16_t entry[4] = {0, 0, 0, (uint16_t)v};
        const qv_entries from = entry_of(entry, QV_STORAGE_RGBT16);
        const long double part = -expm1l(-17.L * v / 65535 * LN_2);
        uint16_t wide[4];
        uint8_t narrow[4];
        double error;
        if (bits == 16) {
            (void)qv_extinction_to_opacity(wide, sizeof wide, QV_STORAGE_RGBA16, UNIT, &from);
            error = (double)(wide[3] - 65535 * part);
        } else {
            (void)qv_extinction_to_opacity(narrow, sizeof narrow, QV_STORAGE_RGBA8, UNIT, &from);
            error = (double)(narrow[3] - 255 * part);
        }
        if (measured_add(m, error))
            measured_input(m, "%u", v);
    }
}

/* ---- The chapter -------------------------------------------------------------------------- */

static const stage stages[] = {
    {"index of a scalar", "u16, 2 s32 to u8", "to nearest", "1/255", .5, 2, "search", measure_index,
     0, NULL},
    {"entry of a table", "2 unorm16 to unorm16", "to nearest", "1/65535", .5, 2, "search",
     measure_table, 0, NULL},
    {"normal", "3 s32 to 3 s32.30", "cut, root, product to nearest", "2^-30", 3.06, 2, "search",
     measure_normal, 0, NULL},
    {"extinction of 17 from opacity", "unorm16 to unorm16", "log; to nearest", "1/65535", .5001, 2,
     "all 65536", measure_to_extinction, 0, NULL},
    {"opacity from extinction of 17", "unorm16 to unorm16", "exp; to nearest", "1/65535", .5001, 2,
     "all 65536", measure_to_opacity, 16, NULL},
    {"8-bit opacity from extinction of 17", "unorm16 to unorm8", "exp; to nearest, twice", "1/255",
     .502, 2, "all 65536", measure_to_opacity, 8, NULL},
};

const chapter chapter_entries = {
    "Voxels (SPEC 19 to 23, 31)",
    "**Scalars.** Index and entry are one quotient each, to nearest.\n\n"
    "**Normal.** As the direction of a ray (1.1), but that components have 30 bits or less\n"
    "before they are normalised, and a cut counts 2 of 2^-30: at x = .81, 2 sqrt(2) x sqrt(1 -\n"
    "x^2) + 1.5 x + 1/2 = 3.06.\n\n"
    "**Entries.** One rounding, and the log's 1.5 * 2^-28 or exp's 2^-31, which the full\n"
    "value's depth of 17 makes 3e-5 of 1/65535; 8 bits are rounded twice: 1/2 of 1/65535 more.\n",
    stages, COUNT(stages)};
