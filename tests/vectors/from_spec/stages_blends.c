/* Stages of sections 48 to 50 and 52: what becomes of a state. */
#include "stages.h"

#include "dither.h"
#include "operations.h"

void stage_light(csv *c)
{
    static const int64_t factors[4] = {2155905153, 2139160321, 4278255361, 2147483649};
    number factor = whole(factors[small(in(c, "factor")) % 4]);
    number o32 = in(c, "o32"), colour = in(c, "colour");
    number A = light_opacity(o32);
    number O = hi(o32, mul(whole(255), power2(23)));
    out(c, A, "a");
    out(c, mul(colour, A), "light");
    out(c, hi(o32, up(colour, 23)), "light32");
    out(c, O, "opacity");
    out(c, least(up(hi(in(c, "e"), factor), 1), O), "shown");
    out(c, opacity32_of_level(in(c, "level")), "of_level");
}

void stage_blend_plain(csv *c)
{
    const unsigned n = (unsigned)small(in(c, "bits"));
    number S = in(c, "state"), colour = in(c, "colour"), a = in(c, "opacity");
    number weighted = div_ones(mul(colour, a), n);
    out(c, blend_plain(S, colour, a, n), "plain");
    out(c, weighted, "weighted");
    out(c, blend_associated(S, weighted, a, n), "associated");
}

void stage_blend_dithered(csv *c)
{
    number C = in(c, "light");
    const unsigned f = (unsigned)small(in(c, "fraction"));
    out(c, hi(C, whole(522133279)), "light5");
    out(c, hi(C, whole(1061109568)), "light6");
    out(c, blend_dithered(in(c, "state"), C, in(c, "a"), in(c, "u"), f), "result");
}

void stage_blend24(csv *c)
{
    number S = in(c, "state"), o32 = in(c, "o32");
    out(c, sub(up(S, 8), hi(up(S, 8), o32)), "kept");
    out(c, blend_24(S, in(c, "light"), o32, in(c, "u")), "result");
}

void stage_blend_front(csv *c)
{
    const unsigned f = (unsigned)small(in(c, "fraction"));
    number S = in(c, "state"), T = in(c, "t"), o32 = in(c, "o32"), colour = in(c, "colour");
    number behind = rest_behind(T, o32);
    out(c, behind, "tn");
    out(c, share_of(colour, T, f), "share");
    out(c, share_of(colour, behind, f), "share_n");
    out(c, blend_colour_under(S, colour, T, o32, f), "of_colour");
    out(c, blend_light_under(S, in(c, "light"), T, o32, in(c, "u"), f), "of_light");
}

void stage_residual(csv *c)
{
    const unsigned f = (unsigned)small(in(c, "fraction"));
    number S = in(c, "state");
    out(c, state_level(S, f), "level");
    out(c, state_residual(S, f), "residual");
}

void stage_replay(csv *c)
{
    channels slice, behind, front;
    in_all(c, "rgba", slice.v, 4);
    in_all(c, "behind", behind.v, 4);
    in_all(c, "front", front.v, 4);
    const channels result = replay(&slice, &behind, &front);
    out_all(c, "result", result.v, 4);
}
