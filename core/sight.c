#include "bearing.h"
#include "kernel.h"
#include "layout.h"
#include "splat.h"

/* The centre of a frame of n pixels is at (n - 1) / 2. */
static int64_t frame_centre(uint16_t pixels)
{
    return (int64_t)(pixels - 1u) * 32768;
}

/* The sum over the axes of a coefficient times the half voxels: |coefficient| < 2^44 (a voxel is at
   most 4096 pixels, or 256 world units, wide), so it is below 2^60. */
static int64_t along(const int64_t coefficient[3], const int32_t half[3])
{
    int64_t sum = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        sum += fx_multiply(coefficient[axis], half[axis]);
    return sum;
}

static int sight_orthographic(qv_sight *sight, const qv_splats *splats, const int32_t half[3],
                              unsigned level)
{
    unsigned above = level - splats->scene.level;
    if (splats->size[0] > QV_MOST_WIDTH >> above || splats->size[1] > QV_MOST_WIDTH >> above)
        return 0;
    sight->x = fx_shift_floor(along(splats->across, half) + 0x8000, 16);
    sight->y = fx_shift_floor(along(splats->down, half) + 0x8000, 16);
    sight->width = splats->size[0] << above;
    sight->height = splats->size[1] << above;
    sight->gain = splats->gain;
    sight->length = splats->length;
    sight->viewer = splats->viewer;
    return 1;
}

/*
 * v * enlarged, from Q31.32 to Q47.16, cut. v is below 2^60; the mantissa becomes a factor of
 * Q2.30. Enlargements are below 2^31, as a voxel's width shows; what would pass 2^62 is as far
 * outside of a frame as 2^40, which it becomes.
 */
static FX_NOINLINE int64_t enlarge(int64_t v, fx_scaled enlarged)
{
    const int64_t far_off = (int64_t)1 << 40;
    int64_t scaled = fx_scale_q30(v, (int32_t)(enlarged.mantissa >> 1)); /* < 2^61 */
    int shift = 16 - (enlarged.exponent + 31);
    if (shift >= 62)
        return 0;
    if (shift >= 0)
        return fx_shift_floor(scaled, (unsigned)shift);
    if (scaled > far_off >> -shift || scaled < -(far_off >> -shift))
        return scaled < 0 ? -far_off : far_off;
    return fx_multiply(scaled, (int32_t)1 << -shift);
}

/* How much larger something shows that lies so far ahead of the eye, in world units Q31.32. */
static FX_NOINLINE fx_scaled enlargement(const qv_splats *splats, int64_t ahead)
{
    return fx_scaled_over(qv_splats_number(splats, QV_DISTANCE),
                          fx_scaled_of((uint64_t)ahead, -32));
}

/* Half of a voxel's longest side, Q31.32. */
static int64_t nearest_ahead(const qv_splats *splats, unsigned level)
{
    uint32_t longest = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t side = qv_spacing(splats->scene.volume.spacing, axis);
        longest = side > longest ? side : longest;
    }
    return (int64_t)longest << (15u + level);
}

uint32_t qv_splats_reach(const qv_splats *splats, unsigned axis)
{
    const qv_splat_scene *scene = &splats->scene;
    fx_scaled width = qv_scaled_up(qv_splats_number(splats, QV_WIDTH + axis), scene->level);
    uint32_t widest = fx_scaled_fixed(width, 16, QV_MOST_WIDTH);
    uint32_t coarse = scene->coarsest > scene->level ? (uint32_t)scene->detail << 8 : 0;
    uint32_t frame = (uint32_t)(axis == 0 ? scene->view.width : scene->view.height) << 16;
    return frame + QV_FIELD(scene->kernel, halves) * (coarse > widest ? coarse : widest);
}

/* Width and height in pixels; 0 where they are out of range. */
static FX_NOINLINE int set_size(qv_sight *sight, const qv_splats *splats, fx_scaled enlarged,
                                unsigned level)
{
    uint32_t size[2];
    for (unsigned i = 0; i < 2; i++) {
        fx_scaled width = qv_scaled_up(qv_splats_number(splats, QV_WIDTH + i), level);
        size[i] = fx_scaled_fixed(fx_scaled_times(width, enlarged), 16, 0xFFFFFFFFu);
        if (size[i] < QV_LEAST_WIDTH || size[i] > QV_MOST_WIDTH)
            return 0;
    }
    sight->width = size[0];
    sight->height = size[1];
    return 1;
}

/* The way to the eye, and how often it was halved; returns 0 where it leads nowhere. */
static FX_NOINLINE int set_way(int32_t way[3], int *halved, const qv_splats *splats,
                               const int32_t half[3])
{
    int64_t v[3];
    for (unsigned axis = 0; axis < 3; axis++)
        v[axis] = splats->eye[axis] - (int64_t)half[axis] * 65536; /* half voxels, Q.16 */
    if (!qv_bearing_leads(v))
        return 0;
    *halved = qv_bearing_scale(way, v);
    return 1;
}

