#include "sample.h"

#include "operations.h"

static bool is_clear(const entries *e)
{
    for (unsigned q = 0; q < e->count; q++)
        if (sign_of(e->A[q]) != 0)
            return false;
    return true;
}

/* A weighted weight times a colour: exact in 8 bits, cut in 16. */
static number share_of_light(const entries *e, number s, number colour)
{
    return e->bits == 8 ? mul(s, colour) : shift16(s, colour);
}

sample weighted(const entries *e, const number w[], weighted_steps *step)
{
    sample r = {whole(0), {{whole(0), whole(0), whole(0)}}, is_clear(e)};
    for (unsigned q = 0; q < e->count; q++) {
        step->s[q] = fits_unsigned(mul(w[q], e->A[q]), 32);
        r.O = fits_unsigned(add(r.O, step->s[q]), 32);
        for (int c = 0; c < 3; c++) {
            step->term[c][q] = share_of_light(e, step->s[q], e->K[c][q]);
            r.L.v[c] = fits_unsigned(add(r.L.v[c], step->term[c][q]), 32);
        }
    }
    return r;
}

static number mean(const entries *e, const number w[], const number of[])
{
    number sum = whole(0);
    for (unsigned q = 0; q < e->count; q++)
        sum = fits_unsigned(add(sum, mul(w[q], of[q])), 32);
    return sum;
}

sample separate(const entries *e, const number w[], separate_steps *step)
{
    sample r = {.O = mean(e, w, e->A), .is_skipped = is_clear(e)};
    const unsigned widened = e->bits == 8 ? 8 : 0;
    for (int c = 0; c < 3; c++) {
        step->D.v[c] = mean(e, w, e->K[c]);
        r.L.v[c] = hi(up(step->D.v[c], widened), up(r.O, widened));
    }
    return r;
}

unsigned nearest_corner(const triple *f)
{
    unsigned q = 0;
    for (unsigned a = 0; a < 3; a++)
        if (!is_less(f->v[a], whole(128)))
            q |= 1u << a;
    return q;
}

sample nearest(const entries *e, unsigned corner)
{
    sample r = {.O = fits_unsigned(up(e->A[corner], 16), 32)};
    for (int c = 0; c < 3; c++)
        r.L.v[c] = fits_unsigned(share_of_light(e, r.O, e->K[c][corner]), 32);
    r.is_skipped = sign_of(e->A[corner]) == 0;
    return r;
}

number opacity32(number O, unsigned bits)
{
    number upper = down(O, 16);
    if (bits == 16)
        return fits_unsigned(add(O, upper), 32);
    return fits_unsigned(add(add(mul(whole(257), O), down(O, 8)), upper), 32);
}
