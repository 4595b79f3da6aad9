/* Stages of sections 12, 13, 40 and 41: samples. */
#include "stages.h"

#include "lengths.h"
#include "ray.h"
#include "sample.h"

static const char *const colours[3] = {"r", "g", "b"};

static void in_entries(csv *c, entries *e)
{
    for (int channel = 0; channel < 3; channel++)
        in_all(c, colours[channel], e->K[channel], e->count);
    in_all(c, "a", e->A, e->count);
}

/* The eight entries and the weights of a sample. */
static weights in_corners(csv *c, entries *e, unsigned bits)
{
    const triple f = in_triple(c, "f");
    const weights w = weights_of(&f);
    e->bits = bits;
    e->count = 8;
    in_entries(c, e);
    out_all(c, "w", w.w, 8);
    return w;
}

/* A skipped sample counts as nothing. */
static void out_sample(csv *c, const sample *s, unsigned bits)
{
    const triple none = {{whole(0), whole(0), whole(0)}};
    out(c, whole(s->is_skipped), "skipped");
    out(c, s->is_skipped ? whole(0) : s->O, "o");
    out_triple(c, "l", s->is_skipped ? &none : &s->L);
    out(c, s->is_skipped ? whole(0) : opacity32(s->O, bits), "a32");
}

static void weighted_stage(csv *c, unsigned bits)
{
    static const char *const terms[3] = {"tr", "tg", "tb"};
    entries e;
    weighted_steps step;
    const weights w = in_corners(c, &e, bits);
    const sample s = weighted(&e, w.w, &step);
    out_all(c, "s", step.s, 8);
    for (int channel = 0; channel < 3; channel++)
        out_all(c, terms[channel], step.term[channel], 8);
    out_sample(c, &s, bits);
}

void stage_sample8(csv *c)
{
    weighted_stage(c, 8);
}

void stage_sample16(csv *c)
{
    weighted_stage(c, 16);
}

static void separate_stage(csv *c, unsigned bits)
{
    entries e;
    separate_steps step;
    const weights w = in_corners(c, &e, bits);
    const sample s = separate(&e, w.w, &step);
    out_triple(c, "d", &step.D);
    out_sample(c, &s, bits);
}

void stage_separate8(csv *c)
{
    separate_stage(c, 8);
}

void stage_separate16(csv *c)
{
    separate_stage(c, 16);
}

void stage_nearest(csv *c)
{
    entries e = {.bits = sign_of(in(c, "wide")) != 0 ? 16 : 8, .count = 8};
    const triple f = in_triple(c, "f"), none = {{whole(0), whole(0), whole(0)}};
    const unsigned q = nearest_corner(&f);
    in_entries(c, &e);
    const sample s = nearest(&e, q);
    out(c, whole(q), "corner");
    out(c, whole(s.is_skipped), "skipped");
    out(c, s.is_skipped ? whole(0) : s.O, "o");
    out_triple(c, "l", s.is_skipped ? &none : &s.L);
}

void stage_bspline(csv *c)
{
    number w[27];
    spline_parts part;
    const triple f = in_triple(c, "f");
    spline_weights(w, &f, &part);
    out_triple(c, "z", &part.z);
    for (unsigned v2 = 0; v2 < 3; v2++)
        for (unsigned v1 = 0; v1 < 3; v1++)
            out(c, part.y[v2].v[v1], "y%u", v1 + 3 * v2);
    out_all(c, "w", w, 27);
}

/* A sample that has s besides; where it is skipped all is 0. */
static void out_level_sample(csv *c, const sample *s, number shift)
{
    const triple none = {{whole(0), whole(0), whole(0)}};
    out(c, whole(s->is_skipped), "skipped");
    out(c, s->is_skipped ? whole(0) : shift, "s");
    out(c, s->is_skipped ? whole(0) : s->O, "o");
    out_triple(c, "l", s->is_skipped ? &none : &s->L);
}

void stage_bspline_sample(csv *c)
{
    number w[27];
    spline_parts unused;
    weighted_steps of_weighted;
    converted_steps of_converted = {.s = whole(0)};
    const long kind = small(in(c, "kind"));
    entries e = {.bits = kind % 2 == 0 ? 8 : 16, .count = 27};
    const triple f = in_triple(c, "f");
    in_entries(c, &e);
    spline_weights(w, &f, &unused);
    const sample s = kind < 2 ? weighted(&e, w, &of_weighted) : converted(&e, w, &of_converted);
    out_level_sample(c, &s, of_converted.s);
}

static void converted_stage(csv *c, unsigned bits)
{
    entries e;
    converted_steps step;
    const weights w = in_corners(c, &e, bits);
    const sample s = converted(&e, w.w, &step);
    out_all(c, "e", step.e, 8);
    out_all(c, "h", step.h, 8);
    out_level_sample(c, &s, step.s);
}

void stage_converted8(csv *c)
{
    converted_stage(c, 8);
}

void stage_converted16(csv *c)
{
    converted_stage(c, 16);
}
