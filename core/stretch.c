#include "stretch.h"

#include "fx_bits.h"

#define QUOTIENT_BITS 23u
#define FARTHEST      (QV_GRID_LIMIT * QV_STEP)
#define LENGTH_SHIFT  (QV_STEP_BITS - 16u) /* from positions to a run's length */

/* The next 16 bits of rest / d, for rest < d and 2^31 <= d. The upper half h of d makes a
   guess: d < (h + 1) 2^16 and h >= 2^15, so that rest / h is above 2^16 rest / d by less than
   2^16 / h <= 2. What is left goes to rest. */
static uint32_t next_digit(uint32_t *rest, uint32_t d)
{
    uint64_t dividend = (uint64_t)*rest << 16;
    uint32_t guess = *rest / (d >> 16); /* <= 2^16 + 2 */
    while (fx_wide_product(guess, d) > dividend)
        guess--;
    *rest = (uint32_t)(dividend - fx_wide_product(guess, d));
    return guess;
}

/* rest / d in 1/2^24, cut to an even number, for rest < d <= 2^40: both are scaled until d
   has 32 bits. */
static uint32_t fraction(uint64_t rest, uint64_t d)
{
    for (; d >> 32 != 0; d >>= 1)
        rest >>= 1;
    unsigned shift = fx_leading_zeros((uint32_t)d);
    uint32_t divisor = (uint32_t)d << shift, part = (uint32_t)rest << shift;
    if (part == divisor) /* the two differed in what was shifted out */
        part--;
    uint32_t upper = next_digit(&part, divisor);
    return (upper << 8 | next_digit(&part, divisor) >> 8) & 0xFFFFFEu;
}

/*
 * n / d in 1/2^24, cut to an even number, for n < 2^62 and 0 < d <= 2^40, by shift and
 * subtract; twice the farthest position where the whole part does not fit.
 */
static int64_t quotient(uint64_t n, uint64_t d)
{
    uint32_t q = 0;
    unsigned bits = 0;
    for (; d <= n >> 1; bits++) {
        if (bits == QUOTIENT_BITS)
            return 2 * FARTHEST;
        d <<= 1; /* <= n */
    }
    for (unsigned i = 0; i < bits; i++) {
        if (n >= d) {
            n -= d;
            q |= 1u;
        }
        q <<= 1;
        d >>= 1;
    }
    if (n >= d) {
        n -= d;
        q |= 1u;
    }
    return ((int64_t)q << QV_STEP_BITS) + fraction(n, d);
}

/* Where a ray meets a plane that lies `way` ahead of sample 0; an even position. */
static int64_t crossing(qv_coord way, qv_coord advance)
{
    int backwards = (way < 0) != (advance < 0);
    uint64_t n = way < 0 ? 0u - (uint64_t)way : (uint64_t)way;
    uint64_t d = advance < 0 ? 0u - (uint64_t)advance : (uint64_t)advance;
    return backwards ? -quotient(n, d) : quotient(n, d);
}

/* Cuts the way to the slab between two faces. */
static void narrow_to_slab(qv_ray *ray, unsigned axis, qv_coord size)
{
    qv_coord place = ray->place[axis], advance = ray->advance[axis];
    if (advance == 0) {
        if (place < 0 || place >= size)
            ray->leave = ray->enter;
        return;
    }
    int64_t low = crossing(-place, advance), high = crossing(size - place, advance);
    int64_t enter = low < high ? low : high, leave = low < high ? high : low;
    if (ray->enter < enter)
        ray->enter = enter;
    if (ray->leave > leave)
        ray->leave = leave;
}

int32_t qv_stretch_of(int64_t position)
{
    return (int32_t)fx_shift_floor(position + QV_HALF_STEP, QV_STEP_BITS);
}

int64_t qv_path_begin(const qv_ray *ray, const qv_scene *scene)
{
    return ray->first == 0 ? -((int64_t)scene->phase << LENGTH_SHIFT) : -FARTHEST;
}

void qv_path_clip(qv_ray *ray, const qv_context *context)
{
    const qv_scene *scene = &context->scene;
    if (ray->first != QV_ONE_SLICE) {
        ray->enter = qv_path_begin(ray, scene);
        ray->leave = FARTHEST;
    }
    for (unsigned axis = 0; axis < 3; axis++)
        narrow_to_slab(ray, axis, (qv_coord)scene->volume.size[axis] << 32);
    ray->all = 0;
    if (ray->enter < ray->leave)
        ray->all = (uint32_t)(qv_stretch_of(ray->leave - 1) - qv_stretch_of(ray->enter)) + 1u;
    ray->samples = ray->all;
}

/* advance * part, to nearest, for a part of a step in 1/2^24 and |advance| <= 2^40. */
static qv_coord part_of(qv_coord advance, uint32_t part)
{
    qv_coord upper = fx_multiply(advance, (int32_t)(part >> 8)); /* |upper| <= 2^56 */
    qv_coord lower = fx_multiply(advance, (int32_t)(part & 0xFFu));
    return fx_shift_floor(upper + fx_shift_floor(lower, 8) + 0x8000, 16);
}

/* The way there is below 2^23 steps of at most 2^8 voxels, and the point lies in the box. 2^level
   steps are as many voxels of the level as a step is of the volume. */
void qv_stand_on_run(qv_ray *ray, const qv_run *run, unsigned level)
{
    int32_t whole = (int32_t)fx_shift_floor(run->middle, QV_STEP_BITS);
    uint32_t part = (uint32_t)run->middle & (uint32_t)(QV_STEP - 1);
    for (unsigned axis = 0; axis < 3; axis++) {
        qv_coord advance = ray->advance[axis];
        qv_coord point = run->origin[axis] + fx_multiply(advance, whole);
        if (part != 0)
            point += part_of(advance, part);
        ray->place[axis] = fx_shift_floor(point, level) + QV_CENTRED;
    }
}

int qv_cut_run(qv_run *run, qv_ray *ray, int64_t end, unsigned level)
{
    int64_t whole = QV_STEP << level;
    int64_t left = (end < ray->leave ? end : ray->leave) - ray->enter;
    if (left <= 0)
        return 0;
    /* from the border before, modulo a power of 2 whatever the sign */
    int64_t behind = (int64_t)((uint64_t)(ray->enter + QV_HALF_STEP) & ((uint64_t)whole - 1u));
    int64_t length = whole - behind < left ? whole - behind : left;
    run->samples = length == whole ? (uint32_t)(left >> (QV_STEP_BITS + level)) : 1u;
    /* to nearest; <= 2^28 */
    run->length = (uint32_t)((length + (1 << LENGTH_SHIFT) / 2) >> LENGTH_SHIFT);
    run->middle = ray->enter + length / 2;
    ray->enter += length * run->samples;
    return 1;
}

void qv_path_reverse(qv_ray *ray)
{
    int64_t enter = ray->enter;
    ray->enter = -ray->leave;
    ray->leave = -enter;
    for (unsigned axis = 0; axis < 3; axis++)
        ray->advance[axis] = -ray->advance[axis];
}
