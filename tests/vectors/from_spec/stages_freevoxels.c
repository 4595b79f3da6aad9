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

static thickness in_thickness(csv *c, bool is_stored, number L)
{
    number U = in(c, "unit"), E = in(c, "extinction");
    return is_stored ? thickness_of_extinction(E, L) : thickness_of_unit(U, L);
}

void stage_attenuation(csv *c)
{
    const bool is_stored = sign_of(in(c, "stored")) != 0;
    const thickness t = in_thickness(c, is_stored, in(c, "length"));
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

void stage_attenuate(csv *c)
{
    enum { VOXELS = 12, BLOCKS = 6, LEVEL2 = 3 };
    const triple n = in_triple(c, "n"), spacing = in_triple(c, "spacing");
    const triple step = direction_step(in(c, "direction"));
    const box b = {{small(n.v[0]), small(n.v[1]), small(n.v[2])}};
    const box level1 = level_box(&b, 1), level2 = level_box(&b, 2);
    const unsigned levels = level_count(&b);
    number x[VOXELS], D[VOXELS], B[BLOCKS];
    const bool is_stored = sign_of(in(c, "stored")) != 0;
    number L = step_length(&step, &spacing);
    const thickness t = in_thickness(c, is_stored, L);
    out(c, L, "length");
    in_all(c, "x", x, VOXELS);
    for (unsigned i = 0; i < VOXELS; i++)
        x[i] = is_stored ? x[i] : ext16(x[i]);
    for (unsigned i = 0; i < VOXELS; i++) {
        const bool is_there = i < box_voxels(&b);
        D[i] = is_there ? voxel_depth(&b, x, i, &step, t) : whole(0);
        out(c, is_there ? attenuation_byte(D[i]) : whole(0), "byte%u", i);
    }
    for (unsigned i = 0; i < BLOCKS; i++) {
        B[i] = i < box_voxels(&level1) ? block_depth(&b, D, i) : whole(0);
        out(c, B[i], "block%u", i);
    }
    for (unsigned i = 0; i < BLOCKS; i++) {
        const bool is_there = levels >= 1 && i < box_voxels(&level1);
        out(c, is_there ? level_byte(&b, B, i, 1) : whole(0), "level1%u", i);
    }
    for (unsigned i = 0; i < LEVEL2; i++) {
        const bool is_there = levels >= 2 && i < box_voxels(&level2);
        out(c, is_there ? level_byte(&b, B, i, 2) : whole(0), "level2%u", i);
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
