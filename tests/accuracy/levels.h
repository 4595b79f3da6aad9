/*
 * levels.h - a volume of packed voxels with its pyramid, both in memory of their own.
 */
#ifndef ACCURACY_LEVELS_H
#define ACCURACY_LEVELS_H

#include "check.h"
#include "reference.h"

#include <stdlib.h>
#include <string.h>

/* May not move: the volume points into it. */
typedef struct levels {
    qv_volume volume;
    qv_pyramid pyramid;
    uint8_t *voxels, *coarser;
    uint16_t palette[QV_PALETTE_ENTRIES][4]; /* of indexed storage */
} levels;

/* A volume that is clear at first, x fastest, without a pyramid. */
static inline void levels_begin(levels *made, uint8_t storage, const uint16_t size[3])
{
    const int32_t entry = ref_is_wide(storage) ? 8 : 4;
    int32_t stride = ref_is_indexed(storage) ? 1 : entry;
    qv_volume *volume = &made->volume;
    memset(made, 0, sizeof *made);
    for (int axis = 0; axis < 3; axis++) {
        volume->size[axis] = size[axis];
        volume->stride[axis] = stride;
        stride *= size[axis];
    }
    volume->storage = storage;
    volume->unit_distance = QV_ONE_Q16;
    volume->voxels_bytes = (uint64_t)stride;
    if (ref_is_indexed(storage)) {
        volume->palette = (qv_address)made->palette;
        volume->palette_bytes = (uint32_t)(QV_PALETTE_ENTRIES * entry);
    }
    made->voxels = calloc((size_t)stride, 1);
    assert_true(made->voxels != NULL);
    volume->voxels = made->voxels;
}

/* Makes so many coarser levels of the volume as it is now. */
static inline void levels_make(levels *made, const qv_filter *filter, const qv_domain *domain,
                               uint8_t count)
{
    qv_volume finer, coarser;
    made->pyramid.levels = count;
    made->pyramid.bytes = qv_pyramid_bytes(made->volume.size, made->volume.storage, count);
    free(made->coarser);
    made->coarser = malloc((size_t)made->pyramid.bytes);
    assert_true(made->coarser != NULL);
    made->pyramid.voxels = made->coarser;
    for (uint8_t number = 0; number < count; number++) {
        uint8_t next = (uint8_t)(number + 1);
        assert_int_equal(qv_pyramid_level(&finer, &made->volume, &made->pyramid, number), QV_OK);
        assert_int_equal(qv_pyramid_level(&coarser, &made->volume, &made->pyramid, next), QV_OK);
        assert_int_equal(qv_downsample(made->coarser + (coarser.voxels - made->pyramid.voxels),
                                       (size_t)coarser.voxels_bytes, &finer, filter, domain, 0,
                                       coarser.size[2]),
                         QV_OK);
    }
}

static inline void levels_free(levels *made)
{
    free(made->voxels);
    free(made->coarser);
}

#endif /* ACCURACY_LEVELS_H */
