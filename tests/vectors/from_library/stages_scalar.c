/*
 * stages_scalar.c - tables, indices and means of scalars: sections 19, 20 and 24.
 */
#include "stages.h"

#include "qvol.h"

/* ---- Transfer table --------------------------------------------------------- */

typedef struct transfer_row {
    uint64_t first, last, from, to, entry, value16, value8;
} transfer_row;

static unsigned transfer_compute(void *columns)
{
    transfer_row *row = columns;
    const qv_control_point points[2] = {{(uint8_t)row->first, {(uint16_t)row->from, 0, 0, 0}},
                                        {(uint8_t)row->last, {(uint16_t)row->to, 0, 0, 0}}};
    qv_transfer table;
    uint8_t narrow[QV_PALETTE_ENTRIES][4];
    if (qv_transfer_build(&table, points, 2) != QV_OK)
        vector_fail("transfer", "points", "refused");
    qv_transfer_to_palette8(narrow, &table);
    row->value16 = table.rgba[row->entry][0];
    row->value8 = narrow[row->entry][0];
    return row->entry < row->first || row->entry > row->last ? VECTOR_SATURATE : 0;
}

static void transfer_draw(void *columns, vector_random *random)
{
    transfer_row *row = columns;
    row->first = (uint64_t)vector_between(random, 0, 254);
    row->last = (uint64_t)vector_between(random, (int64_t)row->first + 1, 255);
    row->from = vector_any(random, 16);
    row->to = vector_any(random, 16);
    row->entry = vector_bits(random, 3) == 0
                     ? vector_bits(random, 8)
                     : (uint64_t)vector_between(random, (int64_t)row->first, (int64_t)row->last);
}

