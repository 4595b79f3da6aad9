#include "bearing.h"

#include "direction.h"
#include "fx_log.h"
#include "fx_wide.h"
#include "layout.h"
#include "storage.h"

/* Which axes a direction moves along: a bit each, 1 .. 7. */
static unsigned axes_of(const int8_t step[3])
{
    return (step[0] != 0 ? 1u : 0u) | (step[1] != 0 ? 2u : 0u) | (step[2] != 0 ? 4u : 0u);
}

#define ONE_Q30 ((uint32_t)1 << 30)

/* n / d for d of 32 bits. */
static uint32_t quotient(uint64_t n, uint32_t d)
{
    unsigned cut = (unsigned)(d >> 31);
    return (uint32_t)fx_divide(n >> cut, d >> cut);
}

void qv_compass_of(qv_compass *compass, const qv_volume *volume, uint32_t directions,
                   uint8_t interpolation)
{
    uint32_t longest = qv_direction_length(volume->spacing, QV_DIRECTIONS - 1u);
    compass->directions = directions;
    compass->interpolation = interpolation;
    compass->any_length = !qv_storage_extinction(volume->storage) && volume->unit_distance == 0;
    for (unsigned axis = 0; axis < 3; axis++) /* shorter than the longest step */
        compass->side[axis] =
            quotient((uint64_t)qv_spacing(volume->spacing, axis) << (7 + 31), longest);
    for (unsigned axes = 1; axes < 8; axes++) {
        uint32_t v[3];
        for (unsigned axis = 0; axis < 3; axis++)
            v[axis] = (axes >> axis & 1u) != 0 ? compass->side[axis] : 0;
        /* 1 to 256 * 16 * sqrt 3, below 2^13 */
        compass->inverse[axes] = quotient((uint64_t)1 << (31 + 19), qv_length_of(v));
    }
}

/* The axes by falling magnitude; of equals, the lower first. */
static void sort_axes(unsigned axis[3], const int32_t v[3])
{
    for (unsigned i = 0; i < 3; i++) {
        unsigned place = i;
        for (; place > 0 && fx_magnitude(v[axis[place - 1u]]) < fx_magnitude(v[i]); place--)
            axis[place] = axis[place - 1u];
        axis[place] = i;
    }
}

/* part / whole as Q2.30 for part <= whole, whole in 2^30 .. 2^31: exactly 0 and 1, and
   between them within 2^-20. */
static uint32_t share_of(uint32_t part, uint32_t whole)
{
    if (part == whole)
        return ONE_Q30;
    uint64_t share = fx_wide_product(part, fx_reciprocal(whole)) >> 28; /* Q31 * Q27 to Q30 */
    return share < ONE_Q30 ? (uint32_t)share : ONE_Q30;
}

/* The direction that goes as v does on the first `count` of the axes. */
static void direction_of(int8_t step[3], const int32_t v[3], const unsigned axis[3], unsigned count)
{
    step[0] = step[1] = step[2] = 0;
    for (unsigned i = 0; i < count; i++)
        step[axis[i]] = v[axis[i]] < 0 ? -1 : 1;
}

/* Light along one direction alone. */
static void set_one(qv_bearing *bearing, uint8_t slot)
{
    for (unsigned i = 0; i < 3; i++) {
        bearing->slot[i] = slot;
        bearing->share[i] = i == 0 ? ONE_Q30 : 0;
        bearing->scale[i] = QV_BEARING_ONE;
    }
    bearing->of_depths = 0;
}

/* What is read of a direction that has a share: scale is to the length of v's step. */
static qv_status set_part(qv_bearing *bearing, unsigned part, const qv_compass *compass,
                          const int8_t step[3], uint32_t length)
{
    uint8_t direction = qv_direction(step[0], step[1], step[2]);
    if ((compass->directions >> direction & 1u) == 0)
        return QV_ERROR_DIRECTION;
    bearing->slot[part] = qv_direction_slot(compass->directions, direction);
    if (!compass->any_length) {
        uint32_t inverse = compass->inverse[axes_of(step)];
        bearing->scale[part] = (uint32_t)(fx_wide_product(inverse, length) >> 31);
    }
    if (bearing->of_depths)
        bearing->scale[part] =
            (uint32_t)(fx_wide_product(bearing->scale[part], bearing->share[part]) >> 30);
    return QV_OK;
}

