/*
 * part_fogs.c - one pixel in a fog: the error by its opacity, and by the number of samples.
 */
#include "pictures.h"

#include <math.h>
#include <stdlib.h>

static const double fog_colour[3] = {0.91, 0.53, 0.17};

/* A fog's error on any channel, in levels. */
typedef double fog_error(const picture_scene *fog, const paper_picture *truth);

static double take_worst(paper_picture *got, const paper_picture *truth)
{
    picture_error found = {0};
    error_take(&found, got, truth);
    return found.worst;
}

/* ---- By opacity ------------------------------------------------------------------------ */

static const our_mode rgba16 = {"RGBA16", QV_STORAGE_RGBA16, &qv_weighted_rgba16, REF_WEIGHTED};
static const our_mode rgba8 = {"RGBA8", QV_STORAGE_RGBA8, &qv_weighted_rgba8, REF_WEIGHTED};
static const our_mode associated8 = {"preweighted RGBA8", QV_STORAGE_ASSOCIATED8,
                                     &qv_preweighted_associated8, REF_WEIGHTED};

static double error_of_ours(const our_mode *by, const picture_scene *fog,
                            const paper_picture *truth)
{
    paper_picture got;
    ours_picture(&got, fog, by);
    return take_worst(&got, truth);
}

static double error_rgba16(const picture_scene *fog, const paper_picture *truth)
{
    return error_of_ours(&rgba16, fog, truth);
}

static double error_rgba8(const picture_scene *fog, const paper_picture *truth)
{
    return error_of_ours(&rgba8, fog, truth);
}

static double error_associated8(const picture_scene *fog, const paper_picture *truth)
{
    return error_of_ours(&associated8, fog, truth);
}

static double error_mapper(const picture_scene *fog, const paper_picture *truth)
{
    paper_picture got;
    mapper_picture(&got, fog, false);
    return take_worst(&got, truth);
}

static double error_half(const picture_scene *fog, const paper_picture *truth)
{
    const store half = {"half floats", STORE_HALF, 0, true};
    model as = model_reference;
    paper_picture got;
    as.light = as.transmittance = model_half;
    model_picture(&got, &as, fog, &half);
    return take_worst(&got, truth);
}

static fog_error *const by_opacity[] = {error_rgba16, error_rgba8, error_associated8, error_mapper,
                                        error_half};

enum { fog_samples = 256, per_decade = 32, decades = 5 };

/* A row has the worst of half a decade; the plot has all. */
static void add_opacity(FILE *curve, double worst[COUNT(by_opacity)], double opacity)
{
    const double rgba[4] = {fog_colour[0], fog_colour[1], fog_colour[2], opacity};
    picture_scene fog;
    paper_picture truth;
    picture_fog_make(&fog, rgba, fog_samples);
    truth_picture(&truth, &fog);
    fprintf(curve, "%.6g", opacity);
    for (size_t i = 0; i < COUNT(by_opacity); i++) {
        const double off = by_opacity[i](&fog, &truth);
        worst[i] = fmax(worst[i], off);
        fprintf(curve, " %.5g", off);
    }
    fputc('\n', curve);
    paper_picture_free(&truth);
    picture_scene_free(&fog);
}

static void opacities(const char *folder)
{
    table t;
    FILE *curve = paper_open(folder, "pictures_opacity.dat");
    printf("### 2.4 Opacity and number of samples\n\n"
           "One pixel in a fog of %d samples, worst channel, in levels: the worst of %d "
           "opacities a row.\nOf opacities below 1/510, 8 bits keep nothing.\n\n"
           "Plot: `pictures_opacity.png`.\n\n",
           fog_samples, per_decade / 2);
    table_begin(&t, folder, "pictures_opacity",
                "opacity from|to|RGBA16|RGBA8|preweighted RGBA8|15 bits, as VTK|half floats");
    for (int row = 0; row < 2 * decades; row++) {
        double worst[COUNT(by_opacity)] = {0};
        for (int i = 0; i < per_decade / 2; i++) {
            const double decade = row / 2.0 + i / (double)per_decade;
            add_opacity(curve, worst, pow(10, decade - decades));
        }
        table_number(&t, "%.2g", pow(10, row / 2.0 - decades));
        table_number(&t, "%.2g", pow(10, (row + 1) / 2.0 - decades));
        for (size_t i = 0; i < COUNT(by_opacity); i++) {
            table_number(&t, "%.3g", worst[i]);
        }
    }
    table_end(&t);
    paper_close(curve);
}

/* ---- By number of samples --------------------------------------------------------------- */

static const int accumulators[] = {8, 12, 16, 20, 24, 31};

static double error_of_bits(const picture_scene *fog, const paper_picture *truth, int bits)
{
    model as = model_reference;
    paper_picture got;
    as.transmittance = as.light = bits;
    model_picture(&got, &as, fog, &store_real);
    return take_worst(&got, truth);
}

/* Fogs of so many samples that let 1/e, e^-1/4 and e^-4 of the light through: the worst. */
static void add_count(double worst[COUNT(accumulators)], unsigned samples)
{
    static const double depths[] = {0.25, 1, 4};
    for (size_t d = 0; d < COUNT(depths); d++) {
        const double opacity = 1 - exp(-depths[d] / samples);
        const double rgba[4] = {fog_colour[0], fog_colour[1], fog_colour[2], opacity};
        picture_scene fog;
        paper_picture truth;
        picture_fog_make(&fog, rgba, samples);
        truth_picture(&truth, &fog);
        for (size_t i = 0; i < COUNT(accumulators); i++) {
            worst[i] = fmax(worst[i], error_of_bits(&fog, &truth, accumulators[i]));
        }
        paper_picture_free(&truth);
        picture_scene_free(&fog);
    }
}

static void counts(const char *folder)
{
    table t;
    printf("The same where the fog lets 78, 37 or 1.8 %% of the light through, in so many "
           "samples, by the\nbits of the accumulators and all else exact: the worst of the "
           "three. n samples cost at most\n255 n 2^-(bits+1) of transmittance and twice that of "
           "light.\n\n"
           "Plot: `pictures_samples.png`.\n\n");
    table_begin(&t, folder, "pictures_samples", "samples|8 bits|12|16|20|24|31|bound of 24");
    for (unsigned samples = 1; samples <= QV_AXIS_MAX; samples *= 2) {
        double worst[COUNT(accumulators)] = {0};
        add_count(worst, samples);
        table_number(&t, "%.0f", samples);
        for (size_t i = 0; i < COUNT(accumulators); i++) {
            table_number(&t, "%.3g", worst[i]);
        }
        table_number(&t, "%.3g", ldexp(255.0 * 2 * samples, -25));
    }
    table_end(&t);
}

void part_fogs(const char *folder)
{
    opacities(folder);
    counts(folder);
}
