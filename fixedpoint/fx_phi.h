/*
 * fx_phi.h - from extinction-weighted to opacity-weighted colour.
 *
 * A stretch of optical depth x has the opacity 1 - 2^-x. Its opacity-weighted
 * colour is its extinction-weighted colour times opacity / extinction (Kraus and
 * Buerger 2008, equation 23), which is the stretch's length times phi: a
 * multiplication in place of a division.
 */
#ifndef FX_PHI_H
#define FX_PHI_H

#include "fx_exp.h"

/*
 * phi(x) = (1 - 2^-x) / (x ln 2), that is (1 - e^-t) / t for t = x ln 2, as Q1.31,
 * for every depth. Exactly 1 at 0; never rises with the depth. Error at most .02 *
 * 2^-16, and at most .16 * 2^-16 of the result (and the last place, 2^-31).
 */
uint32_t fx_phi(fx_depth depth);

#endif /* FX_PHI_H */
