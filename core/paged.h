/*
 * paged.h - the sampling modes through pages: samples as sample.h makes them, of voxels that
 * pages.h finds.
 */
#ifndef QV_PAGED_H
#define QV_PAGED_H

#include "bspline.h"
#include "march.h"
#include "pages.h"

/* By how many cells that of a ray lies behind the first of the box, on one axis. */
FX_INLINE uint32_t qv_paged_beyond(const qv_pages *pages, const qv_ray *ray, unsigned axis)
{
    return (uint32_t)((uint64_t)ray->place[axis] >> 32) - pages->first[axis];
}

/* Where the cell lies in the box; returns 0 where it lies outside. */
FX_INLINE int qv_paged_locate(uint32_t beyond[3], const qv_pages *pages, const qv_ray *ray)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        beyond[axis] = qv_paged_beyond(pages, ray, axis);
        if (beyond[axis] >= pages->cells[axis])
            return 0;
    }
    return 1;
}

/* What is known of a sample's cell once its voxels are in memory. */
typedef struct qv_paged_cell {
    qv_address corner[8]; /* entries; of nearest modes, the first alone */
    fx_fraction fraction[3];
} qv_paged_cell;

FX_INLINE void qv_paged_corners(qv_paged_cell *cell, const uint32_t beyond[3], const qv_ray *ray,
                                const qv_volume *volume, unsigned storage)
{
    const qv_pages *pages = volume->pages;
    uint32_t offset = beyond[0] * qv_voxel_bytes(storage) + beyond[1] * pages->stride[1] +
                      beyond[2] * pages->stride[2]; /* below the bytes of a page */
    for (unsigned c = 0; c < 8; c++)
        cell->corner[c] = qv_paged_entry(pages->corner[c] + (size_t)offset, volume, storage);
    for (unsigned axis = 0; axis < 3; axis++)
        cell->fraction[axis] = fx_fraction_of((uint32_t)ray->place[axis] >> 24);
}

/* Of any ray. */
FX_INLINE void qv_paged_find(qv_paged_cell *cell, const qv_ray *ray, const qv_volume *volume,
                             unsigned storage)
{
    uint32_t beyond[3];
    while (!qv_paged_locate(beyond, volume->pages, ray))
        qv_pages_seek(volume->pages, ray->place);
    qv_paged_corners(cell, beyond, ray, volume, storage);
}

/* Moves the box of cells to where a ray stands, if it does not lie there. */
void qv_paged_bring(const qv_ray *ray, const qv_volume *volume);

/* Of a ray that stands in the box. */
FX_INLINE void qv_paged_find_brought(qv_paged_cell *cell, const qv_ray *ray,
                                     const qv_volume *volume, unsigned storage)
{
    uint32_t beyond[3];
    for (unsigned axis = 0; axis < 3; axis++)
        beyond[axis] = qv_paged_beyond(volume->pages, ray, axis);
    qv_paged_corners(cell, beyond, ray, volume, storage);
}

/* The voxel that contains the point, by 1/2 more of it; clamped for the 1/512 in it. */
FX_INLINE void qv_paged_find_nearest(qv_paged_cell *cell, const qv_ray *ray,
                                     const qv_volume *volume, unsigned storage)
{
    uint16_t position[3];
    for (unsigned axis = 0; axis < 3; axis++) {
        uint64_t place = (uint64_t)(ray->place[axis] + ((qv_coord)1 << 31));
        uint32_t index = (uint32_t)(place >> 32), last = volume->size[axis] - 1u;
        position[axis] = (uint16_t)(index < last ? index : last);
    }
    const uint8_t *voxel = qv_pages_voxel(volume->pages, position);
    cell->corner[0] = qv_paged_entry(voxel, volume, storage);
}

FX_INLINE int qv_paged_cell_nearest(qv_sample *sample, const qv_paged_cell *cell, unsigned storage)
{
    return qv_sample_entry(sample, cell->corner[0], storage);
}

FX_INLINE int qv_paged_cell_weighted(qv_sample *sample, const qv_paged_cell *cell, unsigned storage)
{
    return qv_interpolate_corners(sample, cell->corner, cell->fraction, storage, QV_BY_SHARE);
}

FX_INLINE int qv_paged_cell_separate(qv_sample *sample, const qv_paged_cell *cell, unsigned storage)
{
    int seen = qv_interpolate_corners(sample, cell->corner, cell->fraction, storage, QV_BY_WEIGHT);
    if (seen)
        qv_associate_light(sample, storage);
    return seen;
}

/* Modes that know no lengths advance the ray, while its place is at hand: qv_take_paged_MODE. */
#define QV_TAKE_PAGED(mode, find)                                                                  \
    FX_INLINE int qv_take_paged_##mode(qv_sample *sample, qv_ray *ray, const qv_volume *volume,    \
                                       unsigned storage)                                           \
    {                                                                                              \
        qv_paged_cell cell;                                                                        \
        find(&cell, ray, volume, storage);                                                         \
        qv_advance(ray);                                                                           \
        return qv_paged_cell_##mode(sample, &cell, storage);                                       \
    }

