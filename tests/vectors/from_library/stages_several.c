/*
 * stages_several.c - several elements in one call, where one leads to the next: sections 17, 19, 34
 * and 69.
 */
#include "stages.h"

#include "crc32.h"
#include "composite.h"
#include "pixels.h"
#include "qvol.h"

#include <string.h>

/* ---- A line of pixels ------------------------------------------------------- */

enum { PIXELS = 12, FORMATS = 9, LINE_BYTES = 4 * PIXELS };

typedef struct line_row {
    uint64_t y, channel[4][PIXELS], crc[FORMATS];
} line_row;

static const qv_format *const formats[FORMATS] = {
    &qv_format_rgba8888,  &qv_format_bgra8888,        &qv_format_rgb888,
    &qv_format_rgb565_le, &qv_format_rgb565_be,       &qv_format_l8,
    &qv_format_grey4,     &qv_format_mono_horizontal, &qv_format_mono_vertical};

/* White pixels, all bits of which the line replaces. */
static void fill(uint8_t bytes[LINE_BYTES], const qv_format *format, uint32_t y)
{
    const uint32_t white = QV_LEVEL_ONE;
    memset(bytes, 0, LINE_BYTES);
    for (uint32_t x = 0; x < PIXELS; x++) {
        const qv_pixel pixel = {{white, white, white, white}, x, y};
        format->store(bytes, x, y, &pixel);
    }
}

static unsigned line_compute(void *columns)
{
    line_row *row = columns;
    const uint32_t y = (uint32_t)row->y;
    for (unsigned i = 0; i < FORMATS; i++) {
        uint8_t bytes[LINE_BYTES];
        fill(bytes, formats[i], y);
        for (uint32_t x = 0; x < PIXELS; x++) {
            qv_pixel pixel = {{0, 0, 0, 0}, x, y};
            for (unsigned c = 0; c < 4; c++)
                pixel.channel[c] = (uint32_t)row->channel[c][x];
            formats[i]->store(bytes, x, y, &pixel);
        }
        row->crc[i] = crc32_update(0, bytes, qv_row_bytes(formats[i], PIXELS));
    }
    return 0;
}

static void line_draw(void *columns, vector_random *random)
{
    line_row *row = columns;
    row->y = vector_bits(random, 3);
    for (unsigned i = 0; i < PIXELS; i++) {
        row->channel[3][i] = vector_any(random, 24) % (QV_LEVEL_ONE + 1u);
        for (unsigned c = 0; c < 3; c++)
            row->channel[c][i] = vector_any(random, 24) % (row->channel[3][i] + 1u);
    }
}

