/*
 * The worked examples of Wittenbrink, Malzbender and Goss 1998, sections 2 to 4,
 * through the library: a ray that leaves air and enters a material, one sample
 * between them at the phase r and one inside the material.
 *
 *   separate:  C~ = C a (1 + r^2 - r a)     opaque and white: 1 - r + r^2
 *   weighted:  C~ = C a (1 + r - r a)       opaque and white: 1
 *   alpha = a (1 + r - r a), so weighted C~ / alpha = C for every r and a
 */
#include "check.h"
#include "composite.h"
#include "ray.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define PHASES 256

static const qv_coord one = (qv_coord)1 << 32;

typedef struct kind {
    const char *name;
    qv_storage storage;
    const qv_sampling *separate, *weighted;
    uint16_t highest;     /* level that is 1 */
    double unit;          /* of accumulated colour: see composite.h */
    uint16_t material[3]; /* colour */
} kind;

static const kind kinds[] = {
    {"rgba8",
     QV_STORAGE_RGBA8,
     &qv_separate_rgba8,
     &qv_weighted_rgba8,
     255,
     65536.0 * 255 * 255 / 2,
     {1, 128, 255}},
    {"rgba8 back to front",
     QV_STORAGE_RGBA8,
     &qv_separate_rgba8_back_to_front,
     &qv_weighted_rgba8_back_to_front,
     255,
     65536.0 * 255 * 255 / 2,
     {1, 128, 255}},
    {"rgba16",
     QV_STORAGE_RGBA16,
     &qv_separate_rgba16,
     &qv_weighted_rgba16,
     65535,
     65535.0 * 65535 / 2,
     {1, 32896, 65535}},
    {"rgba16 back to front",
     QV_STORAGE_RGBA16,
     &qv_separate_rgba16_back_to_front,
     &qv_weighted_rgba16_back_to_front,
     65535,
     65535.0 * 65535 / 2,
     {1, 32896, 65535}},
    {"indexed8",
     QV_STORAGE_INDEXED8,
     &qv_separate_indexed8,
     &qv_weighted_indexed8,
     255,
     65536.0 * 255 * 255 / 2,
     {1, 128, 255}},
    {"indexed8_16",
     QV_STORAGE_INDEXED8_16,
     &qv_separate_indexed8_16,
     &qv_weighted_indexed8_16,
     65535,
     65535.0 * 65535 / 2,
     {1, 32896, 65535}},
};

#define KINDS (sizeof kinds / sizeof kinds[0])

/* ---- Air and material ------------------------------------------------------ */

/* Entry 0 is air, entry 1 the material: palette, and pattern of the voxels. */
typedef struct matter {
    unsigned char entries[QV_PALETTE16_BYTES];
    unsigned char voxels[3 * 8];
} matter;

static void write_level(unsigned char *entries, size_t index, uint16_t value, bool wide)
{
    if (wide) {
        memcpy(entries + 2 * index, &value, 2);
    } else {
        entries[index] = (unsigned char)value;
    }
}

static void fill_matter(matter *of, const kind *as, uint16_t opacity)
{
    const bool wide = as->highest > 255;
    const size_t entry_bytes = wide ? 8 : 4;
    const bool indexed =
        as->storage == QV_STORAGE_INDEXED8 || as->storage == QV_STORAGE_INDEXED8_16;
    memset(of, 0, sizeof *of);
    for (size_t channel = 0; channel < 4; channel++) {
        const uint16_t value = channel < 3 ? as->material[channel] : opacity;
        write_level(of->entries, 4 + channel, value, wide);
    }
    for (size_t i = 1; i < 3; i++) {
        if (indexed) {
            of->voxels[i] = 1;
        } else {
            memcpy(of->voxels + i * entry_bytes, of->entries + entry_bytes, entry_bytes);
        }
    }
}

static void describe(qv_volume *volume, const matter *of, const kind *as, uint16_t depth)
{
    const bool wide = as->highest > 255;
    const bool indexed =
        as->storage == QV_STORAGE_INDEXED8 || as->storage == QV_STORAGE_INDEXED8_16;
    const int32_t bytes = indexed ? 1 : wide ? 8 : 4;
    volume->voxels = of->voxels;
    volume->voxels_bytes = (uint64_t)bytes * depth;
    volume->palette = indexed ? of->entries : NULL;
    volume->palette_bytes = !indexed ? 0 : wide ? QV_PALETTE16_BYTES : QV_PALETTE8_BYTES;
    volume->size[0] = 1;
    volume->size[1] = 1;
    volume->size[2] = depth;
    volume->stride[2] = bytes;
    volume->storage = (uint8_t)as->storage;
}

/*
 * The ray along z has samples at r + 1/2 (the air's centre lies at 1/2, the
 * material's first at 3/2), and at steps of 1 before and behind. A box of depth
 * 2 for r < 1/2, of depth 3 from there on, lets it end after one sample in the
 * material; one in the air may come first.
 */
static void border_scene(qv_scene *scene, const matter *of, const kind *as, uint32_t phase)
{
    memset(scene, 0, sizeof *scene);
    describe(&scene->volume, of, as, phase < PHASES / 2 ? 2 : 3);
    scene->camera.origin[0] = one / 2;
    scene->camera.origin[1] = one / 2;
    scene->camera.origin[2] = one / 2 + one * phase / PHASES;
    scene->camera.across[0] = one;
    scene->camera.down[1] = one;
    scene->camera.along[2] = one;
    scene->camera.step = QV_ONE_Q16;
    scene->camera.projection = &qv_projection_orthographic;
}

