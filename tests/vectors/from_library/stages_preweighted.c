/*
 * stages_preweighted.c - samples of associated colours: section 70.
 */
#include "stages.h"

#include "preweighted.h"

#include <string.h>

typedef struct preweighted_row {
    uint64_t f[3], channel[4][8], e[3], t, u[4], low[4], high[4], skipped, en[3], tn;
} preweighted_row;

enum { STEP_X = 4, STEP_Y = 8, STEP_Z = 16, CELL_BYTES = 32 };

static qv_passage passage_of(const preweighted_row *row, const uint8_t cell[CELL_BYTES])
{
    qv_passage passage = {.next = {STEP_X, STEP_Y, STEP_Z}, .base = cell, .samples = 1};
    for (unsigned axis = 0; axis < 3; axis++) {
        passage.place[axis] = (uint32_t)row->f[axis] << 24;
        passage.light[axis] = (uint32_t)row->e[axis];
    }
    passage.transmittance = (uint32_t)row->t;
    return passage;
}

/* The sums at both ends of the rows. */
static void find_ends(preweighted_row *row, const uint8_t cell[CELL_BYTES])
{
    qv_passage passage = passage_of(row, cell);
    qv_ends ends;
    qv_passage_next(&ends, &passage);
    row->low[0] = ends.low.red_blue & 0xFFFFu;
    row->low[1] = ends.low.green_opacity & 0xFFFFu;
    row->low[2] = ends.low.red_blue >> 16;
    row->low[3] = ends.low.green_opacity >> 16;
    row->high[0] = ends.high.red_blue & 0xFFFFu;
    row->high[1] = ends.high.green_opacity & 0xFFFFu;
    row->high[2] = ends.high.red_blue >> 16;
    row->high[3] = ends.high.green_opacity >> 16;
    row->u[3] = (row->f[1] * row->f[2] + 128u) / 256u;
    row->u[2] = row->f[2] - row->u[3];
    row->u[1] = row->f[1] - row->u[3];
    row->u[0] = 256u - row->f[1] - row->u[2];
}

static unsigned compute(preweighted_row *row, void (*pass)(qv_passage *passage))
{
    uint8_t cell[CELL_BYTES];
    for (unsigned i = 0; i < CELL_BYTES; i++)
        cell[i] = (uint8_t)row->channel[i % 4][i / 4];
    find_ends(row, cell);
    qv_passage passage = passage_of(row, cell);
    pass(&passage);
    row->skipped = passage.skipped;
    for (unsigned c = 0; c < 3; c++)
        row->en[c] = passage.light[c];
    row->tn = passage.transmittance;
    return row->u[3] != 0 && (row->f[1] * row->f[2] & 255u) == 128u ? VECTOR_TIE : 0;
}

static unsigned under_compute(void *row)
{
    return compute(row, qv_passage_under);
}

static unsigned over_compute(void *row)
{
    return compute(row, qv_passage_over);
}

/* Colours at most their opacity; what a ray has gathered, at most what it covers. */
static void draw(void *columns, vector_random *random)
{
    preweighted_row *row = columns;
    const unsigned sparse = (unsigned)vector_bits(random, 2) == 0;
    for (unsigned axis = 0; axis < 3; axis++)
        row->f[axis] = vector_any(random, 8);
    for (unsigned q = 0; q < 8; q++) {
        row->channel[3][q] = vector_any(random, 8);
        row->channel[3][q] *= sparse ? vector_bits(random, 1) : 1;
        for (unsigned c = 0; c < 3; c++)
            row->channel[c][q] = vector_bits(random, 8) * row->channel[3][q] / 255u;
    }
    row->t = QV_UNDIMMED - vector_any(random, 32) % (QV_WHOLE + 1u);
    for (unsigned c = 0; c < 3; c++)
        row->e[c] = (QV_UNDIMMED - row->t) * vector_any(random, 16) >> 16;
}

