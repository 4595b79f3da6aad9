/*
 * stages_medium.c - what lengths mean: section 39.
 */
#include "stages.h"

#include "medium.h"

typedef struct medium_row {
    uint64_t model, wide, step, unit, extinction, levels, length;
    uint64_t step_depth, step_light, b, depth, light;
} medium_row;

typedef qv_status preparation(qv_medium *medium, const qv_scene *scene, unsigned levels);

static preparation *const preparations[3] = {qv_medium_corrected, qv_medium_extinction,
                                             qv_medium_converted};

static unsigned medium_compute(void *columns)
{
    static const uint8_t storages[2] = {QV_STORAGE_RGBT8, QV_STORAGE_RGBT16};
    medium_row *row = columns;
    const qv_scene scene = {.volume = {.storage = storages[row->wide],
                                       .unit_distance = (uint32_t)row->unit,
                                       .extinction = (uint32_t)row->extinction},
                            .camera = {.step = (uint32_t)row->step}};
    qv_medium step, piece;
    if (preparations[row->model](&step, &scene, (unsigned)row->levels) != QV_OK)
        vector_fail("medium", "scene", "refused");
    qv_medium_scale(&piece, &step, (uint32_t)row->length);
    row->step_depth = step.depth;
    row->step_light = step.light;
    row->b = step.light_shift;
    row->depth = piece.depth;
    row->light = piece.light;
    return 0;
}

static void medium_draw(void *columns, vector_random *random)
{
    medium_row *row = columns;
    row->model = (uint64_t)vector_between(random, 0, 2);
    row->wide = vector_bits(random, 1);
    row->step = (uint64_t)vector_between(random, 4096, 1 << 20);
    row->unit = row->step * (uint64_t)vector_between(random, 1, 4000) /
                (uint64_t)vector_between(random, 1, 60);
    row->unit = row->unit > UINT32_MAX ? 0 : row->unit;
    row->extinction = vector_any(random, 25) + 1u;
    row->levels = vector_bits(random, 2);
    row->length = vector_bits(random, 1) ? 65536 : (uint64_t)vector_between(random, 1, 65536);
    row->length <<= vector_bits(random, 2) % (row->levels + 1u);
}

/* Steps and unit distances at the ends of their ranges; the full value's depth too. */
static void medium_edges(vector_set *set)
{
    static const uint64_t units[] = {0, 65536, 16, 1 << 28, 0x80000000, 65537};
    static const uint64_t lengths[] = {1, 12346, 65535, 65536};
    for (unsigned i = 0; i < 2 * 24; i++) {
        uint64_t unit = units[i / 4 % 6];
        const medium_row row = {.model = i / 24 * 2,
                                .step = unit == 0x80000000 ? 1 << 20 : 65536,
                                .unit = unit,
                                .levels = 0,
                                .length = lengths[i % 4]};
        if (row.unit == 16 && row.model == 0)
            continue; /* such a ratio is out of range */
        vector_add(set, &row, VECTOR_EDGE);
    }
    static const uint64_t extinctions[] = {1, 255, 65535, 123456, 0x03FFFFFF};
    for (unsigned i = 0; i < 40; i++) {
        const medium_row row = {.model = 1,
                                .wide = i % 2,
                                .step = i / 20 ? 1 << 20 : 65536,
                                .extinction = extinctions[i / 4 % 5],
                                .levels = 0,
                                .length = i / 2 % 2 ? 65536 : 1};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* The greatest ratio and the greatest extinction of each number of levels, by the longest piece. */
static void medium_added(vector_set *set)
{
    for (uint64_t levels = 0; levels < 12; levels++) {
        const medium_row ratio = {.model = 0,
                                  .step = 1 << 20,
                                  .unit = (uint64_t)1 << (9 + levels),
                                  .levels = levels,
                                  .length = (uint64_t)65536 << levels};
        const medium_row depth = {.model = 1,
                                  .wide = levels % 2,
                                  .step = 1 << 20,
                                  .extinction = ((uint64_t)1 << (34 - levels)) - 1u,
                                  .levels = levels,
                                  .length = (uint64_t)65536 << levels};
        vector_add(set, &ratio, VECTOR_EDGE | VECTOR_OVERFLOW);
        if (depth.extinction <= UINT32_MAX)
            vector_add(set, &depth, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
    /* found by search: without its lowest bit this unit distance has another ratio */
    const medium_row odd = {.step = 1 << 20, .unit = 1073741953, .length = 65536};
    vector_add(set, &odd, VECTOR_EDGE);
}

static const vector_field medium_fields[] = {
    {"model", 1, 'i', "u2", "0 section 42; of section 43: 1 stored extinction, 2 stored opacity"},
    {"wide", 1, 'i', "u1", "storage: 0 of 8 bits, 1 of 16 bits"},
    {"step", 1, 'i', "u32.16", "of the ray"},
    {"unit", 1, 'i', "u32.16", "U; 0: the step"},
    {"extinction", 1, 'i', "u32.16", "E, of model 1"},
    {"levels", 1, 'i', "u4", "m"},
    {"length", 1, 'i', "u29.16", "l of the piece"},
    {"step_depth", 1, 'm', "u64.32", "depth of a step"},
    {"step_light", 1, 'm', "u32", "light of a step, 32 - b fraction bits"},
    {"b", 1, 'o', "u5", "b of section 39"},
    {"depth", 1, 'o', "u64.32", "floor(step_depth * length / 65536)"},
    {"light", 1, 'o', "u32", "floor(step_light * length / 65536)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_medium = {
    .name = "medium",
    .section = "39",
    .title = "what a step, and a piece of some length, means",
    .rounding = "the ratio of step to unit distance to nearest, ties upwards; all else is cut",
    .saturation = "none",
    .fields = medium_fields,
    .columns = VECTOR_COLUMNS(medium_row),
    .seed = 39,
    .random_rows = 300,
    .edges = medium_edges,
    .added = medium_added,
    .draw = medium_draw,
    .compute = medium_compute,
};
