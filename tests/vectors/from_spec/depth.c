#include "depth.h"

#include "operations.h"
#include "tables.h"

/* floor((floor(v / 2^n) + 1) / 2): v / 2^(n+1), rounded. */
static number halved(number v, unsigned n)
{
    return down(add(down(v, n), whole(1)), 1);
}

number transmittance_steps(number x, power_steps *step)
{
    step->w = fits_unsigned(down(fits_unsigned(x, 64), 32), 32);
    step->g = low_bits(negative(x), 32);
    step->i = down(step->g, 26);
    step->B = exp_power(step->i);
    step->t = low_bits(mul(whole(64), step->g), 32);
    number s = add(whole(0x00F5FD31), down(mul(whole(0xE494), down(step->t, 16)), 16));
    number r = hi(step->t, add(whole(0xB1721819), hi(step->t, s)));
    number power = fits_unsigned(add(step->B, down(hi(step->B, r), 6)), 32);
    if (!is_less(step->w, whole(32)))
        return whole(0);
    const unsigned w = (unsigned)small(step->w);
    return sign_of(step->g) == 0 ? power2(31 - w) : halved(power, w);
}

number transmittance(number x)
{
    power_steps unused;
    return transmittance_steps(x, &unused);
}

number transmittance16_steps(number x, power16_steps *step)
{
    step->w = fits_unsigned(down(fits_unsigned(x, 32), 24), 8);
    step->g = low_bits(negative(x), 24);
    step->B = exp_power(down(step->g, 18));
    step->t = low_bits(down(step->g, 2), 16);
    number slope = add(whole(0xB171A5D5), down(mul(whole(0xF754), step->t), 8));
    number rest = mul(whole(0x2C7B), low_bits(step->g, 2));
    number r = fits_unsigned(add(shift16(slope, step->t), rest), 32);
    number rise = down(shift16(r, rounded(step->B, 16)), 6);
    number p = sign_of(step->g) == 0 ? power2(31) : down(add(step->B, rise), 1);
    number q = sub(p, down(p, 16));
    if (!is_less(x, up(whole(17), 24)))
        return whole(0);
    return halved(q, 14 + (unsigned)small(step->w));
}

number transmittance16(number x)
{
    power16_steps unused;
    return transmittance16_steps(x, &unused);
}

/* n, i, e and p of section 28: t, doubled w times until its highest bit is set. */
static depth_steps normalised(number t)
{
    const unsigned w = least_shift(t, 1, power2(31));
    depth_steps step = {.w = whole(w), .n = fits_unsigned(up(t, w), 32)};
    step.i = sub(down(step.n, 26), whole(32));
    step.e = fits_unsigned(sub(power2(31), shift16(step.n, log_reciprocal(step.i))), 26);
    step.p = fits_unsigned(mul(whole(64), step.e), 32);
    return step;
}

number depth_of_steps(number t, depth_steps *step)
{
    *step = (depth_steps){whole(0), whole(0), whole(0), whole(0), whole(0)};
    if (sign_of(fits_unsigned(t, 32)) == 0)
        return up(whole(64), 32);
    *step = normalised(t);
    number cubic = add(whole(0x001711A2), down(mul(whole(0x8117), down(step->p, 16)), 16));
    number r = hi(step->p, add(whole(0x05C5527A), hi(step->p, cubic)));
    number fraction = low_bits(add(log_depth(step->i), r), 32);
    return add(up(step->w, 32), up(fraction, 1));
}

number depth_of(number t)
{
    depth_steps unused;
    return depth_of_steps(t, &unused);
}

number depth_of_opacity(number a)
{
    return depth_of(mul(whole(65537), sub(whole(65535), a)));
}

number ext16(number a)
{
    return fits_unsigned(rounded(depth_of_opacity(fits_unsigned(a, 16)), 8), 32);
}

number recip_steps(number v, depth_steps *step)
{
    *step = normalised(least(up(v, 1), sub(power2(32), whole(1))));
    if (is_less(whole(3), step->w))
        fail("recip of less than 2^27");
    number m = add(power2(31), step->e);
    m = fits_unsigned(add(m, down(hi(m, hi(step->p, step->p)), 10)), 32);
    return down(shift16(m, log_reciprocal(step->i)), 3 - (unsigned)small(step->w));
}

number recip(number v)
{
    depth_steps unused;
    return recip_steps(v, &unused);
}

number phi(number x)
{
    const unsigned above = bits_of(fits_unsigned(x, 64));
    const unsigned o = above < 34 ? 0 : above - 33;
    number y = o == 0 ? down(x, 1) : low_bits(down(x, o), 32);
    number i = add(whole(o < 5 ? 8 * o : 40), down(y, 29));
    number b = sub(sub(power2(32), whole(1)), low_bits(mul(whole(8), y), 32));
    number c = down(b, 16);
    number s = add(mul(whole(1024), phi_square(i)), down(mul(phi_cube(i), c), 9));
    number slope = add(phi_linear(i), shift16(s, c));
    number v = fits_unsigned(add(phi_end(i), hi(b, slope)), 32);
    return o == 0 ? v : halved(v, o - 1);
}

number scale(number x, number k)
{
    number upper = up(mul(k, down(x, 32)), 16);
    return fits_unsigned(add(upper, down(mul(k, low_bits(x, 32)), 16)), 64);
}

number opacity_of_depth(number d)
{
    number l = sub(power2(31), transmittance(d));
    return fits_unsigned(rounded(sub(l, down(l, 16)), 15), 16);
}

number correct(number a, number k)
{
    return is_equal(a, whole(65535)) ? a : opacity_of_depth(scale(depth_of_opacity(a), k));
}

number correction_factor(number a, number k)
{
    if (is_equal(a, whole(65535)))
        return power2(27);
    number d = depth_of_opacity(a);
    return down(mul(k, hi(mul(whole(2), recip(phi(d))), phi(scale(d, k)))), 16);
}
