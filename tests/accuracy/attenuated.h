/*
 * attenuated.h - a volume's attenuation in memory of its own, and splats of the volume.
 */
#ifndef ACCURACY_ATTENUATED_H
#define ACCURACY_ATTENUATED_H

#include "check.h"
#include "reference.h"

#include <stdlib.h>
#include <string.h>

/* Sums for a channel that is 1. */
#define ATTENUATED_ONE (255.0 * 65536)

/* The bytes of level 0, and of coarser ones where they are wanted. */
typedef struct attenuated {
    qv_attenuation level[13];
    uint8_t *bytes[13];
} attenuated;

/* The domain of what a volume stores. */
static inline const qv_domain *attenuated_domain(const qv_volume *volume)
{
    return ref_holds_extinction(volume->storage) ? &qv_domain_stored : &qv_domain_extinction;
}

static inline void attenuated_describe(attenuated *made, const qv_volume *volume, int level,
                                       uint32_t directions, const qv_order *order)
{
    qv_attenuation *of = &made->level[level];
    for (int axis = 0; axis < 3; axis++) {
        of->size[axis] = (uint16_t)((volume->size[axis] + (1 << level) - 1) >> level);
    }
    of->directions = directions;
    of->order = order;
    of->bytes = qv_attenuation_bytes(of);
    made->bytes[level] = malloc((size_t)of->bytes);
    assert_non_null(made->bytes[level]);
    of->records = made->bytes[level];
}

/* One direction, of all levels. */
static inline void attenuated_fill(const attenuated *made, const qv_volume *volume, int coarsest,
                                   uint32_t *blocks, uint8_t direction)
{
    const qv_attenuation *of = &made->level[0];
    assert_int_equal(qv_attenuate(made->bytes[0], (size_t)of->bytes, blocks, of, volume,
                                  attenuated_domain(volume), direction),
                     QV_OK);
    for (int level = 1; level <= coarsest; level++) {
        of = &made->level[level];
        assert_int_equal(qv_attenuate_level(made->bytes[level], (size_t)of->bytes, of, blocks,
                                            volume->size, (uint8_t)level, direction),
                         QV_OK);
    }
}

/* Levels 0 .. coarsest, for a set of directions, in an order (null: linear). */
static inline void attenuated_make(attenuated *made, const qv_volume *volume, int coarsest,
                                   uint32_t directions, const qv_order *order)
{
    size_t blocks_count = 1;
    memset(made, 0, sizeof *made);
    for (int axis = 0; axis < 3; axis++) {
        blocks_count *= (size_t)(volume->size[axis] + 1) / 2;
    }
    uint32_t *blocks = malloc(blocks_count * sizeof *blocks);
    assert_non_null(blocks);
    for (int level = 0; level <= coarsest; level++) {
        attenuated_describe(made, volume, level, directions, order);
    }
    for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++) {
        if ((directions >> direction & 1u) != 0) {
            attenuated_fill(made, volume, coarsest, blocks, direction);
        }
    }
    free(blocks);
}

static inline void attenuated_free(attenuated *made)
{
    for (int level = 0; level < 13; level++) {
        free(made->bytes[level]);
    }
}

/* A voxel of a level as it is offered to qv_splat. */
static inline qv_freevoxel attenuated_voxel(const attenuated *made, const qv_volume *level,
                                            int number, const uint16_t at[3])
{
    qv_freevoxel voxel;
    ptrdiff_t offset = 0;
    memset(&voxel, 0, sizeof voxel);
    for (int axis = 0; axis < 3; axis++) {
        offset += (ptrdiff_t)at[axis] * level->stride[axis];
        voxel.position[axis] = at[axis];
    }
    voxel.voxel = level->voxels + offset;
    voxel.attenuation = qv_attenuation_at(&made->level[number], at);
    voxel.level = (uint8_t)number;
    return voxel;
}

/* Adds all voxels of a level, back to front. */
static inline qv_status attenuated_splat(const qv_sums *sums, const qv_splats *splats,
                                         const attenuated *made, const qv_volume *level, int number)
{
    const qv_block all = {{0, 0, 0}, {level->size[0], level->size[1], level->size[2]}};
    return qv_splat_block(sums, splats, level, &made->level[number], (uint8_t)number, &all);
}

#endif /* ACCURACY_ATTENUATED_H */
