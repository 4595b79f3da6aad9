/*
 * stages_freevoxel.c - orders of voxels, and their bytes of attenuation: sections 61 and 62.
 */
#include "stages.h"

#include "attenuation.h"
#include "thickness.h"

/* ---- Orders ----------------------------------------------------------------- */

typedef struct order_row {
    uint64_t n[3], p[3], linear, morton, hilbert;
} order_row;

/* The index of a voxel, which must lead back to it. */
static uint64_t index_of(const qv_order *order, const uint16_t size[3], const uint16_t at[3])
{
    uint16_t back[3];
    const uint64_t index = order->index(size, at);
    order->position(back, size, index);
    if (back[0] != at[0] || back[1] != at[1] || back[2] != at[2])
        vector_fail("order", "index", "does not lead back");
    return index;
}

static unsigned order_compute(void *columns)
{
    order_row *row = columns;
    uint16_t size[3], at[3];
    for (unsigned axis = 0; axis < 3; axis++) {
        size[axis] = (uint16_t)row->n[axis];
        at[axis] = (uint16_t)row->p[axis];
    }
    row->linear = index_of(&qv_order_linear, size, at);
    row->morton = index_of(&qv_order_morton, size, at);
    row->hilbert = index_of(&qv_order_hilbert, size, at);
    return 0;
}

static void order_draw(void *columns, vector_random *random)
{
    order_row *row = columns;
    for (unsigned axis = 0; axis < 3; axis++) {
        row->n[axis] = vector_any(random, 12) + 1u;
        row->p[axis] = (uint64_t)vector_between(random, 0, (int64_t)row->n[axis] - 1);
    }
}

/* Every voxel of S97's box, and the last ones of the largest. */
static void order_edges(vector_set *set)
{
    for (unsigned i = 0; i < 18; i++) {
        const order_row row = {.n = {3, 2, 3}, .p = {i % 3, i / 3 % 2, i / 6}};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (unsigned i = 0; i < 8; i++) {
        order_row row = {.n = {4096, 4096, 4096}};
        for (unsigned axis = 0; axis < 3; axis++)
            row.p[axis] = i >> axis & 1u ? 4095 : 0;
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
}

static const vector_field order_fields[] = {
    {"n", 3, 'i', "u13", "voxels of the box on axis [i]"},
    {"p", 3, 'i', "u12", "voxel, index on axis [i]"},
    {"linear", 1, 'o', "u36", "p0 + n0 (p1 + n1 p2)"},
    {"morton", 1, 'o', "u36", "index in Morton order, section 61"},
    {"hilbert", 1, 'o', "u36", "index in Hilbert order, section 61"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_order = {
    .name = "order",
    .section = "61",
    .title = "the index of a voxel in three orders",
    .rounding = "none: exact",
    .saturation = "none",
    .fields = order_fields,
    .columns = VECTOR_COLUMNS(order_row),
    .seed = 61,
    .random_rows = 200,
    .edges = order_edges,
    .draw = order_draw,
    .compute = order_compute,
};

/* ---- Attenuation of a path -------------------------------------------------- */

typedef struct attenuation_row {
    uint64_t stored, unit, extinction, length, x[8], f, s, weight[8], depth[8], byte[8];
} attenuation_row;

static unsigned attenuation_compute(void *columns)
{
    attenuation_row *row = columns;
    const qv_domain *domain = row->stored ? &qv_domain_stored : &qv_domain_extinction;
    const qv_volume volume = {.storage = row->stored ? QV_STORAGE_RGBT16 : QV_STORAGE_RGBA16,
                              .unit_distance = (uint32_t)row->unit,
                              .extinction = (uint32_t)row->extinction};
    qv_thickness thickness;
    fx_depth depth = 0;
    if (qv_thickness_of(&thickness, &volume, (uint32_t)row->length) != QV_OK)
        vector_fail("attenuation", "length", "refused");
    row->f = thickness.factor;
    row->s = thickness.shift;
    for (unsigned i = 0; i < 8; i++) {
        row->weight[i] = domain->weight((uint16_t)row->x[i]);
        depth += qv_thickness_depth(&thickness, (uint32_t)row->weight[i]);
        row->depth[i] = depth;
        row->byte[i] = qv_attenuation_byte(depth);
    }
    return row->byte[7] == 0 ? VECTOR_SATURATE : 0;
}

static void attenuation_draw(void *columns, vector_random *random)
{
    attenuation_row *row = columns;
    const unsigned bits = (unsigned)vector_between(random, 8, 16);
    row->stored = vector_bits(random, 1);
    row->length = (uint64_t)vector_between(random, 1 << 21, 1 << 25);
    row->unit = vector_bits(random, 2) ? (uint64_t)vector_between(random, 1 << 13, 1 << 20) : 0;
    row->extinction = (uint64_t)vector_between(random, 1, 1 << 22);
    for (unsigned i = 0; i < 8; i++)
        row->x[i] = vector_bits(random, 1) ? vector_bits(random, bits) : 0;
}

static void attenuation_edges(vector_set *set)
{
    static const uint64_t lengths[][3] = {{0, 1, 16123706},
                                          {65536, 1, 1 << 23},
                                          {81920, 65536, 16123706},
                                          {0x80003039, 1, 0x80000000},
                                          {16, 200000, 1 << 23},
                                          {65536, 1, 1 << 19},
                                          {65536, 0x0FFFFFFF, 1 << 23}};
    for (unsigned i = 0; i < 14; i++) {
        const attenuation_row row = {.stored = i / 7,
                                     .unit = lengths[i % 7][0],
                                     .extinction = lengths[i % 7][1],
                                     .length = lengths[i % 7][2],
                                     .x = {1, 0, 128, 4660, 13107, 32768, 65534, 65535}};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (uint64_t x = 1; x < 40; x++) { /* bytes that step by one */
        const attenuation_row row = {
            .length = 1 << 23, .extinction = 1, .x = {x * 3, 60, 60, 60 + x, 60, 60, 60, 60}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field attenuation_fields[] = {
    {"stored", 1, 'i', "u1", "0: opacities, 1: stored extinction"},
    {"unit", 1, 'i', "u32.16", "U, of opacities; may be 0"},
    {"extinction", 1, 'i', "u32.16", "E, of stored extinction"},
    {"length", 1, 'i', "u32.23", "L, of a step along the path"},
    {"x", 8, 'i', "unorm16", "fourth channel of voxel [i] on the path, from outside inwards"},
    {"f", 1, 'm', "u32", "f of the thickness, section 62"},
    {"s", 1, 'm', "u6", "s of the thickness"},
    {"weight", 8, 'm', "u32", "ext16(x[i]), or x[i] where stored = 1"},
    {"depth", 8, 'm', "u64.32", "sum of floor(weight * f / 2^s) of voxels 0 .. [i]"},
    {"byte", 8, 'o', "u8", "byte(depth[i]), of the voxel behind voxel [i]"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_attenuation = {
    .name = "attenuation",
    .section = "62",
    .title = "bytes of attenuation along a path",
    .rounding = "depths are cut; bytes to nearest, ties upwards",
    .saturation = "bytes are 0 from depth 9 on",
    .fields = attenuation_fields,
    .columns = VECTOR_COLUMNS(attenuation_row),
    .seed = 62,
    .random_rows = 250,
    .edges = attenuation_edges,
    .draw = attenuation_draw,
    .compute = attenuation_compute,
};
