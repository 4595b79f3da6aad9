/*
 * stages_cell.c - the cell of a sample and the addresses of its corners: sections 3 and 10.
 */
#include "stages.h"

#include "cell.h"

typedef struct cell_row {
    uint64_t n[3];
    int64_t stride[3], place[3], advance[3], k, point[3];
    uint64_t f[3];
    int64_t address[8];
} cell_row;

/* Voxels lie here; addresses are bytes from its middle on. Nothing is read. */
enum { MEMORY = 1 << 20, MIDDLE = MEMORY / 2 };
static const uint8_t memory[MEMORY];

static void locate(qv_cell *cell, qv_volume *volume, cell_row *row)
{
    qv_ray ray = {.first = 0};
    volume->voxels = memory + MIDDLE;
    volume->storage = QV_STORAGE_RGBA8;
    for (unsigned axis = 0; axis < 3; axis++) {
        volume->size[axis] = (uint16_t)row->n[axis];
        volume->stride[axis] = (int32_t)row->stride[axis];
        ray.place[axis] = row->place[axis];
        ray.advance[axis] = row->advance[axis];
    }
    qv_ray_count_from(&ray, (int32_t)row->k);
    for (unsigned axis = 0; axis < 3; axis++)
        row->point[axis] = ray.place[axis] += QV_CENTRED;
    qv_cell_locate(cell, volume, &ray);
}

static unsigned cell_compute(void *columns)
{
    cell_row *row = columns;
    qv_volume volume = {.storage = QV_STORAGE_RGBA8};
    qv_cell cell;
    qv_address corner[8];
    locate(&cell, &volume, row);
    qv_corners(corner, &cell, &volume, QV_STORAGE_RGBA8);
    for (unsigned q = 0; q < 8; q++)
        row->address[q] = corner[q] - volume.voxels;
    for (unsigned axis = 0; axis < 3; axis++)
        row->f[axis] = fx_fraction_bits(cell.fraction[axis]);
    return cell.next[0] == 0 || cell.next[1] == 0 || cell.next[2] == 0 ? VECTOR_SATURATE : 0;
}

/* Strides of voxels of 4 bytes, axes in one of six orders, some with gaps, some downwards. */
static void set_strides(cell_row *row, vector_random *random)
{
    static const uint8_t orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                         {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const uint8_t *order = orders[vector_between(random, 0, 5)];
    int64_t span = 4;
    for (unsigned i = 0; i < 3; i++) {
        unsigned axis = order[i];
        int64_t gap = vector_bits(random, 2) == 0 ? vector_between(random, 0, 7) : 0;
        row->stride[axis] = (span + gap) * (vector_bits(random, 2) == 0 ? -1 : 1);
        span = (span + gap) * (int64_t)row->n[axis];
    }
}

/* A place and a step whose k-th sample lies within the box. */
static void set_ray(cell_row *row, vector_random *random, unsigned axis, int64_t inside)
{
    row->advance[axis] = vector_between(random, -0x7FFFFFFF, 0x7FFFFFFF);
    row->place[axis] = inside - row->k * row->advance[axis];
}

static void cell_draw(void *columns, vector_random *random)
{
    cell_row *row = columns;
    for (unsigned axis = 0; axis < 3; axis++)
        row->n[axis] = (uint64_t)vector_between(random, 1, 32);
    set_strides(row, random);
    row->k = vector_between(random, -1000, 1000);
    for (unsigned axis = 0; axis < 3; axis++) {
        int64_t box = (int64_t)row->n[axis] << 32;
        set_ray(row, random, axis, (int64_t)(vector_bits(random, 62) % (uint64_t)box));
    }
}

/* Points next to the faces of the box, to voxel centres and to where cutting to 1/256 rounds. */
static void cell_edges(vector_set *set)
{
    static const int64_t near[] = {-1, 0, 1};
    static const int64_t at[] = {1,
                                 INT64_C(1) << 31,
                                 INT64_C(1) << 32,
                                 INT64_C(3) << 31,
                                 (INT64_C(1) << 31) - (INT64_C(1) << 23),
                                 (INT64_C(1) << 32) + (INT64_C(1) << 23),
                                 (INT64_C(5) << 31)};
    for (unsigned axis = 0; axis < 3; axis++)
        for (unsigned i = 0; i < 21; i++) {
            cell_row row = {.n = {4, 3, 3}, .stride = {4, 16, -48}};
            for (unsigned other = 0; other < 3; other++)
                row.place[other] = INT64_C(3) << 31;
            row.place[axis] = at[i / 3] + near[i % 3];
            vector_add(set, &row, VECTOR_EDGE);
        }
    for (unsigned axis = 0; axis < 3; axis++) {
        cell_row row = {.n = {1, 1, 1}, .stride = {4, 4, 4}, .place = {0, 0, 0}};
        row.n[axis] = 4096;
        row.place[axis] = (INT64_C(4096) << 32) - 1;
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
}

/* The longest steps to the farthest samples, of the largest volumes: addresses at the ends of 32
   bits, or strides that are, of which two make a small one. */
static void cell_added(vector_set *set)
{
    static const int64_t strides[4][3] = {
        {524416, 0, 4}, {4, -524416, 4}, {INT32_MAX, -INT32_MAX, 4}, {4, 8, INT32_MIN}};
    static const uint64_t sizes[4][3] = {{4096, 1, 1}, {1, 4096, 2}, {2, 2, 1}, {3, 3, 2}};
    for (unsigned i = 0; i < 4 * 8; i++) {
        cell_row row = {.k = i % 2 ? (1 << 22) - 1 : -(1 << 22)};
        for (unsigned axis = 0; axis < 3; axis++) {
            const int64_t sign = i / 2 % 2 ? -1 : 1, size = (int64_t)sizes[i / 8][axis];
            row.n[axis] = (uint64_t)size;
            row.stride[axis] = strides[i / 8][axis];
            row.advance[axis] = sign * ((INT64_C(1) << 40) - axis);
            row.place[axis] =
                (i / 4 % 2 ? (size << 32) - 1 : size << 31) - row.k * row.advance[axis];
        }
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
}

static const vector_field cell_fields[] = {
    {"n", 3, 'i', "u13", "voxels on axis [i]"},
    {"stride", 3, 'i', "s32", "bytes from voxel to voxel on axis [i]"},
    {"place", 3, 'i', "s64.32", "sample 0 of the ray on axis [i]"},
    {"advance", 3, 'i', "s64.32", "from sample to sample on axis [i]"},
    {"k", 1, 'i', "s23", "number of the sample"},
    {"point", 3, 'm', "s64.32", "place[i] + k * advance[i] - 2^31 + 2^23"},
    {"f", 3, 'o', "u8.8", "floor(point[i] / 2^24) mod 256"},
    {"address", 8, 'o', "s32",
     "bytes from voxel (0, 0, 0) to corner [i]: the sum of index * stride, the index i1 on the "
     "axes whose bit is set in [i], else i0"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_cell = {
    .name = "cell",
    .section = "3, 10",
    .title = "the cell of a sample, addresses of its corners, place in it",
    .rounding = "the point to 1/256, ties upwards",
    .saturation = "indices at the faces of the volume",
    .fields = cell_fields,
    .columns = VECTOR_COLUMNS(cell_row),
    .seed = 10,
    .random_rows = 250,
    .edges = cell_edges,
    .added = cell_added,
    .draw = cell_draw,
    .compute = cell_compute,
};