/* Cells that are clear, opaque or have one voxel, in rays that have seen nothing, half and all. */
static void edges(vector_set *set)
{
    static const uint64_t rests[] = {QV_UNDIMMED, 0x80000000, QV_NOTHING};
    for (unsigned i = 0; i < 3 * 3 * 8; i++) {
        preweighted_row row = {.t = rests[i % 3]};
        for (unsigned axis = 0; axis < 3; axis++) {
            row.f[axis] = i / 9 >> axis & 1u ? 255 : 0;
            row.e[axis] = (QV_UNDIMMED - row.t) >> axis;
        }
        for (unsigned q = 0; q < 32; q++)
            row.channel[q / 8][q % 8] = i / 3 % 3 == 0 ? 0 : i / 3 % 3 == 1 || q % 8 == 5 ? 255 : 0;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

#define ENDS(name, sum)                                                                            \
    {name "0", 1, 'm', "u16", sum("r")}, {name "1", 1, 'm', "u16", sum("g")},                      \
        {name "2", 1, 'm', "u16", sum("b")},                                                       \
    {                                                                                              \
        name "3", 1, 'm', "u16", sum("a")                                                          \
    }
#define LOW(c)  "u0 * " c "0 + u1 * " c "2 + u2 * " c "4 + u3 * " c "6"
#define HIGH(c) "u0 * " c "1 + u1 * " c "3 + u2 * " c "5 + u3 * " c "7"

#define PREWEIGHTED_FIELDS                                                                         \
    {"f", 3, 'i', "u8.8", "place between the voxel centres of axis [i]"},                          \
        {"r", 8, 'i', "unorm8", "red of corner [i], associated"},                                  \
        {"g", 8, 'i', "unorm8", "green of corner [i], associated"},                                \
        {"b", 8, 'i', "unorm8", "blue of corner [i], associated"},                                 \
        {"a", 8, 'i', "unorm8", "opacity of corner [i]"},                                          \
        {"e", 3, 'i', "u32", "light of the ray before, colour [i]"},                               \
        {"t", 1, 'i', "u32", "its transmittance, 255 * 2^24 is 1"},                                \
        {"u0", 1, 'm', "u9.8", "256 - f1 - f2 + u3"}, {"u1", 1, 'm', "u9.8", "f1 - u3"},           \
        {"u2", 1, 'm', "u9.8", "f2 - u3"}, {"u3", 1, 'm', "u9.8", "floor((f1 * f2 + 128) / 256)"}, \
        ENDS("low", LOW), ENDS("high", HIGH),                                                      \
    {                                                                                              \
        "skipped", 1, 'o', "u1", "1 where the sample is skipped"                                   \
    }

static const vector_field under_fields[] = {
    PREWEIGHTED_FIELDS,
    {"en", 3, 'o', "u32", "e[i] + low[i] l + high[i] h, with h and l of section 70"},
    {"tn", 1, 'o', "u32", "t - (low3 l + high3 h)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_preweighted_under = {
    .name = "preweighted_under",
    .section = "70",
    .title = "a sample of associated colours, front to back",
    .rounding = "u3 to nearest, ties upwards; shares are cut",
    .saturation = "none",
    .fields = under_fields,
    .columns = VECTOR_COLUMNS(preweighted_row),
    .seed = 70,
    .random_rows = 150,
    .edges = edges,
    .draw = draw,
    .compute = under_compute,
};

static const vector_field over_fields[] = {
    PREWEIGHTED_FIELDS,
    {"en", 3, 'o', "u32", "e[i] - m3 share(e[i]) + 65536 m[i], with m of section 70"},
    {"tn", 1, 'o', "u32", "t - m3 share(t)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_preweighted_over = {
    .name = "preweighted_over",
    .section = "70",
    .title = "a sample of associated colours, back to front",
    .rounding = "u3 to nearest, ties upwards; m and shares are cut",
    .saturation = "none",
    .fields = over_fields,
    .columns = VECTOR_COLUMNS(preweighted_row),
    .seed = 7007,
    .random_rows = 150,
    .edges = edges,
    .draw = draw,
    .compute = over_compute,
};
