/*
 * stages_splat.c - lengths, numbers with exponents, and splats: sections 64 and 66.
 */
#include "stages.h"

#include "direction.h"
#include "fx_scaled.h"
#include "fx_wide.h"
#include "kernel.h"

/* ---- Lengths ---------------------------------------------------------------- */

typedef struct length_row {
    uint64_t v[3], length;
} length_row;

static unsigned length_compute(void *columns)
{
    length_row *row = columns;
    const uint32_t v[3] = {(uint32_t)row->v[0], (uint32_t)row->v[1], (uint32_t)row->v[2]};
    row->length = qv_length_of(v);
    return 0;
}

static void length_draw(void *columns, vector_random *random)
{
    length_row *row = columns;
    const unsigned bits = (unsigned)vector_between(random, 1, 31);
    for (unsigned axis = 0; axis < 3; axis++)
        row->v[axis] = vector_any(random, bits);
}

static void length_edges(vector_set *set)
{
    for (unsigned i = 0; i < 32; i++)
        for (uint64_t axes = 1; axes < 8; axes += 2) {
            length_row row = {.v = {(uint64_t)1 << i, 0, 0}};
            row.v[1] = axes & 2u ? row.v[0] : 0;
            row.v[2] = axes & 4u ? row.v[0] : i % 3;
            vector_add(set, &row, VECTOR_EDGE);
        }
}

