/*
 * means.c - section 3.2, equation 7: a block's light is the geometric mean of its voxels'.
 */
#include "freevoxels.h"

#include "draw.h"
#include "reference/attenuation.h"

#include <math.h>

enum { side = 8 /* voxels of a block of level 3 */, voxels = side * side * side };

/* ---- Eight voxels --------------------------------------------------------------- */

/* Light of the eight voxels of a block that is lit along z: of a column, the voxel in front and
   the one behind it. */
typedef struct eight {
    double front, behind;
} eight;

static const eight published[4] = {{1, 0.9}, {0.8, 0.5}, {0.4, 0.3}, {0.2, 0.1}};

/* One of them opaque, before one other. */
static const eight one_dark[4] = {{1, 0}, {1, 1}, {1, 1}, {1, 1}};

/* Voxels z = 0 and 1 are the block; those at z = 2 let as much through as reaches it. */
static void fill_column(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    const eight *column = (const eight *)from + at[0] + 2 * at[1];
    const double passes[3] = {1, column->behind / column->front, column->front};
    rgba[3] = paper_channel(1 - passes[at[2]]);
}

/* The byte of the block by the library. */
static uint8_t byte_of_eight(const eight columns[4])
{
    const uint16_t first[3] = {0, 0, 0};
    paper_volume made;
    attenuated light;
    paper_volume_make(&made, 2, 2, 3);
    paper_volume_fill(&made, fill_column, columns);
    attenuated_make(&light, &made.volume, ONLY(qv_direction(0, 0, 1)), 1);
    const uint8_t byte = *qv_attenuation_at(&light.level[1], first);
    attenuated_free(&light);
    paper_volume_free(&made);
    return byte;
}

static void means_of_eight(double *geometric, double *arithmetic, const eight columns[4])
{
    *geometric = 1;
    *arithmetic = 0;
    for (int i = 0; i < 4; i++) {
        *geometric *= pow(columns[i].front * columns[i].behind, 1. / 8);
        *arithmetic += (columns[i].front + columns[i].behind) / 8;
    }
}

/* ---- Three levels ----------------------------------------------------------------- */

static void fill_drawn(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    draws *const random = *(draws *const *)from;
    (void)at;
    rgba[3] = paper_channel(draw_real(random, 0, 0.25));
}

/* The mean of eight bytes, geometric, as a byte. */
static uint8_t mean_of_bytes(const uint8_t *bytes, const unsigned at[3], unsigned size)
{
    double product = 1;
    for (unsigned i = 0; i < 8; i++) {
        const unsigned x = 2 * at[0] + (i & 1), y = 2 * at[1] + (i >> 1 & 1);
        product *= pow(bytes[x + size * (y + size * (2 * at[2] + (i >> 2)))], 1. / 8);
    }
    return (uint8_t)floor(product + 0.5);
}

/* Level by level, each from the bytes of the one below: in place. */
static uint8_t through_levels(uint8_t bytes[voxels])
{
    for (unsigned size = side; size > 1; size /= 2) {
        const unsigned half = size / 2;
        for (unsigned i = 0; i < half * half * half; i++) {
            const unsigned at[3] = {i % half, i / half % half, i / half / half};
            bytes[i] = mean_of_bytes(bytes, at, size);
        }
    }
    return bytes[0];
}

/* How far a block is from exact: made of bytes of bytes, and by the library. */
typedef struct block_error {
    double levels, ours;
} block_error;

static void measure_block(block_error *worst, draws *random)
{
    const int32_t first[3] = {0, 0, 0};
    const uint16_t at[3] = {0, 0, 0}, size[3] = {side, side, side};
    const uint8_t direction = qv_direction(0, 0, 1);
    static double depths[voxels];
    uint8_t bytes[voxels];
    paper_volume made;
    attenuated light;
    paper_volume_make(&made, side, side, side);
    paper_volume_fill(&made, fill_drawn, &random);
    attenuated_make(&light, &made.volume, ONLY(direction), 3);
    ref_outer_depths(depths, &made.volume, direction);
    const double exact = ref_attenuation(ref_mean_depth(depths, size, 3, first));
    for (int i = 0; i < voxels; i++) {
        bytes[i] = (uint8_t)floor(ref_attenuation(depths[i]) + 0.5);
    }
    worst->levels = fmax(worst->levels, fabs(through_levels(bytes) - exact));
    worst->ours = fmax(worst->ours, fabs(*qv_attenuation_at(&light.level[3], at) - exact));
    attenuated_free(&light);
    paper_volume_free(&made);
}

/* ---- Numbers ------------------------------------------------------------------------ */

void means(FILE *table)
{
    enum { blocks = 500 };
    double geometric, arithmetic;
    block_error worst = {0, 0};
    draws random = draw_seeded(1);
    means_of_eight(&geometric, &arithmetic, published);
    const uint8_t byte = byte_of_eight(published);
    paper_table_begin(table, "\n## Equation 7: a block of eight voxels");
    const paper_row mean = {"geometric mean of 1 .9 .8 .5 .4 .3 .2 .1", "-", geometric, byte / 255.,
                            0.51 / 255};
    paper_table_add(table, &mean);
    for (int i = 0; i < blocks; i++) {
        measure_block(&worst, &random);
    }
    const paper_row level3 = {"500 blocks of level 3: byte, farthest off", "-", 0, worst.ours,
                              0.51};
    paper_table_add(table, &level3);
    pairs_begin(table, "\n### Other ways to make it", "that way", "ours");
    pairs_add(table, "arithmetic mean of the same", arithmetic, byte / 255.);
    pairs_add(table, "one voxel in eight has a byte of 0: byte of the block", 0,
              byte_of_eight(one_dark));
    pairs_add(table, "500 blocks of level 3, by bytes of levels 1 and 2: farthest off",
              worst.levels, worst.ours);
}
