#include "slices.h"

#include "dither.h"

number rounded_opacity(number o)
{
    return rounded(o, 16);
}

/* w(s), levels. */
static number sloped(number o, number slope)
{
    return least(up(whole(255), 16), rounded(mul(o, slope), 16));
}

/* The opacity of a slice whose mean shall be w, by steps of bump. */
static number opacity_in_turn(const technique *t, number o, number w, number bump,
                              const turn_of_slice *at)
{
    number base = down(w, 16);
    if (is_less(up(t->cutoff, 16), o))
        return rounded_opacity(o);
    if (sign_of(bump) == 0)
        return base;
    number hits = hits_of(t->period, w, base, bump);
    const bool is_hit = at->is_random ? hits_randomly(t->period, hits, at->u)
                                      : hits_ordered(t->period, hits, at->phase);
    return is_hit ? add(base, bump) : base;
}

number simple_opacity(const technique *t, number o, const turn_of_slice *at)
{
    return opacity_in_turn(t, o, sloped(o, t->slope[0]), whole(1), at);
}

number bumped_opacity(const technique *t, number o, number v, const turn_of_slice *at)
{
    number stop = plateau(most(whole(1), down(o, 16)), whole(255));
    number w = sloped(o, t->slope[is_less(v, stop) ? 0 : 1]);
    return opacity_in_turn(t, o, w, bump_of(v, down(w, 16)), at);
}

number corrected_opacity(number o, number c, number v, number u)
{
    number A = light_opacity(opacity32_of_level(o));
    number S = blend_dithered(v, mul(c, A), A, u, 0);
    number wanted = rounded_opacity(o), nearest = NULL, distance = NULL;
    for (int a = 0; a <= 255; a++) {
        number off = magnitude(sub(whole(a), wanted));
        if (is_equal(blend_plain(v, c, whole(a), 8), S) &&
            (nearest == NULL || is_less(off, distance))) {
            nearest = whole(a);
            distance = off;
        }
    }
    if (nearest == NULL)
        fail("no opacity makes the state of the dithered blend");
    return nearest;
}

number slice_dither(enum sequence of, number n, number frame, number shift, bool has_technique)
{
    if (of == SEQUENCE_ROUNDED)
        return has_technique ? low_bits(add(power2(31), shift), 32) : power2(31);
    number place = low_bits(add(n, up(frame, 10)), 32);
    number u = of == SEQUENCE_GOLDEN   ? golden(place)
               : of == SEQUENCE_HASHED ? hashed(place)
                                       : blocks(place);
    return low_bits(add(add(u, golden(frame)), shift), 32);
}

number slice_phase(number n, number frame, number shift, number period)
{
    number moved = down(mul(down(shift, 16), period), 16);
    number sum = low_bits(add(add(n, frame), moved), 32);
    return sub(sum, mul(period, floor_div(sum, period)));
}
