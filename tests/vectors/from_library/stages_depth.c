/*
 * stages_depth.c - functions of optical depth: sections 27 to 30.
 */
#include "stages.h"

#include "fx_correct.h"
#include "fx_exp.h"
#include "fx_exp_table.h"
#include "fx_log.h"
#include "fx_phi.h"
#include "fx_table.h"
#include "fx_wide.h"

/* ---- Transmittance ---------------------------------------------------------- */

typedef struct transmittance_row {
    uint64_t x, w, g, index, base, place, t, opacity;
} transmittance_row;

static unsigned transmittance_compute(void *columns)
{
    transmittance_row *row = columns;
    row->w = row->x >> 32;
    row->g = (uint32_t)(0u - row->x);
    row->index = row->g >> 26;
    row->base = fx_table32(&exp_power[row->index]);
    row->place = (uint32_t)(row->g << 6);
    row->t = fx_transmittance(row->x);
    row->opacity = fx_opacity(row->x);
    return row->w >= 32 ? VECTOR_SATURATE : 0;
}

static void transmittance_draw(void *columns, vector_random *random)
{
    transmittance_row *row = columns;
    unsigned kind = (unsigned)vector_bits(random, 2);
    row->x = kind == 0 ? vector_any(random, 64) : vector_bits(random, 31 + 2 * kind);
}

/* Whole depths and the borders of the table's segments, and what is next to them. */
static void transmittance_edges(vector_set *set)
{
    for (unsigned whole = 0; whole < 34; whole++)
        for (uint64_t near = 0; near < 5; near++) {
            const transmittance_row row = {.x = ((uint64_t)whole << 32) + near - (whole ? 2u : 0u)};
            vector_add(set, &row, VECTOR_EDGE);
        }
    for (unsigned segment = 1; segment < 64; segment++)
        for (uint64_t near = 0; near < 3; near++) {
            const transmittance_row row = {.x = ((uint64_t)segment << 26) + near - 1u};
            vector_add(set, &row, VECTOR_EDGE);
        }
    const transmittance_row most = {.x = UINT64_MAX};
    vector_add(set, &most, VECTOR_EDGE);
}

/* Found by search: here a table entry or a constant that is off by 1 shows. */
static void transmittance_added(vector_set *set)
{
    static const uint64_t firsts[] = {3492841676u, 4195288403u, 3518492648u,
                                      2770121388u, 2127901709,  1563975050,
                                      1004610349,  537414230,   293222721};
    vector_add_firsts(set, firsts, sizeof firsts / sizeof firsts[0]);
}

static const vector_field transmittance_fields[] = {
    {"x", 1, 'i', "u64.32", "depth in base 2"},
    {"w", 1, 'm', "u32", "floor(x / 2^32)"},
    {"g", 1, 'm', "u32.32", "(-x) mod 2^32"},
    {"index", 1, 'm', "u6", "floor(g / 2^26)"},
    {"base", 1, 'm', "u32.31", "round(2^(31 + index / 64))"},
    {"place", 1, 'm', "u32.32", "64 g mod 2^32"},
    {"t", 1, 'o', "u32.31",
     "0 where w >= 32, 2^(31-w) where g = 0, else floor((floor((base + floor(hi(base, r) / 64)) / "
     "2^w) + 1) / 2), with r = hi(place, 0xB1721819 + hi(place, 0x00F5FD31 + floor(0xE494 * "
     "floor(place / 65536) / 65536)))"},
    {"opacity", 1, 'o', "u32.31", "2147483648 - t"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_transmittance = {
    .name = "transmittance",
    .section = "27",
    .title = "2^-x of an optical depth, wide",
    .rounding = "products of hi to nearest, all else cut but the last",
    .saturation = "0 from depth 32 on",
    .fields = transmittance_fields,
    .columns = VECTOR_COLUMNS(transmittance_row),
    .seed = 27,
    .random_rows = 500,
    .edges = transmittance_edges,
    .added = transmittance_added,
    .draw = transmittance_draw,
    .compute = transmittance_compute,
};

typedef struct transmittance16_row {
    uint64_t x, w, g, base, place, t16, opacity16;
} transmittance16_row;

static unsigned transmittance16_compute(void *columns)
{
    transmittance16_row *row = columns;
    row->w = row->x >> 24;
    row->g = (0u - row->x) & 0xFFFFFFu;
    row->base = fx_table32(&exp_power[row->g >> 18]);
    row->place = row->g >> 2 & 0xFFFFu;
    row->t16 = fx_transmittance16((uint32_t)row->x);
    row->opacity16 = fx_opacity16((uint32_t)row->x);
    return row->w >= 17 ? VECTOR_SATURATE : 0;
}

static void transmittance16_draw(void *columns, vector_random *random)
{
    transmittance16_row *row = columns;
    row->x = vector_bits(random, 1) ? vector_bits(random, 28) : vector_any(random, 32);
}

static void transmittance16_edges(vector_set *set)
{
    for (unsigned whole = 0; whole < 19; whole++)
        for (uint64_t near = 0; near < 5; near++) {
            const transmittance16_row row = {.x = ((uint64_t)whole << 24) + near -
                                                  (whole ? 2u : 0u)};
            vector_add(set, &row, VECTOR_EDGE);
        }
    for (unsigned segment = 1; segment < 64; segment++) {
        const transmittance16_row row = {.x = (uint64_t)segment << 18};
        vector_add(set, &row, VECTOR_EDGE);
    }
    const transmittance16_row most = {.x = UINT32_MAX};
    vector_add(set, &most, VECTOR_EDGE);
}

/* Found by search: here a table entry or a constant that is off by 1 shows. */
static void transmittance16_added(vector_set *set)
{
    static const uint64_t firsts[] = {32564808, 11540331, 18718943, 1251925, 32323512, 60686863};
    vector_add_firsts(set, firsts, sizeof firsts / sizeof firsts[0]);
}

static const vector_field transmittance16_fields[] = {
    {"x", 1, 'i', "u32.24", "depth in base 2"},
    {"w", 1, 'm', "u8", "floor(x / 2^24)"},
    {"g", 1, 'm', "u24.24", "(-x) mod 2^24"},
    {"base", 1, 'm', "u32.31", "exp_power[floor(g / 2^18)]"},
    {"place", 1, 'm', "u16.16", "floor(g / 4) mod 65536"},
    {"t16", 1, 'o', "unorm16",
     "0 where w >= 17, else floor((floor(q / 2^(14+w)) + 1) / 2), with q = p - floor(p / 65536), p "
     "= 2^31 where g = 0, else floor((base + floor(shift16(r, floor((base + 32768) / 65536)) / "
     "64)) / 2), r = shift16(0xB171A5D5 + floor(0xF754 * place / 256), place) + 0x2C7B * (g mod "
     "4)"},
    {"opacity16", 1, 'o', "unorm16", "65535 - t16"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_transmittance16 = {
    .name = "transmittance16",
    .section = "27",
    .title = "2^-x of an optical depth, 16 bits",
    .rounding = "cut, but the last to nearest, ties upwards",
    .saturation = "0 from depth 17 on",
    .fields = transmittance16_fields,
    .columns = VECTOR_COLUMNS(transmittance16_row),
    .seed = 2716,
    .random_rows = 500,
    .edges = transmittance16_edges,
    .added = transmittance16_added,
    .draw = transmittance16_draw,
    .compute = transmittance16_compute,
};
