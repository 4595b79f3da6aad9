/*
 * stages_entry.c - entries with extinction, mixtures, coarser levels, associated colours: sections
 * 31, 32, 34 and 69.
 */
#include "stages.h"

#include "access.h"
#include "qvol.h"

#include <string.h>

/* ---- Conversion of the fourth channel --------------------------------------- */

typedef struct recode_row {
    uint64_t kind, v, from, to, result16, result8;
} recode_row;

typedef qv_status recoding(void *to, size_t bytes, uint8_t storage, uint32_t number,
                           const qv_entries *from);

/* Opacities come from a kind below 2, and are made where its lower bit is set. */
static const struct {
    recoding *recode;
    uint8_t from, to[2];
} recodings[4] = {
    {qv_opacity_to_extinction, QV_STORAGE_RGBA16, {QV_STORAGE_RGBT8, QV_STORAGE_RGBT16}},
    {qv_opacity_to_opacity, QV_STORAGE_RGBA16, {QV_STORAGE_RGBA8, QV_STORAGE_RGBA16}},
    {qv_extinction_to_extinction, QV_STORAGE_RGBT16, {QV_STORAGE_RGBT8, QV_STORAGE_RGBT16}},
    {qv_extinction_to_opacity, QV_STORAGE_RGBT16, {QV_STORAGE_RGBA8, QV_STORAGE_RGBA16}}};

/* Of two entries the second, which the first leads to. */
static unsigned recode_compute(void *columns)
{
    recode_row *row = columns;
    const uint16_t entries[2][4] = {{0, 0, 0, 0}, {0, 0, 0, (uint16_t)row->v}};
    const void *address = entries;
    const qv_entries from = {.entries = address,
                             .count = 2,
                             .unit_distance = (uint32_t)row->from,
                             .extinction = (uint32_t)row->from,
                             .storage = recodings[row->kind].from};
    recoding *recode = recodings[row->kind].recode;
    const uint8_t *to = recodings[row->kind].to;
    uint8_t narrow[2][4] = {{0}};
    uint16_t wide[2][4] = {{0}};
    if (recode(narrow, sizeof narrow, to[0], (uint32_t)row->to, &from) != QV_OK ||
        recode(wide, sizeof wide, to[1], (uint32_t)row->to, &from) != QV_OK)
        vector_fail("recode", "entry", "refused");
    row->result8 = narrow[1][3];
    row->result16 = wide[1][3];
    return row->result16 == 65535 ? VECTOR_SATURATE : 0;
}

static uint64_t draw_number(vector_random *random)
{
    uint64_t number = vector_bits(random, 1) ? vector_any(random, 20) : vector_any(random, 32);
    return number != 0 ? number : 65536;
}

static void recode_draw(void *columns, vector_random *random)
{
    recode_row *row = columns;
    row->kind = vector_bits(random, 2);
    row->v = vector_any(random, 16);
    row->from = draw_number(random);
    row->to = vector_bits(random, 1) ? draw_number(random) : 65536;
}

