/* Stages of sections 31 to 34 and 69: entries of other entries. */
#include "stages.h"

#include "depth.h"
#include "entries.h"
#include "operations.h"

typedef number recoding(number v, number from, number to);

void stage_recode(csv *c)
{
    static recoding *const kinds[4] = {opacity_to_extinction, opacity_to_opacity,
                                       extinction_to_extinction, extinction_to_opacity};
    const long kind = small(in(c, "kind"));
    number result = kinds[kind % 4](in(c, "v"), in(c, "from"), in(c, "to"));
    out(c, result, "result16");
    out(c, to8(result), "result8");
}

void stage_least_extinction(csv *c)
{
    number a[3];
    in_all(c, "a", a, 3);
    out(c, least_extinction(3, a, in(c, "unit"), in(c, "opaque")), "extinction");
}

void stage_mixture(csv *c)
{
    static const char *const colours[3] = {"r", "g", "b"};
    number p[3], E[3];
    triple C[3];
    in_all(c, "p", p, 3);
    in_all(c, "extinction", E, 3);
    for (unsigned m = 0; m < 3; m++)
        for (unsigned i = 0; i < 3; i++)
            C[m].v[i] = in(c, "%s%u", colours[i], m);
    const mixture of = mixture_of(3, p, E, C);
    out(c, of.X, "x");
    out_triple(c, "y", &of.Y);
    for (unsigned i = 0; i < 3; i++)
        out(c, mixture_colour(&of, i), "rgbt%u", i);
    out(c, mixture_extinction(&of, in(c, "full")), "rgbt3");
}

/* A channel of voxel i, as unorm16. */
static number in_channel(csv *c, const char *name, long i, bool is_wide)
{
    number stored = in(c, "%s%u", name, (unsigned)i);
    return is_wide ? stored : mul(whole(257), stored);
}

/* The taps of the result (0, 0, 0). */
static void in_taps(csv *c, taps *of, bool is_wide)
{
    static const char *const colours[3] = {"r", "g", "b"};
    const long nx = small(in(c, "n0")), ny = small(in(c, "n1")), nz = small(in(c, "n2"));
    for (int t = 0; t < TAPS; t++) {
        const long i = tap_voxel(0, t % 4, nx);
        const long j = tap_voxel(0, t / 4 % 4, ny), k = tap_voxel(0, t / 16, nz);
        const long voxel = i + nx * (j + ny * k);
        of->X[t] = in_channel(c, "x", voxel, is_wide);
        for (int channel = 0; channel < 3; channel++)
            of->C[channel][t] = in_channel(c, colours[channel], voxel, is_wide);
    }
}

void stage_downsample(csv *c)
{
    static const int inner[3] = {32, 16, 19};
    taps of;
    const bool is_wide = sign_of(in(c, "wide")) != 0;
    const bool is_converted = sign_of(in(c, "converted")) != 0;
    in_taps(c, &of, is_wide);
    const reduced r = downsample(&of, whole(inner[small(in(c, "filter")) % 3]), is_converted);
    for (unsigned i = 0; i < 8; i++) {
        number X = in_channel(c, "x", i, is_wide);
        out(c, is_converted ? ext16(X) : X, "weight%u", i);
    }
    for (unsigned i = 0; i < 4; i++) {
        number channel = i == 3 ? r.X : r.c.v[i];
        out(c, is_wide ? channel : to8(channel), "rgba%u", i);
    }
}

void stage_associate(csv *c)
{
    const bool is_wide = sign_of(in(c, "wide")) != 0;
    number A = in(c, "rgba3");
    for (unsigned i = 0; i < 3; i++) {
        number colour = in(c, "rgba%u", i);
        out(c, is_wide ? associated_of_16(colour, A) : associated_of_8(colour, A), "associated%u",
            i);
    }
    out(c, is_wide ? to8(A) : A, "associated3");
}
