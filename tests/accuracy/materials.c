/*
 * Kraus and Buerger 2008, section 3.1: between two voxels that hold percentages of
 * materials, extinction-based sampling sees the mixture of the interpolated percentages
 * (equations 18 to 21, without an approximation), opacity-based sampling does not
 * (equations 8 to 15). First in double precision, then in pictures.
 */
#include "check.h"
#include "qvol.h"
#include "random.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MATERIALS 4
#define PAIRS     200 /* of voxels */
#define PLACES    257 /* between their centres: i / 256 */
#define LEVELS    255

/* The greatest depth of a material over the length of the picture's rays, one voxel. */
static const unsigned depths[] = {1, 4, 8, 16};
#define DEPTHS (sizeof depths / sizeof depths[0])

/* Two voxels side by side on x. */
typedef struct pair {
    qv_material material[MATERIALS];
    uint16_t percentage[2][MATERIALS];
} pair;

/* What a ray sees: opacity and opacity-weighted colour, or the terms of a sum. */
typedef struct light {
    double channel[4];
} light;

static void set_pair(pair *two, unsigned depth, uint32_t *seed)
{
    for (unsigned i = 0; i < MATERIALS; i++) {
        for (unsigned c = 0; c < 3; c++)
            two->material[i].colour[c] = (uint16_t)random_next(seed);
        two->material[i].extinction = random_below(seed, depth * QV_ONE_Q16 + 1);
    }
    for (unsigned side = 0; side < 2; side++) {
        uint32_t rest = 65535;
        for (unsigned i = 0; i < MATERIALS; i++) {
            const uint32_t share = i + 1 < MATERIALS ? random_below(seed, rest + 1) : rest;
            two->percentage[side][(i + side) % MATERIALS] = (uint16_t)share;
            rest -= share;
        }
    }
}

/* a * (1 - f) + b * f */
static light between(light a, light b, double f)
{
    for (unsigned i = 0; i < 4; i++)
        a.channel[i] += (b.channel[i] - a.channel[i]) * f;
    return a;
}

/* Equations 6 and 7 of interpolated percentages: emitted colour and extinction. */
static light mixture(const pair *two, double f)
{
    light sum = {{0, 0, 0, 0}};
    for (unsigned i = 0; i < MATERIALS; i++) {
        const double part = (two->percentage[0][i] * (1 - f) + two->percentage[1][i] * f) / 65535;
        const double extinction = ldexp(two->material[i].extinction, -16);
        sum.channel[3] += part * extinction;
        for (unsigned c = 0; c < 3; c++)
            sum.channel[c] += part * extinction * two->material[i].colour[c] / 65535;
    }
    return sum;
}

/* What a ray sees of a length of 1: equations 22 and 23. */
static light seen(light medium)
{
    const double depth = medium.channel[3], opacity = -expm1(-depth * log(2));
    for (unsigned c = 0; c < 3; c++)
        medium.channel[c] *= depth > 0 ? opacity / depth : 0;
    medium.channel[3] = opacity;
    return medium;
}

static double difference(light a, light b)
{
    double most = 0;
    for (unsigned i = 0; i < 4; i++)
        most = fmax(most, fabs(a.channel[i] - b.channel[i]));
    return most;
}

/* Both ways of sampling against the mixture of the interpolated percentages. */
static void in_double_precision(void **state)
{
    (void)state;
    for (size_t d = 0; d < DEPTHS; d++) {
        uint32_t seed = 97;
        double extinction = 0, opacity = 0;
        for (unsigned n = 0; n < PAIRS; n++) {
            pair two;
            set_pair(&two, depths[d], &seed);
            const light a = mixture(&two, 0), b = mixture(&two, 1);
            for (unsigned i = 0; i < PLACES; i++) {
                const double f = i / 256.0;
                const light exact = seen(mixture(&two, f));
                extinction = fmax(extinction, difference(seen(between(a, b, f)), exact));
                opacity = fmax(opacity, difference(between(seen(a), seen(b), f), exact));
            }
        }
        printf("# double precision, depths up to %u: extinction-based %.1e off, "
               "opacity-based %.4f\n",
               depths[d], extinction, opacity);
        assert_true(extinction < 1e-14);
        assert_true(opacity > 0.02);
    }
}

