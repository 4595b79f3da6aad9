/*
 * Bearings: which of a voxel's bytes count for light from anywhere, against a model in doubles.
 */
#include "bearing.h"
#include "check.h"
#include "direction.h"
#include "random.h"

#include <math.h>

static const uint32_t spacings[][3] = {
    {0, 0, 0}, {65536, 98304, 131072}, {4096, 16777216, 65536}, {81920, 81920, 20480}};
/* Cosines where one side of a voxel is 4096 times another. */
#define TOLERANCE 1e-3

#define SPACINGS (sizeof spacings / sizeof *spacings)

static qv_volume volume_of(const uint32_t spacing[3], uint32_t unit)
{
    qv_volume volume = {.storage = QV_STORAGE_RGBA8, .unit_distance = unit};
    for (unsigned axis = 0; axis < 3; axis++)
        volume.spacing[axis] = spacing[axis];
    return volume;
}

static double side_of(const qv_volume *volume, unsigned axis)
{
    return volume->spacing[axis] == 0 ? 1 : volume->spacing[axis] / 65536.;
}

static double length_of(const qv_volume *volume, const double v[3])
{
    double square = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        square += v[axis] * v[axis] * side_of(volume, axis) * side_of(volume, axis);
    return sqrt(square);
}

/* A vector of the size that bearings take, not along an axis. */
static void random_vector(int32_t v[3], uint32_t *random)
{
    const unsigned longest = random_below(random, 3);
    for (unsigned axis = 0; axis < 3; axis++) {
        const uint32_t size = axis == longest
                                  ? 0x40000000u + (random_next(random) >> 2)
                                  : random_next(random) >> (2 + random_below(random, 9));
        v[axis] = random_below(random, 2) == 0 ? (int32_t)size : -(int32_t)size;
    }
}

/* The share of direction d in v. */
static double model_share(const int32_t v[3], uint8_t d)
{
    int8_t step[3];
    double largest = 0, least_on = HUGE_VAL, most_off = 0;
    qv_direction_step(step, d);
    for (unsigned axis = 0; axis < 3; axis++)
        largest = fmax(largest, fabs((double)v[axis]));
    for (unsigned axis = 0; axis < 3; axis++) {
        if (step[axis] == 0)
            most_off = fmax(most_off, fabs(v[axis] / largest));
        else
            least_on = fmin(least_on, v[axis] / largest * step[axis]);
    }
    return fmax(0, least_on - most_off);
}

/* Length of v's step by that of direction d. */
static double model_scale(const qv_volume *volume, const int32_t v[3], uint8_t d)
{
    int8_t step[3];
    double way[3], largest = 0, own[3];
    if (volume->unit_distance == 0)
        return 1;
    qv_direction_step(step, d);
    for (unsigned axis = 0; axis < 3; axis++)
        largest = fmax(largest, fabs((double)v[axis]));
    for (unsigned axis = 0; axis < 3; axis++) {
        way[axis] = v[axis] / largest;
        own[axis] = step[axis];
    }
    return length_of(volume, way) / length_of(volume, own);
}

static void check_parts(const qv_volume *volume, const qv_bearing *bearing, const int32_t v[3])
{
    uint32_t whole = 0;
    for (unsigned i = 0; i < 3; i++)
        whole += bearing->share[i];
    assert_int_equal(whole, 1u << 30);
    for (uint8_t d = 0; d < QV_DIRECTIONS; d++) {
        const double exact = model_share(v, d), by = model_scale(volume, v, d);
        double share = 0, scale = by;
        for (unsigned i = 0; i < 3; i++)
            if (bearing->share[i] != 0 && bearing->slot[i] == d) {
                share = ldexp(bearing->share[i], -30);
                scale = (double)bearing->scale[i] / QV_BEARING_ONE;
            }
        const double expected = bearing->of_depths && share != 0 ? exact * by : by;
        assert_true(fabs(share - exact) <= ldexp(1, -18));
        assert_true(fabs(scale - expected) <= ldexp(1 + by, -16));
    }
}