/* Halves: between points 2 and 4 apart. */
static void transfer_edges(vector_set *set)
{
    for (uint64_t i = 0; i < 64; i++) {
        const transfer_row row = {.first = 100,
                                  .last = 102 + i % 2 * 2,
                                  .from = i / 8 * 9362,
                                  .to = i / 4 % 2 ? 65535 - i : i,
                                  .entry = 99 + i % 7};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field transfer_fields[] = {
    {"first", 1, 'i', "u8", "index g of the first control point"},
    {"last", 1, 'i', "u8", "index h of the second one, above first"},
    {"from", 1, 'i', "unorm16", "its value b"},
    {"to", 1, 'i', "unorm16", "the second one's value d"},
    {"entry", 1, 'i', "u8", "of the table"},
    {"value16", 1, 'o', "unorm16",
     "from up to first, to from last on, else floor((2 (from (last - entry) + to (entry - first)) "
     "+ "
     "last - first) / (2 (last - first)))"},
    {"value8", 1, 'o', "unorm8", "to8(value16)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_transfer = {
    .name = "transfer",
    .section = "19",
    .title = "an entry of a transfer table, between two control points",
    .rounding = "to nearest, ties upwards",
    .saturation = "beyond the points",
    .fields = transfer_fields,
    .columns = VECTOR_COLUMNS(transfer_row),
    .seed = 19,
    .random_rows = 200,
    .edges = transfer_edges,
    .draw = transfer_draw,
    .compute = transfer_compute,
};

/* ---- Index ------------------------------------------------------------------ */

typedef struct index_row {
    int64_t s, low, high;
    uint64_t index;
} index_row;

static unsigned index_compute(void *columns)
{
    index_row *row = columns;
    const int is_signed = row->s < 0;
    const uint16_t value = (uint16_t)row->s;
    const void *values = &value;
    const qv_classifier classifier = {
        .scalars = {.values = values,
                    .values_bytes = sizeof value,
                    .stride = {2, 2, 2},
                    .size = {1, 1, 1},
                    .type = is_signed ? QV_SCALAR_S16 : QV_SCALAR_U16},
        .low = (int32_t)row->low,
        .high = (int32_t)row->high};
    const qv_block block = {{0, 0, 0}, {1, 1, 1}};
    uint8_t index;
    if (qv_classify(&index, 1, QV_STORAGE_INDEXED8, &classifier, &block) != QV_OK)
        vector_fail("index", "classifier", "refused");
    row->index = index;
    return row->s <= row->low || row->s >= row->high ? VECTOR_SATURATE : 0;
}

static void index_draw(void *columns, vector_random *random)
{
    index_row *row = columns;
    row->low = vector_between(random, -65536, 131070);
    row->high = vector_between(random, row->low + 1, 131071);
    row->s = vector_between(random, row->low < -32768 ? -32768 : row->low, 65535);
    if (row->s > 65535 || row->s < -32768)
        row->s = vector_between(random, -32768, 65535);
}

/* Windows in which each step of the index is a half, and the ends of all ranges. */
static void index_edges(vector_set *set)
{
    for (int64_t s = -2; s < 20; s++) {
        const index_row halves = {.s = s, .low = 0, .high = 510};
        const index_row narrow = {.s = s, .low = 7, .high = 8 + s % 3 * s % 3};
        vector_add(set, &halves, VECTOR_EDGE);
        vector_add(set, &narrow, VECTOR_EDGE);
    }
    static const int64_t ends[] = {-32768, -1, 0, 1, 32767, 65534, 65535};
    for (unsigned i = 0; i < 14; i++) {
        const index_row row = {
            .s = ends[i % 7], .low = i < 7 ? -65536 : -1000, .high = i < 7 ? 131071 : 2000};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field index_fields[] = {
    {"s", 1, 'i', "s17", "scalar, -32768 .. 65535"},
    {"low", 1, 'i', "s18", "of the window"},
    {"high", 1, 'i', "s19", "of the window, above low"},
    {"index", 1, 'o', "u8",
     "0 where s <= low, 255 where s >= high, else floor((510 (s - low) + (high - low)) / "
     "(2 (high - low)))"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_index = {
    .name = "index",
    .section = "20",
    .title = "the table's index of a scalar",
    .rounding = "to nearest, ties upwards",
    .saturation = "at 0 and 255",
    .fields = index_fields,
    .columns = VECTOR_COLUMNS(index_row),
    .seed = 20,
    .random_rows = 250,
    .edges = index_edges,
    .draw = index_draw,
    .compute = index_compute,
};

/* ---- Reduction -------------------------------------------------------------- */

typedef struct reduce_row {
    uint64_t n[3];
    int64_t s[8], value;
} reduce_row;

static unsigned reduce_compute(void *columns)
{
    reduce_row *row = columns;
    uint8_t factor[3];
    uint16_t values[8], value;
    const void *from = values;
    for (unsigned i = 0; i < 8; i++)
        values[i] = (uint16_t)row->s[i];
    for (unsigned axis = 0; axis < 3; axis++)
        factor[axis] = row->n[axis] == 3 ? 3 : 2;
    const qv_scalars scalars = {
        .values = from,
        .values_bytes = sizeof values,
        .stride = {2, (int32_t)(2 * row->n[0]), (int32_t)(2 * row->n[0] * row->n[1])},
        .size = {(uint16_t)row->n[0], (uint16_t)row->n[1], (uint16_t)row->n[2]},
        .type = QV_SCALAR_S16};
    if (qv_reduce(&value, sizeof value, &scalars, factor, 0, 1) != QV_OK)
        vector_fail("reduce", "scalars", "refused");
    row->value = (int16_t)value;
    return 0;
}

static void reduce_draw(void *columns, vector_random *random)
{
    reduce_row *row = columns;
    for (unsigned axis = 0; axis < 3; axis++)
        row->n[axis] = vector_bits(random, 1) + 1;
    for (unsigned i = 0; i < 8; i++)
        row->s[i] = (int16_t)(uint16_t)vector_any(random, 16);
}

static void reduce_edges(vector_set *set)
{
    for (int64_t i = 0; i < 24; i++) {
        const reduce_row row = {
            .n = {2, 1 + (uint64_t)i % 2, 1 + (uint64_t)i / 2 % 2},
            .s = {i < 12 ? 32767 : -32768, -5 + i % 12, -2, 4, 0, 1, -1, i % 5}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Means of three and of six: numbers that do not divide 2^32. */
static void reduce_added(vector_set *set)
{
    static const uint8_t sizes[6][3] = {{3, 1, 1}, {1, 3, 1}, {1, 1, 3},
                                        {3, 2, 1}, {1, 3, 2}, {2, 1, 3}};
    for (unsigned i = 0; i < 12; i++) {
        const uint8_t *n = sizes[i % 6];
        const reduce_row row = {
            .n = {n[0], n[1], n[2]},
            .s = {i < 6 ? -32768 : 32767, -32767 + (int64_t)i, 32766, -3, 0, 1 + (int64_t)i, -1}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field reduce_fields[] = {
    {"n", 3, 'i', "u2", "scalars on axis [i], 1 .. 3; 8 in all at most"},
    {"s", 8, 'i', "s16", "scalars, x fastest; those beyond n0 n1 n2 are not read"},
    {"value", 1, 'o', "s16",
     "floor((2 Q + N) / (2 N)) - 32768, with N = n0 n1 n2 and Q the sum of "
     "s + 32768"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_reduce = {
    .name = "reduce",
    .section = "24",
    .title = "the mean of up to eight scalars",
    .rounding = "to nearest, ties upwards",
    .saturation = "none",
    .fields = reduce_fields,
    .columns = VECTOR_COLUMNS(reduce_row),
    .seed = 24,
    .random_rows = 150,
    .edges = reduce_edges,
    .added = reduce_added,
    .draw = reduce_draw,
    .compute = reduce_compute,
};
