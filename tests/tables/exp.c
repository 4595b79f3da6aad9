/*
 * exp.c - powers of 2 in 64 segments of an octave (fixedpoint/fx_exp.c).
 */
#include "curve.h"
#include "write.h"

enum { SEGMENTS = 64 };

/* 2^(place / 64) - 1, in units of 1/64: the rise above the start of a segment. */
static void rise(mpfr_t value, const mpfr_t place, unsigned segment)
{
    (void)segment;
    mpfr_div_ui(value, place, SEGMENTS, MPFR_RNDN);
    mpfr_exp2(value, value, MPFR_RNDN);
    mpfr_sub_ui(value, value, 1, MPFR_RNDN);
    mpfr_mul_ui(value, value, SEGMENTS, MPFR_RNDN);
}

static void write_powers(FILE *file)
{
    uint32_t values[SEGMENTS];
    mpfr_t power;
    mpfr_init2(power, CURVE_BITS);
    for (unsigned i = 0; i < SEGMENTS; i++) {
        mpfr_set_ui(power, i, MPFR_RNDN);
        mpfr_div_ui(power, power, SEGMENTS, MPFR_RNDN);
        mpfr_exp2(power, power, MPFR_RNDN);
        values[i] = curve_round(power, 31, UINT32_MAX);
    }
    write_table(file, 32, "exp_power", values, SEGMENTS, "2^(i/64), Q1.31");
    mpfr_clear(power);
}

static void write_cubic(FILE *file)
{
    mpfr_t c[4];
    curve_init(c, 4);
    curve_fit(c, 3, rise, 0);
    write_number(file, "EXP_LINEAR", curve_round(c[1], 32, UINT32_MAX),
                 "Rise in a segment, in units of 1/64, by the place in it: t, t^2, t^3; Q0.32");
    write_number(file, "EXP_SQUARE", curve_round(c[2], 32, UINT32_MAX), "of t^2");
    write_number(file, "EXP_CUBE", curve_round(c[3], 32, UINT16_MAX), "of t^3");
    curve_clear(c, 4);
}

static void write_quadratic(FILE *file)
{
    mpfr_t c[3];
    curve_init(c, 3);
    curve_fit(c, 2, rise, 0);
    write_number(file, "EXP16_LINEAR", curve_round(c[1], 32, UINT32_MAX),
                 "The same rise by t and t^2 alone: Q0.32");
    write_number(file, "EXP16_SQUARE", curve_round(c[2], 24, UINT16_MAX), "of t^2, Q0.24");
    mpfr_div_ui(c[2], c[2], 2, MPFR_RNDN);
    mpfr_add(c[1], c[1], c[2], MPFR_RNDN);
    write_number(file, "EXP16_REST", curve_round(c[1], 14, UINT16_MAX),
                 "The mean slope, for steps of 2^-18 in Q0.32");
    curve_clear(c, 3);
}

void write_exp(const char *folder)
{
    FILE *file = write_open(folder, "fx_exp_table", "Powers of 2 (fx_exp.c).");
    write_powers(file);
    write_cubic(file);
    write_quadratic(file);
    write_close(file);
}
