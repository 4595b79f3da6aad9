/* Stages of sections 42 to 44: light by length. */
#include "stages.h"

#include "lengths.h"
#include "sample.h"

static medium in_piece(csv *c)
{
    return (medium){.depth = in(c, "depth"), .light = in(c, "light"), .b = in(c, "b")};
}

void stage_corrected(csv *c)
{
    corrected_steps step;
    triple lit;
    const triple L = in_triple(c, "l");
    const medium m = in_piece(c);
    number a32 = opacity32(in(c, "o"), sign_of(in(c, "wide")) != 0 ? 16 : 8);
    number result = corrected(&lit, &L, a32, &m, &step);
    out(c, a32, "a32");
    out(c, step.d, "stored");
    out(c, step.d2, "new_depth");
    out(c, step.x, "x");
    out(c, step.F, "factor");
    out_triple(c, "la", &lit);
    out(c, result, "a32a");
}

static sample in_sample(csv *c)
{
    return (sample){.O = in(c, "o"), .L = in_triple(c, "l")};
}

void stage_extinction_under(csv *c)
{
    extinction_steps step;
    const sample s = in_sample(c);
    const medium m = in_piece(c);
    const extinction_ray before = {.X = in(c, "x"), .T = in(c, "t"), .G = in_triple(c, "g")};
    const extinction_ray after = extinction_under(&before, &s, in(c, "s"), &m, &step);
    out(c, step.d, "d");
    out(c, step.phi, "phi");
    out(c, step.factor, "factor");
    out(c, after.X, "xn");
    out(c, after.T, "tn");
    out_triple(c, "gn", &after.G);
    for (unsigned i = 0; i < 3; i++)
        out(c, extinction_light(after.G.v[i], m.b), "en%u", i);
}

void stage_extinction_over(csv *c)
{
    extinction_steps step;
    const sample s = in_sample(c);
    const medium m = in_piece(c);
    const extinction_ray before = {.X = in(c, "x"), .E = in_triple(c, "e")};
    const extinction_ray after = extinction_over(&before, &s, in(c, "s"), &m, &step);
    out(c, step.d, "d");
    out(c, step.x, "opacity");
    out(c, step.a32, "a32");
    out(c, step.factor, "factor");
    out(c, after.X, "xn");
    out(c, after.T, "tn");
    out_triple(c, "en", &after.E);
}

void stage_level_blend(csv *c)
{
    const level_sample fine = {in(c, "o"), in(c, "s"), in_triple(c, "l")};
    const level_sample coarse = {in(c, "oc"), in(c, "sc"), in_triple(c, "lc")};
    const level_sample both = level_blend(&fine, &coarse, in(c, "share"));
    out(c, both.s, "sb");
    out(c, both.O, "ob");
    out_triple(c, "lb", &both.L);
}
