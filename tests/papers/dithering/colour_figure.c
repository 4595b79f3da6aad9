/*
 * colour_figure.c - figure 39: where colour and opacity are dithered apart, a slice may have
 * opacity but no colour, and what has accumulated falls.
 */
#include "dithering.h"

#include "fx_blend.h"
#include "fx_dither.h"

#include <math.h>

/* The figure's; the slopes are those of figure 26, which has the same opacity. */
enum { slices = 1000, colour = 200 };
static const ref_fog fog = {REF_FOG_RANDOM, .75, {.75, 1}, true, 0};

/* The associated colour as an opacity of its own. Another pixel, so that it hits elsewhere. */
static const ref_fog light_apart = {REF_FOG_RANDOM, .75 * colour / 255, {.75, 1}, true, 1};

/* Apart, colour may exceed opacity, and what accumulates the frame buffer. */
static uint32_t saturated(uint32_t value)
{
    return value < 255 ? value : 255;
}

static void dither_apart(double *values)
{
    uint32_t value = 0, opacity = 0;
    for (uint32_t n = 0; n < slices; n++) {
        const uint32_t given = ref_fog_dithered(&fog, n, opacity);
        const uint32_t light = ref_fog_dithered(&light_apart, n, opacity);
        value = saturated(fx_blend_associated(value, light, given, 8));
        opacity = fx_blend_plain(opacity, 255, given, 8);
        values[n + 1] = value;
    }
}

/* The paper's advice: the colour with the opacity that was dithered. */
static void dither_together(double *values)
{
    uint32_t value = 0, opacity = 0;
    for (uint32_t n = 0; n < slices; n++) {
        const uint32_t given = ref_fog_dithered(&fog, n, opacity);
        value = fx_blend_plain(value, colour, given, 8);
        opacity = fx_blend_plain(opacity, 255, given, 8);
        values[n + 1] = value;
    }
}

static void round_dithered(double *values, unsigned fraction)
{
    const uint32_t opacity = (uint32_t)floor(fog.opacity / 255 * FX_ONE_Q23 + .5);
    const uint32_t light = fx_light_of_colour(colour, opacity);
    uint32_t state = 0;
    for (uint32_t n = 0; n < slices; n++) {
        state = fx_blend_dithered(state, light, opacity, fx_dither_blocks(n), fraction);
        values[n + 1] = ldexp(state, -(int)fraction);
    }
}

/* The largest fall from one slice to the next. */
static double fall_of(const double *values)
{
    double fall = 0;
    for (uint32_t n = 0; n < slices; n++) {
        fall = fmax(fall, values[n] - values[n + 1]);
    }
    return fall;
}

static void compute(plot *made)
{
    dither_apart(made->values[RANDOM]);
    dither_together(made->values[ORDERED]);
    round_dithered(made->values[OURS], 0);
    round_dithered(made->values[WIDE], 8);
    for (uint32_t n = 0; n <= slices; n++) {
        made->values[EXACT][n] = ref_fog_exact(fog.opacity, n) * colour / 255;
    }
    for (int c = 0; c < CURVES; c++) {
        made->values[c][0] = 0;
        for (uint32_t n = 0; n <= slices; n++) {
            made->errors[c][n] = made->values[c][n] - made->values[EXACT][n];
        }
    }
}

void colour_figure(FILE *numbers, FILE *index, const char *folder)
{
    plot curves = {.names = {"exact", "-", "random, colour with its opacity",
                             "random, colour and opacity apart", "dithered rounding, 8 bits (ours)",
                             "dithered rounding, 8.8 bits (ours)"},
                   .shown =
                       SHOWS(EXACT) | SHOWS(ORDERED) | SHOWS(RANDOM) | SHOWS(OURS) | SHOWS(WIDE),
                   .slices = slices};
    char caption[192];
    compute(&curves);
    numbers_add(numbers, "section 5", "colour 157 under a slice of opacity 7 and no colour", "153",
                fx_blend_associated(157, 0, 7, 8));
    numbers_add(numbers, "figure 39", "dithered apart, largest fall from a slice to the next", "-",
                fall_of(curves.values[RANDOM]));
    numbers_add(numbers, "figure 39", "dithered rounding, largest fall", "-",
                fall_of(curves.values[OURS]));
    numbers_add(numbers, "figure 39", "dithered rounding, worst difference in levels", "-",
                fabs(worst_of(curves.errors[OURS], slices)));
    (void)snprintf(
        caption, sizeof caption,
        "Worst, in levels: apart %.3g, with its opacity %.3g, ours %.3g, ours, more bits %.3g",
        fabs(worst_of(curves.errors[RANDOM], slices)),
        fabs(worst_of(curves.errors[ORDERED], slices)), fabs(worst_of(curves.errors[OURS], slices)),
        fabs(worst_of(curves.errors[WIDE], slices)));
    const figure_text text = {39, "accumulated", "Figure 39: opacity 0.75, colour 200", caption};
    write_plot(folder, index, &text, &curves);
}
