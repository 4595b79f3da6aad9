/*
 * cell.h - the eight voxels round a sample, and where among them it lies.
 */
#ifndef QV_CELL_H
#define QV_CELL_H

#include "fx_weight.h"
#include "access.h"
#include "ray.h"
#include "storage.h"

typedef struct qv_cell {
    qv_address base;         /* voxel with the lowest indices */
    qv_offset next[3];       /* from there to its neighbour on each axis; 0 where clamped */
    fx_fraction fraction[3]; /* place between the two, Q0.8 */
} qv_cell;

/*
 * Finds the cell of a ray's next sample. The index before a clamped lower face is
 * -1, which unsigned lies above every size, as does the last index of an axis:
 * one comparison finds both.
 */
FX_INLINE void qv_cell_locate(qv_cell *cell, const qv_volume *volume, const qv_ray *ray)
{
    qv_address base = volume->voxels;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint64_t place = (uint64_t)ray->place[axis];
        uint32_t index = (uint32_t)(place >> 32);
        uint32_t last = volume->size[axis] - 1u;
        qv_offset stride = (qv_offset)volume->stride[axis];
        cell->fraction[axis] = fx_fraction_of((uint32_t)place >> 24);
        cell->next[axis] = stride;
        if (index >= last) {
            cell->next[axis] = 0;
            index = index > QV_AXIS_MAX ? 0 : last;
        }
        base = qv_at(base, (qv_offset)index * stride);
    }
    cell->base = base;
}

/* The address of a voxel's R,G,B,A entry: the voxel's own, or the palette's. */
FX_INLINE qv_address qv_entry(qv_address voxel, const qv_volume *volume, unsigned storage)
{
    if (!qv_storage_indexed(storage))
        return voxel;
    return qv_at(volume->palette, (qv_offset)qv_read8(voxel) * (qv_offset)qv_entry_bytes(storage));
}

/* The entries of a cell's corners; corner i has bit 0 of i on x, bit 1 on y, bit
   2 on z. */
FX_INLINE void qv_corners(qv_address corner[8], const qv_cell *cell, const qv_volume *volume,
                          unsigned storage)
{
    corner[0] = cell->base;
    for (unsigned axis = 0; axis < 3; axis++)
        for (unsigned i = 0; i < 1u << axis; i++)
            corner[(1u << axis) + i] = qv_at(corner[i], cell->next[axis]);
    for (unsigned i = 0; i < 8; i++)
        corner[i] = qv_entry(corner[i], volume, storage);
}

/* One channel of an entry: 0 R, 1 G, 2 B, 3 opacity. */
FX_INLINE fx_channel qv_channel(qv_address entry, unsigned channel, unsigned storage)
{
    if (qv_channel_bytes(storage) == 1)
        return fx_channel_of(qv_read8(qv_at(entry, (qv_offset)channel)));
    return fx_channel_of(qv_read16(qv_at(entry, (qv_offset)(2u * channel))));
}

#endif /* QV_CELL_H */
