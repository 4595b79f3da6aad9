/* Stages of section 70: associated colours. */
#include "stages.h"

#include "preweighted.h"

/* The ends of the rows of a cell, and the place between them. */
static ends in_ends(csv *c, number *X)
{
    static const char *const names[4] = {"r", "g", "b", "a"};
    corners of;
    const triple f = in_triple(c, "f");
    for (unsigned q = 0; q < 8; q++)
        for (unsigned i = 0; i < 4; i++)
            of.of[q].v[i] = in(c, "%s%u", names[i], q);
    const ends r = preweighted_ends(&of, &f);
    out_all(c, "u", r.u, 4);
    out_all(c, "low", r.low.v, 4);
    out_all(c, "high", r.high.v, 4);
    *X = f.v[0];
    return r;
}

static void out_preweighted(csv *c, const preweighted_light *l, bool is_skipped)
{
    out(c, whole(is_skipped), "skipped");
    out_triple(c, "en", &l->E);
    out(c, l->T, "tn");
}

void stage_preweighted_under(csv *c)
{
    number X;
    preweighted_under_steps step;
    const preweighted_light before = {in_triple(c, "e"), in(c, "t")};
    const ends of = in_ends(c, &X);
    const preweighted_light after = preweighted_under(&before, &of, X, &step);
    out_preweighted(c, &after, sign_of(step.t) == 0);
}

void stage_preweighted_over(csv *c)
{
    number X;
    channels m;
    const preweighted_light before = {in_triple(c, "e"), in(c, "t")};
    const ends of = in_ends(c, &X);
    const preweighted_light after = preweighted_over(&before, &of, X, &m);
    out_preweighted(c, &after, sign_of(m.v[3]) == 0);
}
