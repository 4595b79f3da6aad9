/* Stages of sections 8 to 11 and 37 to 39: places on rays. */
#include "stages.h"

#include "lengths.h"
#include "ray.h"

static camera in_camera(csv *c)
{
    return (camera){.origin = in_triple(c, "origin"),
                    .across = in_triple(c, "across"),
                    .down = in_triple(c, "down"),
                    .along = in_triple(c, "along")};
}

void stage_ray_orthographic(csv *c)
{
    ray_steps unused;
    const camera of = in_camera(c);
    const ray r = ray_of_pixel(&of, in(c, "x"), in(c, "y"), in(c, "phase"), &unused);
    out_triple(c, "place", &r.place);
    out_triple(c, "advance", &r.advance);
}

void stage_ray_perspective(csv *c)
{
    ray_steps step;
    camera of = in_camera(c);
    of.pace = in_triple(c, "pace");
    of.is_perspective = true;
    const ray r = ray_of_pixel(&of, in(c, "x"), in(c, "y"), in(c, "phase"), &step);
    out_triple(c, "v", &step.v);
    out(c, step.h, "h");
    out_triple(c, "m", &step.m);
    out(c, step.N, "n");
    out(c, step.r, "r");
    out(c, step.e, "e");
    out(c, whole(r.is_there), "exists");
    out_triple(c, "advance", &r.advance);
    out_triple(c, "place", &r.place);
}

static ray in_ray(csv *c)
{
    return (ray){
        .place = in_triple(c, "place"), .advance = in_triple(c, "advance"), .is_there = true};
}

void stage_clip(csv *c)
{
    const triple size = in_triple(c, "n");
    ray r = in_ray(c);
    r.first_sample = in(c, "least");
    const span k = clip(&r, &size);
    const bool is_none = is_less(k.last, k.first);
    triple point = {{whole(0), whole(0), whole(0)}};
    if (!is_none)
        point = sample_point(&r, k.first);
    out(c, is_none ? whole(0) : add(sub(k.last, k.first), whole(1)), "samples");
    out(c, is_none ? whole(0) : k.first, "k0");
    out_triple(c, "point", &point);
}

void stage_cell(csv *c)
{
    const triple size = in_triple(c, "n"), stride = in_triple(c, "stride");
    const ray r = in_ray(c);
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

void stage_way(csv *c)
{
    const triple size = in_triple(c, "n");
    const ray r = in_ray(c);
    const bool is_perspective = sign_of(in(c, "eye")) != 0;
    number first = is_perspective ? up(in(c, "phase"), 8) : power2(46);
    const way w = way_through(&r, &size, negative(first));
    out(c, whole(w.is_there), "exists");
    out(c, w.is_there ? w.enter : whole(0), "enter");
    out(c, w.is_there ? w.leave : whole(0), "leave");
}

void stage_piece(csv *c)
{
    const ray r = in_ray(c);
    const unsigned level = (unsigned)small(in(c, "level"));
    const piece p = piece_from(&r, in(c, "begin"), in(c, "leave"), level);
    out(c, p.end, "end");
    out(c, p.l, "length");
    out(c, p.t, "t");
    out_triple(c, "point", &p.P);
}

void stage_medium(csv *c)
{
    static const enum medium_kind kinds[2][3] = {
        {MEDIUM_CORRECTED, MEDIUM_EXTINCTION8, MEDIUM_OPACITY},
        {MEDIUM_CORRECTED, MEDIUM_EXTINCTION16, MEDIUM_OPACITY}};
    const long model = small(in(c, "model")), wide = small(in(c, "wide"));
    number step = in(c, "step"), unit = in(c, "unit"), length = in(c, "length");
    number U = sign_of(unit) == 0 ? step : unit;
    const medium m =
        medium_of(kinds[wide % 2][model % 3], U, in(c, "extinction"), step, in(c, "levels"));
    out(c, m.depth, "step_depth");
    out(c, m.light, "step_light");
    out(c, m.b, "b");
    out(c, of_length(m.depth, length), "depth");
    out(c, of_length(m.light, length), "light");
}
