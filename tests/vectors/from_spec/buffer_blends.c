/* Section 59: a slice meets a pixel of a frame buffer. */
#include "buffer.h"

#include "dither.h"
#include "operations.h"

/* C of each channel, and A. */
typedef struct slice_light {
    number C[4], A;
} slice_light;

static slice_light light_of_slice(const blend_kind *kind, const slice *s)
{
    slice_light r = {.A = light_opacity(s->o32)};
    const bool is_fine = kind->f == 16 || kind->family == FAMILY_UNDER;
    r.C[3] = is_fine ? hi(s->o32, up(whole(255), 23)) : mul(whole(255), r.A);
    for (unsigned c = 0; c < 3; c++)
        r.C[c] = least(s->light.v[c], r.C[3]);
    return r;
}

static state over_slice(const blend_kind *kind, const state *before, const slice *s)
{
    const slice_light l = light_of_slice(kind, s);
    state r = *before;
    for (unsigned c = 0; c < kind->channels; c++) {
        number C = l.C[c];
        if (kind->is_565)
            C = hi(C, whole(c == 1 ? 1061109568 : 522133279));
        r.S[c] = kind->f == 16 ? blend_24(before->S[c], C, s->o32, s->u)
                               : blend_dithered(before->S[c], C, l.A, s->u, kind->f);
    }
    return r;
}

/* A pixel that lets nothing through stays as it is. */
static state under_slice(const blend_kind *kind, const state *before, const slice *s)
{
    const slice_light l = light_of_slice(kind, s);
    state r = *before;
    if (sign_of(before->T) == 0)
        return r;
    for (unsigned c = 0; c < kind->channels; c++)
        r.S[c] = blend_light_under(before->S[c], l.C[c], before->T, s->o32, s->u, kind->f);
    r.T = rest_behind(before->T, s->o32);
    return r;
}

/* colour(c, b). */
static number colour_of(const slice_light *l, unsigned c, unsigned b)
{
    if (sign_of(l->A) == 0)
        return whole(0);
    return floor_div(add(up(l->C[c], b + 1), l->A), up(l->A, 1));
}

/* A state of 5, 6 or 8 bits as 8 bits. */
static number widened(const blend_kind *kind, number S, unsigned c)
{
    if (!kind->is_565)
        return S;
    return c == 1 ? add(up(S, 2), down(S, 4)) : add(up(S, 3), down(S, 2));
}

/* The colour c and the value v that a technique looks at. */
typedef struct sight {
    number c, v;
} sight;

static sight sight_of(const blend_kind *kind, const state *s, const slice_light *l)
{
    if (kind->family == FAMILY_HAND_OUT)
        return (sight){whole(255), whole(0)};
    if (kind->channels == 4 && !is_equal(s->S[3], whole(255)))
        return (sight){whole(255), s->S[3]};
    unsigned j = 0;
    for (unsigned c = 1; c < 3; c++)
        if (is_less(colour_of(l, j, 0), colour_of(l, c, 0)))
            j = c;
    return (sight){colour_of(l, j, 0), widened(kind, s->S[j], j)};
}

/* a: what the technique makes of an opacity. */
static number chosen_opacity(const choice *how, number o, sight at, number u)
{
    const turn_of_slice ordered = {false, how->phase, NULL}, random = {true, NULL, u};
    number held = sub(whole(255), magnitude(sub(at.v, at.c)));
    switch (how->kind) {
    case TECHNIQUE_RANDOM:
        return simple_opacity(&how->of, o, &random);
    case TECHNIQUE_ORDERED:
        return simple_opacity(&how->of, o, &ordered);
    case TECHNIQUE_BUMPED:
        return bumped_opacity(&how->of, o, held, &ordered);
    case TECHNIQUE_BUMPED_RANDOM:
        return bumped_opacity(&how->of, o, held, &random);
    case TECHNIQUE_CORRECTED:
        return corrected_opacity(o, at.c, at.v, u);
    default:
        return rounded_opacity(o);
    }
}

static state hardware12_slice(const state *before, const slice *s, const slice_light *l)
{
    state r = *before;
    number a = rounded(hi(s->o32, up(whole(4095), 16)), 16);
    for (unsigned c = 0; c < 3; c++) {
        number colour = hi(colour_of(l, c, 8), whole(269422351));
        r.S[c] = blend_associated(before->S[c], div_ones(mul(a, colour), 12), a, 12);
    }
    r.S[3] = blend_associated(before->S[3], a, a, 12);
    return r;
}

static number plain_channel(const blend_kind *kind, number S, number colour, number a, unsigned c)
{
    const int full = c == 1 ? 63 : 31;
    if (kind->is_565)
        colour = div_ones(mul(whole(full), colour), 8);
    return blend_plain(S, colour, a, 8);
}

static state hardware_slice(const blend_kind *kind, const state *before, const slice *s,
                            const choice *how)
{
    const slice_light l = light_of_slice(kind, s);
    if (kind->f == 4)
        return hardware12_slice(before, s, &l);
    number o = hi(s->o32, up(whole(255), 16));
    number a = chosen_opacity(how, o, sight_of(kind, before, &l), s->u);
    state r = *before;
    for (unsigned c = 0; c < 3; c++) {
        number colour = colour_of(&l, c, 0), lit = div_ones(mul(a, colour), 8);
        if (kind->family == FAMILY_HAND_OUT)
            r.S[c] = lit;
        else if (kind->channels == 4)
            r.S[c] = blend_associated(before->S[c], lit, a, 8);
        else
            r.S[c] = plain_channel(kind, before->S[c], colour, a, c);
    }
    if (kind->channels == 4)
        r.S[3] = kind->family == FAMILY_HAND_OUT ? a : blend_associated(before->S[3], a, a, 8);
    return r;
}

state blend_slice(const blend_kind *kind, const state *before, const slice *s, const choice *how)
{
    if (kind->family == FAMILY_OVER)
        return over_slice(kind, before, s);
    if (kind->family == FAMILY_UNDER)
        return under_slice(kind, before, s);
    return hardware_slice(kind, before, s, how);
}