/* One white pixel, each in turn: where it lies is all that shows. */
static void line_edges(vector_set *set)
{
    for (unsigned i = 0; i < 2 * PIXELS; i++) {
        line_row row = {.y = i / PIXELS * 7};
        for (unsigned c = 0; c < 4; c++)
            row.channel[c][i % PIXELS] = QV_LEVEL_ONE;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field line_fields[] = {
    {"y", 1, 'i', "u3", "the line; columns are 0 .. 11"},
    {"r", PIXELS, 'i', "u24.16", "red of pixel [i]: levels, at most 16711680"},
    {"g", PIXELS, 'i', "u24.16", "green of pixel [i]"},
    {"b", PIXELS, 'i', "u24.16", "blue of pixel [i]"},
    {"a", PIXELS, 'i', "u24.16", "opacity of pixel [i]"},
    {"crc", FORMATS, 'o', "u32",
     "CRC-32 of section 25, of the line's bytes in format [i] of the stage picture; bits that "
     "belong to no pixel are 0"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_line = {
    .name = "line",
    .section = "17",
    .title = "a line of pixels: its checksum in each format",
    .rounding = "as in the stage pixel",
    .saturation = "none",
    .fields = line_fields,
    .columns = VECTOR_COLUMNS(line_row),
    .seed = 1712,
    .random_rows = 40,
    .edges = line_edges,
    .draw = line_draw,
    .compute = line_compute,
};

/* ---- A palette -------------------------------------------------------------- */

enum { POINTS = 3 };

typedef struct palette_row {
    uint64_t index[POINTS], channel[4][POINTS], entry, rgba16[4], rgba8[4];
} palette_row;

static unsigned palette_compute(void *columns)
{
    palette_row *row = columns;
    qv_control_point points[POINTS];
    qv_transfer table;
    uint8_t narrow[QV_PALETTE_ENTRIES][4];
    for (unsigned i = 0; i < POINTS; i++) {
        points[i].index = (uint8_t)row->index[i];
        for (unsigned c = 0; c < 4; c++)
            points[i].rgba[c] = (uint16_t)row->channel[c][i];
    }
    if (qv_transfer_build(&table, points, POINTS) != QV_OK)
        vector_fail("palette", "points", "refused");
    qv_transfer_to_palette8(narrow, &table);
    for (unsigned c = 0; c < 4; c++) {
        row->rgba16[c] = table.rgba[row->entry][c];
        row->rgba8[c] = narrow[row->entry][c];
    }
    return row->entry < row->index[0] || row->entry > row->index[2] ? VECTOR_SATURATE : 0;
}

static void draw_colours(palette_row *row, vector_random *random)
{
    for (unsigned i = 0; i < 4 * POINTS; i++)
        row->channel[i / POINTS][i % POINTS] = vector_any(random, 16);
}

static void palette_draw(void *columns, vector_random *random)
{
    palette_row *row = columns;
    row->index[0] = (uint64_t)vector_between(random, 0, 100);
    row->index[1] = (uint64_t)vector_between(random, (int64_t)row->index[0] + 1, 180);
    row->index[2] = (uint64_t)vector_between(random, (int64_t)row->index[1] + 1, 255);
    row->entry = vector_bits(random, 8);
    draw_colours(row, random);
}

/* The ends of the table and of what lies between points. */
static void palette_edges(vector_set *set)
{
    static const uint64_t entries[] = {0, 1, 9, 10, 11, 99, 100, 101, 199, 200, 201, 255};
    vector_random random = {19};
    for (unsigned i = 0; i < 24; i++) {
        palette_row row = {.index = {i < 12 ? 10 : 0, 100, i < 12 ? 200 : 255},
                           .entry = entries[i % 12]};
        draw_colours(&row, &random);
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field palette_fields[] = {
    {"index", POINTS, 'i', "u8", "of control point [i], rising"},
    {"r", POINTS, 'i', "unorm16", "red of control point [i]"},
    {"g", POINTS, 'i', "unorm16", "green of control point [i]"},
    {"b", POINTS, 'i', "unorm16", "blue of control point [i]"},
    {"a", POINTS, 'i', "unorm16", "opacity of control point [i]"},
    {"entry", 1, 'i', "u8", "of the table"},
    {"rgba16", 4, 'o', "unorm16",
     "channel [i], between the two points about the entry as in the stage transfer"},
    {"rgba8", 4, 'o', "unorm8", "to8(rgba16[i])"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_palette = {
    .name = "palette",
    .section = "19",
    .title = "an entry of a transfer table of three control points",
    .rounding = "to nearest, ties upwards",
    .saturation = "beyond the points",
    .fields = palette_fields,
    .columns = VECTOR_COLUMNS(palette_row),
    .seed = 1903,
    .random_rows = 100,
    .edges = palette_edges,
    .draw = palette_draw,
    .compute = palette_compute,
};

/* ---- A coarser level -------------------------------------------------------- */

enum { VOXELS = 8, RESULTS = 4 };

typedef struct coarser_row {
    uint64_t n[3], filter, converted, channel[4][VOXELS], result[4][RESULTS];
} coarser_row;

static unsigned coarser_compute(void *columns)
{
    static const qv_filter *const filters[3] = {&qv_filter_box2, &qv_filter_box4, &qv_filter_quad4};
    coarser_row *row = columns;
    uint16_t voxels[VOXELS][4], results[RESULTS][4];
    const void *from = voxels;
    const int32_t bytes = sizeof voxels[0];
    const qv_volume finer = {
        .voxels = from,
        .voxels_bytes = sizeof voxels,
        .storage = QV_STORAGE_RGBA16,
        .stride = {bytes, bytes * (int32_t)row->n[0], bytes * (int32_t)(row->n[0] * row->n[1])},
        .size = {(uint16_t)row->n[0], (uint16_t)row->n[1], (uint16_t)row->n[2]}};
    memset(results, 0, sizeof results);
    for (unsigned i = 0; i < 4 * VOXELS; i++)
        voxels[i % VOXELS][i / VOXELS] = (uint16_t)row->channel[i / VOXELS][i % VOXELS];
    if (qv_downsample(results, sizeof results, &finer, filters[row->filter],
                      row->converted ? &qv_domain_extinction : &qv_domain_stored, 0,
                      (uint16_t)((row->n[2] + 1u) / 2u)) != QV_OK)
        vector_fail("coarser", "volume", "refused");
    for (unsigned i = 0; i < 4 * RESULTS; i++)
        row->result[i / RESULTS][i % RESULTS] = results[i % RESULTS][i / RESULTS];
    return 0;
}

/* Volumes of at most eight voxels, of which the coarser level has two or more. */
static void set_size(coarser_row *row, unsigned number)
{
    static const uint8_t sizes[8][3] = {{8, 1, 1}, {1, 8, 1}, {1, 1, 8}, {4, 1, 2},
                                        {3, 1, 1}, {1, 5, 1}, {2, 1, 4}, {1, 3, 2}};
    for (unsigned axis = 0; axis < 3; axis++)
        row->n[axis] = sizes[number][axis];
}

static void coarser_draw(void *columns, vector_random *random)
{
    coarser_row *row = columns;
    set_size(row, (unsigned)vector_bits(random, 3));
    row->filter = (uint64_t)vector_between(random, 0, 2);
    row->converted = vector_bits(random, 1);
    for (unsigned i = 0; i < 4 * VOXELS; i++)
        row->channel[i / VOXELS][i % VOXELS] = vector_any(random, 16);
}

/* One voxel with weight, each in turn. */
static void coarser_edges(vector_set *set)
{
    for (unsigned i = 0; i < 3 * VOXELS; i++) {
        coarser_row row = {.filter = 2, .converted = i % 2};
        set_size(&row, i / VOXELS);
        for (unsigned v = 0; v < VOXELS; v++)
            row.channel[0][v] = row.channel[1][v] = 65535 - v;
        row.channel[3][i % VOXELS] = i % 4 ? 65535 : 1;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field coarser_fields[] = {
    {"n", 3, 'i', "u4", "voxels on axis [i]; 8 in all at most"},
    {"filter", 1, 'i', "u2", "0 box of two, 1 box of four, 2 the third of section 34"},
    {"converted", 1, 'i', "u1", "0 averages what is stored, 1 the extinction of opacities"},
    {"r", VOXELS, 'i', "u16", "red of voxel [i], x fastest; those beyond n0 n1 n2 are not read"},
    {"g", VOXELS, 'i', "u16", "green of voxel [i]"},
    {"b", VOXELS, 'i', "u16", "blue of voxel [i]"},
    {"x", VOXELS, 'i', "u16", "fourth channel of voxel [i], 16-bit storage"},
    {"cr", RESULTS, 'o', "u16",
     "red of voxel [i] of the coarser level, x fastest; 0 where it has no such voxel"},
    {"cg", RESULTS, 'o', "u16", "its green"},
    {"cb", RESULTS, 'o', "u16", "its blue"},
    {"cx", RESULTS, 'o', "u16", "its fourth channel"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_coarser = {
    .name = "coarser",
    .section = "34",
    .title = "all voxels of a coarser level",
    .rounding = "means to nearest, ties upwards",
    .saturation = "taps mirrored in the faces",
    .fields = coarser_fields,
    .columns = VECTOR_COLUMNS(coarser_row),
    .seed = 3404,
    .random_rows = 100,
    .edges = coarser_edges,
    .draw = coarser_draw,
    .compute = coarser_compute,
};

/* ---- A list of associated entries ------------------------------------------- */

enum { ENTRIES = 3 };

typedef struct associated_row {
    uint64_t wide, channel[4][ENTRIES], result[4][ENTRIES];
} associated_row;

static unsigned associated_compute(void *columns)
{
    associated_row *row = columns;
    uint8_t narrow[ENTRIES][4], result[ENTRIES][4];
    uint16_t wide[ENTRIES][4];
    const void *from = row->wide ? (const void *)wide : narrow;
    for (unsigned i = 0; i < 4 * ENTRIES; i++) {
        narrow[i % ENTRIES][i / ENTRIES] = (uint8_t)row->channel[i / ENTRIES][i % ENTRIES];
        wide[i % ENTRIES][i / ENTRIES] = (uint16_t)row->channel[i / ENTRIES][i % ENTRIES];
    }
    const qv_entries entries = {.entries = from,
                                .count = ENTRIES,
                                .unit_distance = QV_ONE_Q16,
                                .storage = row->wide ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8};
    memset(result, 0, sizeof result);
    if (qv_opacity_to_associated(result, sizeof result, &entries) != QV_OK)
        vector_fail("associated", "entries", "refused");
    for (unsigned i = 0; i < 4 * ENTRIES; i++)
        row->result[i / ENTRIES][i % ENTRIES] = result[i % ENTRIES][i / ENTRIES];
    return 0;
}

static void associated_draw(void *columns, vector_random *random)
{
    associated_row *row = columns;
    row->wide = vector_bits(random, 1);
    for (unsigned i = 0; i < 4 * ENTRIES; i++)
        row->channel[i / ENTRIES][i % ENTRIES] = vector_any(random, row->wide ? 16 : 8);
}

/* One channel that is full, each in turn, among opaque entries. */
static void associated_edges(vector_set *set)
{
    for (unsigned i = 0; i < 2 * 3 * ENTRIES; i++) {
        associated_row row = {.wide = i % 2};
        const uint64_t full = row.wide ? 65535 : 255;
        for (unsigned e = 0; e < ENTRIES; e++)
            row.channel[3][e] = full;
        row.channel[i / 2 / ENTRIES][i / 2 % ENTRIES] = full;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field associated_fields[] = {
    {"wide", 1, 'i', "u1", "0 of rgba8, 1 of rgba16"},
    {"r", ENTRIES, 'i', "u16", "red of entry [i]"},
    {"g", ENTRIES, 'i', "u16", "green of entry [i]"},
    {"b", ENTRIES, 'i', "u16", "blue of entry [i]"},
    {"a", ENTRIES, 'i', "u16", "opacity of entry [i]"},
    {"ar", ENTRIES, 'o', "unorm8", "red of associated entry [i], as in the stage associate"},
    {"ag", ENTRIES, 'o', "unorm8", "its green"},
    {"ab", ENTRIES, 'o', "unorm8", "its blue"},
    {"aa", ENTRIES, 'o', "unorm8", "its opacity"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_associated = {
    .name = "associated",
    .section = "69",
    .title = "associated entries, one after another",
    .rounding = "to nearest; there are no ties",
    .saturation = "none",
    .fields = associated_fields,
    .columns = VECTOR_COLUMNS(associated_row),
    .seed = 6903,
    .random_rows = 60,
    .edges = associated_edges,
    .draw = associated_draw,
    .compute = associated_compute,
};