/* v as parts of its largest magnitude, Q2.30, on its axes by falling magnitude; and a last of 0. */
static FX_NOINLINE void split(unsigned axis[3], uint32_t part[4], const int32_t v[3])
{
    sort_axes(axis, v);
    part[0] = ONE_Q30;
    for (unsigned i = 1; i < 3; i++)
        part[i] = share_of(fx_magnitude(v[axis[i]]), fx_magnitude(v[axis[0]]));
    part[3] = 0;
}

/* Length of v's step as part of the longest, Q1.31, which none is longer than: the root of the
   squares may be, by its own error. */
static FX_NOINLINE uint32_t step_length(const qv_compass *compass, const unsigned axis[3],
                                        const uint32_t part[4])
{
    const uint32_t longest = (uint32_t)1 << 31;
    uint32_t way[3];
    for (unsigned i = 0; i < 3; i++) /* part * side <= 2^30 * 2^31 */
        way[i] = (uint32_t)(fx_wide_product(part[i], compass->side[axis[i]]) >> 30);
    uint32_t length = qv_length_of(way);
    return length < longest ? length : longest;
}

/* Between three directions. Where one has all of the share, its byte says it all. */
static FX_NOINLINE qv_status between(qv_bearing *bearing, const qv_compass *compass,
                                     const int32_t v[3], const unsigned axis[3],
                                     const uint32_t part[4], uint32_t length)
{
    bearing->of_depths = compass->interpolation == QV_BETWEEN_DEPTHS;
    for (unsigned i = 0; i < 3; i++) {
        int8_t step[3];
        bearing->share[i] = part[i] - part[i + 1u]; /* parts fall, as magnitudes do */
        if (bearing->share[i] == 0)
            continue;
        direction_of(step, v, axis, i + 1u);
        qv_status status = set_part(bearing, i, compass, step, length);
        if (status != QV_OK)
            return status;
        if (bearing->share[i] == ONE_Q30)
            set_one(bearing, bearing->slot[i]);
    }
    return QV_OK;
}

/* Cosine between w and a direction, in units of |w| * 2^-18. w is a vector in world units, up to
   2^31 on each axis. */
static int64_t cosine_of(const qv_compass *compass, const int32_t w[3], const int8_t step[3])
{
    int64_t dot = 0; /* at most |w| times the step's length, sqrt 3 * 2^31 * 2^31 / 2^31 */
    for (unsigned axis = 0; axis < 3; axis++) {
        if (step[axis] == 0)
            continue;
        int64_t product =
            (int64_t)(fx_wide_product(fx_magnitude(w[axis]), compass->side[axis]) >> 31);
        dot += (w[axis] < 0) == (step[axis] < 0) ? product : -product;
    }
    return fx_multiply(dot, (int32_t)(compass->inverse[axes_of(step)] >> 1)); /* < 2^32 * 2^31 */
}

/* v in world units, and its magnitudes. */
static void to_world(int32_t world[3], uint32_t size[3], const qv_compass *compass,
                     const int32_t v[3])
{
    for (unsigned axis = 0; axis < 3; axis++) {
        size[axis] = (uint32_t)(fx_wide_product(fx_magnitude(v[axis]), compass->side[axis]) >> 31);
        world[axis] = v[axis] < 0 ? -(int32_t)size[axis] : (int32_t)size[axis];
    }
}

/* The direction of the set that is nearest by angle, of equals the one with the lowest number;
   QV_DIRECTIONS where all cosines are at most 1/2. */