static void check_vector(const qv_volume *volume, const int32_t v[3], uint8_t interpolation)
{
    qv_compass compass;
    qv_bearing bearing;
    uint32_t length;
    double way[3], longest[3] = {1, 1, 1}, largest = 0;
    qv_compass_of(&compass, volume, QV_DIRECTIONS_ALL, interpolation);
    assert_int_equal(qv_bearing_of(&bearing, &length, &compass, v), QV_OK);
    assert_int_equal(bearing.of_depths, interpolation == QV_BETWEEN_DEPTHS);
    for (unsigned axis = 0; axis < 3; axis++)
        largest = fmax(largest, fabs((double)v[axis]));
    for (unsigned axis = 0; axis < 3; axis++)
        way[axis] = v[axis] / largest;
    const double exact = length_of(volume, way) / length_of(volume, longest);
    assert_true(fabs(length * ldexp(1, -31) / exact - 1) < ldexp(1, -16));
    check_parts(volume, &bearing, v);
}

static void shares_between_three(void **state)
{
    uint32_t random = 31;
    (void)state;
    for (unsigned i = 0; i < 40000; i++) {
        const qv_volume volume = volume_of(spacings[i % SPACINGS], (i / 7) % 2 * 65536u);
        int32_t v[3];
        random_vector(v, &random);
        check_vector(&volume, v, i % 2 == 0 ? QV_BETWEEN_LIGHT : QV_BETWEEN_DEPTHS);
    }
}

/* Exactly along a direction its byte alone counts, and it is the transmittance. */
static void along_one_direction(void **state)
{
    static const int32_t sizes[] = {0x40000000, 0x7FFFFFFF, 0x51234567};
    (void)state;
    for (unsigned s = 0; s < SPACINGS; s++)
        for (uint8_t d = 0; d < QV_DIRECTIONS; d++) {
            const qv_volume volume = volume_of(spacings[s], 65536);
            qv_compass compass;
            qv_bearing bearing;
            uint32_t length;
            int8_t step[3];
            int32_t v[3];
            uint8_t bytes[QV_DIRECTIONS] = {0};
            qv_direction_step(step, d);
            for (unsigned axis = 0; axis < 3; axis++)
                v[axis] = step[axis] * sizes[s % 3];
            qv_compass_of(&compass, &volume, (uint32_t)1 << d, (uint8_t)(s % 3));
            assert_int_equal(qv_bearing_of(&bearing, &length, &compass, v), QV_OK);
            assert_true(bearing.share[0] == 1u << 30 && bearing.slot[0] == 0);
            for (unsigned byte = 0; byte < 256; byte++) {
                bytes[0] = (uint8_t)byte;
                assert_int_equal(qv_bearing_transmittance(&bearing, bytes, 0), byte * 0x01010101u);
            }
        }
}

static void missing_directions_are_refused(void **state)
{
    const qv_volume volume = volume_of(spacings[0], 65536);
    const int32_t v[3] = {0x60000000, -0x40000000, 0x20000000};
    const uint8_t needed[] = {qv_direction(1, 0, 0), qv_direction(1, -1, 0),
                              qv_direction(1, -1, 1)};
    (void)state;
    for (uint8_t d = 0; d < QV_DIRECTIONS; d++) {
        qv_compass compass;
        qv_bearing bearing;
        uint32_t length;
        const int missing = d == needed[0] || d == needed[1] || d == needed[2];
        qv_compass_of(&compass, &volume, QV_DIRECTIONS_ALL & ~((uint32_t)1 << d), 0);
        assert_int_equal(qv_bearing_of(&bearing, &length, &compass, v),
                         missing ? QV_ERROR_DIRECTION : QV_OK);
    }
}

/* All of the share is one direction's, whose depth is scaled to the length of v's step. */
static void check_nearest(const qv_volume *volume, const qv_bearing *bearing, uint32_t set,
                          const int32_t v[3])
{
    assert_int_equal(bearing->share[0], 1u << 30);
    for (uint8_t d = 0; d < QV_DIRECTIONS; d++) {
        if ((set >> d & 1u) == 0 || qv_direction_slot(set, d) != bearing->slot[0])
            continue;
        const double by = model_scale(volume, v, d);
        assert_true(fabs((double)bearing->scale[0] / QV_BEARING_ONE - by) <= ldexp(1 + by, -16));
    }
}

