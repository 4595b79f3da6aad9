/* Stages of sections 3 to 13: from a place to a sample. */
#include "stages.h"

#include "ray.h"
#include "sample.h"

void stage_cell(csv *c)
{
    const triple size = in_triple(c, "n"), stride = in_triple(c, "stride");
    const ray r = {.place = in_triple(c, "place"), .advance = in_triple(c, "advance")};
    const triple point = sample_point(&r, in(c, "k"));
    const cell of = cell_of_point(&point, &size);
    out_triple(c, "point", &point);
    out_triple(c, "f", &of.f);
    for (unsigned q = 0; q < 8; q++) {
        const triple index = {
            {corner_index(&of, q, 0), corner_index(&of, q, 1), corner_index(&of, q, 2)}};
        out(c, address(&index, &stride), "address%u", q);
    }
}

void stage_weights(csv *c)
{
    const triple f = in_triple(c, "f");
    const weights w = weights_of(&f);
    out(c, w.xy, "xy");
    out(c, w.xz, "xz");
    out(c, w.yz, "yz");
    out(c, w.xyz, "xyz");
    out_all(c, "w", w.w, 8);
}

static const char *const colours[3] = {"r", "g", "b"};

/* The eight entries and the weights of a sample. */
static weights in_corners(csv *c, entries *e, unsigned bits)
{
    const triple f = in_triple(c, "f");
    const weights w = weights_of(&f);
    e->bits = bits;
    e->count = 8;
    for (int channel = 0; channel < 3; channel++)
        in_all(c, colours[channel], e->K[channel], 8);
    in_all(c, "a", e->A, 8);
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
