#include "ray.h"

#include "operations.h"

static triple no_numbers(void)
{
    return (triple){{whole(0), whole(0), whole(0)}};
}

/* along + x across + y down, or the same from origin. */
static triple plane_point(const triple *from, const camera *c, number x, number y)
{
    triple p;
    for (int a = 0; a < 3; a++) {
        number moved = add(mul(x, c->across.v[a]), mul(y, c->down.v[a]));
        p.v[a] = fits_signed(add(from->v[a], moved), 64);
    }
    return p;
}

static triple phased(const triple *from, const triple *advance, number phase)
{
    triple p;
    for (int a = 0; a < 3; a++)
        p.v[a] = fits_signed(add(from->v[a], rounded(mul(advance->v[a], phase), 16)), 64);
    return p;
}

static number greatest_magnitude(const triple *v)
{
    return most(magnitude(v->v[0]), most(magnitude(v->v[1]), magnitude(v->v[2])));
}

/* Section 8: the direction v, normalised. */
static triple unit_vector(const triple *v, ray_steps *step)
{
    const unsigned bits = bits_of(greatest_magnitude(v));
    const unsigned h = bits > 31 ? bits - 31 : 0;
    step->h = whole(h);
    step->N = whole(0);
    for (int a = 0; a < 3; a++) {
        step->m.v[a] = down(magnitude(v->v[a]), h);
        step->N = fits_unsigned(add(step->N, mul(step->m.v[a], step->m.v[a])), 64);
    }
    const root inverse = rsqrt(step->N);
    step->r = inverse.r;
    step->e = whole(inverse.x);
    for (int a = 0; a < 3; a++) {
        number size = rounded(mul(step->m.v[a], inverse.r), inverse.x);
        step->unit.v[a] = with_sign(least(power2(30), size), v->v[a]);
    }
    return step->unit;
}

static ray perspective_ray(const camera *c, number x, number y, number phase, ray_steps *step)
{
    ray r = {no_numbers(), no_numbers(), whole(0), false};
    step->v = plane_point(&c->along, c, x, y);
    const triple unit = unit_vector(&step->v, step);
    if (is_less(greatest_magnitude(&step->v), power2(16)))
        return r;
    for (int a = 0; a < 3; a++)
        r.advance.v[a] = q30(c->pace.v[a], unit.v[a]);
    r.place = phased(&c->origin, &r.advance, phase);
    r.is_there = true;
    return r;
}

ray ray_of_pixel(const camera *c, number x, number y, number phase, ray_steps *step)
{
    *step = (ray_steps){0};
    if (c->is_perspective)
        return perspective_ray(c, x, y, phase, step);
    const triple start = plane_point(&c->origin, c, x, y);
    return (ray){phased(&start, &c->along, phase), c->along, negative(power2(22)), true};
}

/* Section 9, one axis. */
static span clip_axis(span k, number place, number advance, number extent)
{
    if (sign_of(advance) == 0) {
        const bool is_inside = sign_of(place) >= 0 && is_less(place, extent);
        return is_inside ? k : (span){k.first, sub(k.first, whole(1))};
    }
    number d = magnitude(advance);
    number l = floor_div(place, d);
    number h = floor_div(sub(place, extent), d);
    if (sign_of(advance) > 0)
        return (span){most(k.first, negative(l)), least(k.last, sub(whole(-1), h))};
    return (span){most(k.first, add(h, whole(1))), least(k.last, l)};
}

span clip(const ray *r, const triple *size)
{
    span k = {r->first_sample, sub(power2(22), whole(1))};
    if (!r->is_there)
        k.last = sub(k.first, whole(1));
    for (int a = 0; a < 3; a++)
        k = clip_axis(k, r->place.v[a], r->advance.v[a], up(size->v[a], 32));
    return k;
}

triple sample_point(const ray *r, number k)
{
    triple p;
    for (int a = 0; a < 3; a++) {
        number place = add(r->place.v[a], mul(k, r->advance.v[a]));
        p.v[a] = fits_signed(add(sub(place, power2(31)), power2(23)), 64);
    }
    return p;
}

cell cell_of_point(const triple *point, const triple *size)
{
    cell c;
    for (int a = 0; a < 3; a++) {
        number last = sub(size->v[a], whole(1));
        c.i.v[a] = down(point->v[a], 32);
        c.f.v[a] = low_bits(down(point->v[a], 24), 8);
        c.i0.v[a] = clamp(c.i.v[a], whole(0), last);
        c.i1.v[a] = clamp(add(c.i.v[a], whole(1)), whole(0), last);
    }
    return c;
}

number corner_index(const cell *c, unsigned q, unsigned axis)
{
    return (q >> axis & 1) != 0 ? c->i1.v[axis] : c->i0.v[axis];
}

number address(const triple *index, const triple *stride)
{
    number sum = whole(0);
    for (int a = 0; a < 3; a++)
        sum = add(sum, mul(index->v[a], stride->v[a]));
    return sum;
}

weights weights_of(const triple *f)
{
    number X = f->v[0], Y = f->v[1], Z = f->v[2];
    number x = up(X, 8), y = up(Y, 8), z = up(Z, 8);
    weights s = {.xy = mul(X, Y), .xz = mul(X, Z), .yz = mul(Y, Z)};
    number xyz = rounded(mul(s.xy, Z), 8);
    s.xyz = xyz;
    s.w[7] = xyz;
    s.w[6] = sub(s.yz, xyz);
    s.w[5] = sub(s.xz, xyz);
    s.w[3] = sub(s.xy, xyz);
    s.w[1] = sub(sub(add(x, xyz), s.xy), s.xz);
    s.w[2] = sub(sub(add(y, xyz), s.xy), s.yz);
    s.w[4] = sub(sub(add(z, xyz), s.xz), s.yz);
    number added = add(add(whole(65536), s.xy), add(s.xz, s.yz));
    s.w[0] = sub(added, add(add(x, y), add(z, xyz)));
    for (int q = 0; q < 8; q++)
        fits_unsigned(s.w[q], 17);
    return s;
}