static void set_scene(qv_scene *scene, uint16_t voxels[2][4], uint8_t storage, uint32_t extinction)
{
    const qv_coord one = (qv_coord)1 << 32;
    memset(scene, 0, sizeof *scene);
    scene->volume.voxels = (const uint8_t *)voxels;
    scene->volume.voxels_bytes = 16;
    scene->volume.storage = storage;
    scene->volume.unit_distance = QV_ONE_Q16;
    scene->volume.extinction = extinction;
    scene->volume.stride[0] = 8;
    scene->volume.size[0] = 2;
    scene->volume.size[1] = scene->volume.size[2] = 1;
    scene->camera.projection = &qv_projection_orthographic;
    scene->camera.step = QV_ONE_Q16;
    scene->camera.origin[0] = scene->camera.origin[1] = one / 2;
    scene->camera.across[0] = one / 256;
    scene->camera.down[1] = one;
    scene->camera.along[2] = one;
    scene->sampling = storage == QV_STORAGE_RGBT16 ? &qv_extinction_rgbt16 : &qv_corrected_rgba16;
}

/* A row of pixels from the one voxel's centre to the other's: how far off, in levels. */
static double picture_difference(const pair *two, const qv_scene *scene)
{
    static uint8_t row[PLACES][4];
    const qv_rect rect = {0, 0, PLACES, 1};
    const qv_image image = {row, sizeof row, sizeof row, &qv_format_rgba8888};
    qv_context context;
    double most = 0;
    assert_int_equal(qv_init(&context, scene), QV_OK);
    assert_int_equal(qv_render(&image, &context, &rect), QV_OK);
    for (unsigned i = 0; i < PLACES; i++) {
        const light exact = seen(mixture(two, i / 256.0));
        for (unsigned c = 0; c < 4; c++)
            most = fmax(most, fabs(row[i][c] - LEVELS * exact.channel[c]));
    }
    return most;
}

/* The two voxels, stored with extinction and, made from that, with opacity. */
static void set_voxels(uint16_t rgbt[2][4], uint16_t rgba[2][4], const pair *two,
                       uint32_t extinction)
{
    const qv_entries entries = {(const uint8_t *)rgbt, 2, 0, extinction, QV_STORAGE_RGBT16};
    for (unsigned side = 0; side < 2; side++) {
        qv_mixture sum;
        assert_int_equal(qv_mix(&sum, two->material, two->percentage[side], MATERIALS), QV_OK);
        qv_mixture_to_voxel(rgbt[side], &sum, extinction);
    }
    assert_int_equal(qv_extinction_to_opacity(rgba, 16, QV_STORAGE_RGBA16, QV_ONE_Q16, &entries),
                     QV_OK);
}

/* The extinction-based picture is the exact one, rounded. */
static void in_pictures(void **state)
{
    (void)state;
    for (size_t d = 0; d < DEPTHS; d++) {
        const uint32_t full = depths[d] * QV_ONE_Q16;
        uint32_t seed = 101;
        double extinction = 0, opacity = 0;
        for (unsigned n = 0; n < PAIRS; n++) {
            uint16_t rgbt[2][4], rgba[2][4];
            qv_scene scene;
            pair two;
            set_pair(&two, depths[d], &seed);
            set_voxels(rgbt, rgba, &two, full);
            set_scene(&scene, rgbt, QV_STORAGE_RGBT16, full);
            extinction = fmax(extinction, picture_difference(&two, &scene));
            set_scene(&scene, rgba, QV_STORAGE_RGBA16, full);
            opacity = fmax(opacity, picture_difference(&two, &scene));
        }
        printf("# pictures, depths up to %u: extinction-based %.4f levels off, "
               "opacity-based %.1f\n",
               depths[d], extinction, opacity);
        assert_true(extinction < 0.51);
        assert_true(opacity > 5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_double_precision),
        cmocka_unit_test(in_pictures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
