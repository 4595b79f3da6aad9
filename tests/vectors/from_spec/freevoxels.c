#include "freevoxels.h"

#include "depth.h"
#include "operations.h"

number length_of(const triple *v)
{
    number n = whole(0);
    for (int a = 0; a < 3; a++)
        n = add(n, mul(v->v[a], v->v[a]));
    if (sign_of(fits_unsigned(n, 64)) == 0)
        return n;
    const unsigned j = least_shift(n, 2, power2(62));
    number wide = up(n, 2 * j);
    const root inverse = rsqrt(wide);
    return rounded(mul(down(wide, 32), inverse.r), 30 + j);
}

/* floor(v * 2^by), by of either sign. */
static number shifted(number v, long by)
{
    return by < 0 ? down(v, (unsigned)-by) : up(v, (unsigned)by);
}

scaled scaled_of(number v, long e)
{
    const long b = (long)bits_of(v);
    if (b == 0)
        return (scaled){v, 0};
    return (scaled){shifted(v, 32 - b), e + b - 32};
}

scaled scaled_product(scaled a, scaled b)
{
    number p = mul(a.m, b.m);
    const unsigned q = is_less(p, power2(63)) ? 31 : 32;
    return scaled_of(rounded(p, q), a.e + b.e + (long)q);
}

static scaled inverse_of(scaled a)
{
    if (is_equal(a.m, power2(31)))
        return scaled_of(whole(1), -31 - a.e);
    return scaled_of(recip(down(a.m, 1)), -59 - a.e);
}

scaled scaled_quotient(scaled a, scaled b)
{
    return scaled_product(a, inverse_of(b));
}

number scaled_fixed(scaled a, long f)
{
    return least(shifted(a.m, a.e + f), sub(power2(32), whole(1)));
}

/* f and s of t, by j halvings of t, the least that bring it below 2^32. */
static thickness thickness_of(number t, long s)
{
    const unsigned bits = bits_of(t);
    const unsigned j = bits > 32 ? bits - 32 : 0;
    return (thickness){down(fits_unsigned(t, 52), j), whole(s - (long)j)};
}

thickness thickness_of_unit(number U, number L)
{
    if (sign_of(U) == 0)
        return (thickness){power2(31), whole(23)};
    const unsigned c = bit_of(U, 31) ? 1 : 0;
    number wide = add(up(L, 32), down(U, 1));
    return thickness_of(floor_div(down(wide, c), down(U, c)), 31);
}

thickness thickness_of_extinction(number E, number L)
{
    number product = mul(E, L);
    unsigned z = 0;
    while (z < 40 && is_less(up(product, z), power2(50)))
        z++;
    number m = up(product, z);
    return thickness_of(add(m, add(down(m, 16), down(m, 32))), 23 + (long)z);
}

number thickness_depth(thickness t, number w)
{
    return fits_unsigned(down(mul(w, t.f), (unsigned)small(t.s)), 64);
}

number attenuation_byte(number D)
{
    if (!is_less(D, up(whole(9), 32)))
        return whole(0);
    return rounded(mul(whole(255), down(transmittance(D), 7)), 24);
}
