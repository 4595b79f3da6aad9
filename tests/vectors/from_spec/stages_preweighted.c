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

typedef bool preweighted_function(preweighted_light *kept, const ends *of, number X);

static void preweighted_stage(csv *c, preweighted_function *put)
{
    number X;
    preweighted_light kept = {in_triple(c, "e"), in(c, "t")};
    const ends of = in_ends(c, &X);
    out(c, whole(put(&kept, &of, X)), "skipped");
    out_triple(c, "en", &kept.E);
    out(c, kept.T, "tn");
}

void stage_preweighted_under(csv *c)
{
    preweighted_stage(c, preweighted_under);
}

void stage_preweighted_over(csv *c)
{
    preweighted_stage(c, preweighted_over);
}