/* The nearest by angle in world units, of any set; none beyond 60 degrees. */
static void nearest_directions(void **state)
{
    uint32_t random = 32;
    unsigned refused = 0;
    (void)state;
    for (unsigned i = 0; i < 30000; i++) {
        const qv_volume volume = volume_of(spacings[i % SPACINGS], 65536);
        const uint32_t set = random_next(&random) & random_next(&random) & QV_DIRECTIONS_ALL;
        qv_compass compass;
        qv_bearing bearing;
        uint32_t length;
        int32_t v[3];
        double best = -1, taken = -1;
        if (set == 0)
            continue;
        random_vector(v, &random);
        qv_compass_of(&compass, &volume, set, QV_NEAREST);
        const qv_status status = qv_bearing_of(&bearing, &length, &compass, v);
        for (uint8_t d = 0; d < QV_DIRECTIONS; d++) {
            int8_t step[3];
            double dot = 0, way[3], own[3];
            qv_direction_step(step, d);
            for (unsigned axis = 0; axis < 3; axis++) {
                const double side = side_of(&volume, axis);
                way[axis] = v[axis];
                own[axis] = step[axis];
                dot += v[axis] * side * step[axis] * side;
            }
            const double cosine = dot / length_of(&volume, way) / length_of(&volume, own);
            if ((set >> d & 1u) == 0)
                continue;
            best = fmax(best, cosine);
            if (status == QV_OK && qv_direction_slot(set, d) == bearing.slot[0])
                taken = cosine;
        }
        refused += status != QV_OK;
        if (status == QV_OK)
            check_nearest(&volume, &bearing, set, v);
        if (status == QV_OK)
            assert_true(taken >= best - TOLERANCE && best > .5 - TOLERANCE);
        else
            assert_true(status == QV_ERROR_DIRECTION && best < .5 + TOLERANCE);
    }
    assert_true(refused > 100);
}

/* What the bytes at three slots are to let through. */
static double model_light(const qv_bearing *bearing, const uint8_t *bytes)
{
    double depth = 0, light = 0;
    int seen = 0;
    for (unsigned k = 0; k < 3; k++) {
        const uint8_t byte = bytes[bearing->slot[k]];
        const double scale = (double)bearing->scale[k] / QV_BEARING_ONE;
        const double own = scale * (byte == 0 ? 10 : -log2(byte / 255.));
        seen |= byte != 0;
        depth += own;
        light += byte == 0 ? 0 : exp2(-own) * ldexp(bearing->share[k], -30);
    }
    if (!bearing->of_depths)
        return light;
    return seen ? exp2(-depth) : 0;
}

/* Transmittances are interpolated, or depths: of these a byte of 0 counts as 10, but if all are,
   nothing passes. Inside, what passes is part of what does for the voxel that light is followed
   to. */
static void transmittance_between(void **state)
{
    uint32_t random = 33;
    (void)state;
    for (unsigned i = 0; i < 60000; i++) {
        const uint32_t first = random_below(&random, 1u << 29),
                       second = random_below(&random, 1u << 29);
        qv_bearing bearing = {
            {first, second, (1u << 30) - first - second}, {0, 0, 0}, {2, 5, 9}, (uint8_t)(i % 2)};
        uint8_t bytes[10], inside[10];
        for (unsigned k = 0; k < 10; k++) {
            bytes[k] = (uint8_t)(i % 5 == 0 ? i / 5 % 2 : random_next(&random) >> 3);
            inside[k] = (uint8_t)(random_next(&random) >> 5);
        }
        for (unsigned k = 0; k < 3; k++)
            bearing.scale[k] =
                i % 7 == 0 ? QV_BEARING_ONE : random_below(&random, 2 * QV_BEARING_ONE);
        const double outside = model_light(&bearing, bytes), whole = model_light(&bearing, inside);
        const double clear = ldexp(qv_bearing_transmittance(&bearing, bytes, NULL), -32);
        assert_true(fabs(clear - outside) < ldexp(1, -22));
        if (whole < ldexp(1, -9))
            continue;
        const double within = ldexp(qv_bearing_transmittance(&bearing, bytes, inside), -32);
        assert_true(fabs(within - fmin(1, outside / whole)) < ldexp(1, -22) / whole);
    }
}

