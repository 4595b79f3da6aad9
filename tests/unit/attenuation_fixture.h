/*
 * attenuation_fixture.h - random volumes and the memory of their attenuation.
 */
#ifndef ATTENUATION_FIXTURE_H
#define ATTENUATION_FIXTURE_H

#include "downsample_fixture.h"
#include "reference/attenuation.h"

#include <math.h>

#define RECORD_MOST 31 /* bytes: five more than there are directions */
#define UNTOUCHED   0xA5

static const qv_order *const orders[] = {NULL, &qv_order_linear, &qv_order_morton,
                                         &qv_order_hilbert};

/* A volume, its attenuation, and what both are made of. */
typedef struct lit {
    source from;
    qv_attenuation attenuation;
    unsigned char memory[SOURCE_VOXELS * RECORD_MOST];
    uint32_t blocks[SOURCE_VOXELS];
    double depths[SOURCE_VOXELS]; /* of the reference */
} lit;

static inline const qv_domain *domain_of(uint8_t storage)
{
    return storage >= QV_STORAGE_RGBT8 ? &qv_domain_stored : &qv_domain_extinction;
}

/* Records of a level of this size in the memory. */
static inline void lit_records(lit *l, const uint16_t size[3], uint32_t directions, uint16_t record,
                               const qv_order *order)
{
    qv_attenuation *a = &l->attenuation;
    memset(a, 0, sizeof *a);
    memset(l->memory, UNTOUCHED, sizeof l->memory);
    memcpy(a->size, size, sizeof a->size);
    a->records = l->memory;
    a->directions = directions;
    a->record = record;
    a->order = order;
    a->bytes = qv_attenuation_bytes(a);
}

/* 1 .. 11 voxels on an axis, at most SOURCE_VOXELS in all, and now and then a line. */
static inline void random_size(uint16_t size[3], uint32_t *seed)
{
    do {
        for (unsigned axis = 0; axis < 3; axis++)
            size[axis] = (uint16_t)(1 + random_below(seed, 11));
    } while (size[0] * size[1] * size[2] > SOURCE_VOXELS);
    if (random_below(seed, 8) == 0) {
        size[0] = size[1] = size[2] = 1;
        size[random_below(seed, 3)] = (uint16_t)(1 + random_below(seed, 100));
    }
}

/* A random volume, some axes of which are turned round. */
static inline void lit_volume(lit *l, uint8_t storage, source_filling filling, uint32_t *seed)
{
    uint16_t size[3];
    random_size(size, seed);
    source_make(&l->from, storage, size, filling, seed);
    for (unsigned axis = 0; axis < 3; axis++) {
        if (random_below(seed, 3) == 0)
            source_turn(&l->from, axis);
        if (random_below(seed, 3) != 0)
            l->from.volume.spacing[axis] = QV_ONE_Q16 / 16 + random_below(seed, 2 * QV_ONE_Q16);
    }
    l->from.volume.unit_distance = random_below(seed, 2) * (1 + random_below(seed, QV_ONE_Q16) * 2);
    l->from.volume.unit_distance += l->from.volume.unit_distance == 0 ? 0 : QV_ONE_Q16 / 4;
    l->from.volume.extinction = 1 + random_below(seed, 8 * QV_ONE_Q16);
}

/* Fills in one direction's bytes, and the sums of its blocks. */
static inline qv_status lit_attenuate(lit *l, uint8_t direction)
{
    return qv_attenuate(l->memory, (size_t)l->attenuation.bytes, l->blocks, &l->attenuation,
                        &l->from.volume, domain_of(l->from.volume.storage), direction);
}

/* Which of a voxel's bytes is a direction's. */
static inline unsigned slot_of(uint32_t directions, unsigned direction)
{
    unsigned slot = 0;
    for (unsigned d = 0; d < direction; d++)
        slot += directions >> d & 1;
    return slot;
}

/* The greatest distance of the bytes of a direction from 255 times the light of such depths, x
   fastest. */
static inline double farthest_byte(const qv_attenuation *a, unsigned direction,
                                   double (*depth)(const void *user, const uint16_t at[3]),
                                   const void *user)
{
    const unsigned slot = slot_of(a->directions, direction);
    double farthest = 0;
    uint16_t at[3];
    for (at[2] = 0; at[2] < a->size[2]; at[2]++)
        for (at[1] = 0; at[1] < a->size[1]; at[1]++)
            for (at[0] = 0; at[0] < a->size[0]; at[0]++) {
                const double exact = ref_attenuation(depth(user, at));
                farthest = fmax(farthest, fabs(qv_attenuation_at(a, at)[slot] - exact));
            }
    return farthest;
}

static inline void expect_at_most(double off, double most, const char *what)
{
    if (!(off <= most))
        fail_msg("%s: %.5f off, not %.5f", what, off, most);
}

#endif /* ATTENUATION_FIXTURE_H */
