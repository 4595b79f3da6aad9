/*
 * stages_picture.c - whole pictures of small volumes, as checksums of their rows: sections 1 to 18
 * and 36 to 43.
 */
#include "stages.h"

#include "crc32.h"
#include "qvol.h"

#include <string.h>

enum { SIDE = 8, ROW_BYTES = 4 * SIDE };

typedef struct picture_row {
    uint64_t n[3], channel[4][8], wide, mode, back, spacing[3], unit, azimuth, elevation, roll;
    uint64_t field, pitch, step, phase, threshold, background[4], width, height, format;
    uint64_t samples, skipped, terminated, crc[SIDE], picture;
} picture_row;

#define MODE(name)                                                                                 \
    {                                                                                              \
        {&qv_##name##_rgba8, &qv_##name##_rgba8_back_to_front},                                    \
        {                                                                                          \
            &qv_##name##_rgba16, &qv_##name##_rgba16_back_to_front                                 \
        }                                                                                          \
    }

enum { MODES = 7, LENGTH_MODES = 3, FORMATS = 9 };

static const qv_sampling *const modes[MODES][2][2] = {
    MODE(nearest),    MODE(separate),         MODE(weighted),          MODE(corrected),
    MODE(extinction), MODE(bspline_weighted), MODE(bspline_extinction)};

static const qv_format *const formats[FORMATS] = {
    &qv_format_rgba8888,  &qv_format_bgra8888,        &qv_format_rgb888,
    &qv_format_rgb565_le, &qv_format_rgb565_be,       &qv_format_l8,
    &qv_format_grey4,     &qv_format_mono_horizontal, &qv_format_mono_vertical};

typedef struct voxels {
    uint8_t narrow[8][4];
    uint16_t wide[8][4];
} voxels;

static void set_volume(qv_volume *volume, voxels *at, const picture_row *row)
{
    const int32_t bytes = row->wide ? 8 : 4;
    for (unsigned i = 0; i < 32; i++) {
        at->narrow[i % 8][i / 8] = (uint8_t)row->channel[i / 8][i % 8];
        at->wide[i % 8][i / 8] = (uint16_t)row->channel[i / 8][i % 8];
    }
    volume->voxels = row->wide ? (qv_address)at->wide : at->narrow[0];
    volume->voxels_bytes = 8u * (uint32_t)bytes;
    volume->storage = row->wide ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
    volume->unit_distance = (uint32_t)row->unit;
    for (unsigned axis = 0; axis < 3; axis++) {
        volume->size[axis] = (uint16_t)row->n[axis];
        volume->spacing[axis] = (uint32_t)row->spacing[axis];
    }
    volume->stride[0] = bytes;
    volume->stride[1] = bytes * (int32_t)row->n[0];
    volume->stride[2] = volume->stride[1] * (int32_t)row->n[1];
}

static qv_status set_scene(qv_scene *scene, const picture_row *row)
{
    qv_view view = {.pitch = (uint32_t)row->pitch,
                    .step = (uint32_t)row->step,
                    .width = (uint16_t)row->width,
                    .height = (uint16_t)row->height};
    qv_rotation(view.rotation, (uint32_t)row->azimuth, (uint32_t)row->elevation,
                (uint32_t)row->roll);
    scene->sampling = modes[row->mode][row->wide][row->back];
    scene->phase = (uint16_t)row->phase;
    scene->termination = (uint16_t)row->threshold;
    for (unsigned c = 0; c < 4; c++)
        scene->background[c] = (uint8_t)row->background[c];
    if (row->field == 0)
        return qv_orthographic(&scene->camera, &scene->volume, &view);
    return qv_perspective(&scene->camera, &scene->volume, &view, (uint32_t)row->field);
}

static void render(uint8_t pixels[SIDE][ROW_BYTES], picture_row *row)
{
    voxels at;
    qv_context context;
    qv_progress progress = {0, 0, 0, 0, 0};
    qv_scene scene = {.phase = 0};
    const qv_rect rect = {0, 0, (int32_t)row->width, (int32_t)row->height};
    const qv_image image = {pixels, SIDE * ROW_BYTES, ROW_BYTES, formats[row->format]};
    set_volume(&scene.volume, &at, row);
    if (set_scene(&scene, row) != QV_OK || qv_init(&context, &scene) != QV_OK ||
        qv_render_some(&image, &progress, &context, &rect, UINT32_MAX) != QV_OK)
        vector_fail("picture", "scene", "refused");
    row->samples = progress.samples;
    row->skipped = progress.skipped;
    row->terminated = progress.terminated;
}

/* Rows of bytes: of mono_vertical, eight lines are one. */
static unsigned picture_compute(void *columns)
{
    picture_row *row = columns;
    const qv_format *format = formats[row->format];
    const size_t bytes = qv_row_bytes(format, (uint16_t)row->width);
    const uint64_t rows = format->line_shift != 0 ? 1 : row->height;
    uint8_t pixels[SIDE][ROW_BYTES];
    uint32_t picture = 0;
    memset(pixels, 0, sizeof pixels);
    render(pixels, row);
    for (unsigned i = 0; i < rows; i++) {
        row->crc[i] = crc32_update(0, pixels[i], bytes);
        picture = crc32_update(picture, pixels[i], bytes);
    }
    row->picture = picture;
    return 0;
}

static void draw_voxels(picture_row *row, vector_random *random)
{
    const unsigned bits = row->wide ? 16 : 8;
    for (unsigned axis = 0; axis < 3; axis++) {
        row->n[axis] = vector_bits(random, 2) ? 2 : 1;
        row->spacing[axis] = vector_bits(random, 1) ? 65536 : 43691;
    }
    for (unsigned i = 0; i < 32; i++)
        row->channel[i / 8][i % 8] = vector_bits(random, bits);
    for (unsigned v = 0; v < 8; v++)
        if (vector_bits(random, 2) == 0)
            row->channel[3][v] = vector_bits(random, 1) ? ((uint64_t)1 << bits) - 1u : 0;
}

static void picture_draw(void *columns, vector_random *random)
{
    picture_row *row = columns;
    row->wide = vector_bits(random, 1);
    row->mode = (uint64_t)vector_between(random, 0, MODES - 1);
    row->back = vector_bits(random, 1);
    draw_voxels(row, random);
    row->azimuth = vector_bits(random, 32);
    row->elevation = vector_bits(random, 32);
    row->roll = vector_bits(random, 32);
    row->field = vector_bits(random, 1) ? (uint64_t)vector_between(random, 1 << 28, 1 << 30) : 0;
    row->pitch = (uint64_t)vector_between(random, 16384, 65536);
    row->step = (uint64_t)vector_between(random, 16384, 98304);
    row->unit = row->mode >= LENGTH_MODES && vector_bits(random, 1) ? 65536 : 0;
    row->phase = vector_bits(random, 16);
    row->threshold = vector_bits(random, 1) ? 64 : vector_bits(random, 14);
    for (unsigned c = 0; c < 4; c++)
        row->background[c] = vector_any(random, 8);
    row->width = (uint64_t)vector_between(random, 1, SIDE);
    row->height = (uint64_t)vector_between(random, 1, SIDE);
    row->format = (uint64_t)vector_between(random, 0, FORMATS - 1);
}

/* Each mode and format once, looked at along an axis. */
static void picture_edges(vector_set *set)
{
    for (unsigned i = 0; i < MODES * FORMATS; i++) {
        picture_row row = {.n = {2, 2, 2},
                           .mode = i % MODES,
                           .back = i % 2,
                           .spacing = {65536, 65536, 65536},
                           .azimuth = (uint64_t)(i % 4) << 30,
                           .pitch = 16384,
                           .step = 32768,
                           .width = SIDE,
                           .height = SIDE,
                           .format = i / MODES};
        for (unsigned v = 0; v < 8; v++) {
            row.channel[0][v] = v & 1u ? 255 : 0;
            row.channel[1][v] = v & 2u ? 255 : 0;
            row.channel[2][v] = v & 4u ? 255 : 0;
            row.channel[3][v] = 64 + 16 * (v & 1u) + 16 * (v & 2u) + 16 * (v & 4u);
        }
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Opaque voxels and a threshold of 0, that transmittance just meets; in the modes by length, a way
   that ends where a piece does. */
static void picture_added(vector_set *set)
{
    for (unsigned i = 0; i < 2 * MODES; i++) {
        picture_row row = {.n = {2, 2, 2},
                           .wide = i / MODES,
                           .mode = i % MODES,
                           .spacing = {65536, 65536, 65536},
                           .azimuth = (uint64_t)(i % 4) << 30,
                           .pitch = 32768,
                           .step = 32768,
                           .phase = 32768,
                           .width = SIDE,
                           .height = SIDE};
        for (unsigned v = 0; v < 8; v++) {
            row.channel[0][v] = 25 * v;
            row.channel[3][v] = row.wide ? 65535 : 255;
        }
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field picture_fields[] = {
    {"n", 3, 'i', "u2", "voxels on axis [i], 1 or 2"},
    {"r", 8, 'i', "u16", "red of voxel [i], x fastest; those beyond n0 n1 n2 are not read"},
    {"g", 8, 'i', "u16", "green of voxel [i]"},
    {"b", 8, 'i', "u16", "blue of voxel [i]"},
    {"a", 8, 'i', "u16", "opacity of voxel [i]"},
    {"wide", 1, 'i', "u1", "0 rgba8, 1 rgba16"},
    {"mode", 1, 'i', "u3",
     "0 nearest, 1 separate, 2 weighted, 3 corrected, 4 extinction, 5 bspline_weighted, 6 "
     "bspline_extinction"},
    {"back", 1, 'i', "u1", "0 front to back, 1 back to front"},
    {"spacing", 3, 'i', "u32.16", "of axis [i]"},
    {"unit", 1, 'i', "u32.16", "U; 0: the step"},
    {"azimuth", 1, 'i', "u32.32", "2^32 is a full turn"},
    {"elevation", 1, 'i', "u32.32", "2^32 is a full turn"},
    {"roll", 1, 'i', "u32.32", "2^32 is a full turn"},
    {"field", 1, 'i', "u32.32", "field of view F; 0: orthographic"},
    {"pitch", 1, 'i', "u32.16", "of the view"},
    {"step", 1, 'i', "u32.16", "of the view"},
    {"phase", 1, 'i', "u16.16", "of the sample grid"},
    {"threshold", 1, 'i', "u16.16", "of termination"},
    {"background", 4, 'i', "unorm8", "B[[i]] of section 16"},
    {"width", 1, 'i', "u4", "pixels, at most 8; the whole frame is drawn"},
    {"height", 1, 'i', "u4", "lines, at most 8"},
    {"format", 1, 'i', "u4",
     "0 rgba8888, 1 bgra8888, 2 rgb888, 3 rgb565_le, 4 rgb565_be, 5 l8, 6 grey4, 7 "
     "mono_horizontal, 8 mono_vertical"},
    {"samples", 1, 'm', "u32", "that all rays took"},
    {"skipped", 1, 'm', "u32", "those of them that were skipped"},
    {"terminated", 1, 'm', "u32", "rays that were terminated"},
    {"crc", SIDE, 'o', "u32",
     "CRC-32 of section 25, of the bytes of row [i] alone; 0 beyond the picture; bits that belong "
     "to no pixel are 0"},
    {"picture", 1, 'o', "u32", "CRC-32 of all rows, one after another"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_picture = {
    .name = "picture",
    .section = "3 to 18, 36 to 43",
    .title = "whole pictures: checksums of rows",
    .rounding = "as in each stage",
    .saturation = "as in each stage",
    .fields = picture_fields,
    .columns = VECTOR_COLUMNS(picture_row),
    .seed = 18,
    .random_rows = 300,
    .edges = picture_edges,
    .added = picture_added,
    .draw = picture_draw,
    .compute = picture_compute,
};
