/*
 * What a step's length means: the limits of unit distance and extinction, to the last bit,
 * and depth and light of steps and of pieces.
 */
#include "check.h"
#include "medium.h"
#include "random.h"
#include "scene_fixture.h"
#include "storage.h"

#include <math.h>

typedef qv_status preparation(qv_medium *medium, const qv_scene *scene, unsigned levels);

/* The fields of a scene that a medium is made of. */
typedef struct lengths {
    uint32_t step, unit, extinction;
    uint8_t storage, levels;
} lengths;

static qv_scene scene_of(const lengths *of)
{
    qv_scene scene;
    memset(&scene, 0, sizeof scene);
    scene.camera.step = of->step;
    scene.volume.unit_distance = of->unit;
    scene.volume.extinction = of->extinction;
    scene.volume.storage = of->storage;
    return scene;
}

/* Compares the status; on error nothing may be written. */
static void expect(preparation *prepare, const lengths *of, qv_status status)
{
    const qv_scene scene = scene_of(of);
    qv_medium medium;
    fixture_poison(&medium, sizeof medium);
    assert_int_equal(prepare(&medium, &scene, of->levels), status);
    assert_true((status == QV_OK) != fixture_untouched(&medium, sizeof medium));
}

static qv_medium medium_of(preparation *prepare, const lengths *of)
{
    const qv_scene scene = scene_of(of);
    qv_medium medium;
    assert_int_equal(prepare(&medium, &scene, of->levels), QV_OK);
    return medium;
}

/* ---- Unit distance ---- */

typedef struct limit {
    uint32_t step, unit;
    uint8_t levels;
    qv_status status;
} limit;

static void expect_ratios(preparation *prepare, const limit cases[], unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        const lengths of = {cases[i].step, cases[i].unit, 1, QV_STORAGE_RGBA8, cases[i].levels};
        expect(prepare, &of, cases[i].status);
    }
}

/* 2^-12 .. 2^12 steps. */
static void unit_distances_have_limits(void **state)
{
    static const limit both[] = {
        {65536, 65536u << 12, 0, QV_OK},
        {65536, (65536u << 12) + 1, 0, QV_ERROR_UNIT},
        {1, 4096, 0, QV_OK},
        {1, 4097, 0, QV_ERROR_UNIT},
        {0xFFFFFFFF, 0x7FFFFFFF, 0, QV_OK},
        {0xFFFFFFFF, 0x80000000, 0, QV_OK},
        {0x80000001, 0xFFFFFFFF, 0, QV_OK},
        {0x80001, 0x80001000, 0, QV_OK},
        {0x80001, 0x80001001, 0, QV_ERROR_UNIT},
        {0xFFFFFFFF, 0xFFFFFFFF, 0, QV_OK}, /* the step, whatever that is */
        {0xFFFFFFFF, 0, 0, QV_OK},
    };
    static const limit converted[] = {
        {65536, 65536u >> 12, 0, QV_OK},
        {65536, (65536u >> 12) - 1, 0, QV_ERROR_UNIT},
        {(16u << 12) + 1, 16, 0, QV_ERROR_UNIT},
        {(16u << 12) - 1, 16, 0, QV_OK},
    };
    (void)state;

    expect_ratios(qv_medium_corrected, both, sizeof both / sizeof *both);
    expect_ratios(qv_medium_converted, both, sizeof both / sizeof *both);
    expect_ratios(qv_medium_converted, converted, sizeof converted / sizeof *converted);
}

/* At least 2^-11 steps of the coarsest level. */
static void corrected_lengths_have_a_limit(void **state)
{
    static const limit cases[] = {
        {65536, 32, 0, QV_OK},     {65537, 32, 0, QV_ERROR_UNIT},
        {65536, 256, 3, QV_OK},    {65537, 256, 3, QV_ERROR_UNIT},
        {65536, 65536, 11, QV_OK}, {65536, 0, 12, QV_ERROR_UNIT},
    };
    (void)state;

    expect_ratios(qv_medium_corrected, cases, sizeof cases / sizeof *cases);
}

/* ---- Extinction ---- */

/* Above 0 and below 2^22 for a step, also of the coarsest level. */
static void extinctions_have_limits(void **state)
{
    (void)state;

    for (uint8_t levels = 0; levels <= 12; levels++)
        for (uint8_t storage = QV_STORAGE_RGBT8; storage <= QV_STORAGE_INDEXED8_T16; storage++) {
            const uint32_t step = (uint32_t)1 << (22 - levels);
            lengths of = {step, 0, 0xFFFFFFFF, storage, levels};
            expect(qv_medium_extinction, &of, QV_OK); /* 2^22 less 2^-32 of it */
            of.step++;
            expect(qv_medium_extinction, &of, QV_ERROR_EXTINCTION);
            of.step = step * 2;
            of.extinction = 0x80000000u;
            expect(qv_medium_extinction, &of, QV_ERROR_EXTINCTION);
            of.extinction--;
            expect(qv_medium_extinction, &of, QV_OK);
            of.extinction = 0;
            expect(qv_medium_extinction, &of, QV_ERROR_EXTINCTION);
            of.extinction = of.step = 1;
            expect(qv_medium_extinction, &of, QV_OK);
        }
}

/* Full opacity has a depth of 64 for its unit distance: 2^18 for 2^12 of them. */
static void converted_opacity_has_the_same_limit(void **state)
{
    lengths of = {4096, 1, 0, QV_STORAGE_RGBA8, 3};
    (void)state;

    expect(qv_medium_converted, &of, QV_OK);
    of.levels = 4;
    expect(qv_medium_converted, &of, QV_ERROR_EXTINCTION);
    of.step--;
    expect(qv_medium_converted, &of, QV_OK);
}

