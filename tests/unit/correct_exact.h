/*
 * correct_exact.h - opacity correction and its colour factor by the mathematics
 * library.
 */
#ifndef QV_CORRECT_EXACT_H
#define QV_CORRECT_EXACT_H

#include "check.h"
#include "deviation.h"
#include "fx_correct.h"

/* log(1 - opacity / 65535) for opacities below 65535. */
static inline long double correct_logarithm(uint32_t opacity)
{
    return log1pl(-(long double)opacity / 65535);
}

/* Of opacities in 1/65535, of colour factors in 2^-16, and in 2^-16 of the factor. */
typedef struct correct_errors {
    deviation opacity, factor, relative;
} correct_errors;

/* Adds the deviations at one opacity. */
static inline void correct_measure(correct_errors *errors, uint32_t opacity, long double logarithm,
                                   uint32_t ratio)
{
    const long double r = ldexpl(ratio, -16);
    const long double exact = opacity == 65535 ? 65535 : -65535 * expm1l(r * logarithm);
    const long double quotient = opacity == 0 ? r : exact / opacity;
    const long double colour = ldexpl(fx_correct_colour((fx_unorm16)opacity, ratio), 16 - 27);

    deviation_add(&errors->opacity, fx_correct_opacity((fx_unorm16)opacity, ratio), exact);
    deviation_add(&errors->factor, colour, 65536 * quotient);
    deviation_add(&errors->relative, colour / quotient, 65536);
}

/* Prints them, and expects what fx_correct.h declares. */
static inline void correct_judge(const correct_errors *errors)
{
    deviation_print(&errors->opacity, "corrected opacity, units of 1/65535", 1);
    deviation_print(&errors->factor, "colour factor, units of 2^-16", 1);
    deviation_print(&errors->relative, "colour factor, units of 2^-16 of it", 1);
    assert_true(errors->opacity.worst <= .505);
    assert_true(errors->factor.worst <= .5);
    assert_true(errors->relative.worst <= .4);
}

#endif /* QV_CORRECT_EXACT_H */