static FX_NOINLINE uint8_t nearest_of(const qv_compass *compass, const int32_t v[3])
{
    int32_t world[3];
    uint32_t size[3];
    uint8_t taken = QV_DIRECTIONS;
    to_world(world, size, compass, v);
    int64_t best = (int64_t)((uint64_t)qv_length_of(size) << 17);
    for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++) {
        int8_t step[3];
        if ((compass->directions >> direction & 1u) == 0)
            continue;
        qv_direction_step(step, direction);
        int64_t cosine = cosine_of(compass, world, step);
        if (cosine > best) {
            best = cosine;
            taken = direction;
        }
    }
    return taken;
}

uint32_t qv_bearing_facing(const qv_compass *compass, int32_t corner[4][3])
{
    uint32_t facing = 0;
    for (unsigned i = 0; i < 4; i++) {
        int32_t world[3];
        uint32_t size[3];
        to_world(world, size, compass, corner[i]);
        for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++) {
            int8_t step[3];
            qv_direction_step(step, direction);
            if (cosine_of(compass, world, step) > 0)
                facing |= (uint32_t)1 << direction;
        }
    }
    return facing & compass->directions;
}

/* Whether v goes exactly along a direction that is not its opposite. */
static int is_along(const int32_t v[3], const int8_t step[3])
{
    uint32_t largest = qv_bearing_largest(v);
    for (unsigned axis = 0; axis < 3; axis++)
        if (fx_magnitude(v[axis]) != (step[axis] != 0 ? largest : 0u))
            return 0;
    return 1;
}

/* By the nearest direction, scaled to the length of v's step. */
static qv_status nearest(qv_bearing *bearing, const qv_compass *compass, const int32_t v[3],
                         uint8_t direction, uint32_t length)
{
    int8_t step[3];
    if (direction == QV_DIRECTIONS)
        return QV_ERROR_DIRECTION;
    qv_direction_step(step, direction);
    qv_status status = set_part(bearing, 0, compass, step, length);
    if (is_along(v, step))
        set_one(bearing, bearing->slot[0]);
    return status;
}

qv_status qv_bearing_of(qv_bearing *bearing, uint32_t *length, const qv_compass *compass,
                        const int32_t v[3])
{
    unsigned axis[3];
    uint32_t part[4];
    split(axis, part, v);
    *length = step_length(compass, axis, part);
    set_one(bearing, 0);
    if (compass->interpolation == QV_NEAREST)
        return nearest(bearing, compass, v, nearest_of(compass, v), *length);
    return between(bearing, compass, v, axis, part, *length);
}

/* Whether `sign` * v on one axis is more than `other_sign` * v on another, for some corner. */
static int somewhere(int32_t corner[4][3], unsigned axis, int sign, unsigned other, int other_sign)
{
    for (unsigned i = 0; i < 4; i++)
        if ((int64_t)sign * corner[i][axis] > (int64_t)other_sign * corner[i][other])
            return 1;
    return 0;
}

/*
 * A direction has a share in v where v goes its way on each of its axes, by more than it goes on
 * any other axis: linear conditions on v. One that holds at no corner holds nowhere between
 * them.
 */
static int has_share(int32_t corner[4][3], const int8_t step[3])
{
    for (unsigned axis = 0; axis < 3; axis++) {
        if (step[axis] == 0)
            continue;
        if (!somewhere(corner, axis, step[axis], axis, 0))
            return 0;
        for (unsigned other = 0; other < 3; other++)
            if (step[other] == 0 && !(somewhere(corner, axis, step[axis], other, 1) &&
                                      somewhere(corner, axis, step[axis], other, -1)))
                return 0;
    }
    return 1;
}

uint32_t qv_bearing_reach(int32_t corner[4][3])
{
    uint32_t reach = 0;
    for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++) {
        int8_t step[3];
        qv_direction_step(step, direction);
        if (has_share(corner, step))
            reach |= (uint32_t)1 << direction;
    }
    return reach;
}

void qv_bearing_voxels(int64_t v[3], const int64_t world[3], const uint32_t spacing[3])
{
    for (unsigned axis = 0; axis < 3; axis++) {
        uint64_t size = world[axis] < 0 ? 0u - (uint64_t)world[axis] : (uint64_t)world[axis];
        int64_t voxels = (int64_t)fx_divide(size, qv_spacing(spacing, axis));
        v[axis] = world[axis] < 0 ? -voxels : voxels;
    }
}