/* Whatever has a share somewhere between the corners is in reach. */
static void reach_of_corners(void **state)
{
    uint32_t random = 34;
    unsigned spared = 0;
    (void)state;
    for (unsigned i = 0; i < 3000; i++) {
        int32_t corner[4][3];
        for (unsigned k = 0; k < 4; k++)
            random_vector(corner[k], &random);
        const uint32_t reach = qv_bearing_reach(corner);
        spared += reach != QV_DIRECTIONS_ALL;
        for (unsigned k = 0; k < 100; k++) {
            int64_t sum[3] = {0, 0, 0};
            int32_t v[3];
            for (unsigned c = 0; c < 4; c++) {
                const uint32_t part = random_below(&random, 1000);
                for (unsigned axis = 0; axis < 3; axis++)
                    sum[axis] += (int64_t)part * corner[c][axis];
            }
            if (sum[0] == 0 && sum[1] == 0 && sum[2] == 0)
                continue;
            (void)qv_bearing_scale(v, sum);
            for (uint8_t d = 0; d < QV_DIRECTIONS; d++)
                if (model_share(v, d) > 1e-8)
                    assert_true((reach >> d & 1u) != 0);
        }
    }
    assert_true(spared > 300);
}

static void scaled_vectors(void **state)
{
    uint32_t random = 35;
    (void)state;
    for (unsigned i = 0; i < 20000; i++) {
        int64_t v[3];
        int32_t scaled[3];
        const unsigned shift = random_below(&random, 62);
        for (unsigned axis = 0; axis < 3; axis++) {
            const uint64_t bits = (uint64_t)random_next(&random) << 32 | random_next(&random);
            v[axis] = (int64_t)(bits >> 2 >> shift) * (random_below(&random, 2) == 0 ? 1 : -1);
        }
        if (v[0] == 0 && v[1] == 0 && v[2] == 0)
            continue;
        const int halved = qv_bearing_scale(scaled, v);
        const uint32_t largest = qv_bearing_largest(scaled);
        assert_true(largest >= 1u << 30 && largest < 1u << 31);
        for (unsigned axis = 0; axis < 3; axis++)
            assert_true(fabs(scaled[axis] - ldexp((double)v[axis], -halved)) < 1);
    }
}

/* What an opacity's thickness, up to 2^32 - 1 of it, is multiplied by: at most 1. In voxels of 1/16
   the root of the squares of the parts is 2^31 + 1072. */
static void no_step_is_longer_than_the_longest(void **state)
{
    static const uint32_t small[3] = {4096, 4096, 4096};
    static const int32_t v[3] = {0x40000000, -0x40000000, 0x40000000};
    const qv_volume volume = volume_of(small, 65536);
    (void)state;
    for (uint8_t interpolation = 0; interpolation < 2; interpolation++) {
        qv_compass compass;
        qv_bearing bearing;
        uint32_t length;
        qv_compass_of(&compass, &volume, QV_DIRECTIONS_ALL, interpolation);
        assert_int_equal(qv_bearing_of(&bearing, &length, &compass, v), QV_OK);
        assert_int_equal(length, 0x80000000u);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shares_between_three),
        cmocka_unit_test(along_one_direction),
        cmocka_unit_test(missing_directions_are_refused),
        cmocka_unit_test(nearest_directions),
        cmocka_unit_test(transmittance_between),
        cmocka_unit_test(reach_of_corners),
        cmocka_unit_test(scaled_vectors),
        cmocka_unit_test(no_step_is_longer_than_the_longest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
