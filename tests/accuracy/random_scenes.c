/*
 * The library against the double-precision reference on seeded random scenes:
 * each scene and storage on its own, over the pixels that the volume covers.
 */
#include "check.h"
#include "comparison.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#define SCENES        200
#define SHARE         4   /* one scene in this many also runs the other modes */
#define LEAST_COVERED 400 /* channels: a hundred pixels of a frame of some thousand */

static const double least_equal = 0.99;

static const qv_sampling *const front_to_back[3][4] = {
    {&qv_nearest_rgba8, &qv_nearest_rgba16, &qv_nearest_indexed8, &qv_nearest_indexed8_16},
    {&qv_separate_rgba8, &qv_separate_rgba16, &qv_separate_indexed8, &qv_separate_indexed8_16},
    {&qv_weighted_rgba8, &qv_weighted_rgba16, &qv_weighted_indexed8, &qv_weighted_indexed8_16},
};

static const qv_sampling *const back_to_front[4] = {
    &qv_weighted_rgba8_back_to_front,
    &qv_weighted_rgba16_back_to_front,
    &qv_weighted_indexed8_back_to_front,
    &qv_weighted_indexed8_16_back_to_front,
};

static const qv_storage storages[4] = {QV_STORAGE_RGBA8, QV_STORAGE_RGBA16, QV_STORAGE_INDEXED8,
                                       QV_STORAGE_INDEXED8_16};
static const char *const storage_names[4] = {"rgba8", "rgba16", "indexed8", "indexed8_16"};

/* Renders one scene in one storage and tallies it against the reference. */
static tally run_scene(uint32_t seed, int storage, const qv_sampling *sampling,
                       uint16_t termination, ref_mode mode, ref_camera camera)
{
    seeded_scene made;
    tally scene = {0};
    assert_int_equal(seeded_make(&made, seed, storages[storage]), QV_OK);
    made.scene.sampling = sampling;
    made.scene.termination = termination;
    assert_int_equal(compare_scene(&scene, &made, mode, camera), QV_OK);
    seeded_free(&made);
    return scene;
}

static void report(uint32_t seed, int storage, const tally *scene)
{
    char name[64];
    (void)snprintf(name, sizeof name, "seed %" PRIu32 ", %s", seed, storage_names[storage]);
    tally_print(name, scene);
}

/* ---- Stored camera: arithmetic after the position -------------------------- */

/* Each scene and storage on its own must meet the bounds. */
static void test_scenes(const qv_sampling *const samplings[4], ref_mode mode, uint32_t every)
{
    int disagree = 0;
    for (int storage = 0; storage < 4; storage++) {
        tally total = {0};
        uint32_t covered = 0, scenes = 0;
        double least = 1;
        for (uint32_t seed = 1; seed <= SCENES; seed += every) {
            const tally scene =
                run_scene(seed, storage, samplings[storage], 0, mode, REF_STORED_CAMERA);
            tally_add(&total, &scene);
            least = fmin(least, tally_share(&scene));
            covered += scene.channels >= LEAST_COVERED;
            scenes++;
            if (scene.worst > 1 || tally_share(&scene) < least_equal) {
                report(seed, storage, &scene);
                disagree++;
            }
        }
        tally_print(storage_names[storage], &total);
        printf("#   %" PRIu32 " of %" PRIu32 " scenes cover a good part of the frame; "
               "worst scene %.4f %% equal\n",
               covered, scenes, 100 * least);
        assert_true(covered * 10 >= scenes * 9);
    }
    assert_int_equal(disagree, 0);
}

static void test_weighted(void **state)
{
    (void)state;
    test_scenes(front_to_back[REF_WEIGHTED], REF_WEIGHTED, 1);
}

static void test_weighted_back_to_front(void **state)
{
    (void)state;
    test_scenes(back_to_front, REF_WEIGHTED, SHARE);
}

static void test_separate(void **state)
{
    (void)state;
    test_scenes(front_to_back[REF_SEPARATE], REF_SEPARATE, SHARE);
}

static void test_nearest(void **state)
{
    (void)state;
    test_scenes(front_to_back[REF_NEAREST], REF_NEAREST, SHARE);
}

/* ---- Ideal camera: positions as well ----------------------------------------- */

/*
 * Rounding moves a point by at most 1/512 voxel on each axis. Where neighbouring
 * voxels differ by the full range, that changes a sample by up to 3 * 255/512 =
 * 1.5 levels, and a ray along an axis repeats the change at every sample. So a
 * few channels of high-contrast scenes may be 2 levels off; the others are at
 * most 1 off.
 */
static void test_ideal_camera(void **state)
{
    const double most_beyond = 1e-5;
    tally total = {0};
    (void)state;
    for (int storage = 0; storage < 4; storage++) {
        const qv_sampling *sampling = front_to_back[REF_WEIGHTED][storage];
        for (uint32_t seed = 1; seed <= SCENES; seed++) {
            const tally scene =
                run_scene(seed, storage, sampling, 0, REF_WEIGHTED, REF_IDEAL_CAMERA);
            tally_add(&total, &scene);
            if (scene.worst > 1) {
                report(seed, storage, &scene);
            }
        }
    }
    tally_print("ideal camera", &total);
    printf("#   channels more than 1 level off: %" PRIu64 "\n", total.beyond);
    assert_true(total.worst <= 2);
    assert_true((double)total.beyond <= most_beyond * (double)total.channels);
}

/* ---- Early termination ---------------------------------------------------------- */

/* What the default threshold adds to the 1/2 level of rounding. */
static void test_default_termination(void **state)
{
    const double documented = 0.25, arithmetic = 0.02;
    tally total = {0};
    (void)state;
    for (int storage = 0; storage < 4; storage++) {
        const qv_sampling *sampling = front_to_back[REF_WEIGHTED][storage];
        for (uint32_t seed = 1; seed <= SCENES; seed++) {
            const tally scene = run_scene(seed, storage, sampling, QV_TERMINATION_DEFAULT,
                                          REF_WEIGHTED, REF_STORED_CAMERA);
            tally_add(&total, &scene);
        }
    }
    tally_print("default termination", &total);
    printf("#   it adds at most %.4f levels\n", total.farthest - 0.5);
    assert_true(total.worst <= 1);
    assert_true(total.farthest <= 0.5 + documented + arithmetic);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_weighted),     cmocka_unit_test(test_weighted_back_to_front),
        cmocka_unit_test(test_separate),     cmocka_unit_test(test_nearest),
        cmocka_unit_test(test_ideal_camera), cmocka_unit_test(test_default_termination),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
