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
 * Finds a ray's next sample on one axis, and returns where `base` moves to. The
 * index before a clamped lower face is -1, which unsigned lies above every size, as
 * does the last index of an axis: one comparison finds both.
 */
FX_INLINE qv_address qv_cell_locate_axis(qv_cell *cell, qv_address base, const qv_volume *volume,
                                         const qv_ray *ray, unsigned axis)
{
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
    return qv_at(base, (qv_offset)index * stride);
}

/* The cell of a ray's next sample. */
FX_INLINE void qv_cell_locate(qv_cell *cell, const qv_volume *volume, const qv_ray *ray)
{
    qv_address base = qv_cell_locate_axis(cell, volume->voxels, volume, ray, 0);
    base = qv_cell_locate_axis(cell, base, volume, ray, 1);
    cell->base = qv_cell_locate_axis(cell, base, volume, ray, 2);
}

/* The voxel of the half of the cell that the sample lies in. */
FX_INLINE qv_address qv_cell_nearest_voxel(const qv_cell *cell)
{
    qv_address voxel = cell->base;
    FX_UNROLL
    for (unsigned axis = 0; axis < 3; axis++)
        if (fx_fraction_bits(cell->fraction[axis]) >= 128)
            voxel = qv_at(voxel, cell->next[axis]);
    return voxel;
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
    qv_offset up = cell->next[2];
    qv_address at_0 = cell->base, at_x = qv_at(at_0, cell->next[0]);
    qv_address at_y = qv_at(at_0, cell->next[1]), at_xy = qv_at(at_x, cell->next[1]);
    corner[0] = qv_entry(at_0, volume, storage);
    corner[1] = qv_entry(at_x, volume, storage);
    corner[2] = qv_entry(at_y, volume, storage);
    corner[3] = qv_entry(at_xy, volume, storage);
    corner[4] = qv_entry(qv_at(at_0, up), volume, storage);
    corner[5] = qv_entry(qv_at(at_x, up), volume, storage);
    corner[6] = qv_entry(qv_at(at_y, up), volume, storage);
    corner[7] = qv_entry(qv_at(at_xy, up), volume, storage);
}

/* One channel of an entry: 0 R, 1 G, 2 B, 3 opacity. */
FX_INLINE fx_channel qv_channel(qv_address entry, unsigned channel, unsigned storage)
{
    if (qv_channel_bytes(storage) == 1)
        return fx_channel_of(qv_read8(qv_at(entry, (qv_offset)channel)));
    return fx_channel_of(qv_read16(qv_at(entry, (qv_offset)(2u * channel))));
}

#endif /* QV_CELL_H */
