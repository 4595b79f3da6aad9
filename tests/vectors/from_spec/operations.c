#include "operations.h"

number hi(number a, number b)
{
    return fits_unsigned(rounded(mul(fits_unsigned(a, 32), fits_unsigned(b, 32)), 32), 32);
}

number shift16(number a, number b)
{
    return fits_unsigned(down(mul(fits_unsigned(a, 32), fits_unsigned(b, 16)), 16), 32);
}

number q30(number v, number f)
{
    return fits_signed(rounded(mul(fits_signed(v, 64), fits_signed(f, 32)), 30), 64);
}

number quot16(number n, number d)
{
    fits_unsigned(n, 64);
    fits_unsigned(d, 64);
    return least(whole(65535), floor_div(add(n, down(d, 1)), d));
}

unsigned least_shift(number a, unsigned step, number bound)
{
    unsigned s = 0;
    while (is_less(up(a, step * s), bound))
        s++;
    return s;
}

/* Section 2.2: floor((a b + 2^30) / 2^31), with a b < 2^63. */
static number p31(number a, number b)
{
    return fits_unsigned(rounded(fits_unsigned(mul(a, b), 63), 31), 32);
}

root rsqrt(number n)
{
    number seen = most(whole(1), fits_unsigned(n, 64));
    const unsigned s = least_shift(seen, 2, power2(62));
    number f = fits_unsigned(down(up(seen, 2 * s), 32), 32);
    number r = sub(whole(0x8851EB85), hi(f, whole(0x4CCCCCCD)));
    for (int i = 0; i < 4; i++) {
        number g = p31(p31(f, r), r);
        r = p31(r, sub(whole(0xC0000000), g));
    }
    return (root){least(r, power2(31)), 32 - s};
}

number to8(number a)
{
    return down(add(mul(whole(255), fits_unsigned(a, 16)), whole(32895)), 16);
}

number div255(number p)
{
    /* round(p / 255) = floor((2 p + 255) / 510). */
    return floor_div(add(up(p, 1), whole(255)), whole(510));
}
