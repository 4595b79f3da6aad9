/*
 * phi.c - (1 - 2^-x) / (x ln 2) in octaves of 8 segments (fixedpoint/fx_phi.c).
 *
 * A segment's polynomial runs backwards from its end, so that no coefficient is
 * negative.
 */
#include "curve.h"
#include "write.h"

enum { OCTAVES = 6, SEGMENTS = 8, ROWS = OCTAVES * SEGMENTS };

typedef struct phi_table {
    uint32_t end[ROWS], linear[ROWS], square[ROWS], cube[ROWS];
} phi_table;

/* x of a place, counted backwards in a row: rows are 1/4 wide up to 2, then 1/8 of
   2^octave. */
static void argument(mpfr_t x, const mpfr_t place, unsigned row)
{
    const unsigned octave = row / SEGMENTS, segment = row % SEGMENTS;
    mpfr_ui_sub(x, segment + 1, place, MPFR_RNDN);
    mpfr_div_ui(x, x, SEGMENTS, MPFR_RNDN);
    if (octave > 0)
        mpfr_add_ui(x, x, 1, MPFR_RNDN);
    mpfr_mul_2ui(x, x, octave > 0 ? octave : 1, MPFR_RNDN);
}

/* phi, times 2^octave; the last octave stands for all from there on, without 2^-x. */
static void scaled_phi(mpfr_t value, const mpfr_t place, unsigned row)
{
    mpfr_t x, t;
    mpfr_inits2(CURVE_BITS, x, t, (mpfr_ptr)0);
    argument(x, place, row);
    mpfr_const_log2(t, MPFR_RNDN);
    mpfr_mul(t, t, x, MPFR_RNDN);
    mpfr_neg(value, t, MPFR_RNDN);
    mpfr_expm1(value, value, MPFR_RNDN);
    mpfr_neg(value, value, MPFR_RNDN);
    if (row / SEGMENTS == OCTAVES - 1)
        mpfr_set_ui(value, 1, MPFR_RNDN);
    mpfr_div(value, value, t, MPFR_RNDN);
    mpfr_mul_2ui(value, value, row / SEGMENTS, MPFR_RNDN);
    if (mpfr_zero_p(t))
        mpfr_set_ui(value, 1, MPFR_RNDN);
    mpfr_clears(x, t, (mpfr_ptr)0);
}

/* The linear term takes what the rounding of the others left, in the integers of
   fx_phi.c, so that a segment starts exactly where it should. */
static void fit_row(phi_table *table, unsigned row)
{
    mpfr_t c[4], start;
    curve_init(c, 4);
    mpfr_init2(start, CURVE_BITS);
    curve_fit(c, 3, scaled_phi, row);
    table->end[row] = curve_round(c[0], 31, UINT32_MAX);
    table->square[row] = curve_round(c[2], 21, UINT16_MAX);
    table->cube[row] = curve_round(c[3], 24, UINT16_MAX);

    mpfr_set_ui(start, 1, MPFR_RNDN);
    scaled_phi(start, start, row);
    const uint32_t curved = (table->square[row] << 10) + (table->cube[row] * 65535u >> 9);
    table->linear[row] = curve_round(start, 31, UINT32_MAX) - table->end[row] -
                         (uint32_t)((uint64_t)curved * 65535u >> 16);
    mpfr_clear(start);
    curve_clear(c, 4);
}

void write_phi(const char *folder)
{
    static phi_table table;
    FILE *file = write_open(folder, "fx_phi_table", "(1 - 2^-x) / (x ln 2) (fx_phi.c).");
    for (unsigned row = 0; row < ROWS; row++)
        fit_row(&table, row);
    write_table(file, 32, "phi_end", table.end, ROWS, "Value at a segment's end, Q1.31");
    write_table(file, 32, "phi_linear", table.linear, ROWS,
                "By the way back from there, in segments: t, Q1.31");
    write_table(file, 16, "phi_square", table.square, ROWS, "of t^2, units of 2^-21");
    write_table(file, 16, "phi_cube", table.cube, ROWS, "of t^3, units of 2^-24");
    write_close(file);
}
