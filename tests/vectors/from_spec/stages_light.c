/* Stages of sections 13 to 17: from samples to pixels. */
#include "stages.h"

#include "composite.h"
#include "operations.h"
#include "pixels.h"
#include "sample.h"

typedef struct lit {
    triple L;
    light before;
    number a32;
} lit;

static lit in_lit(csv *c)
{
    const bool is_wide = sign_of(in(c, "wide")) != 0;
    lit s = {in_triple(c, "l"), {in_triple(c, "e"), in(c, "t")}, NULL};
    s.a32 = opacity32(in(c, "o"), is_wide ? 16 : 8);
    out(c, s.a32, "a32");
    out(c, hi(s.before.T, s.a32), "lost");
    return s;
}

static void out_light(csv *c, const light *l)
{
    out_triple(c, "en", &l->E);
    out(c, l->T, "tn");
}

void stage_under(csv *c)
{
    const lit s = in_lit(c);
    const light after = under(&s.before, &s.L, s.a32);
    for (unsigned channel = 0; channel < 3; channel++)
        out(c, hi(s.L.v[channel], s.before.T), "part%u", channel);
    out_light(c, &after);
    out(c, whole(is_end(after.T, in(c, "threshold"))), "ended");
}

void stage_over(csv *c)
{
    const lit s = in_lit(c);
    const light after = over(&s.before, &s.L, s.a32);
    for (unsigned channel = 0; channel < 3; channel++) {
        out(c, hi(s.before.E.v[channel], s.a32), "part%u", channel);
        out(c, rounded(s.L.v[channel], 1), "half%u", channel);
    }
    out_light(c, &after);
}

void stage_readout(csv *c)
{
    static const int64_t factors[4] = {33686018, 33424380, 66847740, 33554432};
    const int64_t factor = factors[small(in(c, "kind")) % 4];
    const light l = {in_triple(c, "e"), in(c, "t")};
    channels B;
    in_all(c, "background", B.v, 4);
    for (unsigned i = 0; i < 4; i++)
        out(c, mul(i == 3 ? whole(255) : B.v[i], B.v[3]), "p%u", i);
    const channels G = background_levels(&B);
    const channels result = read_out(&l, &G, whole(factor));
    out_all(c, "g", G.v, 4);
    out_all(c, "channel", result.v, 4);
}

/* Bytes as a number, the first one highest. */
static number bytes(const channels *levels, const int order[], unsigned count)
{
    number all = whole(0);
    for (unsigned i = 0; i < count; i++)
        all = add(up(all, 8), levels->v[order[i]]);
    return all;
}

void stage_pixel(csv *c)
{
    static const int rgba[4] = {0, 1, 2, 3}, bgra[4] = {2, 1, 0, 3};
    channels of, level;
    in_all(c, "channel", of.v, 4);
    for (unsigned i = 0; i < 4; i++)
        level.v[i] = level8(of.v[i]);
    number t = threshold_at(in(c, "x"), in(c, "y"));
    number grey = grey_of(&of), high_first = rgb565(&of, t);
    out(c, t, "threshold");
    out(c, grey, "grey");
    out(c, bytes(&level, rgba, 4), "rgba8888");
    out(c, bytes(&level, bgra, 4), "bgra8888");
    out(c, bytes(&level, rgba, 3), "rgb888");
    out(c, add(up(low_bits(high_first, 8), 8), down(high_first, 8)), "rgb565_le");
    out(c, high_first, "rgb565_be");
    out(c, level8(grey), "l8");
    out(c, dither(grey, whole(15), t), "grey4");
    out(c, dither(grey, whole(1), t), "mono");
}
