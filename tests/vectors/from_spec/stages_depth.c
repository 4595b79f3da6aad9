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
