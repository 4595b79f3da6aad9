/*
 * The figures of Williams et al. by the functions of fixedpoint/: fogs of colour 255 in
 * 8 and 12 bits, without dither, with simple dither, with bumps and two slopes; and two
 * bricks, by the greatest error of their combination (AAP).
 */
#include "check.h"
#include "fog.h"

#include <math.h>
#include <stdio.h>

/* The greatest deviation from exact blending, in levels. */
static double deviation_of(const ref_fog *fog)
{
    double levels[REF_FOG_SLICES_MAX + 1];
    ref_fog_accumulate(levels, REF_FOG_SLICES_MAX, fog);
    return ref_fog_deviation(levels, REF_FOG_SLICES_MAX, fog->opacity);
}

/* Two bricks that share `count` slices in every way, in percent of what one has; with its sign. */
static double brick_error(const ref_fog *fog, uint32_t count)
{
    double levels[REF_FOG_SLICES_MAX + 1];
    ref_fog_accumulate(levels, count, fog);
    return ref_fog_seam(levels, count);
}

/* Section 2.3: without dither. The last figure is the paper's. */
static void bricks_without_dither(void **state)
{
    static const struct {
        double opacity;
        uint32_t slices;
        double error, paper;
    } cases[] = {
        {1, 200, 28.01, 28}, {1, 1000, 49.80, 49}, {5, 200, 8.87, 8.6}, {10, 200, 4.71, 4.5}};
    (void)state;
    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        const ref_fog fog = {REF_FOG_PLAIN, cases[i].opacity, {1, 1}, false, 0};
        const double error = brick_error(&fog, cases[i].slices);
        printf("# opacity %g, %u slices: %.2f %%, in the paper %g\n", fog.opacity, cases[i].slices,
               error, cases[i].paper);
        assert_true(fabs(error - cases[i].error) < .01);
    }
}

/* Section 3: a bump of 1 and no slopes, 1000 slices. */
static void bricks_with_simple_dither(void **state)
{
    static const double errors[][3] = {{.5, 49.80, 49}, {.75, 49.80, 49}, {1.5, 24.71, 24}};
    (void)state;
    for (unsigned i = 0; i < sizeof errors / sizeof *errors; i++) {
        const ref_fog fog = {REF_FOG_ORDERED, errors[i][0], {1, 1}, false, 0};
        const double error = brick_error(&fog, REF_FOG_SLICES_MAX);
        printf("# opacity %g: %.2f %%, in the paper %g\n", fog.opacity, error, errors[i][2]);
        assert_true(fabs(error - errors[i][1]) < .01);
    }
}

/* Figure 35: .66 in the paper. */
static void bricks_with_bumps(void **state)
{
    const ref_fog fog = {REF_FOG_ORDERED, 1, {.85, .9}, true, 0};
    const double error = fabs(brick_error(&fog, REF_FOG_SLICES_MAX));
    (void)state;
    printf("# opacity 1, slopes .85 and .9: %.2f %%, in the paper .66\n", error);
    assert_true(error > .5 && error < .7);
}

/* Figures 23 to 32: the published slopes, with bumps; the deviations as recomputed. */
static void published_slopes(void **state)
{
    static const double fogs[][4] = {
        {.03, .75, 1, 2.9}, {.1, 1, 1, 10.8},       {.25, .8, .9, 11.5}, {.5, .75, 1, 9.7},
        {.75, .75, 1, 9.7}, {1, .85, .9, 13.3},     {1.1, .85, .9, 14},  {1.25, .8, 1.5, 8.9},
        {1.5, 1, 1.3, 9},   {1.75, 1, 1.686, 26.3}, {2, .9, 1.4, 33}};
    (void)state;
    for (unsigned i = 0; i < sizeof fogs / sizeof *fogs; i++) {
        const ref_fog fog = {REF_FOG_ORDERED, fogs[i][0], {fogs[i][1], fogs[i][2]}, true, 0};
        const double off = deviation_of(&fog);
        printf("# opacity %g, slopes %g and %g: %.2f levels off\n", fogs[i][0], fogs[i][1],
               fogs[i][2], off);
        assert_true(fabs(off - fogs[i][3]) <= .051);
    }
}

/* Section 4.1: 12 bits without dither, opacities 1/4095, .1/255 and 1/255, in 8-bit levels. */
static void twelve_bits(void **state)
{
    static const double fogs[][2] = {{1 / 4095., 7.0}, {.1 / 255, 17.4}, {1 / 255., 2.9}};
    (void)state;
    for (unsigned i = 0; i < sizeof fogs / sizeof *fogs; i++) {
        const ref_fog fog = {REF_FOG_PLAIN_12, 255 * fogs[i][0], {1, 1}, false, 0};
        const double worst = deviation_of(&fog);
        printf("# 12 bits, opacity %g: %.2f levels off\n", fog.opacity, worst);
        assert_true(fabs(worst - fogs[i][1]) <= .051);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bricks_without_dither), cmocka_unit_test(bricks_with_simple_dither),
        cmocka_unit_test(bricks_with_bumps),     cmocka_unit_test(published_slopes),
        cmocka_unit_test(twelve_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
