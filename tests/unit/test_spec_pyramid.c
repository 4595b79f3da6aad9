/*
 * The worked examples S51 .. S54 of tests/SPEC.md: pyramids. The same inputs and results
 * as there, written out.
 */
#include "check.h"
#include "qvol.h"

#include <string.h>

static unsigned char memory[480];

/* A packed volume, x fastest. */
static void describe(qv_volume *v, const void *voxels, uint8_t storage, uint16_t x, uint16_t y,
                     uint16_t z)
{
    const int32_t bytes = storage == QV_STORAGE_RGBA16 ? 8 : 4;
    memset(v, 0, sizeof *v);
    v->voxels = (qv_address)voxels;
    v->storage = storage;
    v->size[0] = x;
    v->size[1] = y;
    v->size[2] = z;
    v->stride[0] = bytes;
    v->stride[1] = bytes * x;
    v->stride[2] = bytes * x * y;
    v->voxels_bytes = (uint64_t)x * y * z * (uint64_t)bytes;
}

static void S51_levels(void **state)
{
    static const uint16_t voxels[9 * 6 * 5][4];
    const qv_pyramid pyramid = {memory, sizeof memory, 4};
    qv_volume volume, level;
    (void)state;

    describe(&volume, voxels, QV_STORAGE_RGBA16, 9, 6, 5);
    volume.spacing[1] = 4096;
    assert_int_equal(qv_pyramid_levels(volume.size), 4);
    assert_int_equal(qv_pyramid_bytes(volume.size, QV_STORAGE_RGBA16, 1), 360);
    assert_int_equal(qv_pyramid_bytes(volume.size, QV_STORAGE_RGBA16, 4), 480);
    assert_int_equal(qv_pyramid_level(&level, &volume, &pyramid, 3), QV_OK);
    assert_int_equal(level.voxels - memory, 456);
    assert_int_equal(level.spacing[1], 32768);
}

static void S52_a_row(void **state)
{
    static const uint16_t row[3][4] = {
        {65535, 0, 1000, 1}, {0, 40000, 2000, 65535}, {12345, 65535, 3000, 32768}};
    static const struct {
        const qv_filter *filter;
        const qv_domain *domain;
        uint16_t result[2][4];
    } examples[] = {
        {&qv_filter_box2,
         &qv_domain_stored,
         {{1, 39999, 2000, 32768}, {12345, 65535, 3000, 32768}}},
        {&qv_filter_box4,
         &qv_domain_stored,
         {{4116, 48511, 2333, 24576}, {4115, 48512, 2333, 49152}}},
        {&qv_filter_quad4,
         &qv_domain_stored,
         {{3148, 46508, 2255, 26112}, {5212, 50782, 2422, 46080}}},
        {&qv_filter_box2,
         &qv_domain_extinction,
         {{0, 40000, 2000, 65535}, {12345, 65535, 3000, 32768}}},
        {&qv_filter_box4,
         &qv_domain_extinction,
         {{190, 40393, 2015, 65534}, {190, 40393, 2015, 65535}}},
        {&qv_filter_quad4,
         &qv_domain_extinction,
         {{131, 40270, 2011, 65535}, {276, 40570, 2022, 65535}}},
    };
    qv_volume v;
    uint16_t result[2][4];
    (void)state;

    describe(&v, row, QV_STORAGE_RGBA16, 3, 1, 1);
    for (unsigned i = 0; i < sizeof examples / sizeof examples[0]; i++) {
        assert_int_equal(
            qv_downsample(result, sizeof result, &v, examples[i].filter, examples[i].domain, 0, 1),
            QV_OK);
        assert_memory_equal(result, examples[i].result, sizeof result);
    }
}

static void S53_eight_voxels(void **state)
{
    static const uint8_t voxels[8][4] = {{255, 0, 10, 1},   {0, 128, 20, 255}, {3, 255, 30, 128},
                                         {200, 100, 50, 0}, {7, 8, 9, 10},     {250, 251, 252, 253},
                                         {1, 2, 3, 254},    {90, 80, 70, 60}};
    static const uint8_t by_opacity[4] = {72, 140, 81, 120}, by_extinction[4] = {22, 127, 39, 255};
    const qv_filter *const filters[] = {&qv_filter_box2, &qv_filter_box4, &qv_filter_quad4};
    qv_volume v;
    uint8_t result[4];
    (void)state;

    describe(&v, voxels, QV_STORAGE_RGBA8, 2, 2, 2);
    for (unsigned i = 0; i < 3; i++) {
        assert_int_equal(qv_downsample(result, 4, &v, filters[i], &qv_domain_stored, 0, 1), QV_OK);
        assert_memory_equal(result, by_opacity, 4);
        assert_int_equal(qv_downsample(result, 4, &v, filters[i], &qv_domain_extinction, 0, 1),
                         QV_OK);
        assert_memory_equal(result, by_extinction, 4);
    }
}

/* The scene and view of S11, with a pyramid of which nothing is read. */
static void make_view(qv_scene *scene, qv_view *view, const qv_pyramid *pyramid)
{
    memset(scene, 0, sizeof *scene);
    describe(&scene->volume, memory, QV_STORAGE_RGBA8, 3, 4, 5);
    scene->volume.spacing[0] = 65536;
    scene->volume.spacing[1] = 98304;
    scene->volume.spacing[2] = 43691;
    scene->pyramid = pyramid;
    qv_rotation(view->rotation, 0x15555555u, 0x15555555u, 0xF0000000u);
    view->pitch = 32768;
    view->step = 49152;
    view->width = 6;
    view->height = 5;
}

static void S54_level_of_detail(void **state)
{
    static const struct {
        uint32_t pitch;
        uint16_t level;
    } examples[] = {{32768, 0}, {43692, 0}, {65536, 150}, {1000000, 1156}, {16777216, 2048}};
    static const qv_pyramid pyramid = {memory, 0, 8};
    qv_scene scene;
    qv_view view;
    (void)state;

    make_view(&scene, &view, &pyramid);
    for (unsigned i = 0; i < sizeof examples / sizeof examples[0]; i++) {
        view.pitch = examples[i].pitch;
        assert_int_equal(qv_orthographic(&scene.camera, &scene.volume, &view), QV_OK);
        assert_int_equal(qv_detail(&scene, &view), QV_OK);
        assert_int_equal(scene.level, examples[i].level);
        assert_int_equal(scene.level_distance, 0);
    }
    view.pitch = 32768;
    for (uint16_t height = 5; height <= 500; height = (uint16_t)(height + 495)) {
        view.height = height;
        assert_int_equal(qv_perspective(&scene.camera, &scene.volume, &view, 0x1C71C71Cu), QV_OK);
        assert_int_equal(qv_detail(&scene, &view), QV_OK);
        assert_int_equal(scene.level, 0);
        assert_int_equal(scene.level_distance, height == 5 ? 6 : 610);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S51_levels),
        cmocka_unit_test(S52_a_row),
        cmocka_unit_test(S53_eight_voxels),
        cmocka_unit_test(S54_level_of_detail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
