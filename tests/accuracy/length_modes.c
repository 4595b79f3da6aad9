/*
 * Modes that weigh by length against the double-precision reference on seeded scenes:
 * every storage, front to back, back to front and through a pyramid.
 */
#include "check.h"
#include "comparison.h"

#include <inttypes.h>
#include <stdio.h>

#define SCENES        200
#define SHARE         8   /* one scene in this many runs the other storages */
#define LEAST_COVERED 200 /* channels: fifty pixels of a frame of some thousand */

static const double least_equal = 0.99;

typedef enum direction { FRONT_TO_BACK, BACK_TO_FRONT, LEVELS } direction;

typedef struct length_mode {
    const char *name;
    const qv_sampling *sampling[3]; /* by direction */
    ref_mode mode;
} length_mode;

#define LENGTH_MODE(name, mode)                                                                    \
    {                                                                                              \
#name, {&name, &name##_back_to_front, &name##_levels }, mode                               \
    }
#define OPACITY_MODES(name, mode)                                                                  \
    LENGTH_MODE(name##_rgba16, mode), LENGTH_MODE(name##_rgba8, mode),                             \
        LENGTH_MODE(name##_indexed8, mode), LENGTH_MODE(name##_indexed8_16, mode)
#define EXTINCTION_MODES(name, mode)                                                               \
    LENGTH_MODE(name##_rgbt16, mode), LENGTH_MODE(name##_rgbt8, mode),                             \
        LENGTH_MODE(name##_indexed8_t8, mode), LENGTH_MODE(name##_indexed8_t16, mode)

#define STORAGES 4 /* of a group below, the first with 16 bits in each voxel */

static const length_mode corrected[STORAGES] = {OPACITY_MODES(qv_corrected, REF_CORRECTED)};
static const length_mode extinction[STORAGES] = {EXTINCTION_MODES(qv_extinction, REF_EXTINCTION)};
static const length_mode converted[STORAGES] = {OPACITY_MODES(qv_extinction, REF_EXTINCTION)};
static const length_mode bspline_weighted[STORAGES] = {
    OPACITY_MODES(qv_bspline_weighted, REF_BSPLINE_WEIGHTED)};
static const length_mode bspline_extinction[STORAGES] = {
    EXTINCTION_MODES(qv_bspline_extinction, REF_BSPLINE_EXTINCTION)};
static const length_mode bspline_converted[STORAGES] = {
    OPACITY_MODES(qv_bspline_extinction, REF_BSPLINE_EXTINCTION)};

static tally run_scene(uint32_t seed, const length_mode *of, direction towards)
{
    const qv_sampling *sampling = of->sampling[towards];
    seeded_scene made;
    tally scene = {0};
    assert_int_equal(seeded_make_by_length(&made, seed, (qv_storage)sampling->storage), QV_OK);
    if (towards == LEVELS) {
        assert_int_equal(seeded_add_pyramid(&made, seed), QV_OK);
    }
    made.scene.sampling = sampling;
    assert_int_equal(compare_scene(&scene, &made, of->mode, REF_STORED_CAMERA), QV_OK);
    if (scene.worst > 1) {
        printf("# seed %" PRIu32 ", %s, %s, level %.3f from %" PRIu32
               " on, step %.3f: worst %" PRIu32 ", farthest %.3f\n",
               seed, of->name, made.filling, made.scene.level / 256.0, made.scene.level_distance,
               made.view.step, scene.worst, scene.farthest);
    }
    seeded_free(&made);
    return scene;
}

/* Adds up the scenes of one storage; returns whether they are as near as they must be. */
static bool run_scenes(const length_mode *of, direction towards, uint32_t every)
{
    static const char *const names[3] = {"front to back", "back to front", "levels"};
    char name[64];
    tally total = {0};
    uint32_t covered = 0, scenes = 0;
    for (uint32_t seed = 1; seed <= SCENES; seed += every) {
        const tally scene = run_scene(seed, of, towards);
        tally_add(&total, &scene);
        covered += scene.channels >= LEAST_COVERED;
        scenes++;
    }
    (void)snprintf(name, sizeof name, "%s, %s", of->name, names[towards]);
    tally_print(name, &total);
    return total.worst <= 1 && tally_share(&total) >= least_equal && covered * 10 >= scenes * 9;
}

static void test_mode(const length_mode modes[STORAGES])
{
    bool near = true;
    for (int storage = 0; storage < STORAGES; storage++) {
        for (int towards = FRONT_TO_BACK; towards <= LEVELS; towards++) {
            const uint32_t every = storage == 0 ? 1 : SHARE;
            near = run_scenes(&modes[storage], (direction)towards, every) && near;
        }
    }
    assert_true(near);
}

static void test_corrected(void **state)
{
    (void)state;
    test_mode(corrected);
}

static void test_extinction(void **state)
{
    (void)state;
    test_mode(extinction);
}

static void test_extinction_of_opacity(void **state)
{
    (void)state;
    test_mode(converted);
}

static void test_bspline_weighted(void **state)
{
    (void)state;
    test_mode(bspline_weighted);
}

static void test_bspline_extinction(void **state)
{
    (void)state;
    test_mode(bspline_extinction);
}

static void test_bspline_extinction_of_opacity(void **state)
{
    (void)state;
    test_mode(bspline_converted);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_corrected),
        cmocka_unit_test(test_extinction),
        cmocka_unit_test(test_extinction_of_opacity),
        cmocka_unit_test(test_bspline_weighted),
        cmocka_unit_test(test_bspline_extinction),
        cmocka_unit_test(test_bspline_extinction_of_opacity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
