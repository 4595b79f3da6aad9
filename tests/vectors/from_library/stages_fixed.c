/*
 * stages_fixed.c - operations of fixed-point numbers: section 2.
 */
#include "stages.h"

#include "fx_angle.h"
#include "fx_root.h"
#include "fx_unorm.h"
#include "fx_wide.h"

/* ---- Products --------------------------------------------------------------- */

typedef struct product_row {
    uint64_t a, b, high, shift16;
} product_row;

static unsigned product_compute(void *columns)
{
    product_row *row = columns;
    uint32_t a = (uint32_t)row->a, b = (uint32_t)row->b;
    row->high = fx_high_product(a, b);
    row->shift16 = fx_product_shift16(a, (uint16_t)b);
    if (row->high != fx_high_product_narrow(a, b) || row->high != fx_high_product_digits(a, b))
        vector_fail("product", "high", "differs between its forms");
    return a * b == 0x80000000u ? VECTOR_TIE : 0;
}

static void product_draw(void *columns, vector_random *random)
{
    product_row *row = columns;
    row->a = vector_any(random, 32);
    row->b = vector_any(random, 32);
}

static void product_edges(vector_set *set)
{
    static const uint64_t numbers[] = {0, 1, 65535, 65536, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF};
    enum { NUMBERS = sizeof numbers / sizeof numbers[0] };
    for (unsigned i = 0; i < NUMBERS * NUMBERS; i++) {
        const product_row row = {.a = numbers[i / NUMBERS], .b = numbers[i % NUMBERS]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field product_fields[] = {
    {"a", 1, 'i', "u32", "any"},
    {"b", 1, 'i', "u32", "any"},
    {"high", 1, 'o', "u32", "hi(a, b) = floor((a * b + 2^31) / 2^32)"},
    {"shift16", 1, 'o', "u32", "floor(a * (b mod 65536) / 65536)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_product = {
    .name = "product",
    .section = "2",
    .title = "the upper half of a product, and one shifted by 16",
    .rounding = "high to nearest, ties upwards; shift16 is cut",
    .saturation = "none",
    .fields = product_fields,
    .columns = VECTOR_COLUMNS(product_row),
    .seed = 2,
    .random_rows = 300,
    .edges = product_edges,
    .draw = product_draw,
    .compute = product_compute,
};

/* ---- Products of coordinates ------------------------------------------------ */

typedef struct scale_row {
    int64_t v, factor, scaled;
} scale_row;

static unsigned scale_compute(void *columns)
{
    scale_row *row = columns;
    row->scaled = fx_scale_q30(row->v, (int32_t)row->factor);
    uint64_t rest = (uint64_t)row->v * (uint64_t)row->factor; /* modulo 2^64: bits below 2^30 */
    return (rest & 0x3FFFFFFFu) == 0x20000000u ? VECTOR_TIE : 0;
}

static void scale_draw(void *columns, vector_random *random)
{
    scale_row *row = columns;
    row->v = vector_signed(random, 60);
    row->factor = (int32_t)(uint32_t)vector_any(random, 32);
}

static void scale_edges(vector_set *set)
{
    static const int64_t numbers[] = {0, 1, -1, 3, -3, (INT64_C(1) << 60) - 1, -(INT64_C(1) << 60)};
    static const int64_t factors[] = {0,           1,          -1,         0x20000000,
                                      -0x20000000, 0x40000000, 0x7FFFFFFF, INT32_MIN};
    for (unsigned i = 0; i < 7 * 8; i++) {
        const scale_row row = {.v = numbers[i / 8], .factor = factors[i % 8]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field scale_fields[] = {
    {"v", 1, 'i', "s64", "magnitude below 2^61"},
    {"factor", 1, 'i', "s32.30", "any"},
    {"scaled", 1, 'o', "s64", "q30(v, factor) = floor((v * factor + 2^29) / 2^30)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_scale = {
    .name = "scale",
    .section = "2",
    .title = "a coordinate by a component of a rotation",
    .rounding = "to nearest, ties upwards, also below 0",
    .saturation = "none",
    .fields = scale_fields,
    .columns = VECTOR_COLUMNS(scale_row),
    .seed = 230,
    .random_rows = 300,
    .edges = scale_edges,
    .draw = scale_draw,
    .compute = scale_compute,
};

/* ---- Quotients -------------------------------------------------------------- */

typedef struct quotient_row {
    uint64_t n, d, m, e, quotient, quotient16;
} quotient_row;

static unsigned quotient_compute(void *columns)
{
    quotient_row *row = columns;
    row->quotient = fx_divide(row->n, (uint32_t)row->d);
    row->quotient16 = fx_quotient16(row->m, row->e);
    return row->quotient16 == 65535u ? VECTOR_SATURATE : 0;
}

/* A ratio of numbers below 2^63, mostly below 1. */
static void quotient_draw(void *columns, vector_random *random)
{
    quotient_row *row = columns;
    row->n = vector_any(random, 64);
    row->d = vector_any(random, 31) | 1u;
    row->e = vector_any(random, 48) | 1u;
    row->m = vector_bits(random, 16) * row->e;
    row->m += vector_bits(random, 48) % row->e;
    if (vector_bits(random, 2) == 0)
        row->m = vector_any(random, 63);
}

/* Halves, and what is next to them. */
static void quotient_edges(vector_set *set)
{
    for (uint64_t i = 0; i < 64; i++) {
        uint64_t e = i / 4 * 2 + 2;
        const quotient_row row = {.n = i % 2 ? UINT64_MAX - i : i,
                                  .d = i % 3 ? (uint64_t)1 << i % 31 : 0x7FFFFFFF,
                                  .m = 1000 * e + e / 2 - 2 + i % 4,
                                  .e = e};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Quotients of 65536 or a little less: rounded they are 65536, just below it, or just above. */
static void quotient_added(vector_set *set)
{
    static const uint64_t divisors[] = {1, 2, 3, 65535, 65536, UINT64_C(1) << 40, 0xFFFFFFFFFFFF};
    for (unsigned i = 0; i < 7 * 3; i++) {
        const uint64_t e = divisors[i / 3];
        const quotient_row row = {.n = 131071, .d = 2, .m = (e << 16) - e / 2 + i % 3 - 1, .e = e};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field quotient_fields[] = {
    {"n", 1, 'i', "u64", "any"},
    {"d", 1, 'i', "u31", "not 0"},
    {"m", 1, 'i', "u64", "m + floor(e / 2) is below 2^64"},
    {"e", 1, 'i', "u64", "not 0"},
    {"quotient", 1, 'o', "u64", "div(n, d) = floor(n / d)"},
    {"quotient16", 1, 'o', "u16", "quot16(m, e) = min(65535, floor((m + floor(e / 2)) / e))"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_quotient = {
    .name = "quotient",
    .section = "2",
    .title = "quotients",
    .rounding = "quotient is cut; quotient16 to nearest, ties upwards",
    .saturation = "quotient16 at 65535",
    .fields = quotient_fields,
    .columns = VECTOR_COLUMNS(quotient_row),
    .seed = 264,
    .random_rows = 300,
    .edges = quotient_edges,
    .added = quotient_added,
    .draw = quotient_draw,
    .compute = quotient_compute,
};

/* ---- Sine ------------------------------------------------------------------- */

typedef struct sine_row {
    uint64_t angle;
    int64_t sine, cosine;
} sine_row;

static unsigned sine_compute(void *columns)
{
    sine_row *row = columns;
    int32_t sine, cosine;
    fx_sine_cosine(&sine, &cosine, (uint32_t)row->angle);
    row->sine = sine;
    row->cosine = cosine;
    return 0;
}

static void sine_draw(void *columns, vector_random *random)
{
    sine_row *row = columns;
    row->angle = vector_bits(random, 32);
}

/* Multiples of 45 degrees, and what is next to them. */
static void sine_edges(vector_set *set)
{
    for (uint64_t eighth = 0; eighth < 8; eighth++)
        for (uint64_t near = 0; near < 5; near++) {
            const sine_row row = {.angle = (uint32_t)((eighth << 29) + near - 2u)};
            vector_add(set, &row, VECTOR_EDGE);
        }
}

static const vector_field sine_fields[] = {
    {"angle", 1, 'i', "u32.32", "2^32 is a full turn"},
    {"sine", 1, 'o', "s32.30", "sine(angle) of section 2.1"},
    {"cosine", 1, 'o', "s32.30", "cosine(angle) of section 2.1"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_sine = {
    .name = "sine",
    .section = "2.1",
    .title = "sine and cosine",
    .rounding = "products and the last 30 bits to nearest, ties upwards",
    .saturation = "none",
    .fields = sine_fields,
    .columns = VECTOR_COLUMNS(sine_row),
    .seed = 21,
    .random_rows = 1000,
    .edges = sine_edges,
    .draw = sine_draw,
    .compute = sine_compute,
};

/* ---- Reciprocal square root ------------------------------------------------- */

typedef struct root_row {
    uint64_t n, r, x;
} root_row;

static unsigned root_compute(void *columns)
{
    root_row *row = columns;
    unsigned exponent;
    row->r = fx_rsqrt(row->n, &exponent);
    row->x = exponent;
    return row->r == 0x80000000u ? VECTOR_SATURATE : 0;
}

static void root_draw(void *columns, vector_random *random)
{
    root_row *row = columns;
    row->n = vector_any(random, 64);
}

static void root_edges(vector_set *set)
{
    for (unsigned bit = 0; bit < 64; bit++)
        for (uint64_t near = 0; near < 3; near++) {
            const root_row row = {.n = ((uint64_t)1 << bit) + near - 1u};
            vector_add(set, &row, VECTOR_EDGE);
        }
}

static const vector_field root_fields[] = {{"n", 1, 'i', "u64", "any; 0 counts as 1"},
                                           {"r", 1, 'o', "u32.30", "r of rsqrt(n), section 2.2"},
                                           {"x", 1, 'o', "u6", "x of rsqrt(n)"},
                                           {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_root = {
    .name = "root",
    .section = "2.2",
    .title = "the reciprocal square root",
    .rounding = "products to nearest, ties upwards",
    .saturation = "r at 2^31",
    .fields = root_fields,
    .columns = VECTOR_COLUMNS(root_row),
    .seed = 22,
    .random_rows = 800,
    .edges = root_edges,
    .draw = root_draw,
    .compute = root_compute,
};

/* ---- unorm ------------------------------------------------------------------ */

typedef struct unorm_row {
    uint64_t a, p, narrow, wide, quotient;
} unorm_row;

static unsigned unorm_compute(void *columns)
{
    unorm_row *row = columns;
    row->narrow = fx_unorm16_to_unorm8((fx_unorm16)row->a);
    row->wide = fx_unorm8_to_unorm16((fx_unorm8)row->narrow);
    row->quotient = fx_div255_round((uint32_t)row->p);
    return 0;
}

static void unorm_draw(void *columns, vector_random *random)
{
    unorm_row *row = columns;
    row->a = vector_any(random, 16);
    row->p = vector_bits(random, 16) % 65026u;
}

/* Where the results step: to8 between 257 v + 128 and the next, div255 between 255 v + 127 and the
   next. */
static void unorm_edges(vector_set *set)
{
    for (uint64_t v = 0; v < 256; v++)
        for (uint64_t near = 0; near < 2; near++) {
            uint64_t a = 257 * v + 128 + near, p = 255 * v + 127 + near;
            const unorm_row row = {.a = a < 65536 ? a : 65535, .p = p < 65026 ? p : 65025};
            vector_add(set, &row, VECTOR_EDGE);
        }
}

static const vector_field unorm_fields[] = {
    {"a", 1, 'i', "unorm16", "any"},
    {"p", 1, 'i', "u16", "at most 65025"},
    {"narrow", 1, 'o', "unorm8", "to8(a) = floor((255 a + 32895) / 65536)"},
    {"wide", 1, 'o', "unorm16", "257 narrow"},
    {"quotient", 1, 'o', "u8", "div255(p) = round(p / 255)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_unorm = {
    .name = "unorm",
    .section = "2.3",
    .title = "8 and 16 bits, and products of 8 bits",
    .rounding = "to nearest; there are no ties",
    .saturation = "none",
    .fields = unorm_fields,
    .columns = VECTOR_COLUMNS(unorm_row),
    .seed = 23,
    .random_rows = 100,
    .edges = unorm_edges,
    .draw = unorm_draw,
    .compute = unorm_compute,
};
