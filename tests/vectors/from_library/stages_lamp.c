/*
 * stages_lamp.c - FreeVoxels of a whole volume, and their light: sections 62, 63, 65 and 68.
 */
#include "stages.h"

#include "bearing.h"
#include "direction.h"
#include "lighting.h"

#include <string.h>

/* ---- Attenuation of a volume ------------------------------------------------ */

enum { VOXELS = 12, BLOCKS = 6, LEVEL_2 = 3 };

typedef struct attenuate_row {
    uint64_t n[3], stored, unit, extinction, spacing[3], direction, x[VOXELS];
    uint64_t length, byte[VOXELS], block[BLOCKS], level1[BLOCKS], level2[LEVEL_2];
} attenuate_row;

static void set_volume(qv_volume *volume, uint16_t voxels[VOXELS][4], const attenuate_row *row)
{
    memset(voxels, 0, VOXELS * sizeof voxels[0]);
    for (unsigned i = 0; i < VOXELS; i++)
        voxels[i][3] = (uint16_t)row->x[i];
    volume->voxels = (qv_address)voxels;
    volume->voxels_bytes = VOXELS * sizeof voxels[0];
    volume->storage = row->stored ? QV_STORAGE_RGBT16 : QV_STORAGE_RGBA16;
    volume->unit_distance = (uint32_t)row->unit;
    volume->extinction = (uint32_t)row->extinction;
    for (unsigned axis = 0; axis < 3; axis++) {
        volume->size[axis] = (uint16_t)row->n[axis];
        volume->spacing[axis] = (uint32_t)row->spacing[axis];
    }
    volume->stride[0] = 8;
    volume->stride[1] = 8 * (int32_t)row->n[0];
    volume->stride[2] = volume->stride[1] * (int32_t)row->n[1];
}

/* The bytes of a coarser level; 0 where the size has none. */
static void make_level(uint64_t *bytes, unsigned count, const attenuate_row *row,
                       const uint32_t *blocks, unsigned level)
{
    uint8_t made[BLOCKS] = {0};
    uint16_t size[3];
    qv_attenuation attenuation = {.directions = (uint32_t)1 << row->direction};
    for (unsigned axis = 0; axis < 3; axis++) {
        size[axis] = (uint16_t)row->n[axis];
        attenuation.size[axis] = (uint16_t)((size[axis] + (1u << level) - 1u) >> level);
    }
    if (qv_pyramid_levels(size) < level)
        return;
    if (qv_attenuate_level(made, sizeof made, &attenuation, blocks, size, (uint8_t)level,
                           (uint8_t)row->direction) != QV_OK)
        vector_fail("attenuate", "level", "refused");
    for (unsigned i = 0; i < count; i++)
        bytes[i] = made[i];
}

static unsigned attenuate_compute(void *columns)
{
    attenuate_row *row = columns;
    const qv_domain *domain = row->stored ? &qv_domain_stored : &qv_domain_extinction;
    qv_attenuation attenuation = {.directions = (uint32_t)1 << row->direction};
    uint16_t voxels[VOXELS][4];
    uint8_t bytes[VOXELS] = {0};
    uint32_t blocks[BLOCKS] = {0};
    qv_volume volume = {.storage = 0};
    set_volume(&volume, voxels, row);
    for (unsigned axis = 0; axis < 3; axis++)
        attenuation.size[axis] = volume.size[axis];
    if (qv_attenuate(bytes, sizeof bytes, blocks, &attenuation, &volume, domain,
                     (uint8_t)row->direction) != QV_OK)
        vector_fail("attenuate", "volume", "refused");
    row->length = qv_direction_length(volume.spacing, (uint8_t)row->direction);
    for (unsigned i = 0; i < VOXELS; i++)
        row->byte[i] = bytes[i];
    for (unsigned i = 0; i < BLOCKS; i++)
        row->block[i] = blocks[i];
    make_level(row->level1, BLOCKS, row, blocks, 1);
    make_level(row->level2, LEVEL_2, row, blocks, 2);
    return 0;
}

static const uint8_t sizes[8][3] = {{3, 2, 2},  {2, 2, 3}, {12, 1, 1}, {1, 4, 3},
                                    {1, 1, 11}, {2, 3, 2}, {1, 1, 1},  {1, 9, 1}};

static void attenuate_draw(void *columns, vector_random *random)
{
    attenuate_row *row = columns;
    const uint8_t *size = sizes[vector_bits(random, 3)];
    const unsigned bits = (unsigned)vector_between(random, 9, 16);
    for (unsigned axis = 0; axis < 3; axis++) {
        row->n[axis] = size[axis];
        row->spacing[axis] = (uint64_t)vector_between(random, 32768, 131072);
    }
    row->stored = vector_bits(random, 1);
    row->unit = vector_bits(random, 2) ? (uint64_t)vector_between(random, 1 << 14, 1 << 18) : 0;
    row->extinction = (uint64_t)vector_between(random, 1 << 12, 1 << 19);
    row->direction = (uint64_t)vector_between(random, 0, 25);
    for (unsigned i = 0; i < VOXELS; i++)
        row->x[i] = vector_bits(random, 2) ? vector_bits(random, bits) : 0;
}