/* ---- Contexts ---- */

static void contexts_are_left_alone_on_error(void **state)
{
    static const qv_sampling *const modes[] = {&qv_corrected_rgba8, &qv_extinction_rgba16,
                                               &qv_bspline_weighted_indexed8,
                                               &qv_bspline_extinction_indexed8_16};
    static fixture f;
    qv_context context;
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        fixture_make(&f, modes[i], 1);
        f.scene.volume.unit_distance = f.scene.camera.step << 12;
        assert_int_equal(qv_init(&context, &f.scene), QV_OK);
        f.scene.volume.unit_distance++;
        fixture_poison(&context, sizeof context);
        assert_int_equal(qv_init(&context, &f.scene), QV_ERROR_UNIT);
        assert_true(fixture_untouched(&context, sizeof context));
    }
}

/* ---- What it is worth ---- */

/* Depths of modes with extinction are for 2^32 units of a sample's sum. */
static double units_of_1(uint8_t storage)
{
    return 65536.0 * (qv_channel_bytes(storage) == 1 ? 255 : 65535);
}

static double light_of(const qv_medium *medium)
{
    return ldexp(medium->light, (int)medium->light_shift - 32);
}

/* Light is cut to 32 bits, of which the coarsest level needs the first; `off` is what the
   depth that it is made of may be off by. */
static void expect_light(const qv_medium *medium, double light, double off, uint8_t levels)
{
    const double unit = ldexp(1, (int)medium->light_shift - 32);
    assert_true(fabs(light_of(medium) - light) <= 2 * unit + light * 0x1p-31 + off);
    assert_true(medium->light_shift >= 1 && (uint64_t)medium->light << levels < VOXEL);
    assert_true(medium->light_shift == 1 || (uint64_t)medium->light << levels >= VOXEL / 2);
}

static lengths random_lengths(uint32_t *seed)
{
    const lengths of = {
        (uint32_t)QV_ONE_Q16 << 4 >> random_below(seed, 9), random_next(seed) >> 9 | 0x100,
        random_next(seed) >> random_below(seed, 32) | 1,
        (uint8_t)(QV_STORAGE_RGBT8 + random_below(seed, 4)), (uint8_t)random_below(seed, 3)};
    return of;
}

static void steps_are_those_of_real_numbers(void **state)
{
    uint32_t seed = 1;
    (void)state;

    for (unsigned i = 0; i < 20000; i++) {
        const lengths of = random_lengths(&seed);
        const double ratio = (double)of.step / of.unit;
        const double depth = ldexp((double)of.extinction * of.step, -32);
        if (ratio * 4 <= 1024) {
            const qv_medium corrected = medium_of(qv_medium_corrected, &of);
            const qv_medium converted = medium_of(qv_medium_converted, &of);
            assert_true(fabs(ldexp((double)corrected.depth, -32) - ratio) <= 0x1p-32);
            assert_true(fabs(ldexp((double)converted.depth, -39) / ratio - 1) < 0x1p-15);
            assert_true((double)converted.depth >= ldexp(ratio, 39) - 128);
            expect_light(&corrected, ratio, 0, of.levels);
            expect_light(&converted, ratio * 64 * log(2), 64 * 0x1p-33, of.levels);
        }
        if (depth < 0x1p20) {
            const qv_medium stored = medium_of(qv_medium_extinction, &of);
            const double of_1 = ldexp((double)stored.depth * units_of_1(of.storage), -64);
            assert_true(fabs(of_1 - depth) <= depth * 0x1p-30 + 0x1p-30);
            expect_light(&stored, depth * log(2), 0, of.levels);
        }
    }
}

/* ---- Pieces ---- */

/* A whole step is the step itself; any other length is in proportion, cut. */
static void pieces_are_in_proportion(void **state)
{
    uint32_t seed = 2;
    (void)state;

    for (unsigned i = 0; i < 20000; i++) {
        lengths of = random_lengths(&seed);
        qv_medium whole, part;
        of.extinction >>= 8;
        of.extinction |= 1;
        const qv_medium step = medium_of(qv_medium_extinction, &of);
        const uint32_t most = (uint32_t)QV_ONE_Q16 << of.levels;
        const uint32_t length = (1 + random_below(&seed, most / 2)) * 2;
        qv_medium_scale(&whole, &step, QV_ONE_Q16);
        assert_memory_equal(&whole, &step, sizeof step);
        qv_medium_scale(&part, &step, length);
        const double depth = (double)step.depth * (length / 65536.0);
        const double light = (double)step.light * (length / 65536.0);
        assert_true((double)part.depth <= depth * (1 + 0x1p-50));
        assert_true((double)part.depth > depth * (1 - 0x1p-50) - 1);
        assert_true(part.light <= light && part.light > light - 1);
        assert_int_equal(part.light_shift, step.light_shift);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unit_distances_have_limits),
        cmocka_unit_test(corrected_lengths_have_a_limit),
        cmocka_unit_test(extinctions_have_limits),
        cmocka_unit_test(converted_opacity_has_the_same_limit),
        cmocka_unit_test(contexts_are_left_alone_on_error),
        cmocka_unit_test(steps_are_those_of_real_numbers),
        cmocka_unit_test(pieces_are_in_proportion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