static const vector_field length_fields[] = {
    {"v", 3, 'i', "u32", "magnitude on axis [i], at most 2^31 + 2^21"},
    {"length", 1, 'o', "u32", "length(v) of section 64"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_length = {
    .name = "length",
    .section = "64",
    .title = "the length of a vector",
    .rounding = "the last product to nearest, ties upwards",
    .saturation = "none",
    .fields = length_fields,
    .columns = VECTOR_COLUMNS(length_row),
    .seed = 64,
    .random_rows = 250,
    .edges = length_edges,
    .draw = length_draw,
    .compute = length_compute,
};

/* ---- Numbers with exponents ------------------------------------------------- */

typedef struct scaled_row {
    uint64_t v;
    int64_t e;
    uint64_t w;
    int64_t g, fraction;
    uint64_t m;
    int64_t me;
    uint64_t product;
    int64_t product_e;
    uint64_t quotient;
    int64_t quotient_e;
    uint64_t fixed;
} scaled_row;

static unsigned scaled_compute(void *columns)
{
    scaled_row *row = columns;
    const fx_scaled a = fx_scaled_of(row->v, (int)row->e), b = fx_scaled_of(row->w, (int)row->g);
    const fx_scaled product = fx_scaled_times(a, b), quotient = fx_scaled_over(a, b);
    row->m = a.mantissa;
    row->me = a.mantissa != 0 ? a.exponent : 0;
    row->product = product.mantissa;
    row->product_e = product.mantissa != 0 ? product.exponent : 0;
    row->quotient = quotient.mantissa;
    row->quotient_e = quotient.mantissa != 0 ? quotient.exponent : 0;
    row->fixed = fx_scaled_fixed(a, (int)row->fraction, UINT32_MAX);
    return row->fixed == UINT32_MAX ? VECTOR_SATURATE : 0;
}

static void scaled_draw(void *columns, vector_random *random)
{
    scaled_row *row = columns;
    row->v = vector_any(random, 64);
    row->e = vector_between(random, -100, 100);
    row->w = vector_any(random, 64);
    row->w += row->w == 0;
    row->g = vector_between(random, -100, 100);
    row->fraction = -row->e - 16 + vector_between(random, -30, 10);
}

static void scaled_edges(vector_set *set)
{
    for (unsigned bit = 0; bit < 64; bit++) {
        const scaled_row row = {
            .v = UINT64_MAX >> bit, .w = (uint64_t)1 << bit, .g = -20, .fraction = (int)bit - 32};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (uint64_t v = 0; v < 8; v++) {
        const scaled_row row = {.v = v, .e = 7, .w = v + 1, .g = -31, .fraction = 22};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Shifts by 31, 32 and 33 bits, and to the left. */
static void scaled_added(vector_set *set)
{
    for (int64_t shift = -1; shift < 35; shift++) {
        const scaled_row row = {.v = 0x80000001, .w = 3, .fraction = -shift};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field scaled_fields[] = {
    {"v", 1, 'i', "u64", "any"},
    {"e", 1, 'i', "s16", "any"},
    {"w", 1, 'i', "u64", "not 0"},
    {"g", 1, 'i', "s16", "any"},
    {"fraction", 1, 'i', "s16", "any"},
    {"m", 1, 'o', "u32", "m of scaled(v, e)"},
    {"me", 1, 'o', "s16", "its exponent; exponents of 0 are 0"},
    {"product", 1, 'o', "u32", "m of scaled(v, e) scaled(w, g)"},
    {"product_e", 1, 'o', "s16", "its exponent"},
    {"quotient", 1, 'o', "u32", "m of scaled(v, e) / scaled(w, g)"},
    {"quotient_e", 1, 'o', "s16", "its exponent"},
    {"fixed", 1, 'o', "u32", "fixed(scaled(v, e), fraction)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_scaled = {
    .name = "scaled",
    .section = "64",
    .title = "numbers with exponents",
    .rounding = "products to nearest, ties upwards; scaled and fixed are cut",
    .saturation = "fixed at 2^32 - 1",
    .fields = scaled_fields,
    .columns = VECTOR_COLUMNS(scaled_row),
    .seed = 6410,
    .random_rows = 250,
    .edges = scaled_edges,
    .added = scaled_added,
    .draw = scaled_draw,
    .compute = scaled_compute,
};

/* ---- Footprint -------------------------------------------------------------- */

typedef struct footprint_row {
    uint64_t kernel;
    int64_t centre;
    uint64_t size;
    int64_t first;
    uint64_t half, doublings, reciprocal, weight[6];
} footprint_row;

static unsigned footprint_compute(void *columns)
{
    footprint_row *row = columns;
    const qv_kernel *kernel = row->kernel ? &qv_kernel_quadratic : &qv_kernel_linear;
    qv_footprint footprint;
    uint16_t weights[6];
    qv_footprint_of(&footprint, kernel, row->centre, (uint32_t)row->size);
    qv_footprint_weights(weights, &footprint, (int32_t)row->first, 6);
    row->half = footprint.half;
    row->doublings = footprint.shift;
    row->reciprocal = footprint.reciprocal;
    for (unsigned i = 0; i < 6; i++) {
        row->weight[i] = weights[i];
        if (weights[i] != qv_footprint_weight(&footprint, (int32_t)(row->first + i)))
            vector_fail("footprint", "weight", "differs between its forms");
    }
    return 0;
}

static void footprint_draw(void *columns, vector_random *random)
{
    footprint_row *row = columns;
    row->kernel = vector_bits(random, 1);
    row->size = vector_bits(random, 2) ? (uint64_t)vector_between(random, 1 << 10, 1 << 18)
                                       : (uint64_t)vector_between(random, 1 << 10, 1 << 28);
    row->first = vector_between(random, -1000, 1000);
    row->centre = row->first * 65536 + vector_between(random, 0, 5 * 65536);
}

static void footprint_edges(vector_set *set)
{
    static const uint64_t sizes[] = {1 << 10, 1 << 16, 65537, 1 << 17, 100000, 1 << 28};
    static const int64_t centres[] = {0, 1, 32767, 32768, 32769, 176185, -1};
    for (unsigned i = 0; i < 2 * 6 * 7; i++) {
        const footprint_row row = {.kernel = i % 2,
                                   .centre = centres[i / 12],
                                   .size = sizes[i / 2 % 6],
                                   .first = i / 12 == 5 ? 0 : -2};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field footprint_fields[] = {
    {"kernel", 1, 'i', "u1", "0 linear (halves 2), 1 quadratic (halves 3)"},
    {"centre", 1, 'i', "s40.16", "x of section 66, pixels"},
    {"size", 1, 'i', "u29.16", "of the voxel, 2^10 .. 2^28"},
    {"first", 1, 'i', "s16", "first pixel"},
    {"half", 1, 'm', "u30.16", "floor(size / 2) halves"},
    {"doublings", 1, 'm', "u5", "j, that bring half to 2^30 .. 2^31"},
    {"reciprocal", 1, 'm', "u32.27", "R: 2^28 where 2^j half is 2^30, else recip of it"},
    {"weight", 6, 'o', "u16.15", "weight(first + [i]) of section 66"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_footprint = {
    .name = "footprint",
    .section = "66",
    .title = "the weights of a splat on pixels side by side",
    .rounding = "edges are cut towards the middle",
    .saturation = "beyond the kernel",
    .fields = footprint_fields,
    .columns = VECTOR_COLUMNS(footprint_row),
    .seed = 66,
    .random_rows = 250,
    .edges = footprint_edges,
    .draw = footprint_draw,
    .compute = footprint_compute,
};

/* ---- Sums ------------------------------------------------------------------- */

typedef struct splat_row {
    uint64_t sum[4], light[4], wy, wx, line[4], next[4];
} splat_row;

static void splat(splat_row *row, const qv_splatting *splatting)
{
    uint32_t sums[4], light[4];
    const uint16_t weight = (uint16_t)row->wx;
    for (unsigned c = 0; c < 4; c++) {
        light[c] = fx_product_shift16((uint32_t)row->light[c], (uint16_t)row->wy);
        sums[c] = (uint32_t)row->sum[c];
        row->line[c] = light[c];
    }
    splatting->row(sums, &weight, 1, light);
    for (unsigned c = 0; c < 4; c++)
        row->next[c] = sums[c];
}

static unsigned splat_added_compute(void *columns)
{
    splat_row *row = columns;
    splat(row, &qv_splatting_added);
    return row->next[3] == UINT32_MAX ? VECTOR_SATURATE : 0;
}

static unsigned splat_over_compute(void *columns)
{
    splat_row *row = columns;
    splat(row, &qv_splatting_over);
    return row->next[3] == 16711680u ? VECTOR_SATURATE : 0;
}

static void draw_splat(splat_row *row, vector_random *random, uint64_t most)
{
    row->light[3] = vector_any(random, 31) % (1069547520u + 1u);
    for (unsigned c = 0; c < 4; c++) {
        row->sum[c] = vector_any(random, 32) % (most + 1u);
        if (c < 3)
            row->light[c] = row->light[3] * vector_any(random, 16) >> 16;
    }
    row->wy = (uint64_t)vector_between(random, 0, 32769);
    row->wx = (uint64_t)vector_between(random, 0, 32769);
}

static void splat_added_draw(void *row, vector_random *random)
{
    draw_splat(row, random, UINT32_MAX);
}

static void splat_over_draw(void *row, vector_random *random)
{
    draw_splat(row, random, 16711680u);
}

static void splat_edges(vector_set *set)
{
    static const uint64_t sums[] = {0, 1, 8355840, 16711680};
    static const uint64_t weights[] = {0, 1, 16384, 32768};
    for (unsigned i = 0; i < 64; i++) {
        splat_row row = {.wy = weights[i / 4 % 4], .wx = weights[i / 16]};
        for (unsigned c = 0; c < 4; c++) {
            row.sum[c] = sums[i % 4];
            row.light[c] = 1069547520u >> (3u - c);
        }
        vector_add(set, &row, VECTOR_EDGE);
    }
}

#define SPLAT_FIELDS(formula)                                                                      \
    {"sum", 4, 'i', "u32.16", "of the pixel before, channel [i]"},                                 \
        {"light", 4, 'i', "u32.22", "of the splat, channel [i]"},                                  \
        {"wy", 1, 'i', "u16.15", "weight(y)"}, {"wx", 1, 'i', "u16.15", "weight(x)"},              \
        {"line", 4, 'm', "u32", "floor(light[i] * wy / 65536)"},                                   \
        {"next", 4, 'o', "u32.16", formula},                                                       \
    {                                                                                              \
        NULL, 0, 0, NULL, NULL                                                                     \
    }

static const vector_field splat_added_fields[] = {
    SPLAT_FIELDS("min(2^32 - 1, sum[i] + floor((floor(line[i] * wx / 65536) + 8) / 16))")};

const vector_stage stage_splat_added = {
    .name = "splat_added",
    .section = "66",
    .title = "a splat added to the sums of a pixel",
    .rounding = "products are cut, the part to nearest, ties upwards",
    .saturation = "sums at 2^32 - 1",
    .fields = splat_added_fields,
    .columns = VECTOR_COLUMNS(splat_row),
    .seed = 6601,
    .random_rows = 150,
    .edges = splat_edges,
    .draw = splat_added_draw,
    .compute = splat_added_compute,
};

static const vector_field splat_over_fields[] = {SPLAT_FIELDS(
    "min(16711680, sum[i] - hi(sum[i], o) + part(line[i])), with part(v) = min(16711680, "
    "floor((floor(v * wx / 65536) + 8) / 16)), a = part(line3) and o = 257 a + "
    "floor(a / 256) + floor(a / 65536)")};

const vector_stage stage_splat_over = {
    .name = "splat_over",
    .section = "66",
    .title = "a splat blended over the sums of a pixel",
    .rounding = "products are cut but for hi, the part to nearest, ties upwards",
    .saturation = "parts and sums at 255 * 65536",
    .fields = splat_over_fields,
    .columns = VECTOR_COLUMNS(splat_row),
    .seed = 6602,
    .random_rows = 150,
    .edges = splat_edges,
    .draw = splat_over_draw,
    .compute = splat_over_compute,
};