/* S103: every direction, and other sizes. */
static void attenuate_edges(vector_set *set)
{
    static const uint16_t opacities[VOXELS] = {0, 13107, 65535, 4660, 22136, 30000,
                                               1, 32768, 50000, 600,  40000, 9000};
    for (unsigned i = 0; i < 26 + 8; i++) {
        attenuate_row row = {.unit = i % 3 ? 81920 : 0,
                             .extinction = 65536,
                             .spacing = {65536, 98304, 43691},
                             .direction = i % 26};
        for (unsigned axis = 0; axis < 3; axis++)
            row.n[axis] = sizes[i < 26 ? 0 : i - 26][axis];
        for (unsigned v = 0; v < VOXELS; v++)
            row.x[v] = opacities[v];
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field attenuate_fields[] = {
    {"n", 3, 'i', "u4", "voxels on axis [i]; 12 in all at most"},
    {"stored", 1, 'i', "u1", "0: opacities, 1: stored extinction"},
    {"unit", 1, 'i', "u32.16", "U, of opacities; may be 0"},
    {"extinction", 1, 'i', "u32.16", "E, of stored extinction"},
    {"spacing", 3, 'i', "u32.16", "of axis [i]"},
    {"direction", 1, 'i', "u5", "0 .. 25"},
    {"x", VOXELS, 'i', "unorm16",
     "fourth channel of voxel [i], x fastest; those beyond are not read"},
    {"length", 1, 'm', "u32.23", "L of the direction, section 62"},
    {"byte", VOXELS, 'o', "u8", "of voxel [i]; 0 beyond n0 n1 n2"},
    {"block", BLOCKS, 'm', "u32.22", "B of block [i], section 63; 0 beyond"},
    {"level1", BLOCKS, 'o', "u8",
     "byte of voxel [i] of level 1; 0 beyond, or without such a level"},
    {"level2", LEVEL_2, 'o', "u8", "byte of voxel [i] of level 2, likewise"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_attenuate = {
    .name = "attenuate",
    .section = "62, 63",
    .title = "a small volume's bytes of attenuation in one direction, and of its levels",
    .rounding = "depths are cut; sums, means and bytes to nearest, ties upwards",
    .saturation = "bytes are 0 from depth 9 on; no depth counts as more than 64 in blocks",
    .fields = attenuate_fields,
    .columns = VECTOR_COLUMNS(attenuate_row),
    .seed = 6263,
    .random_rows = 300,
    .edges = attenuate_edges,
    .draw = attenuate_draw,
    .compute = attenuate_compute,
};

/* ---- Light of lamps --------------------------------------------------------- */

typedef struct lamp_row {
    uint64_t spacing[3], unit, interpolation, byte[QV_DIRECTIONS], eye, count;
    int64_t direction[2][3];
    uint64_t colour[2][3], ambient[3], rgb[3];
    uint64_t transmittance[2], inside, lit[3];
} lamp_row;

static void set_lighting(qv_lighting *lighting, const lamp_row *row)
{
    memset(lighting, 0, sizeof *lighting);
    lighting->count = (uint8_t)row->count;
    for (unsigned c = 0; c < 3; c++) {
        lighting->ambient[c] = (uint16_t)row->ambient[c];
        for (unsigned lamp = 0; lamp < 2; lamp++) {
            lighting->lamps[lamp].direction[c] = (int16_t)row->direction[lamp][c];
            lighting->lamps[lamp].colour[c] = (uint16_t)row->colour[lamp][c];
        }
    }
}

static unsigned lamp_compute(void *columns)
{
    lamp_row *row = columns;
    qv_compass compass;
    qv_bearing bearing[QV_LAMPS_MAX];
    qv_lighting lighting;
    fx_unorm16 rgb[3];
    uint8_t bytes[QV_DIRECTIONS], eye[QV_DIRECTIONS];
    qv_volume volume = {.storage = QV_STORAGE_RGBA16, .unit_distance = (uint32_t)row->unit};
    for (unsigned c = 0; c < 3; c++) {
        volume.spacing[c] = (uint32_t)row->spacing[c];
        rgb[c] = (fx_unorm16)row->rgb[c];
    }
    for (unsigned d = 0; d < QV_DIRECTIONS; d++) {
        bytes[d] = (uint8_t)row->byte[d];
        eye[d] = (uint8_t)row->eye;
    }
    set_lighting(&lighting, row);
    qv_compass_of(&compass, &volume, QV_DIRECTIONS_ALL, (uint8_t)row->interpolation);
    if (qv_lighting_check(&lighting) != QV_OK ||
        qv_lighting_bearings(bearing, &lighting, &compass, volume.spacing) != QV_OK)
        vector_fail("lamp", "lamps", "refused");
    for (unsigned lamp = 0; lamp < row->count; lamp++)
        row->transmittance[lamp] = qv_bearing_transmittance(&bearing[lamp], bytes, 0);
    if (row->count != 0)
        row->inside = qv_bearing_transmittance(&bearing[0], bytes, eye);
    qv_lighting_colour(rgb, &lighting, bearing, bytes);
    for (unsigned c = 0; c < 3; c++)
        row->lit[c] = rgb[c];
    return 0;
}

static void lamp_draw(void *columns, vector_random *random)
{
    lamp_row *row = columns;
    const unsigned bits = (unsigned)vector_between(random, 1, 16);
    row->interpolation = (uint64_t)vector_between(random, 0, 2);
    row->unit = vector_bits(random, 2) ? 65536 : 0;
    row->count = (uint64_t)vector_between(random, 1, 2);
    row->eye = vector_any(random, 8);
    for (unsigned d = 0; d < QV_DIRECTIONS; d++)
        row->byte[d] = vector_bits(random, 3) ? vector_bits(random, 8) : 0;
    for (unsigned c = 0; c < 3; c++) {
        row->spacing[c] = (uint64_t)vector_between(random, 40000, 131072);
        row->ambient[c] = vector_bits(random, 1) ? vector_bits(random, 15) : 0;
        row->rgb[c] = vector_any(random, 16);
        for (unsigned lamp = 0; lamp < 2; lamp++) {
            row->direction[lamp][c] = vector_between(random, -(1 << (bits - 1)), 1 << (bits - 1));
            if (row->direction[lamp][c] == 32768)
                row->direction[lamp][c] = 32767;
            row->colour[lamp][c] = vector_any(random, 16);
        }
    }
    row->direction[0][0] += row->direction[0][0] == 0;
    row->direction[1][2] += row->direction[1][2] == 0;
}

/* Along each direction, and between two of its neighbours, by each interpolation. */
static void lamp_edges(vector_set *set)
{
    for (unsigned i = 0; i < 26 * 3; i++) {
        int8_t step[3];
        lamp_row row = {.spacing = {65536, 81920, 131072},
                        .unit = i % 2 ? 65536 : 0,
                        .interpolation = i / 26,
                        .eye = 240,
                        .count = 2,
                        .colour = {{65535, 30000, 0}, {9000, 20000, 50000}},
                        .rgb = {60000, 30000, 1234}};
        qv_direction_step(step, (uint8_t)(i % 26));
        for (unsigned d = 0; d < QV_DIRECTIONS; d++)
            row.byte[d] = 255 - 9 * d;
        for (unsigned axis = 0; axis < 3; axis++) {
            row.direction[0][axis] = step[axis];
            row.direction[1][axis] = 100 * step[axis] + (int64_t)axis - 1;
        }
        vector_add(set, &row, VECTOR_EDGE);
    }
    const lamp_row dark = {.spacing = {65536, 65536, 65536}, .rgb = {65535, 1, 2}};
    vector_add(set, &dark, VECTOR_EDGE);
}

static const vector_field lamp_fields[] = {
    {"spacing", 3, 'i', "u32.16", "of axis [i]"},
    {"unit", 1, 'i', "u32.16", "U; 0: opacities have no unit distance"},
    {"interpolation", 1, 'i', "u2", "0 between light, 1 nearest, 2 between depths"},
    {"byte", QV_DIRECTIONS, 'i', "u8", "of the voxel in direction [i]; the set is all directions"},
    {"eye", 1, 'i', "u8", "every byte of the voxel of an eye inside"},
    {"count", 1, 'i', "u2", "lamps, 0 .. 2"},
    {"da", 3, 'i', "s16", "direction to the first lamp, axis [i]"},
    {"db", 3, 'i', "s16", "direction to the second lamp, axis [i]"},
    {"ca", 3, 'i', "unorm16", "colour of the first lamp, channel [i]"},
    {"cb", 3, 'i', "unorm16", "colour of the second lamp, channel [i]"},
    {"ambient", 3, 'i', "unorm16", "channel [i]"},
    {"rgb", 3, 'i', "unorm16", "colour of the voxel, channel [i]"},
    {"ta", 1, 'm', "u32.32", "transmittance to the first lamp, 0 without one"},
    {"tb", 1, 'm', "u32.32", "transmittance to the second lamp, 0 without one"},
    {"inside", 1, 'o', "u32.32",
     "transmittance along da from an eye whose voxel has the bytes eye; 0 without a lamp"},
    {"lit", 3, 'o', "unorm16", "C[[i]] of section 65"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_lamp = {
    .name = "lamp",
    .section = "65, 68",
    .title = "the light of lamps on a voxel, by its bytes",
    .rounding = "the last products to nearest, ties upwards",
    .saturation = "light at 65535",
    .fields = lamp_fields,
    .columns = VECTOR_COLUMNS(lamp_row),
    .seed = 65,
    .random_rows = 400,
    .edges = lamp_edges,
    .draw = lamp_draw,
    .compute = lamp_compute,
};
