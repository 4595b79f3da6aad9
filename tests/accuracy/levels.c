/*
 * Levels of detail: every level of a homogeneous volume's pyramid is the same picture, and
 * what a pyramid of a smooth volume shows changes smoothly from level to level, along a slow
 * zoom and from pixel to pixel.
 */
#include "check.h"
#include "fine.h"
#include "levels.h"
#include "reference.h"

#include <math.h>
#include <stdio.h>

#define SIDE         16 /* pixels of a frame */
#define PIXELS       (SIDE * SIDE)
#define COUNT(array) (sizeof(array) / sizeof(array)[0])

typedef fine_pixel picture[PIXELS];

typedef struct mode {
    const char *name;
    const qv_sampling *sampling;
} mode;

#define MODE(name)                                                                                 \
    {                                                                                              \
#name, &qv_##name##_levels                                                                 \
    }

static const mode modes[] = {
    MODE(corrected_rgba8),
    MODE(corrected_rgba16),
    MODE(corrected_indexed8),
    MODE(corrected_indexed8_16),
    MODE(bspline_weighted_rgba8),
    MODE(bspline_weighted_rgba16),
    MODE(bspline_weighted_indexed8),
    MODE(bspline_weighted_indexed8_16),
    MODE(extinction_rgba8),
    MODE(extinction_rgba16),
    MODE(extinction_indexed8),
    MODE(extinction_indexed8_16),
    MODE(extinction_rgbt8),
    MODE(extinction_rgbt16),
    MODE(extinction_indexed8_t8),
    MODE(extinction_indexed8_t16),
    MODE(bspline_extinction_rgba8),
    MODE(bspline_extinction_rgba16),
    MODE(bspline_extinction_indexed8),
    MODE(bspline_extinction_indexed8_16),
    MODE(bspline_extinction_rgbt8),
    MODE(bspline_extinction_rgbt16),
    MODE(bspline_extinction_indexed8_t8),
    MODE(bspline_extinction_indexed8_t16),
};

/* ---- Pictures --------------------------------------------------------------------- */

/* Askew, so that rays cross every level's cells at any place. */
static void aim(qv_scene *scene, const levels *of, const mode *m, double pitch, bool perspective)
{
    qv_view view;
    memset(scene, 0, sizeof *scene);
    scene->volume = of->volume;
    scene->pyramid = &of->pyramid;
    scene->sampling = m->sampling;
    qv_rotation(view.rotation, 0x15000000u, 0x0b000000u, 0x03000000u);
    view.pitch = (uint32_t)(pitch * QV_ONE_Q16);
    view.step = QV_ONE_Q16 / 2;
    view.width = SIDE;
    view.height = SIDE;
    assert_int_equal(perspective
                         ? qv_perspective(&scene->camera, &scene->volume, &view, 0x2aaaaaaau)
                         : qv_orthographic(&scene->camera, &scene->volume, &view),
                     QV_OK);
}

static void render(picture made, const qv_scene *scene)
{
    assert_int_equal(render_fine_frame(made, scene, SIDE, SIDE), QV_OK);
}

/* The largest difference of two channels, in 1/65535, or in levels of a display. */
static double differ(const fine_pixel *a, const fine_pixel *b, bool wide)
{
    double most = 0;
    for (int channel = 0; channel < 4; channel++) {
        const double one = a->channel[channel] / FINE_ONE, other = b->channel[channel] / FINE_ONE;
        const double shown = ref_level(one, 255) - (double)ref_level(other, 255);
        most = fmax(most, wide ? fabs(one - other) * 65535 : fabs(shown));
    }
    return most;
}

static double differ_most(const picture a, const picture b, bool wide)
{
    double most = 0;
    for (int i = 0; i < PIXELS; i++) {
        most = fmax(most, differ(&a[i], &b[i], wide));
    }
    return most;
}

/* ---- Homogeneous volumes ------------------------------------------------------------- */

/* Odd and even, cubes and not. */
static const uint16_t sizes[][3] = {{16, 16, 16}, {21, 13, 9}, {1, 30, 5}, {7, 2, 31}};

/* Of 65535. */
static const uint16_t fourths[] = {257, 6000, 40000, 65535};

static const qv_filter *const filters[] = {&qv_filter_box2, &qv_filter_box4, &qv_filter_quad4};

/* Every voxel the same, or every entry of a palette whose indices are not. */
static void fill(levels *made, uint16_t fourth)
{
    const bool wide = ref_is_wide(made->volume.storage);
    const bool indexed = ref_is_indexed(made->volume.storage);
    const uint16_t words[4] = {65535, 30000, 257, fourth};
    const size_t bytes = wide ? 8 : 4;
    uint8_t *const entries = indexed ? (uint8_t *)made->palette : made->voxels;
    const size_t memory = indexed ? bytes * QV_PALETTE_ENTRIES : (size_t)made->volume.voxels_bytes;
    uint8_t entry[8];
    memcpy(entry, words, sizeof entry);
    for (int channel = 0; channel < 4 && !wide; channel++) {
        entry[channel] = (uint8_t)(words[channel] / 257);
    }
    for (size_t at = 0; at < memory; at += bytes) {
        memcpy(entries + at, entry, bytes);
    }
    for (size_t at = 0; indexed && at < made->volume.voxels_bytes; at++) {
        made->voxels[at] = (uint8_t)(at * 37);
    }
}