QV_TAKE_PAGED(nearest, qv_paged_find_nearest)
QV_TAKE_PAGED(separate, qv_paged_find)
QV_TAKE_PAGED(weighted, qv_paged_find)

/* The others do not, and their rays stand in the box: qv_family.bring. */
FX_INLINE int qv_paged_weighted(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                                unsigned storage)
{
    qv_paged_cell cell;
    qv_paged_find_brought(&cell, ray, volume, storage);
    return qv_paged_cell_weighted(sample, &cell, storage);
}

FX_INLINE int qv_paged_converted(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                                 unsigned storage)
{
    qv_paged_cell cell;
    qv_paged_find_brought(&cell, ray, volume, storage);
    return qv_interpolate_corners(sample, cell.corner, cell.fraction, storage, QV_BY_DENSITY);
}

/* ---- B-splines ---------------------------------------------------------------- */

/* The entry of one of the 27 voxels, numbered x fastest. */
FX_INLINE qv_address qv_paged_tap(unsigned number, const qv_triple triple[3],
                                  const qv_volume *volume, unsigned storage)
{
    const uint16_t position[3] = {(uint16_t)triple[0].at[number % 3u],
                                  (uint16_t)triple[1].at[number / 3u % 3u],
                                  (uint16_t)triple[2].at[number / 9u]};
    return qv_paged_entry(qv_pages_voxel(volume->pages, position), volume, storage);
}

/* The largest opacity of the 27 voxels. */
FX_INLINE uint32_t qv_paged_most(const qv_triple triple[3], const qv_volume *volume,
                                 unsigned storage)
{
    uint32_t most = 0;
    for (unsigned i = 0; i < QV_BSPLINE_TAPS; i++)
        most = qv_larger(most, qv_opacity_bits(qv_paged_tap(i, triple, volume, storage), storage));
    return most;
}

/*
 * The sums over all voxels, each with its part of 1. A voxel is looked for where it is added, so
 * that the stack keeps no list of 27; those without opacity add nothing. Returns 0 where all are.
 */
FX_INLINE int qv_paged_add_taps(qv_sample *sum, const qv_triple triple[3], const qv_volume *volume,
                                unsigned storage, qv_factor factor)
{
    fx_weight slice[3], row[3], voxel[3];
    int seen = 0;
    qv_part_one(slice, &triple[2]);
    for (unsigned i = 0; i < QV_BSPLINE_TAPS; i++) {
        if (i % 9u == 0)
            qv_part(row, slice[i / 9u], &triple[1]);
        if (i % 3u == 0)
            qv_part(voxel, row[i / 3u % 3u], &triple[0]);
        qv_address entry = qv_paged_tap(i, triple, volume, storage);
        if (qv_opacity_bits(entry, storage) != 0) {
            qv_add_voxel(sum, voxel[i % 3u], entry, storage, factor);
            seen = 1;
        }
    }
    return seen;
}

FX_INLINE int qv_paged_bspline(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                               unsigned storage, qv_factor factor)
{
    qv_triple triple[3];
    for (unsigned axis = 0; axis < 3; axis++)
        qv_triple_locate(&triple[axis], volume->size[axis], 1, ray, axis);
    sample->scale = 0;
    if (factor == QV_BY_DENSITY) {
        uint32_t most = qv_paged_most(triple, volume, storage);
        if (most == 0)
            return 0;
        sample->scale = qv_density_scale(most, storage);
    }
    sample->opacity = fx_share_of(0);
    for (unsigned c = 0; c < 3; c++)
        sample->light[c] = fx_sum_of(0);
    return qv_paged_add_taps(sample, triple, volume, storage, factor);
}

FX_INLINE int qv_paged_bspline_weighted(qv_sample *sample, const qv_ray *ray,
                                        const qv_volume *volume, unsigned storage)
{
    return qv_paged_bspline(sample, ray, volume, storage, QV_BY_SHARE);
}

FX_INLINE int qv_paged_bspline_converted(qv_sample *sample, const qv_ray *ray,
                                         const qv_volume *volume, unsigned storage)
{
    return qv_paged_bspline(sample, ray, volume, storage, QV_BY_DENSITY);
}

/*
 * Where addresses of program memory are no pointers, pages, which lie in RAM, hold indices into
 * a palette there, and no entries.
 */
#ifdef QV_MEMORY_HEADER
#define QV_PAGED_ENTRIES(...)
#else
#define QV_PAGED_ENTRIES(...) __VA_ARGS__
#endif

#endif /* QV_PAGED_H */
