/*
 * A homogeneous slab is the same pixel whatever the step, the phase, the spacing of its
 * voxels and the level of its pyramid: every mode that weighs by length, along the slab
 * and across it.
 */
#include "check.h"
#include "fine.h"
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

#define LONGEST     1024 /* voxels */
#define MOST_LEVELS 9    /* with steps up to 4 a piece is then at most 2^11 unit distances long */
#define CUBE_EDGE   40   /* world units of a slab that is seen askew */

/* World units. */
static const double steps[] = {1.0 / 8, 1.0 / 4, 1.0 / 2, 1, 2, 3, 4, 0.3, 1.37, 3.7};
static const double spacings[] = {0.5, 1, 2};
static const uint16_t phases[] = {0, 0x5eb1};

/* Of 65535, the full value included. */
static const uint16_t fourths[] = {1, 2, 33, 257, 1000, 6554, 21845, 32768, 60000, 65534, 65535};

static const uint16_t colour[3] = {65535, 30000, 257};

/* ---- Slabs ----------------------------------------------------------------------- */

typedef struct slab_kind {
    const char *name;
    qv_angle azimuth, elevation;
    uint16_t thickness[3]; /* world units */
} slab_kind;

static const slab_kind kinds[] = {
    {"across z, 1 unit", 0, 0xc0000000u, {4, 4, 1}},
    {"across x, 2 units", 0x40000000u, 0, {2, 4, 4}},
    {"across y, 64 units", 0, 0, {4, 64, 4}},
    {"along z, 1024 units", 0, 0x40000000u, {4, 4, LONGEST}},
    {"along x, 512 units", 0xc0000000u, 0, {512, 4, 4}},
    {"askew", 0x1b000000u, 0x0c000000u, {CUBE_EDGE, CUBE_EDGE, CUBE_EDGE}},
};

/* Enough for a cube of the finest voxels; long rows have fewer. */
#define MEMORY (8u * (2 * CUBE_EDGE) * (2 * CUBE_EDGE) * (2 * CUBE_EDGE))

typedef struct slab {
    unsigned char *voxels, *coarser; /* the latter null where no levels are wanted */
    qv_volume volume;
    qv_pyramid pyramid;
} slab;

static void repeat(unsigned char *to, uint64_t size, const unsigned char *entry, size_t bytes)
{
    for (uint64_t at = 0; at < size; at += bytes) {
        memcpy(to + at, entry, bytes);
    }
}

static void fill(slab *made, uint16_t fourth)
{
    const size_t bytes = ref_is_wide(made->volume.storage) ? 8 : 4;
    const uint16_t wide[4] = {colour[0], colour[1], colour[2], fourth};
    unsigned char entry[8];
    memcpy(entry, wide, sizeof entry);
    for (int channel = 0; channel < 4 && bytes == 4; channel++) {
        entry[channel] = (unsigned char)((wide[channel] + 128u) / 257u);
    }
    repeat(made->voxels, made->volume.voxels_bytes, entry, bytes);
    if (made->coarser != NULL) {
        repeat(made->coarser, made->pyramid.bytes, entry, bytes);
    }
}

/* A slab of a kind; false where its voxels would be too many, or none. */
static bool make_slab(slab *made, const slab_kind *kind, uint8_t storage, double spacing)
{
    int32_t stride = ref_is_wide(storage) ? 8 : 4;
    memset(&made->volume, 0, sizeof made->volume);
    for (int axis = 0; axis < 3; axis++) {
        const double size = kind->thickness[axis] / spacing;
        if (size < 1 || size > LONGEST) {
            return false;
        }
        made->volume.size[axis] = (uint16_t)size;
        made->volume.spacing[axis] = (uint32_t)(spacing * QV_ONE_Q16);
        made->volume.stride[axis] = stride;
        stride *= made->volume.size[axis];
    }
    made->volume.storage = storage;
    made->volume.voxels = made->voxels;
    made->volume.voxels_bytes = (uint64_t)stride;
    made->volume.unit_distance = QV_ONE_Q16;
    made->pyramid.voxels = made->coarser;
    made->pyramid.levels = qv_pyramid_levels(made->volume.size);
    if (made->pyramid.levels > MOST_LEVELS) {
        made->pyramid.levels = MOST_LEVELS;
    }
    made->pyramid.bytes = qv_pyramid_bytes(made->volume.size, storage, made->pyramid.levels);
    return true;
}

