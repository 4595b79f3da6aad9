/*
 * What qv_recommend says of each frame buffer, as a table of README.md: 1000 slices, the faintest
 * of an opacity of .1/255.
 */
#include "qvol.h"

#include <stdio.h>

#define SLICES   1000
#define FAINTEST (0xFFFFFFFFu / 2550)

static const char *text_of(qv_advice advice)
{
    switch (advice) {
    case QV_ADVICE_PLAIN:
        return "rounded";
    case QV_ADVICE_DITHER:
        return "dithered";
    case QV_ADVICE_RESIDUAL:
        return "dithered, with residuals";
    default:
        return "24 bits, rounded";
    }
}

int main(void)
{
    static const struct {
        uint8_t bits, residual;
        const char *blends;
    } rows[] = {
        {5, 0, "`qv_over_rgb565`, of 5 bits"},
        {6, 0, "`qv_over_rgb565`, of 6 bits"},
        {8, 0, "`qv_over_rgb888`, `qv_over_rgba8888`"},
        {8, 4, "`..._residual4`"},
        {8, 8, "`..._residual8`"},
        {12, 0, "`qv_over_rgba12`"},
        {16, 0, "`qv_over_rgb16`, `qv_over_rgba16`"},
        {24, 0, "`qv_over_rgb24`, `qv_over_rgba24`"},
    };
    printf("| bits and residual | blend | | a fog, at most | any content, at most |\n");
    printf("|---|---|---|---|---|\n");
    for (unsigned i = 0; i < sizeof rows / sizeof *rows; i++) {
        qv_recommendation r;
        if (qv_recommend(&r, rows[i].bits, rows[i].residual, SLICES, FAINTEST) != QV_OK)
            return 1;
        printf("| %u + %u | %s | %s | %.2f | %.2f |\n", rows[i].bits, rows[i].residual,
               rows[i].blends, text_of(r.advice), r.worst_fog / 100., r.worst / 100.);
    }
    return 0;
}
