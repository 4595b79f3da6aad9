/* Section 66: how much of a splat falls on each pixel of an axis. */
#include "freevoxels.h"

#include "depth.h"
#include "operations.h"

/* K[a] of the quadratic kernel. */
static number quadratic_integral(long a)
{
    const long p = 3 * a, left = 192 - p;
    if (p < 64)
        return floor_div(whole(36864 * p - p * p * p + 48), whole(96));
    return floor_div(whole(3 * 2097152 - left * left * left + 96), whole(192));
}

/* K[a] of a kernel. */
static number kernel(unsigned halves, unsigned a)
{
    const long place = (long)a;
    return halves == 2 ? whole(1024 * place - 8 * place * place) : quadratic_integral(place);
}

footprint footprint_of(number x, number size, unsigned halves)
{
    footprint r = {.halves = halves, .x = x, .size = size};
    r.H = mul(down(size, 1), whole(halves));
    r.j = 31 - bits_of(r.H);
    number wide = up(r.H, r.j);
    r.R = is_equal(wide, power2(30)) ? power2(28) : recip(wide);
    return r;
}

/* i: how far an edge lies from the centre, in 1/64 of the kernel's half and 16 bits. */
static number place_in_kernel(const footprint *of, number t)
{
    if (!is_less(magnitude(t), of->H))
        return power2(22);
    return down(mul(magnitude(t), of->R), 36 - of->j);
}

/* share, u32.31: the kernel's integral up to the place i. */
static number share_of_kernel(unsigned halves, number i)
{
    const unsigned a = (unsigned)small(least(whole(64), down(i, 16)));
    if (a == 64)
        return power2(31);
    number f = low_bits(i, 16);
    number next = kernel(halves, a + 1);
    number rise = sub(next, kernel(halves, a));
    number b = sub(rise, sub(kernel(halves, a + 2), next));
    number bent = mul(b, down(mul(f, sub(power2(16), f)), 17));
    return fits_unsigned(add(add(up(kernel(halves, a), 16), mul(f, rise)), bent), 32);
}

static number edge(const footprint *of, number k)
{
    number t = sub(sub(up(k, 16), power2(15)), of->x);
    number share = share_of_kernel(of->halves, place_in_kernel(of, t));
    return with_sign(down(mul(of->size, share), 33), t);
}

number footprint_weight(const footprint *of, number k)
{
    return fits_unsigned(sub(edge(of, add(k, whole(1))), edge(of, k)), 16);
}

number splat_part(number line, number weight)
{
    return rounded(shift16(line, weight), 4);
}

channels splat_added(const channels *sum, const number part[])
{
    channels r;
    for (int c = 0; c < 4; c++)
        r.v[c] = least(sub(power2(32), whole(1)), add(sum->v[c], part[c]));
    return r;
}

channels splat_over(const channels *sum, const number part[])
{
    channels r;
    number top = up(whole(255), 16);
    number a = least(top, part[3]);
    number o = add(mul(whole(257), a), add(down(a, 8), down(a, 16)));
    for (int c = 0; c < 4; c++) {
        number left = sub(sum->v[c], hi(sum->v[c], o));
        r.v[c] = least(top, add(left, least(top, part[c])));
    }
    return r;
}
