#include "classify.h"

#include "operations.h"

number table_entry(number b, number d, number t, number n)
{
    number mixed = add(mul(b, sub(n, t)), mul(d, t));
    return floor_div(add(up(mixed, 1), n), up(n, 1));
}

number index_of_scalar(number s, number low, number high)
{
    if (!is_less(low, s))
        return whole(0);
    if (!is_less(s, high))
        return whole(255);
    number window = sub(high, low);
    return floor_div(add(mul(whole(510), sub(s, low)), window), up(window, 1));
}

triple gradient_scales(const triple *S)
{
    triple g;
    for (int a = 0; a < 3; a++)
        g.v[a] = fits_unsigned(mul(S->v[(a + 1) % 3], S->v[(a + 2) % 3]), 49);
    return g;
}

bool is_long_enough(const triple *d, const triple *S, number at_least, number window)
{
    const triple g = gradient_scales(S);
    number length = whole(0);
    number bound = mul(at_least, window);
    for (int a = 0; a < 3; a++) {
        number part = mul(d->v[a], g.v[a]);
        length = add(length, mul(part, part));
        bound = mul(bound, S->v[a]);
    }
    return !is_less(up(length, 46), mul(bound, bound));
}

/* floor(e * 2^h), h of either sign. */
static number shifted(number e, int h)
{
    return h < 0 ? down(e, (unsigned)-h) : up(e, (unsigned)h);
}

triple unit(const triple *v, const triple *g)
{
    triple e, m, r;
    number greatest = whole(0);
    for (int a = 0; a < 3; a++) {
        e.v[a] = fits_unsigned(mul(magnitude(v->v[a]), g->v[a]), 64);
        greatest = most(greatest, e.v[a]);
    }
    const int h = 30 - (int)bits_of(greatest);
    number N = whole(0);
    for (int a = 0; a < 3; a++) {
        m.v[a] = shifted(e.v[a], h);
        N = fits_unsigned(add(N, mul(m.v[a], m.v[a])), 64);
    }
    const root inverse = rsqrt(N);
    for (int a = 0; a < 3; a++) {
        number size = least(power2(30), rounded(mul(m.v[a], inverse.r), inverse.x));
        r.v[a] = with_sign(size, v->v[a]);
    }
    return r;
}

static number halved(number v)
{
    return with_sign(down(magnitude(v), 1), v);
}

void light_directions(lighting *l, const triple *to_light, const triple *to_viewer)
{
    const triple one = {{whole(1), whole(1), whole(1)}};
    l->light = unit(to_light, &one);
    l->has_highlight = sign_of(l->specular) != 0;
    l->half = (triple){{whole(0), whole(0), whole(0)}};
    if (!l->has_highlight)
        return;
    const triple viewer = unit(to_viewer, &one);
    triple mean;
    number length = whole(0);
    for (int a = 0; a < 3; a++) {
        mean.v[a] = add(halved(l->light.v[a]), halved(viewer.v[a]));
        length = add(length, mul(mean.v[a], mean.v[a]));
    }
    l->has_highlight = !is_less(length, power2(42));
    if (l->has_highlight)
        l->half = unit(&mean, &one);
}

static number dot(const triple *p, const triple *q)
{
    number sum = whole(0);
    for (int a = 0; a < 3; a++)
        sum = add(sum, q30(p->v[a], q->v[a]));
    return clamp(sum, whole(0), power2(30));
}

static number share(number k, number v)
{
    return rounded(mul(k, v), 8);
}

shade_steps shade_factors(const lighting *l, const triple *normal)
{
    shade_steps s = {.lambert = dot(normal, &l->light)};
    s.factor = add(share(l->ambient, power2(30)), share(l->diffuse, s.lambert));
    s.gleam = whole(0);
    s.highlight = whole(0);
    if (l->has_highlight) {
        s.gleam = dot(normal, &l->half);
        for (long i = small(l->gloss); i > 0; i--)
            s.gleam = rounded(mul(s.gleam, s.gleam), 30);
        s.highlight = share(l->specular, s.gleam);
    }
    return s;
}

number shade(const shade_steps *s, number colour)
{
    number lit = add(mul(colour, s->factor), mul(whole(65535), s->highlight));
    return least(whole(65535), rounded(fits_unsigned(lit, 48), 30));
}

number reduced_mean(unsigned count, const number scalar[], number least_of_type)
{
    number N = whole(count), Q = whole(0);
    for (unsigned i = 0; i < count; i++)
        Q = add(Q, sub(scalar[i], least_of_type));
    return add(least_of_type, floor_div(add(up(Q, 1), N), up(N, 1)));
}
