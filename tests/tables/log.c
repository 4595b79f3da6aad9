/*
 * log.c - reciprocals and logarithms of the ends of 32 segments of 1/2 .. 1
 * (fixedpoint/fx_log.c), and extinctions of 8-bit opacities (fx_log8.c).
 */
#include "curve.h"
#include "write.h"

enum { SEGMENTS = 32, OPACITIES = 256, OPAQUE = 64 };

/* -log2(1 - place / 32), in units of 1. */
static void depth_of_gap(mpfr_t value, const mpfr_t place, unsigned segment)
{
    (void)segment;
    mpfr_div_ui(value, place, SEGMENTS, MPFR_RNDN);
    mpfr_ui_sub(value, 1, value, MPFR_RNDN);
    mpfr_log2(value, value, MPFR_RNDN);
    mpfr_neg(value, value, MPFR_RNDN);
}

/* The reciprocal of the segment's end, (33 + i) / 64, is cut, so that a number of
   the segment times it stays below 1. Its depth is that of the number it stands
   for, log2 of it as it is, less one unit: by so much is the rest of the result too
   great, half of it on average since the gap is rounded up, half since the greatest
   number, 2^32 - 1, is 1. With it that number's depth is exactly 0. */
static void write_segments(FILE *file)
{
    uint32_t reciprocals[SEGMENTS], depths[SEGMENTS];
    mpfr_t depth;
    mpfr_init2(depth, CURVE_BITS);
    for (unsigned i = 0; i < SEGMENTS; i++) {
        reciprocals[i] = 64u * 32768u / (33u + i);
        mpfr_set_ui(depth, reciprocals[i], MPFR_RNDN);
        mpfr_div_ui(depth, depth, 32768, MPFR_RNDN);
        mpfr_log2(depth, depth, MPFR_RNDN);
        depths[i] = curve_round(depth, 31, INT32_MAX) - 1u; /* modulo 2^32 */
    }
    write_table(file, 16, "log_reciprocal", reciprocals, SEGMENTS, "64 / (33 + i), Q1.15, cut");
    write_table(file, 32, "log_depth", depths, SEGMENTS,
                "log2 of these, Q1.31, less one unit; sums are modulo 2^32");
    mpfr_clear(depth);
}

static void write_cubic(FILE *file)
{
    mpfr_t c[4];
    curve_init(c, 4);
    curve_fit(c, 3, depth_of_gap, 0);
    write_number(file, "LOG_LINEAR", curve_round(c[1], 31, UINT32_MAX),
                 "-log2(1 - t/32) by t, t^2, t^3; Q1.31");
    write_number(file, "LOG_SQUARE", curve_round(c[2], 31, UINT32_MAX), "of t^2");
    write_number(file, "LOG_CUBE", curve_round(c[3], 31, UINT16_MAX), "of t^3");
    curve_clear(c, 4);
}

void write_log(const char *folder)
{
    FILE *file = write_open(folder, "fx_log_table", "Logarithms and reciprocals (fx_log.c).");
    write_segments(file);
    write_cubic(file);
    write_close(file);
}

void write_log8(const char *folder)
{
    FILE *file = write_open(folder, "fx_log8_table", "Extinctions of 8-bit opacities (fx_log8.c).");
    uint32_t values[OPACITIES];
    mpfr_t depth;
    mpfr_init2(depth, CURVE_BITS);
    for (unsigned i = 0; i < OPACITIES - 1; i++) {
        mpfr_set_ui(depth, OPACITIES - 1, MPFR_RNDN);
        mpfr_div_ui(depth, depth, OPACITIES - 1 - i, MPFR_RNDN);
        mpfr_log2(depth, depth, MPFR_RNDN);
        values[i] = curve_round(depth, 24, UINT32_MAX);
    }
    values[OPACITIES - 1] = (uint32_t)OPAQUE << 24;
    write_table(file, 32, "log8_extinction", values, OPACITIES,
                "-log2(1 - i/255), Q8.24; the last as FX_OPAQUE");
    mpfr_clear(depth);
    write_close(file);
}