static void recode_edges(vector_set *set)
{
    static const uint64_t values[] = {0, 1, 128, 12345, 32768, 65534, 65535};
    static const uint64_t numbers[][2] = {{65536, 65536},          {65536, 1114112}, {98304, 65536},
                                          {1, UINT32_MAX},         {UINT32_MAX, 1},  {3, 1000000},
                                          {0x80000001, 0xFFFFFFFF}};
    for (unsigned i = 0; i < 4 * 49; i++) {
        const recode_row row = {.kind = i / 49,
                                .v = values[i % 7],
                                .from = numbers[i / 7 % 7][0],
                                .to = numbers[i / 7 % 7][1]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* The last that rounds down, and the first that does not. */
static void recode_added(vector_set *set)
{
    for (uint64_t v = 32767; v < 32769; v++) {
        const recode_row row = {.kind = 2, .v = v, .from = 1, .to = 65536};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field recode_fields[] = {
    {"kind", 1, 'i', "u2",
     "0 opacity to extinction, 1 opacity to opacity, 2 extinction to extinction, 3 extinction to "
     "opacity"},
    {"v", 1, 'i', "unorm16", "the fourth channel"},
    {"from", 1, 'i', "u32.16", "its U or E, not 0"},
    {"to", 1, 'i', "u32.16", "the new U' or E', not 0"},
    {"result16", 1, 'o', "unorm16", "the formula of its kind in section 31; 0 where v = 0"},
    {"result8", 1, 'o', "unorm8", "to8(result16)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_recode = {
    .name = "recode",
    .section = "31",
    .title = "opacity and extinction made of each other",
    .rounding = "to nearest, ties upwards",
    .saturation = "results at 65535, ratios at 2^53",
    .fields = recode_fields,
    .columns = VECTOR_COLUMNS(recode_row),
    .seed = 31,
    .random_rows = 400,
    .edges = recode_edges,
    .added = recode_added,
    .draw = recode_draw,
    .compute = recode_compute,
};

/* ---- The extinction that holds opacities ------------------------------------ */

typedef struct least_row {
    uint64_t a[3], unit, opaque, extinction;
} least_row;

static unsigned least_compute(void *columns)
{
    least_row *row = columns;
    uint16_t entries[3][4];
    memset(entries, 0, sizeof entries);
    for (unsigned i = 0; i < 3; i++)
        entries[i][3] = (uint16_t)row->a[i];
    const void *address = entries;
    const qv_entries from = {.entries = address,
                             .count = 3,
                             .unit_distance = (uint32_t)row->unit,
                             .storage = QV_STORAGE_RGBA16};
    uint32_t extinction;
    if (qv_extinction_of(&extinction, &from, (uint32_t)row->opaque) != QV_OK)
        vector_fail("least_extinction", "entries", "refused");
    row->extinction = extinction;
    return extinction == UINT32_MAX ? VECTOR_SATURATE : 0;
}

static void least_draw(void *columns, vector_random *random)
{
    least_row *row = columns;
    for (unsigned i = 0; i < 3; i++)
        row->a[i] = vector_any(random, 16);
    row->unit = draw_number(random);
    row->opaque = vector_bits(random, 1) ? vector_any(random, 32) : 0;
}

static void least_edges(vector_set *set)
{
    static const uint64_t units[] = {1, 3, 65536, 98304, UINT32_MAX};
    for (unsigned i = 0; i < 40; i++) {
        const least_row row = {.a = {i % 2 ? 12345 : 0, i / 2 % 2 ? 65534 : 1, i / 4 % 2 * 65535},
                               .unit = units[i / 8],
                               .opaque = i % 3 == 0 ? 589824 : 0};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field least_fields[] = {
    {"a", 3, 'i', "unorm16", "opacity [i]"},
    {"unit", 1, 'i', "u32.16", "U, not 0"},
    {"opaque", 1, 'i', "u32.16", "O, what stands for 65535; 0: not given"},
    {"extinction", 1, 'o', "u32.16", "E of section 31, the least that holds the opacities"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_least_extinction = {
    .name = "least_extinction",
    .section = "31",
    .title = "the least extinction that holds some opacities",
    .rounding = "upwards",
    .saturation = "1 .. 2^32 - 1",
    .fields = least_fields,
    .columns = VECTOR_COLUMNS(least_row),
    .seed = 3149,
    .random_rows = 100,
    .edges = least_edges,
    .draw = least_draw,
    .compute = least_compute,
};

/* ---- Mixtures --------------------------------------------------------------- */

typedef struct mixture_row {
    uint64_t p[3], extinction[3], r[3], g[3], b[3], full, x, y[3], rgbt[4];
} mixture_row;

static unsigned mixture_compute(void *columns)
{
    mixture_row *row = columns;
    qv_material materials[3];
    uint16_t percentages[3], rgbt[4];
    qv_mixture mixture;
    for (unsigned m = 0; m < 3; m++) {
        percentages[m] = (uint16_t)row->p[m];
        materials[m].extinction = (uint32_t)row->extinction[m];
        materials[m].colour[0] = (uint16_t)row->r[m];
        materials[m].colour[1] = (uint16_t)row->g[m];
        materials[m].colour[2] = (uint16_t)row->b[m];
    }
    if (qv_mix(&mixture, materials, percentages, 3) != QV_OK)
        vector_fail("mixture", "percentages", "refused");
    qv_mixture_to_voxel(rgbt, &mixture, (uint32_t)row->full);
    row->x = mixture.extinction;
    for (unsigned c = 0; c < 4; c++)
        row->rgbt[c] = rgbt[c];
    for (unsigned c = 0; c < 3; c++)
        row->y[c] = mixture.light[c];
    return row->rgbt[3] == 65535 ? VECTOR_SATURATE : 0;
}

static void mixture_draw(void *columns, vector_random *random)
{
    mixture_row *row = columns;
    int64_t rest = 65535;
    for (unsigned m = 0; m < 3; m++) {
        row->p[m] = (uint64_t)vector_between(random, 0, rest);
        rest -= (int64_t)row->p[m];
        row->extinction[m] = vector_any(random, 32);
        row->r[m] = vector_any(random, 16);
        row->g[m] = vector_any(random, 16);
        row->b[m] = vector_any(random, 16);
    }
    row->full = draw_number(random);
}

static void mixture_edges(vector_set *set)
{
    for (unsigned i = 0; i < 16; i++) {
        const mixture_row row = {.p = {i % 2 ? 65535 : 0, i % 2 ? 0 : i * 1000, 0},
                                 .extinction = {i / 2 % 2 ? UINT32_MAX : 1, 98304, 3},
                                 .r = {65535, 0, 1},
                                 .g = {1, 40000, 2},
                                 .b = {32768, 65535, 3},
                                 .full = i / 4 % 2 ? 65536
                                         : i / 8   ? UINT32_MAX
                                                   : 1};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field mixture_fields[] = {
    {"p", 3, 'i', "unorm16", "percentage of material [i]; the three sum to at most 65535"},
    {"extinction", 3, 'i', "u32.16", "of material [i]"},
    {"r", 3, 'i', "unorm16", "red of material [i]"},
    {"g", 3, 'i', "unorm16", "green of material [i]"},
    {"b", 3, 'i', "unorm16", "blue of material [i]"},
    {"full", 1, 'i', "u32.16", "E, the extinction of the full value"},
    {"x", 1, 'm', "u48", "p0 * extinction0 + p1 * extinction1 + p2 * extinction2"},
    {"y0", 1, 'm', "u64", "p0 * extinction0 * r0 + p1 * extinction1 * r1 + p2 * extinction2 * r2"},
    {"y1", 1, 'm', "u64", "p0 * extinction0 * g0 + p1 * extinction1 * g1 + p2 * extinction2 * g2"},
    {"y2", 1, 'm', "u64", "p0 * extinction0 * b0 + p1 * extinction1 * b1 + p2 * extinction2 * b2"},
    {"rgbt0", 1, 'o', "unorm16", "quot16(y0, x), 0 where x = 0"},
    {"rgbt1", 1, 'o', "unorm16", "quot16(y1, x), 0 where x = 0"},
    {"rgbt2", 1, 'o', "unorm16", "quot16(y2, x), 0 where x = 0"},
    {"rgbt3", 1, 'o', "unorm16", "quot16(x, full)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_mixture = {
    .name = "mixture",
    .section = "32",
    .title = "an entry of a mixture of materials",
    .rounding = "to nearest, ties upwards",
    .saturation = "rgbt3 at 65535",
    .fields = mixture_fields,
    .columns = VECTOR_COLUMNS(mixture_row),
    .seed = 32,
    .random_rows = 150,
    .edges = mixture_edges,
    .draw = mixture_draw,
    .compute = mixture_compute,
};

/* ---- Downsampling ----------------------------------------------------------- */

typedef struct downsample_row {
    uint64_t n[3], filter, converted, wide, channel[4][8], weight[8], rgba[4];
} downsample_row;

/* The first voxel of the coarser level of up to eight. */
static unsigned downsample_compute(void *columns)
{
    static const qv_filter *const filters[3] = {&qv_filter_box2, &qv_filter_box4, &qv_filter_quad4};
    downsample_row *row = columns;
    const qv_domain *domain = row->converted ? &qv_domain_extinction : &qv_domain_stored;
    uint8_t narrow[8][4], narrow_result[8 * 4];
    uint16_t wide[8][4], wide_result[8 * 4];
    for (unsigned i = 0; i < 32; i++) {
        narrow[i % 8][i / 8] = (uint8_t)row->channel[i / 8][i % 8];
        wide[i % 8][i / 8] = (uint16_t)row->channel[i / 8][i % 8];
    }
    const int32_t bytes = row->wide ? 8 : 4;
    qv_volume finer = {.voxels = narrow[0], .voxels_bytes = (uint32_t)bytes * 8u};
    if (row->wide)
        finer.voxels = (qv_address)wide;
    finer.storage = row->wide ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
    finer.stride[0] = bytes;
    finer.stride[1] = bytes * (int32_t)row->n[0];
    finer.stride[2] = finer.stride[1] * (int32_t)row->n[1];
    for (unsigned axis = 0; axis < 3; axis++)
        finer.size[axis] = (uint16_t)row->n[axis];
    void *to = row->wide ? (void *)wide_result : narrow_result;
    if (qv_downsample(to, row->wide ? sizeof wide_result : sizeof narrow_result, &finer,
                      filters[row->filter], domain, 0, 1) != QV_OK)
        vector_fail("downsample", "volume", "refused");
    for (unsigned c = 0; c < 4; c++)
        row->rgba[c] = row->wide ? wide_result[c] : narrow_result[c];
    for (unsigned i = 0; i < 8; i++)
        row->weight[i] = domain->weight((uint16_t)(row->channel[3][i] * (row->wide ? 1u : 257u)));
    return 0;
}

static void draw_size(uint64_t n[3], vector_random *random)
{
    static const uint8_t sizes[8][3] = {{2, 2, 2}, {2, 1, 1}, {8, 1, 1}, {4, 2, 1},
                                        {1, 3, 2}, {3, 1, 1}, {2, 1, 3}, {1, 5, 1}};
    const uint8_t *size = sizes[vector_bits(random, 3)];
    for (unsigned axis = 0; axis < 3; axis++)
        n[axis] = size[axis];
}

static void downsample_draw(void *columns, vector_random *random)
{
    downsample_row *row = columns;
    draw_size(row->n, random);
    row->filter = (uint64_t)vector_between(random, 0, 2);
    row->converted = vector_bits(random, 1);
    row->wide = vector_bits(random, 1);
    unsigned bits = row->wide ? 16 : 8;
    for (unsigned i = 0; i < 32; i++)
        row->channel[i / 8][i % 8] = vector_any(random, bits);
    if (vector_bits(random, 2) == 0)
        for (unsigned i = 0; i < 8; i++)
            row->channel[3][i] *= vector_bits(random, 1);
}

/* All full, none, one alone; by every filter, domain and width. */
static void downsample_edges(vector_set *set)
{
    for (unsigned i = 0; i < 3 * 2 * 2 * 4; i++) {
        downsample_row row = {
            .n = {2, 2, 2}, .filter = i % 3, .converted = i / 3 % 2, .wide = i / 6 % 2};
        uint64_t full = row.wide ? 65535 : 255;
        for (unsigned v = 0; v < 8; v++) {
            row.channel[0][v] = full;
            row.channel[1][v] = v % 2 ? full : 0;
            row.channel[2][v] = v == 3;
            row.channel[3][v] = i / 12 == 0 ? full : i / 12 == 1 ? 0 : v == 3 ? full : i / 12 - 2;
        }
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* The least weight that is not 0: what is added to it shows in the colours. */
static void downsample_added(vector_set *set)
{
    for (unsigned i = 0; i < 12; i++) {
        downsample_row row = {.n = {2, 2, 2}, .filter = i % 3, .converted = i / 3 % 2, .wide = 1};
        for (unsigned v = 0; v < 24; v++)
            row.channel[v / 8][v % 8] = 65535 - 7 * (v / 8);
        row.channel[3][i / 6 * 7] = 1;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field downsample_fields[] = {
    {"n", 3, 'i', "u4", "voxels on axis [i]; 8 in all at most"},
    {"filter", 1, 'i', "u2", "0 box of two, 1 box of four, 2 the third of section 34"},
    {"converted", 1, 'i', "u1", "0 averages what is stored, 1 the extinction of opacities"},
    {"wide", 1, 'i', "u1", "0: 8-bit storage, 1: 16-bit"},
    {"r", 8, 'i', "u16", "red of voxel [i], x fastest; those beyond n0 n1 n2 are not read"},
    {"g", 8, 'i', "u16", "green of voxel [i]"},
    {"b", 8, 'i', "u16", "blue of voxel [i]"},
    {"x", 8, 'i', "u16", "fourth channel of voxel [i]"},
    {"weight", 8, 'm', "u32", "of voxel [i]: x[i] as unorm16, or ext16 of it"},
    {"rgba", 4, 'o', "u16", "channel [i] of result (0, 0, 0), as stored"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_downsample = {
    .name = "downsample",
    .section = "34",
    .title = "a voxel of a coarser level",
    .rounding = "means to nearest, ties upwards",
    .saturation = "taps mirrored in the faces",
    .fields = downsample_fields,
    .columns = VECTOR_COLUMNS(downsample_row),
    .seed = 34,
    .random_rows = 250,
    .edges = downsample_edges,
    .added = downsample_added,
    .draw = downsample_draw,
    .compute = downsample_compute,
};

/* ---- Associated entries ----------------------------------------------------- */

typedef struct associate_row {
    uint64_t wide, rgba[4], associated[4];
} associate_row;

static unsigned associate_compute(void *columns)
{
    associate_row *row = columns;
    uint8_t narrow[4], result[4];
    uint16_t wide[4];
    for (unsigned c = 0; c < 4; c++) {
        narrow[c] = (uint8_t)row->rgba[c];
        wide[c] = (uint16_t)row->rgba[c];
    }
    qv_entries from = {.entries = narrow, .count = 1, .storage = QV_STORAGE_RGBA8};
    if (row->wide) {
        from.entries = (qv_address)wide;
        from.storage = QV_STORAGE_RGBA16;
    }
    from.unit_distance = QV_ONE_Q16;
    if (qv_opacity_to_associated(result, sizeof result, &from) != QV_OK)
        vector_fail("associate", "entry", "refused");
    for (unsigned c = 0; c < 4; c++)
        row->associated[c] = result[c];
    return 0;
}

static void associate_draw(void *columns, vector_random *random)
{
    associate_row *row = columns;
    row->wide = vector_bits(random, 1);
    for (unsigned c = 0; c < 4; c++)
        row->rgba[c] = vector_any(random, row->wide ? 16 : 8);
}

/* Products next to where 8 bits step: 16842495 v + 8421247 is the last that rounds to v. */
static void associate_edges(vector_set *set)
{
    for (uint64_t v = 0; v < 255; v += 5) {
        uint64_t a = 60000 + v, last = (16842495 * v + 8421247) / a;
        const associate_row row = {.wide = 1, .rgba = {last % 65536, (last + 1) % 65536, 65535, a}};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (uint64_t v = 0; v < 64; v++) {
        const associate_row row = {.rgba = {v * 4, 255 - v, 1, v % 4 ? 255 - v % 4 + 1 : v * 4}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Products that are the last to round down, 16842495 j + 8421247, or the first to round up. */
static void associate_added(vector_set *set)
{
    static const uint64_t factors[][2] = {{65096, 55757}, {60167, 55286}, {57938, 51599},
                                          {62981, 62443}, {62606, 62548}, {58384, 55532}};
    for (unsigned i = 0; i < sizeof factors / sizeof factors[0]; i++) {
        const associate_row row = {.wide = 1,
                                   .rgba = {factors[i][0], factors[i][0], 1, factors[i][1]}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field associate_fields[] = {
    {"wide", 1, 'i', "u1", "0 of rgba8, 1 of rgba16"},
    {"rgba", 4, 'i', "u16", "channel [i]"},
    {"associated0", 1, 'o', "unorm8",
     "div255(rgba0 * rgba3), or floor((rgba0 * rgba3 + 8421247) / 16842495) where wide = 1"},
    {"associated1", 1, 'o', "unorm8", "the same of rgba1"},
    {"associated2", 1, 'o', "unorm8", "the same of rgba2"},
    {"associated3", 1, 'o', "unorm8", "rgba3, or to8(rgba3) where wide = 1"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_associate = {
    .name = "associate",
    .section = "69",
    .title = "an associated entry",
    .rounding = "to nearest; there are no ties",
    .saturation = "none",
    .fields = associate_fields,
    .columns = VECTOR_COLUMNS(associate_row),
    .seed = 69,
    .random_rows = 150,
    .edges = associate_edges,
    .added = associate_added,
    .draw = associate_draw,
    .compute = associate_compute,
};
