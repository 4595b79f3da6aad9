/* Stages of sections 19 to 24: from scalars to colours. */
#include "stages.h"

#include "classify.h"
#include "operations.h"

void stage_transfer(csv *c)
{
    number first = in(c, "first"), last = in(c, "last"), entry = in(c, "entry");
    number from = in(c, "from"), to = in(c, "to");
    number place = clamp(entry, first, last);
    number value = table_entry(from, to, sub(place, first), sub(last, first));
    out(c, value, "value16");
    out(c, to8(value), "value8");
}

void stage_index(csv *c)
{
    out(c, index_of_scalar(in(c, "s"), in(c, "low"), in(c, "high")), "index");
}

/* The normal of a voxel; false, and 0, where it keeps its colour. */
static bool in_normal(csv *c, triple *normal)
{
    const triple d = in_triple(c, "d"), spacing = in_triple(c, "spacing");
    const triple g = gradient_scales(&spacing);
    number at_least = in(c, "least"), window = in(c, "window");
    bool is_long = is_long_enough(&d, &spacing, at_least, window);
    triple back;
    bool is_zero = true;
    for (int a = 0; a < 3; a++) {
        is_zero = is_zero && sign_of(d.v[a]) == 0;
        back.v[a] = negative(d.v[a]);
        normal->v[a] = whole(0);
    }
    is_long = is_long && !is_zero;
    if (is_long)
        *normal = unit(&back, &g);
    return is_long;
}

void stage_gradient(csv *c)
{
    triple normal;
    const bool is_long = in_normal(c, &normal);
    const triple spacing = in_triple(c, "spacing"), g = gradient_scales(&spacing);
    out_triple(c, "g", &g);
    out(c, whole(is_long), "long_enough");
    out_triple(c, "normal", &normal);
}

void stage_shade(csv *c)
{
    triple normal;
    const bool is_long = in_normal(c, &normal);
    const triple light = in_triple(c, "light"), viewer = in_triple(c, "viewer");
    lighting l = {.ambient = in(c, "ambient"),
                  .diffuse = in(c, "diffuse"),
                  .specular = in(c, "specular"),
                  .gloss = in(c, "gloss")};
    light_directions(&l, &light, &viewer);
    out_triple(c, "to_light", &l.light);
    out_triple(c, "half", &l.half);
    const shade_steps step = shade_factors(&l, &normal);
    for (unsigned i = 0; i < 3; i++) {
        number colour = in(c, "colour%u", i);
        out(c, is_long ? shade(&step, colour) : colour, "shaded%u", i);
    }
}

void stage_reduce(csv *c)
{
    const triple n = in_triple(c, "n");
    number s[8];
    in_all(c, "s", s, 8);
    const unsigned count = (unsigned)small(mul(n.v[0], mul(n.v[1], n.v[2])));
    out(c, reduced_mean(count, s, whole(-32768)), "value");
}