/* ---- Pixels ---------------------------------------------------------------------- */

/* Of all pixels of one medium and length. */
typedef struct extremes {
    double least[4], most[4]; /* 0 .. 1 */
    double off;               /* of the opacity, from the exact one */
} extremes;

static void take(extremes *into, const fine_pixel *pixel, double exact)
{
    for (int channel = 0; channel < 4; channel++) {
        const double value = pixel->channel[channel] / FINE_ONE;
        into->least[channel] = fmin(into->least[channel], value);
        into->most[channel] = fmax(into->most[channel], value);
    }
    into->off = fmax(into->off, fabs(pixel->channel[3] / FINE_ONE - exact));
}

/* The largest difference between two pixels, in levels of a display or of 16 bits. */
static double differ(const extremes *of, bool wide)
{
    double most = 0;
    for (int channel = 0; channel < 4; channel++) {
        const double fine = (of->most[channel] - of->least[channel]) * 65535;
        const double levels =
            ref_level(of->most[channel], 255) - (double)ref_level(of->least[channel], 255);
        most = fmax(most, wide ? fine : levels);
    }
    return most;
}

/* The way of the middle ray through the slab, in world units. */
static double way(const slab_kind *kind)
{
    double rotation[3][3], shortest = HUGE_VAL;
    ref_rotation(rotation, kind->azimuth, kind->elevation, 0);
    for (int axis = 0; axis < 3; axis++) {
        shortest = fmin(shortest, kind->thickness[axis] / fabs(rotation[2][axis]));
    }
    return shortest;
}

/* The volume, or all levels of the pyramid, and between them. */
static void render_levels(extremes *into, const slab *made, qv_scene *scene, double exact)
{
    const uint32_t most = made->coarser != NULL ? made->pyramid.levels * 256u : 0;
    fine_pixel pixel;
    for (uint32_t level = 0; level <= most; level += 128) {
        scene->level = (uint16_t)level;
        assert_int_equal(render_fine(&pixel, scene), QV_OK);
        take(into, &pixel, exact);
    }
}

static void render_steps(extremes *into, const slab *made, const slab_kind *kind,
                         const qv_sampling *sampling, double exact)
{
    qv_scene scene;
    qv_view view;
    memset(&scene, 0, sizeof scene);
    scene.volume = made->volume;
    scene.sampling = sampling;
    scene.pyramid = made->coarser != NULL ? &made->pyramid : NULL;
    memset(&view, 0, sizeof view);
    qv_rotation(view.rotation, kind->azimuth, kind->elevation, 0);
    view.pitch = QV_ONE_Q16;
    view.width = 1;
    view.height = 1;
    for (size_t i = 0; i < COUNT(steps) * COUNT(phases); i++) {
        view.step = (uint32_t)(steps[i % COUNT(steps)] * QV_ONE_Q16);
        scene.phase = phases[i / COUNT(steps)];
        assert_int_equal(qv_orthographic(&scene.camera, &scene.volume, &view), QV_OK);
        render_levels(into, made, &scene, exact);
    }
}

/* All spacings and steps of one medium: fourth is of the full value. */
static double run_medium(double *off, const slab_kind *kind, slab *made, uint16_t fourth,
                         const qv_sampling *sampling)
{
    extremes found = {{1, 1, 1, 1}, {0, 0, 0, 0}, 0};
    for (size_t i = 0; i < COUNT(spacings); i++) {
        if (make_slab(made, kind, sampling->storage, spacings[i])) {
            const bool wide = ref_is_wide(sampling->storage);
            const double channel = wide ? fourth / 65535.0 : (fourth + 128) / 257 / 255.0;
            made->volume.extinction = 16 * QV_ONE_Q16;
            fill(made, fourth);
            const double depth = way(kind) * ref_extinction(channel, &made->volume);
            render_steps(&found, made, kind, sampling, 1 - exp2(-depth));
        }
    }
    *off = fmax(*off, found.off);
    return differ(&found, ref_is_wide(sampling->storage));
}

