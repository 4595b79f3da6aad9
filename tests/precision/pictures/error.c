#include "pictures.h"

#include <math.h>

/* A channel as 8 bits hold it. */
static double packed(double channel)
{
    return ref_level(fmax(channel, 0), 255);
}

void error_add_pixel(picture_error *into, const double got[4], const double truth[4])
{
    for (int channel = 0; channel < 4; channel++) {
        const double off = 255 * (got[channel] - truth[channel]);
        const double levels = fabs(packed(got[channel]) - packed(truth[channel]));
        into->channels++;
        into->equal += levels == 0;
        into->beyond += levels > 1;
        into->squares += off * off;
        into->sum += off;
        into->worst = fmax(into->worst, fabs(off));
    }
}

void error_add(picture_error *into, const paper_picture *got, const paper_picture *truth)
{
    const size_t pixels = (size_t)truth->width * truth->height;
    for (size_t i = 0; i < pixels; i++) {
        if (truth->rgba[i][3] > 0) {
            error_add_pixel(into, got->rgba[i], truth->rgba[i]);
        }
    }
}

void error_take(picture_error *into, paper_picture *got, const paper_picture *truth)
{
    error_add(into, got, truth);
    paper_picture_free(got);
}

double error_rms(const picture_error *of)
{
    return of->channels > 0 ? sqrt(of->squares / of->channels) : 0;
}

double error_psnr(const picture_error *of)
{
    return of->squares > 0 ? 20 * log10(255 / error_rms(of)) : HUGE_VAL;
}

double error_equal(const picture_error *of)
{
    return of->channels > 0 ? 100 * of->equal / of->channels : 100;
}
