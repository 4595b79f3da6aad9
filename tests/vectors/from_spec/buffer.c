/* Sections 58 and 60: how pixels of a frame buffer are stored, cleared and read. */
#include "buffer.h"

#include "dither.h"
#include "operations.h"

/* Bits of channel c in the pixel, and where they begin. */
static unsigned channel_bits(const blend_kind *kind, unsigned c)
{
    if (kind->is_565)
        return c == 1 ? 6 : 5;
    return kind->has_residual ? 8 : 8 + kind->f;
}

static unsigned channel_place(const blend_kind *kind, unsigned c)
{
    static const unsigned places[3] = {11, 5, 0};
    return kind->is_565 ? places[c] : c * channel_bits(kind, c);
}

/* The lowest bits of v as a number with a sign. */
static number low_signed(number v, unsigned bits)
{
    number moved = low_bits(add(v, power2(bits - 1)), bits);
    return sub(moved, power2(bits - 1));
}

state read_state(const blend_kind *kind, const stored_pixel *from)
{
    state s = {.T = low_bits(from->beside, 24)};
    for (unsigned c = 0; c < kind->channels; c++) {
        number stored = down(from->pixel, channel_place(kind, c));
        s.S[c] = low_bits(stored, channel_bits(kind, c));
        if (kind->has_residual) {
            number residual = low_signed(down(from->beside, c * kind->f), kind->f);
            s.S[c] = add(up(s.S[c], kind->f), residual);
        }
    }
    return s;
}

stored_pixel write_state(const blend_kind *kind, const state *s)
{
    stored_pixel to = {whole(0), kind->family == FAMILY_UNDER ? s->T : whole(0)};
    for (unsigned c = 0; c < kind->channels; c++) {
        number S = s->S[c];
        if (kind->has_residual) {
            number residual = low_bits(state_residual(S, kind->f), kind->f);
            to.beside = add(to.beside, up(residual, c * kind->f));
            S = state_level(S, kind->f);
        }
        fits_unsigned(S, channel_bits(kind, c));
        to.pixel = add(to.pixel, up(S, channel_place(kind, c)));
    }
    return to;
}

/* The state of 1 of a channel. */
static number full_state(const blend_kind *kind, unsigned c)
{
    if (kind->is_565 || kind->family == FAMILY_HARDWARE)
        return sub(power2(channel_bits(kind, c)), whole(1));
    return up(whole(255), kind->f);
}

/* What hardware_* and hand_out hold of the light and opacity of a background. */
static number cleared_channel(const blend_kind *kind, number lit, unsigned c)
{
    if (kind->is_565)
        return rounded(hi(lit, whole(c == 1 ? 1061109568 : 522133279)), 23);
    if (kind->f == 4)
        return rounded(add(lit, hi(lit, whole(15790321))), 19);
    return rounded(lit, 23);
}

state cleared_state(const blend_kind *kind, const channels *background)
{
    const channels G = background_levels(background);
    slice s = {.o32 = mul(whole(0x01010101), background->v[3]), .u = power2(31)};
    state empty = {{whole(0), whole(0), whole(0), whole(0)}, sub(power2(24), whole(1))};
    for (unsigned c = 0; c < 3; c++)
        s.light.v[c] = up(G.v[c], 6);
    if (kind->family == FAMILY_UNDER)
        return empty;
    if (kind->family == FAMILY_OVER)
        return blend_slice(kind, &empty, &s, NULL);
    for (unsigned c = 0; c < 3; c++)
        empty.S[c] = cleared_channel(kind, s.light.v[c], c);
    empty.S[3] = rounded(hi(s.o32, up(whole(kind->f == 4 ? 4095 : 255), 16)), 16);
    return empty;
}

static number shown_opacity(const blend_kind *kind, const state *s)
{
    if (kind->family == FAMILY_UNDER) {
        if (is_equal(s->T, sub(power2(24), whole(1))))
            return whole(0);
        return opacity32_of_level(share_of(whole(255), s->T, 16));
    }
    if (kind->channels == 3)
        return sub(power2(32), whole(1));
    if (kind->family == FAMILY_HARDWARE && kind->f == 4)
        return add(add(up(s->S[3], 20), up(s->S[3], 8)), down(s->S[3], 4));
    return opacity32_of_level(up(s->S[3], 16 - kind->f));
}

slice shown(const blend_kind *kind, const state *s)
{
    slice r = {.o32 = shown_opacity(kind, s)};
    for (unsigned c = 0; c < 3; c++) {
        number F = full_state(kind, c);
        number wide = up(mul(up(whole(255), 23), s->S[c]), 1);
        r.light.v[c] = floor_div(add(wide, F), up(F, 1));
    }
    return r;
}

channels shown_channels(const blend_kind *kind, const slice *shows, const channels *background)
{
    const channels G = background_levels(background);
    number through = sub(sub(power2(32), whole(1)), shows->o32);
    number t = kind->family == FAMILY_UNDER ? through : whole(0);
    number own = rounded(hi(shows->o32, up(whole(255), 23)), 7);
    channels r;
    r.v[3] = add(own, down(hi(t, G.v[3]), 1));
    for (unsigned c = 0; c < 3; c++) {
        number level = add(rounded(shows->light.v[c], 7), down(hi(t, G.v[c]), 1));
        r.v[c] = least(r.v[3], level);
    }
    return r;
}
