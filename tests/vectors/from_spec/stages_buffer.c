/* Stages of sections 58 to 60: pixels of frame buffers. */
#include "stages.h"

#include "buffer.h"

enum { PIXEL_BYTES = 12, BESIDE_BYTES = 4, KINDS = 20 };

static blend_kind in_kind(csv *c)
{
    static const blend_kind kinds[KINDS] = {
        {FAMILY_OVER, 3, 0, false, false},     {FAMILY_OVER, 4, 0, false, false},
        {FAMILY_OVER, 3, 4, true, false},      {FAMILY_OVER, 4, 4, true, false},
        {FAMILY_OVER, 3, 8, true, false},      {FAMILY_OVER, 4, 8, true, false},
        {FAMILY_OVER, 3, 0, false, true},      {FAMILY_OVER, 4, 4, false, false},
        {FAMILY_OVER, 3, 8, false, false},     {FAMILY_OVER, 4, 8, false, false},
        {FAMILY_OVER, 3, 16, false, false},    {FAMILY_OVER, 4, 16, false, false},
        {FAMILY_UNDER, 3, 0, false, false},    {FAMILY_UNDER, 3, 8, false, false},
        {FAMILY_UNDER, 3, 16, false, false},   {FAMILY_HARDWARE, 3, 0, false, false},
        {FAMILY_HARDWARE, 3, 0, false, true},  {FAMILY_HARDWARE, 4, 0, false, false},
        {FAMILY_HARDWARE, 4, 4, false, false}, {FAMILY_HAND_OUT, 4, 0, false, false}};
    return kinds[small(in(c, "blend")) % KINDS];
}

/* Bytes as a string of bits, the first ones lowest. */
static number in_bytes(csv *c, const char *name, unsigned count)
{
    number all = whole(0);
    for (unsigned i = count; i-- > 0;)
        all = add(up(all, 8), in(c, "%s%u", name, i));
    return all;
}

static void out_bytes(csv *c, const char *name, number all, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        out(c, low_bits(down(all, 8 * i), 8), "%s%u", name, i);
}

static state in_state(csv *c, const blend_kind *kind)
{
    const stored_pixel from = {in_bytes(c, "pixel", PIXEL_BYTES),
                               in_bytes(c, "beside", BESIDE_BYTES)};
    return read_state(kind, &from);
}

static void out_state(csv *c, const blend_kind *kind, const state *s, const char *pixel,
                      const char *beside)
{
    const stored_pixel to = write_state(kind, s);
    out_bytes(c, pixel, to.pixel, PIXEL_BYTES);
    out_bytes(c, beside, to.beside, BESIDE_BYTES);
}

void stage_pixel_blend(csv *c)
{
    const blend_kind kind = in_kind(c);
    const state before = in_state(c, &kind);
    const slice s = {in_triple(c, "light"), in(c, "o32"), in(c, "u")};
    const choice how = {(enum technique_kind)small(in(c, "technique")),
                        {in(c, "period"), {in(c, "slope0"), in(c, "slope1")}, in(c, "cutoff")},
                        in(c, "k")};
    const state after = blend_slice(&kind, &before, &s, &how);
    out_state(c, &kind, &after, "after", "beside_after");
}

void stage_pixel_show(csv *c)
{
    const blend_kind kind = in_kind(c);
    const state held = in_state(c, &kind);
    channels background;
    in_all(c, "background", background.v, 4);
    const state cleared = cleared_state(&kind, &background);
    const slice shows = shown(&kind, &held);
    const channels seen = shown_channels(&kind, &shows, &background);
    out_state(c, &kind, &cleared, "cleared", "beside_cleared");
    out_triple(c, "light", &shows.light);
    out(c, shows.o32, "o32");
    out_all(c, "channel", seen.v, 4);
}
