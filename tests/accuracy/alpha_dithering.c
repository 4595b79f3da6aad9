/*
 * The figures of Williams et al. by the functions of fixedpoint/: fogs of colour 255 in
 * 8 and 12 bits, without dither, with simple dither, with bumps and two slopes; and two
 * bricks, by the greatest error of their combination (AAP).
 */
#include "check.h"
#include "fx_blend.h"
#include "fx_dither.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#define SLICES_MAX 1000
#define PERIOD     32

/* A fog and how it is dithered. Opacity in levels. */
typedef struct fog {
    double opacity;
    double slope[2]; /* below and above the knee */
    bool dither;
    bool bumping;
} fog;

/* Where the second slope begins. */
static uint32_t knee_of(const fog *of)
{
    return fx_plateau(of->opacity <= 1 ? 1 : (uint32_t)of->opacity, 255);
}

/* The opacity of 8 bits of slice n; value is what has accumulated, *bump only grows. */
static uint32_t dithered_opacity(const fog *of, uint32_t n, uint32_t value, bool *second,
                                 uint32_t *bump)
{
    const fx_period period = fx_period_of(PERIOD);
    *second = *second || value >= knee_of(of);
    const uint32_t opacity = (uint32_t)(of->opacity * of->slope[*second] * 65536 + .5);
    const uint32_t base = opacity >> 16;
    if (of->bumping && fx_bump(value, base) > *bump)
        *bump = fx_bump(value, base);
    const uint32_t hits = fx_hits(&period, opacity, base, *bump);
    return base + (fx_hit_ordered(&period, hits, n % PERIOD) ? *bump : 0);
}

/* values[n]: after n slices. */
static void accumulate(uint32_t *values, uint32_t count, const fog *of)
{
    uint32_t bump = 1;
    bool second = false;
    values[0] = 0;
    for (uint32_t n = 0; n < count; n++) {
        uint32_t opacity = (uint32_t)(of->opacity + .5);
        if (of->dither)
            opacity = dithered_opacity(of, n, values[n], &second, &bump);
        values[n + 1] = fx_blend_plain(values[n], 255, opacity, 8);
    }
}

/* The greatest deviation from exact blending, in levels. */
static double deviation_of(const fog *of)
{
    uint32_t values[SLICES_MAX + 1];
    double worst = 0;
    accumulate(values, SLICES_MAX, of);
    for (uint32_t n = 0; n <= SLICES_MAX; n++) {
        const double exact = 255 * (1 - pow(1 - of->opacity / 255, n));
        worst = fmax(worst, fabs(values[n] - exact));
    }
    return worst;
}

/* Two bricks that share `count` slices in every way, in percent of what one has; with its sign. */
static double brick_error(const fog *of, uint32_t count)
{
    uint32_t values[SLICES_MAX + 1];
    double worst = 0;
    accumulate(values, count, of);
    for (uint32_t n = 0; n <= count; n++) {
        const double near = values[n], far = values[count - n];
        const double error = (near + (1 - near / 255) * far) / values[count] - 1;
        if (fabs(error) > fabs(worst))
            worst = error;
    }
    return 100 * worst;
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
        const fog of = {cases[i].opacity, {1, 1}, false, false};
        const double error = brick_error(&of, cases[i].slices);
        printf("# opacity %g, %u slices: %.2f %%, in the paper %g\n", of.opacity, cases[i].slices,
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
        const fog of = {errors[i][0], {1, 1}, true, false};
        const double error = brick_error(&of, SLICES_MAX);
        printf("# opacity %g: %.2f %%, in the paper %g\n", of.opacity, error, errors[i][2]);
        assert_true(fabs(error - errors[i][1]) < .01);
    }
}

/* Figure 35: .66 in the paper. */
static void bricks_with_bumps(void **state)
{
    const fog of = {1, {.85, .9}, true, true};
    const double error = fabs(brick_error(&of, SLICES_MAX));
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
        const fog of = {fogs[i][0], {fogs[i][1], fogs[i][2]}, true, true};
        const double off = deviation_of(&of);
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
        const uint32_t opacity = (uint32_t)(fogs[i][0] * 4095 + .5);
        uint32_t value = 0;
        double worst = 0;
        for (uint32_t n = 1; n <= SLICES_MAX; n++) {
            value = fx_blend_plain(value, 4095, opacity, 12);
            worst = fmax(worst, fabs(value / 4095. - 1 + pow(1 - fogs[i][0], n)) * 255);
        }
        printf("# 12 bits, opacity %g: %.2f levels off\n", 255 * fogs[i][0], worst);
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
