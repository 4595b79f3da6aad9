/* Sections 48 to 50 and 52: what becomes of a state. */
#include "dither.h"
#include "operations.h"

number light_opacity(number o32)
{
    return rounded(o32, 9);
}

number opacity32_of_level(number level)
{
    number tail = add(down(level, 8), down(level, 16));
    return fits_unsigned(add(mul(whole(257), level), tail), 32);
}

number div_ones(number x, unsigned n)
{
    number t = add(x, power2(n - 1));
    return down(add(t, down(t, n)), n);
}

static number ones(unsigned n)
{
    return sub(power2(n), whole(1));
}

number blend_plain(number S, number c, number a, unsigned n)
{
    number left = mul(sub(ones(n), a), S);
    return fits_unsigned(div_ones(add(mul(c, a), left), n), n);
}

number blend_associated(number S, number c, number a, unsigned n)
{
    return fits_unsigned(add(c, div_ones(mul(sub(ones(n), a), S), n)), n);
}

number blend_dithered(number S, number C, number A, number u, unsigned f)
{
    number left = down(mul(sub(power2(23), A), S), f);
    number sum = add(add(C, left), down(u, 9 + f));
    return down(fits_unsigned(sum, 32), 23 - f);
}

number blend_24(number S, number C, number o32, number u)
{
    number wide = up(S, 8);
    number K = sub(wide, hi(wide, o32));
    number noise = down(mul(whole(252), down(u, 24)), 8);
    number sum = add(add(K, up(C, 1)), add(whole(2), noise));
    return down(fits_unsigned(sum, 32), 8);
}

number rest_behind(number T, number o32)
{
    number wide = up(T, 8);
    return fits_unsigned(rounded(sub(wide, hi(wide, o32)), 8), 24);
}

number share_of(number c, number T, unsigned f)
{
    return rounded(mul(up(c, f), sub(power2(24), T)), 24);
}

number blend_colour_under(number S, number c, number T, number o32, unsigned f)
{
    number behind = rest_behind(T, o32);
    number gain = sub(share_of(c, behind, f), share_of(c, T, f));
    return least(add(S, gain), share_of(whole(255), behind, f));
}

number blend_light_under(number S, number C, number T, number o32, number u, unsigned f)
{
    number sum = add(hi(C, up(T, 8)), down(u, 9 + f));
    number top = share_of(whole(255), rest_behind(T, o32), f);
    return least(add(S, down(sum, 23 - f)), top);
}

number state_level(number S, unsigned f)
{
    return rounded(S, f);
}

number state_residual(number S, unsigned f)
{
    return fits_signed(sub(S, up(state_level(S, f), f)), f);
}

static channels replay_step(const channels *X, const channels *f)
{
    channels r;
    number left = sub(whole(255), f->v[3]);
    for (int c = 0; c < 4; c++)
        r.v[c] = add(least(f->v[c], f->v[3]), div_ones(mul(left, X->v[c]), 8));
    return r;
}

static bool are_equal(const channels *a, const channels *b)
{
    for (int c = 0; c < 4; c++)
        if (!is_equal(a->v[c], b->v[c]))
            return false;
    return true;
}

channels replay(const channels *slice, const channels *behind, const channels *K)
{
    channels s, X, S = *behind;
    for (int c = 0; c < 4; c++) {
        s.v[c] = c == 3 ? slice->v[3] : div_ones(mul(slice->v[c], slice->v[3]), 8);
        X.v[c] = whole(0);
    }
    while (!are_equal(&X, K)) {
        const channels next = replay_step(&X, &s);
        if (are_equal(&next, &X))
            return replay_step(behind, K);
        X = next;
        S = replay_step(&S, &s);
    }
    return S;
}