/* The largest difference of any level, also between two, from level 0. */
static double compare_levels(const levels *of, const mode *m)
{
    const bool wide = ref_is_wide(of->volume.storage);
    double most = 0;
    picture first, other;
    qv_scene scene;
    aim(&scene, of, m, 1.5, false);
    render(first, &scene);
    for (uint32_t level = 77; level <= of->pyramid.levels * 256u; level += 179) { /* 256 too */
        scene.level = (uint16_t)level;
        render(other, &scene);
        most = fmax(most, differ_most(first, other, wide));
    }
    return most;
}

/* The same for levels that rise with the distance, by any part of the way through. */
static double compare_distances(const levels *of, const mode *m)
{
    const bool wide = ref_is_wide(of->volume.storage);
    double most = 0;
    picture first, other;
    qv_scene scene;
    aim(&scene, of, m, 1.5, true);
    render(first, &scene);
    for (uint32_t distance = 1; distance < 100; distance = distance * 3 / 2 + 1) {
        scene.level_distance = distance;
        render(other, &scene);
        most = fmax(most, differ_most(first, other, wide));
    }
    return most;
}

typedef double comparison(const levels *of, const mode *m);

static double compare_volume(const mode *m, comparison *compare, size_t number,
                             const qv_domain *domain)
{
    levels made;
    levels_begin(&made, m->sampling->storage, sizes[number % COUNT(sizes)]);
    made.volume.extinction = QV_ONE_Q16 / 8;
    fill(&made, fourths[number / COUNT(sizes)]);
    levels_make(&made, filters[number % COUNT(filters)], domain,
                qv_pyramid_levels(made.volume.size));
    const double most = compare(&made, m);
    levels_free(&made);
    return most;
}

static double compare_volumes(const mode *m, comparison *compare)
{
    double most = 0;
    for (size_t i = 0; i < COUNT(sizes) * COUNT(fourths); i++) {
        most = fmax(most, compare_volume(m, compare, i, &qv_domain_stored));
        if (!ref_holds_extinction(m->sampling->storage)) {
            most = fmax(most, compare_volume(m, compare, i, &qv_domain_extinction));
        }
    }
    return most;
}

static void test_homogeneous(comparison *compare)
{
    int bad = 0;
    for (size_t i = 0; i < COUNT(modes); i++) {
        const bool wide = ref_is_wide(modes[i].sampling->storage);
        const double most = compare_volumes(&modes[i], compare);
        printf("# %s: at most %.2f of %s apart\n", modes[i].name, most, wide ? "65535" : "255");
        bad += most > (wide ? 8 : 1);
    }
    assert_int_equal(bad, 0);
}

static void test_homogeneous_levels(void **state)
{
    (void)state;
    test_homogeneous(compare_levels);
}

static void test_homogeneous_distances(void **state)
{
    (void)state;
    test_homogeneous(compare_distances);
}

/* ---- A smooth volume -------------------------------------------------------------------- */

#define SMOOTH_LEVELS 3
#define DISPLAY_LEVEL 257.0 /* of 65535: one of 255 */

enum { NX = 48, NY = 41, NZ = 37 };

/* Clouds some 16 voxels wide. */
static double cloud(int x, int y, int z, double turn)
{
    return (sin(x * 0.2 + turn) + sin(y * 0.17 + 2 * turn) + sin(z * 0.23 - turn)) / 6 + 0.5;
}

static void make_smooth(levels *made, const mode *m)
{
    const uint8_t storage = m->sampling->storage;
    const uint16_t size[3] = {NX, NY, NZ};
    levels_begin(made, storage, size);
    made->volume.extinction = QV_ONE_Q16 / 4;
    uint8_t *at = made->voxels;
    for (int i = 0; i < NX * NY * NZ; i++, at += made->volume.stride[0]) {
        const int x = i % NX, y = i / NX % NY, z = i / (NX * NY);
        const double fourth = cloud(x, y, z, 0);
        const double value[4] = {cloud(x, y, z, 1), cloud(x, y, z, 2), cloud(x, y, z, 3),
                                 ref_holds_extinction(storage) ? fourth : fourth * fourth / 4};
        for (int channel = 0; channel < 4; channel++) {
            const uint16_t wide = (uint16_t)ref_level(value[channel], 65535);
            const uint8_t narrow = (uint8_t)ref_level(value[channel], 255);
            if (ref_is_wide(storage)) {
                memcpy(at + 2 * channel, &wide, sizeof wide);
            } else {
                at[channel] = narrow;
            }
        }
    }
    levels_make(made, &qv_filter_box4, &qv_domain_stored, SMOOTH_LEVELS);
}

