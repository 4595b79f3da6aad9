#include "entries.h"

#include "depth.h"
#include "operations.h"

static number full(void)
{
    return whole(65535);
}

static number ratio(number a, number b)
{
    const bool is_small = is_less(b, power2(31));
    number quotient = is_small ? floor_div(up(a, 32), b) : floor_div(up(a, 31), down(b, 1));
    return least(power2(53), quotient);
}

number opacity_to_extinction(number v, number U, number E)
{
    if (sign_of(v) == 0)
        return v;
    return quot16(mul(full(), depth_of_opacity(v)), mul(U, E));
}

number extinction_to_opacity(number v, number E, number U)
{
    if (sign_of(v) == 0)
        return v;
    return opacity_of_depth(down(mul(mul(E, U), mul(whole(65537), v)), 32));
}

number opacity_to_opacity(number v, number U, number U_new)
{
    if (sign_of(v) == 0 || is_equal(v, full()))
        return v;
    return opacity_of_depth(down(mul(ratio(U_new, U), depth_of_opacity(v)), 32));
}

number extinction_to_extinction(number v, number E, number E_new)
{
    if (sign_of(v) == 0)
        return v;
    return least(full(), rounded(mul(ratio(E, E_new), v), 32));
}

/* least(x): E from U, rounded up. */
static number least_of(number x, number U)
{
    number quotient = negative(floor_div(negative(x), U));
    return clamp(quotient, whole(1), sub(power2(32), whole(1)));
}

number least_extinction(unsigned count, const number a[], number U, number opaque)
{
    number greatest = whole(0);
    bool has_opaque = false;
    for (unsigned i = 0; i < count; i++) {
        if (is_equal(a[i], full()))
            has_opaque = true;
        else
            greatest = most(greatest, a[i]);
    }
    number E = least_of(depth_of_opacity(greatest), U);
    if (!has_opaque)
        return E;
    return most(E, sign_of(opaque) == 0 ? least_of(power2(38), U) : opaque);
}

mixture mixture_of(unsigned count, const number p[], const number E[], const triple C[])
{
    mixture r = {whole(0), {{whole(0), whole(0), whole(0)}}};
    for (unsigned m = 0; m < count; m++) {
        number part = mul(p[m], E[m]);
        r.X = fits_unsigned(add(r.X, part), 48);
        for (int c = 0; c < 3; c++)
            r.Y.v[c] = fits_unsigned(add(r.Y.v[c], mul(part, C[m].v[c])), 64);
    }
    return r;
}

number mixture_colour(const mixture *m, unsigned channel)
{
    return sign_of(m->X) == 0 ? whole(0) : quot16(m->Y.v[channel], m->X);
}

number mixture_extinction(const mixture *m, number E)
{
    return quot16(m->X, E);
}

long tap_voxel(long p, long t, long n)
{
    const long q = 2 * p - 1 + t;
    const long mirrored = q >= n ? 2 * n - 1 - q : q;
    return mirrored < 0 ? 0 : mirrored;
}

/* A filter's tap t on one axis: outer, inner, inner, outer. */
static number tap(unsigned t, number inner)
{
    return t == 1 || t == 2 ? inner : sub(whole(32), inner);
}

reduced downsample(const taps *of, number inner, bool is_extinction)
{
    reduced r = {whole(0), NULL, NULL, {{whole(0), whole(0), whole(0)}}, {{NULL}}};
    for (unsigned t = 0; t < TAPS; t++) {
        number plane = mul(tap(t / 4 % 4, inner), tap(t / 16, inner));
        number weight = is_extinction ? ext16(of->X[t]) : of->X[t];
        number part = mul(mul(tap(t % 4, inner), plane), weight);
        r.W = fits_unsigned(add(r.W, part), 49);
        for (int c = 0; c < 3; c++)
            r.L.v[c] = fits_unsigned(add(r.L.v[c], mul(part, of->C[c][t])), 64);
    }
    r.m = rounded(r.W, 18);
    r.X = is_extinction ? sub(full(), transmittance16(r.m)) : r.m;
    for (int c = 0; c < 3; c++)
        r.c.v[c] = sign_of(r.W) == 0 ? whole(0) : quot16(r.L.v[c], r.W);
    return r;
}

number associated_of_8(number colour, number A)
{
    return div255(mul(colour, A));
}

number associated_of_16(number colour, number A)
{
    return floor_div(add(mul(colour, A), whole(8421247)), whole(16842495));
}
