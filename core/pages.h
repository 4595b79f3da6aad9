/*
 * pages.h - voxels that come through a cache of pages, each of which holds a brick.
 *
 * The library's own part of qv_pages describes a box of cells whose corners lie the same way in
 * the same pages: corner c of the cell beyond[] voxels after the first one lies at corner[c] +
 * beyond . stride. Along a ray most cells lie in the box of the last one. The box of a cell that
 * lies in several bricks, or is clamped, is one cell wide on that axis.
 */
#ifndef QV_PAGES_H
#define QV_PAGES_H

#include "fx_inline.h"
#include "access.h"
#include "qvol.h"
#include "storage.h"

/* No brick: there are fewer. */
#define QV_NO_BRICK 0xFFFFFFFFu

/*
 * Whether a volume can be sampled through its pages, `taps` voxels on an axis at a time.
 * QV_OK, QV_ERROR_NULL, _PAGES or an error of qv_volume_check that is not of voxels in memory.
 */
qv_status qv_pages_check(const qv_volume *volume, unsigned taps);

/* A voxel, from its page. As many bricks as a sample may lie in stay in the cache, those that were
   asked for last. */
const uint8_t *qv_pages_voxel(qv_pages *pages, const uint16_t position[3]);

/* Moves the box of cells to the cell of a ray's place. */
void qv_pages_seek(qv_pages *pages, const qv_coord place[3]);

/* Whether all voxels could be read. QV_OK, QV_ERROR_READ. */
static inline qv_status qv_pages_status(const qv_volume *volume)
{
    return volume->pages ? volume->pages->status : QV_OK;
}

/* The entry of a voxel that lies in RAM. */
FX_INLINE qv_address qv_paged_entry(const uint8_t *voxel, const qv_volume *volume, unsigned storage)
{
#ifndef QV_MEMORY_HEADER
    if (!qv_storage_indexed(storage))
        return voxel;
#endif
    return qv_at(volume->palette, (qv_offset)*voxel * (qv_offset)qv_entry_bytes(storage));
}

#endif /* QV_PAGES_H */
