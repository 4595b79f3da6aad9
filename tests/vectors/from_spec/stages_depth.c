/* Stages of part C: optical depth. */
#include "stages.h"

#include "depth.h"
#include "tables.h"

void stage_transmittance(csv *c)
{
    power_steps step;
    number T = transmittance_steps(in(c, "x"), &step);
    out(c, step.w, "w");
    out(c, step.g, "g");
    out(c, step.i, "index");
    out(c, step.B, "base");
    out(c, step.t, "place");
    out(c, T, "t");
    out(c, sub(power2(31), T), "opacity");
}

void stage_transmittance16(csv *c)
{
    power16_steps step;
    number T = transmittance16_steps(in(c, "x"), &step);
    out(c, step.w, "w");
    out(c, step.g, "g");
    out(c, step.B, "base");
    out(c, step.t, "place");
    out(c, T, "t16");
    out(c, sub(whole(65535), T), "opacity16");
}

static void out_normalised(csv *c, const depth_steps *step)
{
    out(c, step->w, "w");
    out(c, step->n, "n");
    out(c, step->i, "index");
    out(c, step->e, "gap");
}

void stage_depth(csv *c)
{
    depth_steps step;
    number D = depth_of_steps(in(c, "t"), &step);
    out_normalised(c, &step);
    out(c, D, "depth");
}

void stage_extinction(csv *c)
{
    out(c, ext16(in(c, "a16")), "ext16");
    out(c, ext8(in(c, "a8")), "ext8");
}

void stage_reciprocal(csv *c)
{
    depth_steps step;
    number r = recip_steps(in(c, "v"), &step);
    out_normalised(c, &step);
    out(c, r, "reciprocal");
}

void stage_phi(csv *c)
{
    out(c, phi(in(c, "x")), "phi");
}

void stage_correct(csv *c)
{
    number a = in(c, "a"), k = in(c, "ratio");
    number d = depth_of_opacity(a);
    out(c, d, "depth");
    out(c, scale(d, k), "scaled");
    out(c, correct(a, k), "opacity");
    out(c, correction_factor(a, k), "factor");
}