int qv_bearing_scale(int32_t scaled[3], const int64_t v[3])
{
    uint64_t size[3], all = 0;
    int halved = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        size[axis] = v[axis] < 0 ? 0u - (uint64_t)v[axis] : (uint64_t)v[axis];
        all |= size[axis];
    }
    for (; all >> 31 != 0; all >>= 1)
        halved++;
    for (; all >> 30 == 0; all <<= 1)
        halved--;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint64_t part = halved < 0 ? size[axis] << -halved : size[axis] >> halved;
        scaled[axis] = v[axis] < 0 ? -(int32_t)part : (int32_t)part;
    }
    return halved;
}

/* Depth of a byte, Q8.24: 257 times a byte is the same transmittance of 16 bits. */
static uint32_t depth_of(uint8_t byte)
{
    return byte == 0 ? QV_HIDDEN : fx_extinction_of_unorm16((fx_unorm16)(257u * (255u - byte)));
}

/* What is left of light, Q0.32: from Q1.31, of which 2^31 becomes 2^32 - 1. */
static uint32_t clear_after(fx_depth depth)
{
    uint32_t clear = fx_transmittance(depth);
    return (clear << 1) - (clear >> 31);
}

/* The depth of a part of a bearing, Q32.32: Q8.24 by Q13.19, at most 10 * 2^13. */
static fx_depth depth_along(const qv_bearing *bearing, unsigned part, qv_address bytes)
{
    uint8_t byte = qv_read8(qv_at(bytes, bearing->slot[part]));
    return fx_wide_product(bearing->scale[part], depth_of(byte)) >> 11;
}

/* Transmittance along a part of a bearing. A byte of 0 lets nothing through, whatever the scale;
   of scale 1 any byte is what it says. */
static uint32_t clear_along(const qv_bearing *bearing, unsigned part, qv_address bytes)
{
    uint8_t byte = qv_read8(qv_at(bytes, bearing->slot[part]));
    if (byte == 0 || bearing->scale[part] == QV_BEARING_ONE)
        return 0x01010101u * byte;
    return clear_after(depth_along(bearing, part, bytes));
}

/* Between transmittances: shares sum to 2^30. */
static uint32_t between_light(const qv_bearing *bearing, qv_address bytes)
{
    uint64_t clear = ONE_Q30 / 2u;
    for (unsigned i = 0; i < 3; i++)
        if (bearing->share[i] != 0)
            clear += fx_wide_product(clear_along(bearing, i, bytes), bearing->share[i]);
    return (uint32_t)(clear >> 30);
}

/* Between depths, whose scales are shares too; dark where all bytes are 0. */
static uint32_t between_depths(const qv_bearing *bearing, qv_address bytes)
{
    fx_depth depth = 0;
    int dark = 1;
    for (unsigned i = 0; i < 3; i++) {
        if (bearing->share[i] == 0)
            continue;
        depth += depth_along(bearing, i, bytes);
        dark &= qv_read8(qv_at(bytes, bearing->slot[i])) == 0;
    }
    return dark ? 0 : clear_after(depth);
}

static uint32_t clear_of(const qv_bearing *bearing, qv_address bytes)
{
    return bearing->of_depths ? between_depths(bearing, bytes) : between_light(bearing, bytes);
}

/* A_B / A_V is a difference of depths, of which the nearer voxel's cannot be more. */
uint32_t qv_bearing_transmittance(const qv_bearing *bearing, qv_address bytes, qv_address inside)
{
    uint32_t clear = clear_of(bearing, bytes);
    if (!inside || clear == 0)
        return clear;
    uint32_t whole = clear_of(bearing, inside);
    if (whole == 0) /* what qv_splat_init refuses */
        return 0;
    fx_depth depth = fx_depth_of_transmittance(clear);
    fx_depth less = fx_depth_of_transmittance(whole);
    return clear_after(depth > less ? depth - less : 0);
}