static const mode smooth_modes[] = {
    MODE(corrected_rgba16),  MODE(bspline_weighted_rgba16),   MODE(extinction_rgba16),
    MODE(extinction_rgbt16), MODE(bspline_extinction_rgbt16), MODE(extinction_rgbt8),
    MODE(corrected_rgba8),
};

/* The largest difference from one picture to the next in a slow zoom, from level 0 to the
   coarsest in steps of 1/256; and, in `whole`, of any from that of level 0. */
static double zoom(double *whole, const levels *of, const mode *m)
{
    static picture first, pictures[2];
    double most = 0;
    qv_scene scene;
    *whole = 0;
    aim(&scene, of, m, 3, false);
    render(first, &scene);
    memcpy(pictures[0], first, sizeof first);
    for (unsigned level = 1; level <= 256 * SMOOTH_LEVELS; level++) {
        scene.level = (uint16_t)level;
        render(pictures[level % 2], &scene);
        most = fmax(most, differ_most(pictures[0], pictures[1], true));
        *whole = fmax(*whole, differ_most(pictures[level % 2], first, true));
    }
    return most;
}

/* A jump is largest at a whole level, where the step doubles. */
static void test_zoom(void **state)
{
    int bad = 0;
    (void)state;
    for (size_t i = 0; i < COUNT(smooth_modes); i++) {
        double whole;
        levels made;
        make_smooth(&made, &smooth_modes[i]);
        const double most = zoom(&whole, &made, &smooth_modes[i]);
        levels_free(&made);
        printf("# %s: at most %.1f of 65535 from 1/256 of a level to the next, %.0f in all\n",
               smooth_modes[i].name, most, whole);
        bad += most > DISPLAY_LEVEL;
    }
    assert_int_equal(bad, 0);
}

/* ---- Seams ------------------------------------------------------------------------------- */

/* Four rows of pixels 1/16 voxel apart, along which the borders of spans cross the volume. */
#define FINER 32
#define ROWS  4
#define WIDTH (SIDE * FINER)

typedef struct rows {
    fine_pixel pixel[ROWS * WIDTH];
} rows;

static void render_rows(rows *made, const qv_scene *scene)
{
    assert_int_equal(render_fine_frame(made->pixel, scene, WIDTH, ROWS), QV_OK);
}

static void aim_rows(qv_scene *scene, const levels *of, const mode *m)
{
    aim(scene, of, m, 2, true);
    for (int axis = 0; axis < 3; axis++) {
        scene->camera.across[axis] /= FINER;
        scene->camera.down[axis] *= SIDE / ROWS;
    }
}

/* How much a pixel differs from the one to its left. */
static double from_left(const rows *of, int pixel)
{
    return differ(&of->pixel[pixel], &of->pixel[pixel - 1], true);
}

/* By how much neighbours differ more than in any picture of one level. */
static double excess(const rows *of, const rows constant[SMOOTH_LEVELS + 1])
{
    double most = 0;
    for (int i = 0; i < ROWS * WIDTH; i++) {
        if (i % WIDTH != 0) {
            double natural = 0;
            for (int level = 0; level <= SMOOTH_LEVELS; level++) {
                natural = fmax(natural, from_left(&constant[level], i));
            }
            most = fmax(most, from_left(of, i) - natural);
        }
    }
    return most;
}

/* Over distances at which levels begin to rise: in front of the volume, in it, behind it. */
static double find_seams(const levels *of, const mode *m)
{
    static rows constant[SMOOTH_LEVELS + 1], risen;
    double most = 0;
    qv_scene scene;
    aim_rows(&scene, of, m);
    for (int level = 0; level <= SMOOTH_LEVELS; level++) {
        scene.level = (uint16_t)(level * 256);
        render_rows(&constant[level], &scene);
    }
    scene.level = 0;
    for (uint32_t distance = 1; distance < 200; distance = distance * 4 / 3 + 1) {
        scene.level_distance = distance;
        render_rows(&risen, &scene);
        most = fmax(most, excess(&risen, constant));
    }
    return most;
}

static void test_seams(void **state)
{
    int bad = 0;
    (void)state;
    for (size_t i = 0; i < COUNT(smooth_modes); i++) {
        levels made;
        make_smooth(&made, &smooth_modes[i]);
        const double most = find_seams(&made, &smooth_modes[i]);
        levels_free(&made);
        printf("# %s: neighbours differ by at most %.1f of 65535 more than in one level\n",
               smooth_modes[i].name, most);
        bad += most > DISPLAY_LEVEL / 4;
    }
    assert_int_equal(bad, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_homogeneous_levels),
        cmocka_unit_test(test_homogeneous_distances),
        cmocka_unit_test(test_zoom),
        cmocka_unit_test(test_seams),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
