#include "dither.h"

#include "depth.h"
#include "operations.h"

static number modulo32(number v)
{
    return low_bits(v, 32);
}

static number golden_ratio(void)
{
    return whole(0x9E3779B9);
}

number hash_of(number v)
{
    v = either(v, down(v, 16));
    v = modulo32(mul(whole(0x7FEB352D), v));
    v = either(v, down(v, 15));
    v = modulo32(mul(whole(0x846CA68B), v));
    return either(v, down(v, 16));
}

number golden(number n)
{
    return modulo32(mul(golden_ratio(), n));
}

number hashed(number n)
{
    return hash_of(modulo32(add(up(n, 1), whole(1))));
}

number blocks(number n)
{
    number b = down(n, 3);
    number block = add(golden(b), hash_of(down(b, 6)));
    number place = up(add(mul(whole(5), n), hash_of(b)), 29);
    return modulo32(add(place, down(modulo32(block), 3)));
}

number dither_at(number u, number x, number y, number f)
{
    number moved = add(mul(whole(0xC13FA9A9), x), mul(whole(0x91E10DA6), y));
    return modulo32(add(add(u, moved), mul(golden_ratio(), f)));
}

number hits_of(number P, number o, number base, number bump)
{
    number above = mul(up(P, 1), sub(o, up(base, 16)));
    return least(P, floor_div(add(above, up(bump, 16)), up(bump, 17)));
}

bool hits_ordered(number P, number hits, number n)
{
    number k = sub(n, mul(P, floor_div(n, P)));
    number next = mul(add(k, whole(1)), hits);
    return is_less(floor_div(mul(k, hits), P), floor_div(next, P));
}

bool hits_randomly(number P, number hits, number u)
{
    return is_less(down(mul(down(u, 16), P), 16), hits);
}

/* floor((F - 1) / 2 / divisor). */
static number half_by(number F, number divisor)
{
    return floor_div(down(sub(F, whole(1)), 1), divisor);
}

number plateau(number o, number F)
{
    return sign_of(o) == 0 ? o : sub(F, half_by(F, o));
}

number over_least(number v, number F)
{
    if (is_equal(v, F))
        return add(F, whole(1));
    return add(half_by(F, sub(F, v)), whole(1));
}

number bump_of(number v, number base)
{
    int k = 1;
    while (k < 255 && is_less(mul(whole(k), sub(whole(255), v)), whole(128)))
        k = 2 * k + 1;
    return least(whole(k), sub(whole(255), base));
}

number opacity_for_slices(number o32, number N, number M)
{
    number full = sub(power2(32), whole(1));
    if (is_equal(N, M) || is_equal(o32, full))
        return o32;
    number k = fits_unsigned(floor_div(up(N, 32), M), 64);
    number x = sub(power2(31), transmittance(down(mul(k, depth_of(sub(full, o32))), 32)));
    return sub(up(x, 1), down(x, 31));
}
