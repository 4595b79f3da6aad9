/* Stages of part H: FreeVoxels. */
#include "stages.h"

#include "depth.h"
#include "freevoxels.h"
#include "operations.h"
#include "orders.h"

void stage_order(csv *c)
{
    const triple n = in_triple(c, "n"), p = in_triple(c, "p");
    out(c, linear_index(&n, &p), "linear");
    out(c, curve_index(&n, &p, false), "morton");
    out(c, curve_index(&n, &p, true), "hilbert");
}

void stage_attenuation(csv *c)
{
    const bool is_stored = sign_of(in(c, "stored")) != 0;
    number U = in(c, "unit"), E = in(c, "extinction"), L = in(c, "length");
    const thickness t = is_stored ? thickness_of_extinction(E, L) : thickness_of_unit(U, L);
    number D = whole(0);
    out(c, t.f, "f");
    out(c, t.s, "s");
    for (unsigned i = 0; i < 8; i++) {
        number x = in(c, "x%u", i);
        number weight = is_stored ? x : ext16(x);
        D = fits_unsigned(add(D, thickness_depth(t, weight)), 64);
        out(c, weight, "weight%u", i);
        out(c, D, "depth%u", i);
        out(c, attenuation_byte(D), "byte%u", i);
    }
}

void stage_length(csv *c)
{
    const triple v = in_triple(c, "v");
    out(c, length_of(&v), "length");
}

static void out_scaled(csv *c, scaled s, const char *m, const char *e)
{
    out(c, s.m, "%s", m);
    out(c, whole(s.e), "%s", e);
}

void stage_scaled(csv *c)
{
    const scaled a = scaled_of(in(c, "v"), small(in(c, "e")));
    const scaled b = scaled_of(in(c, "w"), small(in(c, "g")));
    out_scaled(c, a, "m", "me");
    out_scaled(c, scaled_product(a, b), "product", "product_e");
    out_scaled(c, scaled_quotient(a, b), "quotient", "quotient_e");
    out(c, scaled_fixed(a, small(in(c, "fraction"))), "fixed");
}

void stage_footprint(csv *c)
{
    const unsigned halves = sign_of(in(c, "kernel")) == 0 ? 2 : 3;
    const footprint of = footprint_of(in(c, "centre"), in(c, "size"), halves);
    number first = in(c, "first");
    out(c, of.H, "half");
    out(c, whole(of.j), "doublings");
    out(c, of.R, "reciprocal");
    for (unsigned i = 0; i < 6; i++)
        out(c, footprint_weight(&of, add(first, whole(i))), "weight%u", i);
}

typedef channels splat_function(const channels *sum, const number part[]);

static void splat_stage(csv *c, splat_function *put)
{
    channels sum;
    number part[4];
    number wy = in(c, "wy"), wx = in(c, "wx");
    in_all(c, "sum", sum.v, 4);
    for (unsigned i = 0; i < 4; i++) {
        number line = shift16(in(c, "light%u", i), wy);
        out(c, line, "line%u", i);
        part[i] = splat_part(line, wx);
    }
    const channels next = put(&sum, part);
    out_all(c, "next", next.v, 4);
}

void stage_splat_added(csv *c)
{
    splat_stage(c, splat_added);
}

void stage_splat_over(csv *c)
{
    splat_stage(c, splat_over);
}
