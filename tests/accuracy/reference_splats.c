/*
 * The reference for splats against what is known without it.
 */
#include "check.h"
#include "draw.h"
#include "freevoxels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define EDGE   7 /* voxels */
#define VOXELS ((size_t)EDGE * EDGE * EDGE)
#define FRAME  32 /* pixels */
#define PIXELS ((size_t)FRAME * FRAME)

static const double tolerance = 1e-12;

typedef struct cube {
    uint8_t voxels[VOXELS][4];
    qv_volume volume;
} cube;

/* White voxels of 1 x 1.5 x 0.75 world units; of one opacity, or of any. */
static void cube_make(cube *made, uint8_t opacity)
{
    static const uint32_t spacing[3] = {65536, 98304, 49152};
    draws random = draw_seeded(9);
    int32_t stride = sizeof made->voxels[0];
    memset(made, 0, sizeof *made);
    memset(made->voxels, 255, sizeof made->voxels);
    for (size_t i = 0; i < VOXELS; i++) {
        made->voxels[i][3] = opacity != 0 ? opacity : (uint8_t)draw_below(&random, 256);
    }
    for (int axis = 0; axis < 3; axis++) {
        made->volume.size[axis] = EDGE;
        made->volume.spacing[axis] = spacing[axis];
        made->volume.stride[axis] = stride;
        stride *= EDGE;
    }
    made->volume.voxels = made->voxels[0];
    made->volume.voxels_bytes = sizeof made->voxels;
    made->volume.storage = QV_STORAGE_RGBA8;
    made->volume.unit_distance = 3 * QV_ONE_Q16;
}

/* v is the sum of its directions by their shares, which sum to 1. */
static void test_surround(void **state)
{
    draws random = draw_seeded(10);
    (void)state;
    for (int i = 0; i < 1000; i++) {
        const double v[3] = {draw_real(&random, -1, 1), draw_real(&random, -1, 1),
                             draw_real(&random, -1, 1)};
        const double longest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
        double sum[3] = {0, 0, 0}, shares = 0;
        ref_surrounding around;
        ref_surround(&around, v);
        for (int j = 0; j < 3; j++) {
            const int number = around.direction[j] + (around.direction[j] >= 13);
            sum[0] += around.weight[j] * (number % 3 - 1);
            sum[1] += around.weight[j] * (number / 3 % 3 - 1);
            sum[2] += around.weight[j] * (number / 9 - 1);
            shares += around.weight[j];
            assert_true(around.weight[j] >= 0);
        }
        for (int axis = 0; axis < 3; axis++) {
            assert_true(fabs(sum[axis] - v[axis] / longest) < tolerance);
        }
        assert_true(fabs(shares - 1) < tolerance);
    }
}

/* In a fog a ray through voxel centres crosses as many steps as voxels. */
static void test_ray_in_fog(void **state)
{
    static cube fog;
    ref_field field;
    ref_outside outside;
    int32_t at[3];
    (void)state;
    cube_make(&fog, 40);
    assert_true(ref_field_make(&field, &fog.volume));
    assert_true(ref_outside_make(&outside, &fog.volume));
    for (int i = 0; i < (int)VOXELS; i++) {
        at[0] = i % EDGE;
        at[1] = i / EDGE % EDGE;
        at[2] = i / EDGE / EDGE;
        for (int number = 0; number < 27; number++) {
            const double v[3] = {number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1};
            const double voxels = number == 13 ? 0 : ref_depth_between(&outside, 0, at, v);
            const double ray = number == 13 ? 0 : ref_depth_of_ray(&field, 0, at, v);
            assert_true(fabs(voxels - ray) < tolerance);
        }
    }
    ref_field_free(&field);
    ref_outside_free(&outside);
}

/* Elsewhere it is the mean of many samples. */
static void test_ray_in_noise(void **state)
{
    static cube noise;
    const double v[3] = {0.35, -0.8, 0.55}, coarse = 1e-6;
    const int32_t at[3] = {2, 4, 3};
    const int samples = 200000;
    double sum = 0, end = HUGE_VAL, start[3], step[3];
    ref_field field;
    (void)state;
    cube_make(&noise, 0);
    assert_true(ref_field_make(&field, &noise.volume));
    for (int axis = 0; axis < 3; axis++) {
        step[axis] = v[axis] / fabs(v[1]);
        start[axis] = at[axis] + 0.5 + step[axis] / 2;
        end = fmin(end, ((step[axis] > 0 ? EDGE : 0) - start[axis]) / step[axis]);
    }
    for (int i = 0; i < samples; i++) {
        double point[3], sample[4];
        for (int axis = 0; axis < 3; axis++) {
            point[axis] = start[axis] + (i + 0.5) / samples * end * step[axis];
        }
        ref_reconstruct(sample, &noise.volume, REF_EXTINCTION, point);
        sum += sample[3] / samples * end;
    }
    const double expected = sum * ref_step_length(&noise.volume, v);
    assert_true(fabs(ref_depth_of_ray(&field, 0, at, v) - expected) < coarse * expected);
    ref_field_free(&field);
}

static double no_depth(const void *in, int level, const int32_t at[3], const double v[3])
{
    (void)in;
    (void)level;
    (void)at;
    (void)v;
    return 0;
}

static void look(ref_splats *splats, qv_splat_scene *scene, const cube *at, int kernel)
{
    memset(scene, 0, sizeof *scene);
    memset(splats, 0, sizeof *splats);
    splats->scene = scene;
    splats->levels = &at->volume;
    splats->kernel = kernel;
    splats->depths.along = no_depth;
    splats->view.pitch = 0.75;
    splats->view.width = FRAME;
    splats->view.height = FRAME;
}

/*
 * From any side, all of a fog's voxels bring what they absorb of a beam as wide as the box: their
 * opacity along a step, by their volume over a step's length.
 */
static void test_sums(void **state)
{
    static cube fog;
    static ref_sums sums[PIXELS];
    qv_splat_scene scene;
    ref_splats splats;
    (void)state;
    cube_make(&fog, 40);
    const double extinction = ref_extinction(40 / 255.0, &fog.volume);
    for (uint32_t turn = 0; turn < 16; turn++) {
        look(&splats, &scene, &fog, 2 + (int)(turn % 2));
        ref_rotation(splats.view.rotation, turn * 0x10000000u, turn * 0x03000000u, turn);
        double v[3], sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            v[axis] = splats.view.rotation[2][axis] / (fog.volume.spacing[axis] / 65536.0);
        }
        const double length = ref_step_length(&fog.volume, v), voxel = 1 * 1.5 * 0.75;
        const double area = splats.view.pitch * splats.view.pitch;
        ref_splat_clear(sums, &splats);
        ref_splat_level(sums, &splats, 0);
        for (size_t i = 0; i < PIXELS; i++) {
            sum += sums[i][3] * area;
        }
        const double expected = VOXELS * voxel / length * (1 - exp2(-extinction * length));
        assert_true(fabs(sum - expected) < tolerance * expected);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_surround),
        cmocka_unit_test(test_ray_in_fog),
        cmocka_unit_test(test_ray_in_noise),
        cmocka_unit_test(test_sums),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
