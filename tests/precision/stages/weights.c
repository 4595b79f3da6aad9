/*
 * weights.c - the eight weights of trilinear interpolation, for every fraction.
 */
#include "stages.h"

#include "weights.h"

/* The weight of corner q in 2^-16: a product of three whole numbers below 2^9, by 2^8. */
static double exact(unsigned q, const uint32_t f[3])
{
    uint32_t product = 1;
    for (unsigned axis = 0; axis < 3; axis++)
        product *= (q >> axis & 1) != 0 ? f[axis] : 256 - f[axis];
    return product / 256.;
}

static void measure_fraction(measured *m, const uint32_t f[3])
{
    const fx_fraction fraction[3] = {fx_fraction_of(f[0]), fx_fraction_of(f[1]),
                                     fx_fraction_of(f[2])};
    fx_weight weight[8];
    qv_weights(weight, fraction);
    for (unsigned q = 0; q < 8; q++)
        if (measured_add(m, fx_weight_bits(weight[q]) - exact(q, f)))
            measured_input(m, "f = (%u, %u, %u), corner %u", f[0], f[1], f[2], q);
}

static void measure(measured *m, unsigned unused)
{
    (void)unused;
    for (uint32_t n = 0; n < 1u << 24; n++) {
        const uint32_t f[3] = {n & 255, n >> 8 & 255, n >> 16};
        measure_fraction(m, f);
    }
}

static const stage stages[] = {
    {"trilinear weights", "3 fractions u8.8 to 8 weights u17.16", "one product, to nearest",
     "2^-16", .5, 2, "all 2^24 fractions", measure, 0, NULL},
};

const chapter chapter_weights = {
    "Weights of a cell (SPEC 11)",
    "x, y, z and their three products in pairs are exact in u17.16: 8 and 16 fraction bits.\n"
    "Only xyz has 24, and is rounded to 16, by at most 1/2. Each of the eight weights is a sum\n"
    "of exact terms and of xyz, once, so that each is off by that same error, with the sign\n"
    "that xyz has there; the eight errors cancel in the sum, which is exactly 65536.\n",
    stages, COUNT(stages)};
