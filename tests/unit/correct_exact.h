/*
 * correct_exact.h - opacity correction and its colour factor by the mathematics
 * library.
 */
#ifndef QV_CORRECT_EXACT_H
#define QV_CORRECT_EXACT_H

#include "deviation.h"
#include "fx_correct.h"

/* log(1 - opacity / 65535) for opacities below 65535. */
static inline long double correct_logarithm(uint32_t opacity)
{
    return log1pl(-(long double)opacity / 65535);
}

/* The deviations at one opacity: of the opacity in 1/65535, of the factor in 2^-16
   of it. */
static inline void correct_measure(deviation *opacities, deviation *factors, uint32_t opacity,
                                   long double logarithm, uint32_t ratio)
{
    const long double r = ldexpl(ratio, -16);
    const long double exact = opacity == 65535 ? 65535 : -65535 * expm1l(r * logarithm);
    const long double quotient = opacity == 0 ? r : exact / opacity;
    const uint32_t colour = fx_correct_colour((fx_unorm16)opacity, ratio);

    deviation_add(opacities, fx_correct_opacity((fx_unorm16)opacity, ratio), exact);
    deviation_add(factors, ldexpl(colour, 16 - 27) / quotient, 65536);
}

#endif /* QV_CORRECT_EXACT_H */
