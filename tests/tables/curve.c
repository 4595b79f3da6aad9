#include "curve.h"

#include <stdio.h>
#include <stdlib.h>

void curve_init(mpfr_t c[], unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        mpfr_init2(c[i], CURVE_BITS);
}

void curve_clear(mpfr_t c[], unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        mpfr_clear(c[i]);
}

uint32_t curve_round(const mpfr_t value, int exponent, uint32_t limit)
{
    mpfr_t scaled;
    mpfr_init2(scaled, CURVE_BITS);
    mpfr_mul_2si(scaled, value, exponent, MPFR_RNDN);
    if (mpfr_cmp_d(scaled, -0.5) < 0 || mpfr_cmp_d(scaled, limit + 0.5) >= 0) {
        fprintf(stderr, "tables: a coefficient is out of range\n");
        exit(EXIT_FAILURE);
    }
    uint32_t rounded = (uint32_t)mpfr_get_ui(scaled, MPFR_RNDN);
    mpfr_clear(scaled);
    return rounded;
}

/* Node k of n + 1: (1 - cos((2k + 1) u) / cos(u)) / 2 with u = pi / (2n + 2). */
static void node(mpfr_t place, unsigned k, unsigned degree)
{
    mpfr_t angle;
    mpfr_init2(angle, CURVE_BITS);
    mpfr_const_pi(angle, MPFR_RNDN);
    mpfr_div_ui(angle, angle, 2 * degree + 2, MPFR_RNDN);
    mpfr_cos(place, angle, MPFR_RNDN);
    mpfr_mul_ui(angle, angle, 2 * k + 1, MPFR_RNDN);
    mpfr_cos(angle, angle, MPFR_RNDN);
    mpfr_div(place, angle, place, MPFR_RNDN);
    mpfr_ui_sub(place, 1, place, MPFR_RNDN);
    mpfr_div_ui(place, place, 2, MPFR_RNDN);
    mpfr_clear(angle);
}

/* Newton's divided differences: values become the coefficients of 1, (t - t0),
   (t - t0)(t - t1), ... */
static void divide_differences(mpfr_t values[], mpfr_t places[], unsigned degree)
{
    mpfr_t width;
    mpfr_init2(width, CURVE_BITS);
    for (unsigned order = 1; order <= degree; order++)
        for (unsigned i = degree; i >= order; i--) {
            mpfr_sub(values[i], values[i], values[i - 1], MPFR_RNDN);
            mpfr_sub(width, places[i], places[i - order], MPFR_RNDN);
            mpfr_div(values[i], values[i], width, MPFR_RNDN);
        }
    mpfr_clear(width);
}

/* Newton's form to powers of t: from the inside, c = c * (t - places[k]) + c[k]. */
static void expand(mpfr_t c[], mpfr_t places[], unsigned degree)
{
    mpfr_t product;
    mpfr_init2(product, CURVE_BITS);
    for (unsigned k = degree; k-- > 0;)
        for (unsigned i = k; i < degree; i++) {
            mpfr_mul(product, c[i + 1], places[k], MPFR_RNDN);
            mpfr_sub(c[i], c[i], product, MPFR_RNDN);
        }
    mpfr_clear(product);
}

void curve_fit(mpfr_t c[], unsigned degree, curve_function *function, unsigned segment)
{
    mpfr_t places[CURVE_DEGREE_MAX + 1];
    curve_init(places, degree + 1);
    for (unsigned k = 0; k <= degree; k++) {
        node(places[k], k, degree);
        function(c[k], places[k], segment);
    }
    divide_differences(c, places, degree);
    expand(c, places, degree);
    curve_clear(places, degree + 1);
}
