#include "ray.h"

#define QUOTIENT_BITS 23u

/* Voxels from a sample to the next where no other is to lie in the box. */
#define BEYOND ((qv_coord)1 << 45)

/* A range of sample numbers, both ends included. */
typedef struct {
    int32_t first, last;
} range;

/*
 * floor(n / d) for d > 0, by shift and subtract on as many bits as the quotient
 * has; magnitudes of 2^24 and more come out as some value not below 2^24 - 1 =
 * 4 QV_GRID_LIMIT - 1. floor(n / d) = -1 - floor((-1 - n) / d) for negative n.
 */
static int32_t quotient(qv_coord n, uint64_t d)
{
    uint64_t rest = n < 0 ? ~(uint64_t)n : (uint64_t)n;
    uint32_t q = 0;
    unsigned bits = 0;
    while (bits < QUOTIENT_BITS && d <= rest >> 1) {
        d <<= 1; /* <= rest < 2^62 */
        bits++;
    }
    for (unsigned i = 0; i <= bits; i++) {
        q <<= 1;
        if (rest >= d) {
            rest -= d;
            q |= 1u;
        }
        d >>= 1;
    }
    return n < 0 ? -1 - (int32_t)q : (int32_t)q;
}

/*
 * Keeps the k with 0 <= place + k * advance < size. Seen from the slab's other
 * face, at size - 1 - place, a ray that runs downwards runs upwards.
 */
static void narrow_to_slab(range *k, qv_coord place, qv_coord advance, qv_coord size)
{
    if (advance == 0) {
        if (place < 0 || place >= size)
            k->last = k->first - 1;
        return;
    }
    uint64_t pace = (uint64_t)advance;
    if (advance < 0) {
        pace = 0u - pace;
        place = size - 1 - place;
    }
    int32_t first = -quotient(place, pace), last = -1 - quotient(place - size, pace);
    if (k->first < first)
        k->first = first;
    if (k->last > last)
        k->last = last;
}

void qv_ray_clip(qv_ray *ray, const qv_context *context)
{
    const uint16_t *size = context->scene.volume.size;
    range k = {ray->first, QV_GRID_LIMIT - 1};
    for (unsigned axis = 0; axis < 3; axis++)
        narrow_to_slab(&k, ray->place[axis], ray->advance[axis], (qv_coord)size[axis] << 32);
    ray->all = k.last < k.first ? 0u : (uint32_t)(k.last - k.first) + 1u;
    ray->samples = ray->all;
    /* where samples remain, the point lies in the box: no overflow */
    if (ray->samples != 0)
        for (unsigned axis = 0; axis < 3; axis++)
            ray->place[axis] += fx_multiply(ray->advance[axis], k.first) + QV_CENTRED;
}

void qv_ray_count_from(qv_ray *ray, int32_t sample)
{
    for (unsigned axis = 0; axis < 3; axis++)
        ray->place[axis] += fx_multiply(ray->advance[axis], sample);
    ray->first -= sample;
}

int qv_ray_hold(qv_ray *ray, const qv_context *context)
{
    const uint16_t *size = context->scene.volume.size;
    if (ray->first > 0)
        return 0;
    for (unsigned axis = 0; axis < 3; axis++)
        if (ray->place[axis] < 0 || ray->place[axis] >= (qv_coord)size[axis] << 32)
            return 0;
    for (unsigned axis = 0; axis < 3; axis++)
        ray->advance[axis] = 0;
    ray->advance[0] = BEYOND;
    ray->first = 0;
    return 1;
}

qv_coord qv_phase_of(qv_coord v, uint16_t phase)
{
    return fx_shift_floor(fx_multiply(v, phase) + 0x8000, 16); /* |v| * 2^16 <= 2^56 */
}