/* What comes along it: a voxel brings its gain times the layers that the way crosses for each
   unit that it leads ahead. */
static FX_NOINLINE uint32_t gain_along(const qv_splats *splats, const int32_t way[3], int halved,
                                       int64_t ahead)
{
    fx_scaled gain = fx_scaled_of(qv_bearing_largest(way), halved - 17); /* layers */
    gain = fx_scaled_over(gain, fx_scaled_of((uint64_t)ahead, -32));
    gain = fx_scaled_times(qv_splats_number(splats, QV_GAIN), gain);
    return fx_scaled_fixed(gain, 0, 0xFFFFFFFFu);
}

static int within(int64_t v, uint32_t reach)
{
    return v >= -(int64_t)reach && v <= (int64_t)reach;
}

/* Where it is seen, and how large, so much enlarged; 0 where that is out of reach. */
static int set_place(qv_sight *sight, const qv_splats *splats, const int32_t half[3],
                     fx_scaled enlarged, unsigned level)
{
    if (!set_size(sight, splats, enlarged, level))
        return 0;
    sight->x = enlarge(along(splats->across, half), enlarged);
    sight->y = enlarge(along(splats->down, half), enlarged);
    return within(sight->x, qv_splats_reach(splats, 0)) &&
           within(sight->y, qv_splats_reach(splats, 1));
}

/* All but the bearing of the way to the eye. */
static int sight_perspective(qv_sight *sight, int32_t way[3], const qv_splats *splats,
                             const int32_t half[3], unsigned level)
{
    int64_t ahead = splats->distance + along(splats->ahead, half);
    int halved;
    if (ahead < nearest_ahead(splats, level) ||
        !set_place(sight, splats, half, enlargement(splats, ahead), level) ||
        !set_way(way, &halved, splats, half))
        return 0;
    sight->gain = gain_along(splats, way, halved, ahead);
    return 1;
}

/* The same of either viewer; an orthographic one has his bearing too. */
static FX_NOINLINE int sight_but_bearing(qv_sight *sight, int32_t way[3], const qv_splats *splats,
                                         const uint16_t position[3], unsigned level)
{
    const qv_splat_scene *scene = &splats->scene;
    int32_t half[3];
    qv_half_voxels(half, scene->volume.size, position, level);
    int drawn = scene->field_of_view == 0 ? sight_orthographic(sight, splats, half, level)
                                          : sight_perspective(sight, way, splats, half, level);
    if (!drawn)
        return 0;
    sight->x += frame_centre(scene->view.width);
    sight->y += frame_centre(scene->view.height);
    return 1;
}

int qv_sight_of(qv_sight *sight, const qv_splats *splats, const uint16_t position[3],
                unsigned level)
{
    int32_t way[3];
    if (!sight_but_bearing(sight, way, splats, position, level))
        return 0;
    return splats->scene.field_of_view == 0 ||
           qv_bearing_of(&sight->viewer, &sight->length, &splats->compass, way) == QV_OK;
}

/* ---- Levels ----------------------------------------------------------------- */

int qv_splats_fine(const qv_splats *splats, fx_scaled enlarged, unsigned level)
{
    const fx_scaled detail = fx_scaled_of(splats->scene.detail, -8);
    for (unsigned i = 0; i < 2; i++) {
        fx_scaled width = qv_scaled_up(qv_splats_number(splats, QV_WIDTH + i), level);
        if (!fx_scaled_at_most(fx_scaled_times(width, enlarged), detail))
            return 0;
    }
    return 1;
}

/* What is too near to be drawn is not fine enough at any level. */
static FX_NOINLINE int is_fine(const qv_splats *splats, const uint16_t position[3], unsigned level)
{
    int32_t half[3];
    qv_half_voxels(half, splats->scene.volume.size, position, level);
    int64_t ahead = splats->distance + along(splats->ahead, half);
    return ahead >= nearest_ahead(splats, level) &&
           qv_splats_fine(splats, enlargement(splats, ahead), level);
}

int qv_splat_belongs(const qv_splats *splats, const uint16_t position[3], unsigned level)
{
    const qv_splat_scene *scene = &splats->scene;
    if (level < scene->level || level > scene->coarsest)
        return 0;
    if (scene->field_of_view == 0)
        return level == splats->drawn;
    for (unsigned above = scene->coarsest; above > level; above--) {
        uint16_t whole[3];
        for (unsigned axis = 0; axis < 3; axis++)
            whole[axis] = (uint16_t)(position[axis] >> (above - level));
        if (is_fine(splats, whole, above))
            return 0;
    }
    return level == scene->level || is_fine(splats, position, level);
}
