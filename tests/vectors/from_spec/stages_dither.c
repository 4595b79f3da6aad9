/* Stages of sections 45 to 47, 51 and 57: what a slice is dithered with. */
#include "stages.h"

#include "depth.h"
#include "dither.h"
#include "slices.h"

void stage_dither(csv *c)
{
    number n = in(c, "n");
    out(c, hash_of(n), "hash");
    out(c, golden(n), "golden");
    out(c, hashed(n), "hashed");
    out(c, blocks(n), "blocks");
    out(c, dither_at(in(c, "u"), in(c, "x"), in(c, "y"), in(c, "frame")), "at");
}

void stage_hits(csv *c)
{
    number P = in(c, "period"), n = in(c, "n");
    number hits = hits_of(P, in(c, "o"), in(c, "base"), in(c, "bump"));
    out(c, hits, "hits");
    out(c, slice_phase(n, whole(0), whole(0), P), "k");
    out(c, whole(hits_ordered(P, hits, n)), "ordered");
    out(c, whole(hits_randomly(P, hits, in(c, "u"))), "random");
}

void stage_plateau(csv *c)
{
    number F = sub(power2((unsigned)small(in(c, "bits"))), whole(1)), v = in(c, "v");
    out(c, plateau(in(c, "o"), F), "plateau");
    out(c, over_least(v, F), "over");
    out(c, bump_of(low_bits(v, 8), in(c, "base")), "bump");
}

void stage_alpha(csv *c)
{
    const technique t = {in(c, "period"), {in(c, "slope0"), in(c, "slope1")}, in(c, "cutoff")};
    const turn_of_slice ordered = {false, in(c, "k"), NULL}, random = {true, NULL, in(c, "u")};
    number o = in(c, "o"), v = in(c, "v");
    out(c, rounded_opacity(o), "rounded");
    out(c, simple_opacity(&t, o, &ordered), "ordered");
    out(c, simple_opacity(&t, o, &random), "random");
    out(c, bumped_opacity(&t, o, v, &ordered), "bumped");
    out(c, bumped_opacity(&t, o, v, &random), "bumped_random");
    out(c, corrected_opacity(o, in(c, "colour"), v, random.u), "corrected");
}

void stage_slices(csv *c)
{
    number o32 = in(c, "o32");
    number through = sub(sub(power2(32), whole(1)), o32);
    out(c, depth_of(through), "depth");
    out(c, opacity_for_slices(o32, in(c, "slices"), in(c, "wanted")), "thinner");
}

void stage_slice_dither(csv *c)
{
    const bool is_backwards = sign_of(in(c, "backwards")) != 0;
    number k = in(c, "slice"), frame = in(c, "frame"), period = in(c, "period");
    number n = is_backwards ? sub(power2(22), k) : add(power2(22), k);
    number moved = dither_at(whole(0), in(c, "x"), in(c, "y"), whole(0));
    number shift = sign_of(in(c, "still")) != 0 ? whole(0) : moved;
    const enum sequence of = (enum sequence)small(in(c, "sequence"));
    out(c, slice_dither(of, n, frame, shift, is_backwards), "u");
    out(c, is_backwards ? slice_phase(n, frame, shift, period) : whole(0), "phase");
}
