/*
 * Scenes and contexts: what is refused, which must leave the context alone, and
 * what a context holds.
 */
#include "check.h"
#include "length_samplings.h"
#include "scene_fixture.h"

static fixture f;
static qv_scene *const scene = &f.scene;

static void make(void)
{
    fixture_make(&f, &qv_weighted_indexed8, 1);
}

static void expect(qv_status status)
{
    qv_context context;
    fixture_poison(&context, sizeof context);
    assert_int_equal(qv_init(&context, scene), status);
    assert_true((status == QV_OK) != fixture_untouched(&context, sizeof context));
}

/* ---- What is refused ---- */

static void null_pointers(void **state)
{
    qv_context context;
    (void)state;

    make();
    fixture_poison(&context, sizeof context);
    assert_int_equal(qv_init(NULL, scene), QV_ERROR_NULL);
    assert_int_equal(qv_init(&context, NULL), QV_ERROR_NULL);
    assert_true(fixture_untouched(&context, sizeof context));
    scene->sampling = NULL;
    expect(QV_ERROR_NULL);
    make();
    scene->volume.voxels = NULL;
    expect(QV_ERROR_NULL);
    make();
    scene->camera.projection = NULL;
    expect(QV_ERROR_NULL);
}

/* Each error of the volume's own check, once. */
static void volumes_are_checked(void **state)
{
    (void)state;

    make();
    scene->volume.storage = 0;
    expect(QV_ERROR_STORAGE);
    make();
    scene->volume.size[1] = 0;
    expect(QV_ERROR_SIZE);
    make();
    scene->volume.stride[2] = 1;
    expect(QV_ERROR_STRIDE);
    make();
    scene->volume.palette_bytes = 1;
    expect(QV_ERROR_PALETTE);
    make();
    scene->volume.spacing[0] = 1;
    expect(QV_ERROR_SPACING);
}

static void cameras_are_checked(void **state)
{
    (void)state;

    make();
    memset(scene->camera.down, 0, sizeof scene->camera.down);
    expect(QV_ERROR_CAMERA);
    make();
    scene->camera.step = 0;
    expect(QV_ERROR_STEP);
}

/* A rotation of zeros, and an eye too far from a box of small voxels: the
   constructor takes them, the scene does not. */
static void views_that_make_no_camera(void **state)
{
    qv_view view = fixture_view(0, 0, 0);
    (void)state;

    make();
    memset(view.rotation, 0, sizeof view.rotation);
    assert_int_equal(qv_orthographic(&scene->camera, &scene->volume, &view), QV_OK);
    expect(QV_ERROR_CAMERA);
    view = fixture_view(0, 0, 0);
    view.pitch = 256u << 16;
    for (unsigned axis = 0; axis < 3; axis++)
        scene->volume.spacing[axis] = QV_ONE_Q16 / 16;
    assert_int_equal(qv_perspective(&scene->camera, &scene->volume, &view, 0x00B60B61u), QV_OK);
    expect(QV_ERROR_CAMERA);
}

/* Every mode with every storage but its own. */
static void modes_of_another_storage(void **state)
{
    static const qv_sampling *const modes[4] = {&qv_weighted_rgba8, &qv_weighted_rgba16,
                                                &qv_nearest_indexed8_back_to_front,
                                                &qv_separate_indexed8_16};
    (void)state;

    for (unsigned storage = 0; storage < 4; storage++)
        for (unsigned mode = 0; mode < 4; mode++) {
            fixture_make(&f, modes[storage], 1);
            scene->sampling = modes[mode];
            expect(storage == mode ? QV_OK : QV_ERROR_STORAGE);
        }
}

/* The same for the modes that weigh by length, in both orders and through a pyramid. */
static void lengths_of_another_storage(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++)
        for (unsigned j = 0; j < LENGTH_SAMPLINGS; j++) {
            const qv_sampling *const modes[3] = {
                length_samplings[j].front, length_samplings[j].back, length_samplings[j].levels};
            fixture_make(&f, length_samplings[i].front, 1);
            fixture_add_pyramid(&f);
            for (unsigned m = 0; m < 3; m++) {
                scene->sampling = modes[m];
                expect(modes[m]->storage == scene->volume.storage ? QV_OK : QV_ERROR_STORAGE);
            }
        }
}

/* Weighted samples are not corrected: the unit is the step, named or not. */
static void unit_distances_other_than_the_step(void **state)
{
    (void)state;

    make();
    scene->volume.unit_distance = scene->camera.step;
    expect(QV_OK);
    scene->volume.unit_distance++;
    expect(QV_ERROR_UNIT);
    scene->volume.unit_distance = 1;
    expect(QV_ERROR_UNIT);
    scene->volume.unit_distance = UINT32_MAX;
    expect(QV_ERROR_UNIT);
}

/* ---- Modes ---- */

