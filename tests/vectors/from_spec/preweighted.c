#include "preweighted.h"

ends preweighted_ends(const corners *c, const triple *f)
{
    number Y = f->v[1], Z = f->v[2], b = rounded(mul(Y, Z), 8);
    ends r = {.u = {add(sub(sub(whole(256), Y), Z), b), sub(Y, b), sub(Z, b), b}};
    for (int channel = 0; channel < 4; channel++) {
        number low = whole(0), high = whole(0);
        for (int j = 0; j < 4; j++) {
            fits_unsigned(r.u[j], 9);
            low = add(low, mul(r.u[j], c->of[2 * j].v[channel]));
            high = add(high, mul(r.u[j], c->of[2 * j + 1].v[channel]));
        }
        r.low.v[channel] = fits_unsigned(low, 16);
        r.high.v[channel] = fits_unsigned(high, 16);
    }
    return r;
}

static number share(number v)
{
    return add(down(v, 16), down(v, 24));
}

bool preweighted_under(preweighted_light *kept, const ends *of, number X)
{
    number s = share(kept->T);
    number h = down(mul(s, X), 8);
    number l = sub(s, h);
    number t = add(mul(of->low.v[3], l), mul(of->high.v[3], h));
    if (sign_of(t) == 0)
        return true;
    for (int c = 0; c < 3; c++) {
        number lit = add(mul(of->low.v[c], l), mul(of->high.v[c], h));
        kept->E.v[c] = low_bits(add(kept->E.v[c], lit), 32);
    }
    kept->T = fits_unsigned(sub(kept->T, t), 32);
    return false;
}

/* m of a channel. */
static number mean(const ends *of, number X, int channel)
{
    number low = mul(of->low.v[channel], sub(whole(256), X));
    return down(add(low, mul(of->high.v[channel], X)), 8);
}

bool preweighted_over(preweighted_light *kept, const ends *of, number X)
{
    number opacity = mean(of, X, 3);
    if (sign_of(opacity) == 0)
        return true;
    for (int c = 0; c < 3; c++) {
        number left = sub(kept->E.v[c], mul(opacity, share(kept->E.v[c])));
        kept->E.v[c] = low_bits(add(left, up(mean(of, X, c), 16)), 32);
    }
    kept->T = fits_unsigned(sub(kept->T, mul(opacity, share(kept->T))), 32);
    return false;
}
