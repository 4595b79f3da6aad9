/* Sections 41 to 44: what a piece of a ray weighs. */
#include "lengths.h"
#include "depth.h"
#include "operations.h"
#include "tables.h"

/* Extinctions e of the opacities, and the greatest of them. */
static number extinctions(const entries *of, number e[])
{
    number greatest = whole(0);
    for (unsigned q = 0; q < of->count; q++) {
        number x = of->bits == 8 ? ext8(of->A[q]) : ext16(of->A[q]);
        e[q] = fits_unsigned(sub(x, down(x, 30)), 30);
        greatest = most(greatest, e[q]);
    }
    return greatest;
}

sample converted(const entries *of, const number w[], converted_steps *step)
{
    sample r = {whole(0), {{whole(0), whole(0), whole(0)}}, false};
    number greatest = extinctions(of, step->e);
    r.is_skipped = sign_of(greatest) == 0;
    const unsigned s = r.is_skipped ? 0 : least_shift(greatest, 1, power2(29));
    number widening = whole(of->bits == 8 ? 257 : 1);
    step->s = whole(s);
    for (unsigned q = 0; q < of->count; q++) {
        step->h[q] = hi(up(w[q], 15), up(step->e[q], s + 2));
        r.O = fits_unsigned(add(r.O, step->h[q]), 32);
        for (int c = 0; c < 3; c++) {
            number term = shift16(step->h[q], mul(widening, of->K[c][q]));
            r.L.v[c] = fits_unsigned(add(r.L.v[c], term), 32);
        }
    }
    return r;
}

/* An opacity x, u32.31, as u32.32 of which 2^32 - 1 is 1. */
static number widened(number x)
{
    return fits_unsigned(sub(up(x, 1), down(x, 31)), 32);
}

/* F, u32.(32-b). */
static number light_factor(const corrected_steps *step, const medium *of)
{
    if (!is_less(step->d, up(whole(23), 32)))
        return down(step->x, (unsigned)small(of->b) - 1);
    number share = hi(up(recip(phi(step->d)), 1), phi(step->d2));
    return fits_unsigned(down(mul(share, of->light), 27), 32);
}

number corrected(triple *lit, const triple *L, number a32, const medium *of, corrected_steps *step)
{
    const unsigned b = (unsigned)small(of->b);
    step->d = depth_of(sub(sub(power2(32), whole(1)), a32));
    step->d2 = fits_unsigned(down(mul(step->d, of->depth), 32), 64);
    step->x = sub(power2(31), transmittance(step->d2));
    step->F = light_factor(step, of);
    const bool is_whole_step = is_equal(of->depth, power2(32));
    for (int c = 0; c < 3; c++)
        lit->v[c] = is_whole_step ? L->v[c] : down(mul(L->v[c], step->F), 32 - b);
    return is_whole_step ? a32 : widened(step->x);
}

extinction_ray extinction_at_start(void)
{
    const triple none = {{whole(0), whole(0), whole(0)}};
    return (extinction_ray){whole(0), power2(31), none, none};
}

/* The depth d of the piece, and factor(t). */
static number factor_of(number t, const sample *of, number s, const medium *m,
                        extinction_steps *step)
{
    step->d = fits_unsigned(down(mul(of->O, m->depth), 32 + (unsigned)small(s)), 64);
    step->phi = phi(step->d);
    number seen = up(down(mul(t, step->phi), 32), 1);
    return fits_unsigned(down(mul(seen, m->light), 32), 32);
}

extinction_ray extinction_under(const extinction_ray *before, const sample *of, number s,
                                const medium *m, extinction_steps *step)
{
    extinction_ray r = *before;
    step->factor = factor_of(before->T, of, s, m, step);
    for (int c = 0; c < 3; c++) {
        number lit = down(mul(of->L.v[c], step->factor), (unsigned)small(s));
        r.G.v[c] = fits_unsigned(add(before->G.v[c], lit), 64);
    }
    r.X = fits_unsigned(add(before->X, step->d), 64);
    r.T = transmittance(r.X);
    return r;
}

extinction_ray extinction_over(const extinction_ray *before, const sample *of, number s,
                               const medium *m, extinction_steps *step)
{
    extinction_ray r = *before;
    const unsigned scaled = (unsigned)small(s) + 32 - (unsigned)small(m->b);
    step->factor = factor_of(power2(31), of, s, m, step);
    step->x = sub(power2(31), transmittance(step->d));
    step->a32 = widened(step->x);
    for (int c = 0; c < 3; c++) {
        number left = sub(before->E.v[c], hi(before->E.v[c], step->a32));
        number lit = down(mul(of->L.v[c], step->factor), scaled);
        r.E.v[c] = fits_unsigned(add(left, lit), 32);
    }
    if (is_less(before->X, power2(38)))
        r.X = add(before->X, step->d);
    r.T = transmittance(r.X);
    return r;
}

number extinction_light(number G, number b)
{
    return fits_unsigned(down(G, 32 - (unsigned)small(b)), 32);
}

static number blend(number fine, number coarse, number share)
{
    number rest = mul(fine, sub(power2(32), share));
    return fits_unsigned(rounded(add(rest, mul(coarse, share)), 32), 32);
}

level_sample level_blend(const level_sample *fine, const level_sample *coarse, number share)
{
    level_sample r = {.s = least(fine->s, coarse->s)};
    const unsigned x = (unsigned)small(sub(fine->s, r.s));
    const unsigned y = (unsigned)small(sub(coarse->s, r.s));
    r.O = blend(down(fine->O, x), down(coarse->O, y), share);
    for (int c = 0; c < 3; c++)
        r.L.v[c] = blend(down(fine->L.v[c], x), down(coarse->L.v[c], y), share);
    return r;
}
