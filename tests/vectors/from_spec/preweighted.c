#include "preweighted.h"

ends preweighted_ends(const corners *c, const triple *f)
{
    number Y = f->v[1], Z = f->v[2];
    ends r = {.b = rounded(mul(Y, Z), 8)};
    r.u[0] = add(sub(sub(whole(256), Y), Z), r.b);
    r.u[1] = sub(Y, r.b);
    r.u[2] = sub(Z, r.b);
    r.u[3] = r.b;
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

preweighted_light preweighted_under(const preweighted_light *before, const ends *of, number X,
                                    preweighted_under_steps *step)
{
    preweighted_light r = *before;
    step->s = share(before->T);
    step->h = down(mul(step->s, X), 8);
    step->l = sub(step->s, step->h);
    step->t = add(mul(of->low.v[3], step->l), mul(of->high.v[3], step->h));
    if (sign_of(step->t) == 0)
        return r;
    for (int c = 0; c < 3; c++) {
        number lit = add(mul(of->low.v[c], step->l), mul(of->high.v[c], step->h));
        r.E.v[c] = low_bits(add(before->E.v[c], lit), 32);
    }
    r.T = fits_unsigned(sub(before->T, step->t), 32);
    return r;
}

preweighted_light preweighted_over(const preweighted_light *before, const ends *of, number X,
                                   channels *m)
{
    preweighted_light r = *before;
    for (int c = 0; c < 4; c++) {
        number low = mul(of->low.v[c], sub(whole(256), X));
        m->v[c] = down(add(low, mul(of->high.v[c], X)), 8);
    }
    if (sign_of(m->v[3]) == 0)
        return r;
    for (int c = 0; c < 3; c++) {
        number left = sub(before->E.v[c], mul(m->v[3], share(before->E.v[c])));
        r.E.v[c] = low_bits(add(left, up(m->v[c], 16)), 32);
    }
    r.T = fits_unsigned(sub(before->T, mul(m->v[3], share(before->T))), 32);
    return r;
}