/* ---- Rays ------------------------------------------------------------------ */

/* Accumulated light in real numbers: three associated colours and opacity. */
static void march(double light[4], qv_scene *scene, const kind *as, const qv_sampling *sampling)
{
    qv_light gathered = {{0, 0, 0}, QV_CLEAR, 0, 0};
    qv_context context;
    qv_ray ray;
    scene->sampling = sampling;
    assert_int_equal(qv_init(&context, scene), QV_OK);
    scene->camera.projection->ray(&ray, &context, 0, 0);
    sampling->march(&gathered, &ray, &context);
    for (int channel = 0; channel < 3; channel++) {
        light[channel] = gathered.colour[channel] / as->unit;
    }
    light[3] = 1 - gathered.transmittance / 2147483648.0;
}

typedef struct errors {
    double formula; /* largest difference from the paper's formulas, of 1 */
    double lsb; /* largest difference of C~ / alpha from the material, of its storage's levels */
} errors;

static void compare(errors *worst, qv_scene *scene, const kind *as, double r, double a)
{
    double separate[4], weighted[4];
    const double alpha = a * (1 + r - r * a);
    march(separate, scene, as, as->separate);
    march(weighted, scene, as, as->weighted);
    worst->formula = fmax(worst->formula, fabs(weighted[3] - alpha));
    worst->formula = fmax(worst->formula, fabs(separate[3] - alpha));
    for (int channel = 0; channel < 3; channel++) {
        const double colour = (double)as->material[channel] / as->highest;
        const double expected = colour * a * (1 + r * r - r * a);
        const double returned = weighted[channel] / weighted[3];
        worst->formula = fmax(worst->formula, fabs(separate[channel] - expected));
        worst->formula = fmax(worst->formula, fabs(weighted[channel] - colour * alpha));
        worst->lsb = fmax(worst->lsb, fabs(returned - colour) * as->highest);
    }
}

/* All phases and opacities: general formulas, and the material's colour returned. */
static void test_general_formulas(void **state)
{
    const double most_formula_error = 1.0 / (1 << 24);
    (void)state;
    for (size_t i = 0; i < KINDS; i++) {
        const kind *as = &kinds[i];
        errors worst = {0, 0};
        matter of;
        qv_scene scene;
        for (uint32_t level = 1; level <= 255; level++) {
            const uint16_t opacity = (uint16_t)(level * (as->highest / 255u));
            fill_matter(&of, as, opacity);
            for (uint32_t phase = 1; phase < PHASES; phase++) {
                border_scene(&scene, &of, as, phase);
                compare(&worst, &scene, as, phase / (double)PHASES, level / 255.0);
            }
        }
        printf("# %s: formulas within %.3g, C~/alpha within %.6f of a level\n", as->name,
               worst.formula, worst.lsb);
        assert_true(worst.formula <= most_formula_error);
        assert_true(worst.lsb <= 1);
    }
}

/* ---- Pixels ------------------------------------------------------------------ */

static void render(uint8_t pixel[4], qv_scene *scene, const qv_sampling *sampling)
{
    const qv_rect rect = {0, 0, 1, 1};
    const qv_image image = {pixel, 4, 4, &qv_format_rgba8888};
    qv_context context;
    scene->sampling = sampling;
    assert_int_equal(qv_init(&context, scene), QV_OK);
    assert_int_equal(qv_render(&image, &context, &rect), QV_OK);
}

/* Sections 2 and 3: samples of opacity 0, 1/2 and 1 give 0.75, and 1 as they should. */
static void test_three_samples(void **state)
{
    matter of;
    qv_scene scene;
    uint8_t pixel[4];
    (void)state;
    for (size_t i = 0; i < KINDS; i++) {
        fill_matter(&of, &kinds[i], kinds[i].highest);
        border_scene(&scene, &of, &kinds[i], PHASES / 2);
        render(pixel, &scene, kinds[i].separate);
        assert_int_equal(pixel[2], 191); /* 0.75 * 255 = 191.25 */
        assert_int_equal(pixel[3], 255);
        render(pixel, &scene, kinds[i].weighted);
        assert_int_equal(pixel[2], 255);
        assert_int_equal(pixel[3], 255);
    }
}

/* Figure 6: 1 - r + r^2 for an opaque white material, and 1 with weighting. */
static void test_phase_curve(void **state)
{
    matter of;
    qv_scene scene;
    uint8_t pixel[4];
    (void)state;
    for (size_t i = 0; i < KINDS; i++) {
        fill_matter(&of, &kinds[i], kinds[i].highest);
        for (uint32_t phase = 1; phase < PHASES; phase++) {
            const double r = phase / (double)PHASES;
            border_scene(&scene, &of, &kinds[i], phase);
            render(pixel, &scene, kinds[i].separate);
            assert_int_equal(pixel[2], (int)floor(255 * (1 - r + r * r) + 0.5));
            render(pixel, &scene, kinds[i].weighted);
            assert_int_equal(pixel[2], 255);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_three_samples),
        cmocka_unit_test(test_phase_curve),
        cmocka_unit_test(test_general_formulas),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
