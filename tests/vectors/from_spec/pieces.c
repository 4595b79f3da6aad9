/* Sections 37 to 39: the way of a ray through the box, its pieces, and the medium. */
#include "lengths.h"
#include "operations.h"

static number cut(number n, number d)
{
    number size = magnitude(n), pace = magnitude(d);
    number w = floor_div(size, pace);
    number r = sub(size, mul(w, pace));
    const unsigned bits = bits_of(pace);
    const unsigned h = bits > 32 ? bits - 32 : 0;
    number quotient = floor_div(up(down(r, h), 24), down(pace, h));
    number v = least(sub(power2(24), whole(1)), quotient);
    number t = add(up(w, 24), up(down(v, 1), 1));
    return with_sign(with_sign(t, n), d);
}

/* No way where a ray stands still outside of the box. */
static way way_on_axis(way w, number place, number advance, number extent)
{
    if (sign_of(advance) == 0) {
        if (sign_of(place) < 0 || !is_less(place, extent))
            w.is_there = false;
        return w;
    }
    number low = cut(negative(place), advance);
    number high = cut(sub(extent, place), advance);
    w.enter = most(w.enter, least(low, high));
    w.leave = least(w.leave, most(low, high));
    return w;
}

way way_through(const ray *r, const triple *size, number first)
{
    way w = {first, power2(46), r->is_there};
    for (int a = 0; a < 3 && r->is_there; a++)
        w = way_on_axis(w, r->place.v[a], r->advance.v[a], up(size->v[a], 32));
    w.is_there = w.is_there && is_less(w.enter, w.leave);
    return w;
}

piece piece_from(const ray *r, number begin, number leave, unsigned level)
{
    const unsigned bits = 24 + level;
    number half = power2(23);
    piece p;
    number next = sub(up(add(down(add(begin, half), bits), whole(1)), bits), half);
    p.end = least(next, leave);
    number length = sub(p.end, begin);
    p.l = fits_unsigned(rounded(length, 8), 29);
    p.t = add(begin, down(length, 1));
    for (int a = 0; a < 3; a++) {
        number place = add(r->place.v[a], rounded(mul(p.t, r->advance.v[a]), 24));
        number on_level = sub(down(place, level), power2(31));
        p.P.v[a] = fits_signed(add(on_level, power2(23)), 64);
    }
    return p;
}

/* The step by the unit distance, u45.32. */
static number step_by_unit(number U, number step)
{
    if (is_equal(U, step))
        return power2(32);
    const unsigned h = is_less(U, power2(31)) ? 0 : 1;
    number wide = add(up(step, 32), down(U, 1));
    return floor_div(down(wide, h), down(U, h));
}

/* What 2^32 units of O are worth for a step, of stored extinction times the step. */
static number depth_of_extinction(number g, bool is_wide)
{
    if (is_wide)
        return add(g, down(g, 16));
    return add(mul(whole(257), g), add(add(down(g, 8), down(g, 16)), down(g, 24)));
}

medium medium_of(enum medium_kind kind, number U, number E, number step, number levels)
{
    medium m;
    number k = step_by_unit(U, step), wide = k;
    if (kind == MEDIUM_CORRECTED) {
        m.depth = k;
    } else {
        number g = kind == MEDIUM_OPACITY ? up(k, 6) : mul(E, step);
        m.depth = kind == MEDIUM_OPACITY ? add(up(k, 7), down(k, 20))
                                         : depth_of_extinction(g, kind == MEDIUM_EXTINCTION16);
        wide = down(mul(g, whole(0xB17217F8)), 32);
    }
    const unsigned bits = bits_of(wide) + (unsigned)small(levels);
    const unsigned b = bits > 33 ? bits - 32 : 1;
    m.b = whole(b);
    m.light = fits_unsigned(down(wide, b), 32);
    return m;
}

number of_length(number of_step, number l)
{
    return down(mul(of_step, l), 16);
}