/* ---- Modes ----------------------------------------------------------------------- */

typedef enum levels_kind { VOLUME, PYRAMID } levels_kind;

static void test_sampling(const char *name, const qv_sampling *sampling, levels_kind levels)
{
    const bool wide = ref_is_wide(sampling->storage);
    double worst = 0, off = 0;
    slab made = {.voxels = malloc(MEMORY), .coarser = levels == PYRAMID ? malloc(MEMORY) : NULL};
    assert_true(made.voxels != NULL && (levels == VOLUME || made.coarser != NULL));
    for (size_t kind = 0; kind < COUNT(kinds); kind++) {
        for (size_t i = 0; i < COUNT(fourths); i++) {
            const double found = run_medium(&off, &kinds[kind], &made, fourths[i], sampling);
            if (found > (wide ? 8 : 1)) {
                printf("# %s, %s, %u of 65535: %.2f apart\n", name, kinds[kind].name, fourths[i],
                       found);
            }
            worst = fmax(worst, found);
        }
    }
    free(made.voxels);
    free(made.coarser);
    printf("# %s: at most %.2f of %s apart, opacity %.2f of 65535 off\n", name, worst,
           wide ? "65535" : "255", off * 65535);
    assert_true(worst <= (wide ? 8 : 1));
}

#define TEST(name, levels)                                                                         \
    static void test_##name(void **state)                                                          \
    {                                                                                              \
        (void)state;                                                                               \
        test_sampling(#name, &qv_##name, levels);                                                  \
    }

TEST(corrected_rgba16, VOLUME)
TEST(corrected_rgba16_back_to_front, VOLUME)
TEST(corrected_rgba8, VOLUME)
TEST(extinction_rgba16, VOLUME)
TEST(extinction_rgbt16, VOLUME)
TEST(extinction_rgbt16_back_to_front, VOLUME)
TEST(extinction_rgba8, VOLUME)
TEST(extinction_rgbt8, VOLUME)
TEST(bspline_weighted_rgba16, VOLUME)
TEST(bspline_weighted_rgba8, VOLUME)
TEST(bspline_extinction_rgba16, VOLUME)
TEST(bspline_extinction_rgbt16, VOLUME)
TEST(bspline_extinction_rgbt8, VOLUME)
TEST(corrected_rgba16_levels, PYRAMID)
TEST(extinction_rgba16_levels, PYRAMID)
TEST(extinction_rgbt16_levels, PYRAMID)
TEST(extinction_rgbt8_levels, PYRAMID)
TEST(bspline_weighted_rgba8_levels, PYRAMID)
TEST(bspline_extinction_rgbt16_levels, PYRAMID)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_corrected_rgba16),
        cmocka_unit_test(test_corrected_rgba16_back_to_front),
        cmocka_unit_test(test_corrected_rgba8),
        cmocka_unit_test(test_extinction_rgba16),
        cmocka_unit_test(test_extinction_rgbt16),
        cmocka_unit_test(test_extinction_rgbt16_back_to_front),
        cmocka_unit_test(test_extinction_rgba8),
        cmocka_unit_test(test_extinction_rgbt8),
        cmocka_unit_test(test_bspline_weighted_rgba16),
        cmocka_unit_test(test_bspline_weighted_rgba8),
        cmocka_unit_test(test_bspline_extinction_rgba16),
        cmocka_unit_test(test_bspline_extinction_rgbt16),
        cmocka_unit_test(test_bspline_extinction_rgbt8),
        cmocka_unit_test(test_corrected_rgba16_levels),
        cmocka_unit_test(test_extinction_rgba16_levels),
        cmocka_unit_test(test_extinction_rgbt16_levels),
        cmocka_unit_test(test_extinction_rgbt8_levels),
        cmocka_unit_test(test_bspline_weighted_rgba8_levels),
        cmocka_unit_test(test_bspline_extinction_rgbt16_levels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
