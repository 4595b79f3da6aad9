/*
 * The library against the double-precision reference on seeded random scenes:
 * each scene and storage on its own, over the pixels that the volume covers.
 */
#include "check.h"
#include "seeded.h"
#include "tally.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define SCENES    200
#define SHARE     8 /* one scene in this many also runs the other modes */
#define MOST_EDGE 64

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

static const char *const storage_names[4] = {"rgba8", "rgba16", "indexed8", "indexed8_16"};

typedef uint8_t picture[MOST_EDGE][MOST_EDGE][4];

static void render(picture pixels, const seeded_scene *made)
{
    const qv_rect rect = {0, 0, (int32_t)made->view.width, (int32_t)made->view.height};
    const qv_image image = {pixels, sizeof(picture), sizeof pixels[0], &qv_format_rgba8888};
    qv_context context;
    assert_int_equal(qv_init(&context, &made->scene), QV_OK);
    assert_int_equal(qv_render(&image, &context, &rect), QV_OK);
}

typedef enum camera_kind { STORED, IDEAL } camera_kind;

/* Compares every pixel that the volume covers in the reference. */
static void compare(tally *into, picture pixels, const seeded_scene *made, ref_mode mode,
                    camera_kind camera)
{
    ref_pixel expected;
    for (int32_t y = 0; y < made->view.height; y++) {
        for (int32_t x = 0; x < made->view.width; x++) {
            if (camera == IDEAL) {
                ref_render_ideal(&expected, &made->scene, &made->view, mode, x, y);
            } else {
                ref_render(&expected, &made->scene, mode, x, y);
            }
            if (expected.opacity > 0) {
                tally_pixel(into, pixels[y][x], &expected);
            }
        }
    }
}

/* One scene in one storage; returns whether it meets the bounds. */
static bool scene_agrees(tally *total, uint32_t seed, int storage, const qv_sampling *sampling,
                         ref_mode mode)
{
    picture pixels;
    seeded_scene made;
    tally scene = {0, 0, 0, 0};
    assert_int_equal(seeded_make(&made, seed, (qv_storage)(storage + 1)), QV_OK);
    made.scene.sampling = sampling;
    render(pixels, &made);
    compare(&scene, pixels, &made, mode, STORED);
    tally_add(total, &scene);
    const bool agrees = scene.worst <= 1 && tally_share(&scene) >= least_equal;
    if (!agrees) {
        printf("# seed %" PRIu32 ", %s, %s: ", seed, storage_names[storage], made.filling);
        tally_print("disagrees", &scene);
    }
    seeded_free(&made);
    return agrees;
}

static void test_scenes(const qv_sampling *const samplings[4], ref_mode mode, uint32_t every)
{
    int disagree = 0;
    for (int storage = 0; storage < 4; storage++) {
        tally total = {0, 0, 0, 0};
        for (uint32_t seed = 1; seed <= SCENES; seed += every) {
            disagree += !scene_agrees(&total, seed, storage, samplings[storage], mode);
        }
        tally_print(storage_names[storage], &total);
        assert_true(total.channels > 500 * SCENES / every);
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

/* The camera with real angles and points that nothing rounds. */
static void test_ideal_camera(void **state)
{
    tally total = {0, 0, 0, 0};
    (void)state;
    for (uint32_t seed = 1; seed <= SCENES; seed++) {
        picture pixels;
        seeded_scene made;
        tally scene = {0, 0, 0, 0};
        const int storage = (int)(seed % 4);
        assert_int_equal(seeded_make(&made, seed, (qv_storage)(storage + 1)), QV_OK);
        made.scene.sampling = front_to_back[REF_WEIGHTED][storage];
        render(pixels, &made);
        compare(&scene, pixels, &made, REF_WEIGHTED, IDEAL);
        tally_add(&total, &scene);
        if (scene.worst > 1) {
            printf("# seed %" PRIu32 ", %s, %s: ", seed, storage_names[storage], made.filling);
            tally_print("off the ideal camera", &scene);
        }
        seeded_free(&made);
    }
    tally_print("ideal camera", &total);
    assert_true(total.worst <= 1);
}

/* What ending rays at the default threshold adds to half a level of rounding. */
static void test_default_termination(void **state)
{
    const double documented = 0.25;
    tally total = {0, 0, 0, 0};
    (void)state;
    for (uint32_t seed = 1; seed <= SCENES; seed++) {
        picture pixels;
        seeded_scene made;
        const int storage = (int)(seed % 4);
        assert_int_equal(seeded_make(&made, seed, (qv_storage)(storage + 1)), QV_OK);
        made.scene.sampling = front_to_back[REF_WEIGHTED][storage];
        made.scene.termination = QV_TERMINATION_DEFAULT;
        render(pixels, &made);
        compare(&total, pixels, &made, REF_WEIGHTED, STORED);
        seeded_free(&made);
    }
    tally_print("default termination", &total);
    assert_true(total.farthest <= 0.5 + documented + 0.02);
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
