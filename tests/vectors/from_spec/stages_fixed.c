/* Stages of section 2: fixed-point operations. */
#include "stages.h"

#include "operations.h"
#include "view.h"

void stage_product(csv *c)
{
    number a = in(c, "a"), b = in(c, "b");
    out(c, hi(a, b), "high");
    out(c, shift16(a, low_bits(b, 16)), "shift16");
}

void stage_scale(csv *c)
{
    out(c, q30(in(c, "v"), in(c, "factor")), "scaled");
}

void stage_quotient(csv *c)
{
    out(c, fits_unsigned(floor_div(in(c, "n"), in(c, "d")), 64), "quotient");
    out(c, quot16(in(c, "m"), in(c, "e")), "quotient16");
}

void stage_sine(csv *c)
{
    const turn t = turn_of(in(c, "angle"));
    out(c, t.sine, "sine");
    out(c, t.cosine, "cosine");
}

void stage_root(csv *c)
{
    const root r = rsqrt(in(c, "n"));
    out(c, r.r, "r");
    out(c, whole(r.x), "x");
}

void stage_unorm(csv *c)
{
    number narrow = to8(in(c, "a"));
    out(c, narrow, "narrow");
    out(c, mul(whole(257), narrow), "wide");
    out(c, div255(in(c, "p")), "quotient");
}
