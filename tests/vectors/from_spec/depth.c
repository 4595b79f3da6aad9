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
    step->s = add(whole(0x00F5FD31), down(mul(whole(0xE494), down(step->t, 16)), 16));
    step->r = hi(step->t, add(whole(0xB1721819), hi(step->t, step->s)));
    step->power = fits_unsigned(add(step->B, down(hi(step->B, step->r), 6)), 32);
    if (!is_less(step->w, whole(32)))
        return whole(0);
    const unsigned w = (unsigned)small(step->w);
    return sign_of(step->g) == 0 ? power2(31 - w) : halved(step->power, w);
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
    step->r = fits_unsigned(add(shift16(slope, step->t), rest), 32);
    number rise = down(shift16(step->r, rounded(step->B, 16)), 6);
    step->p = sign_of(step->g) == 0 ? power2(31) : down(add(step->B, rise), 1);
    step->q = sub(step->p, down(step->p, 16));
    if (!is_less(x, up(whole(17), 24)))
        return whole(0);
    return halved(step->q, 14 + (unsigned)small(step->w));
}

number transmittance16(number x)
{
    power16_steps unused;
    return transmittance16_steps(x, &unused);
}

number depth_of_steps(number t, depth_steps *step)
{
    *step = (depth_steps){0};
    if (sign_of(fits_unsigned(t, 32)) == 0)
        return up(whole(64), 32);
    const unsigned w = least_shift(t, 1, power2(31));
    step->w = whole(w);
    step->n = fits_unsigned(up(t, w), 32);
    step->i = sub(down(step->n, 26), whole(32));
    step->e = fits_unsigned(sub(power2(31), shift16(step->n, log_reciprocal(step->i))), 26);
    step->p = fits_unsigned(mul(whole(64), step->e), 32);
    number cubic = add(whole(0x001711A2), down(mul(whole(0x8117), down(step->p, 16)), 16));
    step->r = hi(step->p, add(whole(0x05C5527A), hi(step->p, cubic)));
    number fraction = low_bits(add(log_depth(step->i), step->r), 32);
    return add(up(step->w, 32), up(fraction, 1));
}

number depth_of(number t)
{
    depth_steps unused;
    return depth_of_steps(t, &unused);
}

number ext16(number a)
{
    number t = mul(whole(65537), sub(whole(65535), fits_unsigned(a, 16)));
    return fits_unsigned(rounded(depth_of(t), 8), 32);
}

number recip(number v)
{
    number seen = least(up(v, 1), sub(power2(32), whole(1)));
    const unsigned w = least_shift(seen, 1, power2(31));
    if (w > 3)
        fail("recip of less than 2^27");
    number n = up(seen, w);
    number i = sub(down(n, 26), whole(32));
    number e = fits_unsigned(sub(power2(31), shift16(n, log_reciprocal(i))), 26);
    number p = mul(whole(64), e);
    number m = add(power2(31), e);
    m = fits_unsigned(add(m, down(hi(m, hi(p, p)), 10)), 32);
    return down(shift16(m, log_reciprocal(i)), 3 - w);
}

number phi_with_steps(number x, phi_steps *step)
{
    const unsigned above = bits_of(fits_unsigned(x, 64));
    const unsigned o = above < 34 ? 0 : above - 33;
    step->o = whole(o);
    step->y = o == 0 ? down(x, 1) : low_bits(down(x, o), 32);
    step->i = add(mul(whole(8), least(step->o, whole(5))), down(step->y, 29));
    number ahead = low_bits(mul(whole(8), step->y), 32);
    step->b = sub(sub(power2(32), whole(1)), ahead);
    step->c = down(step->b, 16);
    step->s = fits_unsigned(
        add(mul(whole(1024), phi_square(step->i)), down(mul(phi_cube(step->i), step->c), 9)), 32);
    number slope = add(phi_linear(step->i), shift16(step->s, step->c));
    step->v = fits_unsigned(add(phi_end(step->i), hi(step->b, slope)), 32);
    return o == 0 ? step->v : halved(step->v, o - 1);
}

number phi(number x)
{
    phi_steps unused;
    return phi_with_steps(x, &unused);
}

number scale(number x, number k)
{
    number upper = up(mul(k, down(x, 32)), 16);
    return fits_unsigned(add(upper, down(mul(k, low_bits(x, 32)), 16)), 64);
}

/* D of what an opacity, unorm16, lets through. */
static number depth_of_opacity(number a)
{
    return depth_of(mul(whole(65537), sub(whole(65535), a)));
}

number correct(number a, number k)
{
    if (is_equal(a, whole(65535)))
        return a;
    number l = sub(power2(31), transmittance(scale(depth_of_opacity(a), k)));
    number q = sub(l, down(l, 16));
    return fits_unsigned(rounded(q, 15), 16);
}

number correction_factor(number a, number k)
{
    if (is_equal(a, whole(65535)))
        return power2(27);
    number d = depth_of_opacity(a);
    return down(mul(k, hi(mul(whole(2), recip(phi(d))), phi(scale(d, k)))), 16);
}
