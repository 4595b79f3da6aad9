/*
 * bspline.c - the 27 weights of the quadratic B-spline, for every fraction.
 */
#include "stages.h"

#include "bspline.h"

/* Fractions of an axis as parts of 2^17: products of three are below 2^51, exact in doubles. */
static void exact_part(double part[3], uint32_t f)
{
    part[0] = (256 - f) * (256 - f);
    part[2] = f * f;
    part[1] = (1 << 17) - part[0] - part[2];
}

static void set_taps(qv_triple *triple, uint32_t f)
{
    triple->tap[0] = fx_tap_of_square(256u - f);
    triple->tap[1] = fx_tap_of_square(f);
}

/* The row of voxels (v1, v2), of a weight that is exactly `exact` * 2^-34. */
static void measure_row(measured *m, fx_weight row, double exact, const uint32_t f[3])
{
    qv_triple triple;
    fx_weight weight[3];
    double part[3];
    set_taps(&triple, f[0]);
    qv_part(weight, row, &triple);
    exact_part(part, f[0]);
    for (unsigned v = 0; v < 3; v++)
        if (measured_add(m, fx_weight_bits(weight[v]) - ldexp(part[v] * exact, 16 - 51)))
            measured_input(m, "f = (%u, %u, %u), v0 = %u", f[0], f[1], f[2], v);
}

static void measure_slice(measured *m, uint32_t fy, uint32_t fz)
{
    qv_triple of_z, of_y;
    fx_weight z[3], y[3];
    double exact_z[3], exact_y[3];
    set_taps(&of_z, fz);
    set_taps(&of_y, fy);
    exact_part(exact_z, fz);
    exact_part(exact_y, fy);
    qv_part_one(z, &of_z);
    for (unsigned v2 = 0; v2 < 3; v2++) {
        qv_part(y, z[v2], &of_y);
        for (unsigned v1 = 0; v1 < 3; v1++)
            for (uint32_t fx = 0; fx < 256; fx++) {
                const uint32_t f[3] = {fx, fy, fz};
                measure_row(m, y[v1], exact_y[v1] * exact_z[v2], f);
            }
    }
}

static void measure(measured *m, unsigned unused)
{
    (void)unused;
    for (uint32_t n = 0; n < 65536; n++)
        measure_slice(m, n & 255, n >> 8);
}

static const stage stages[] = {
    {"B-spline weights", "3 fractions u8.8 to 27 weights u17.16", "3 products, to nearest", "2^-16",
     2.32, 2, "all 2^24 fractions", measure, 0, NULL},
};

const chapter chapter_bspline = {
    "Weights of the B-spline (SPEC 40)",
    "A weight is parted three times. An outer part is rounded, by 1/2; the middle one is what\n"
    "is left, off by up to 1; and either carries its share of the error of what was parted, at\n"
    "most 1/2 or 3/4 of it. The middle of the middle of the middle: 1 + 3/4 (1 + 3/4) = 2.3125.\n",
    stages, COUNT(stages)};