/* Each descriptor names the storage in its name; none is like another. */
static void modes_read_the_storage_of_their_name(void **state)
{
    static const qv_sampling *const modes[4][6] = {
        {&qv_nearest_rgba8, &qv_separate_rgba8, &qv_weighted_rgba8, &qv_nearest_rgba8_back_to_front,
         &qv_separate_rgba8_back_to_front, &qv_weighted_rgba8_back_to_front},
        {&qv_nearest_rgba16, &qv_separate_rgba16, &qv_weighted_rgba16,
         &qv_nearest_rgba16_back_to_front, &qv_separate_rgba16_back_to_front,
         &qv_weighted_rgba16_back_to_front},
        {&qv_nearest_indexed8, &qv_separate_indexed8, &qv_weighted_indexed8,
         &qv_nearest_indexed8_back_to_front, &qv_separate_indexed8_back_to_front,
         &qv_weighted_indexed8_back_to_front},
        {&qv_nearest_indexed8_16, &qv_separate_indexed8_16, &qv_weighted_indexed8_16,
         &qv_nearest_indexed8_16_back_to_front, &qv_separate_indexed8_16_back_to_front,
         &qv_weighted_indexed8_16_back_to_front}};
    (void)state;

    for (unsigned i = 0; i < 24; i++) {
        assert_int_equal(modes[i / 6][i % 6]->storage, QV_STORAGE_RGBA8 + i / 6);
        for (unsigned j = 0; j < i; j++)
            assert_true(modes[i / 6][i % 6]->march != modes[j / 6][j % 6]->march);
    }
}

/* Those that weigh by length are of storages with opacity, then with extinction. */
static void lengths_read_the_storage_of_their_name(void **state)
{
    const qv_sampling *seen[LENGTH_SAMPLINGS * 3];
    unsigned count = 0;
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++) {
        const qv_sampling *const modes[3] = {length_samplings[i].front, length_samplings[i].back,
                                             length_samplings[i].levels};
        const unsigned first = i < 4 * STORAGES ? QV_STORAGE_RGBA8 : QV_STORAGE_RGBT8;
        for (unsigned m = 0; m < 3; m++) {
            assert_int_equal(modes[m]->storage, first + i % STORAGES);
            for (unsigned j = 0; j < count; j++)
                assert_true(seen[j]->march != modes[m]->march);
            seen[count++] = modes[m];
        }
    }
}

/* ---- Contexts ---- */

/* A context made elsewhere, from a descriptor that is gone, draws the same. */
static void contexts_may_be_moved(void **state)
{
    fixture_pixels expected, pixels;
    qv_context elsewhere[2];
    const qv_image image = {pixels, sizeof pixels, FIXTURE_WIDTH * 4, &qv_format_rgba8888};
    (void)state;

    make();
    fixture_render(expected, &f);
    assert_int_equal(qv_init(&elsewhere[0], scene), QV_OK);
    elsewhere[1] = elsewhere[0];
    fixture_poison(&elsewhere[0], sizeof elsewhere[0]);
    fixture_poison(scene, sizeof *scene);
    assert_int_equal(qv_render(&image, &elsewhere[1], &fixture_frame), QV_OK);
    assert_memory_equal(pixels, expected, sizeof pixels);
}

/* The one pixel of an empty scene. */
static void expect_background(const uint8_t background[4], const uint8_t expected[4])
{
    static const qv_rect pixel = {-100, -100, -99, -99};
    uint8_t rgba[4];
    const qv_image image = {rgba, 4, 0, &qv_format_rgba8888};
    memcpy(scene->background, background, 4);
    const qv_context context = fixture_context(&f);
    assert_int_equal(qv_render(&image, &context, &pixel), QV_OK);
    assert_memory_equal(rgba, expected, 4);
}

/* For every colour and opacity: associated, to nearest (no ties occur). */
static void the_background_is_associated(void **state)
{
    (void)state;

    make();
    for (uint32_t opacity = 0; opacity <= 255; opacity++)
        for (uint32_t colour = 0; colour <= 255; colour++) {
            const uint8_t associated = (uint8_t)((2 * colour * opacity + 255) / 510);
            const uint8_t background[4] = {(uint8_t)colour, 0, (uint8_t)colour, (uint8_t)opacity};
            const uint8_t expected[4] = {associated, 0, associated, (uint8_t)opacity};
            expect_background(background, expected);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(null_pointers),
        cmocka_unit_test(volumes_are_checked),
        cmocka_unit_test(cameras_are_checked),
        cmocka_unit_test(views_that_make_no_camera),
        cmocka_unit_test(modes_of_another_storage),
        cmocka_unit_test(lengths_of_another_storage),
        cmocka_unit_test(unit_distances_other_than_the_step),
        cmocka_unit_test(modes_read_the_storage_of_their_name),
        cmocka_unit_test(lengths_read_the_storage_of_their_name),
        cmocka_unit_test(contexts_may_be_moved),
        cmocka_unit_test(the_background_is_associated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
