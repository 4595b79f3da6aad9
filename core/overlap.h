/*
 * overlap.h - whether memory that is written is also read.
 */
#ifndef QV_OVERLAP_H
#define QV_OVERLAP_H

#include "access.h"
#include "qvol.h"

/* Whether regions of so many bytes share one, where the second begins `distance` behind the first,
   modulo the address space. */
static inline int qv_regions_meet(uintptr_t distance, uint64_t first, uint64_t second)
{
    return distance < first || (uintptr_t)(0u - distance) < second;
}

/* Whether memory that is written is also the voxels' of a checked volume, gaps between them
   included; its palette's; or that which a descriptor of attenuation gives. */
int qv_voxels_meet(const qv_volume *volume, const void *written, uint64_t bytes);
int qv_palette_meets(const qv_volume *volume, const void *written, uint64_t bytes);
int qv_records_meet(const qv_attenuation *attenuation, const void *written, uint64_t bytes);

#endif /* QV_OVERLAP_H */
