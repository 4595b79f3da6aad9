/*
 * slicing.c - a table of the library's blends.
 */
#include "slicing.h"
#include "error.h"
#include "settings_slices.h"

#include <stddef.h>
#include <string.h>

/* Who is dithered: opacities, the results of blending, or these with a residual beside. */
enum method { OPACITIES, RESULTS, RESIDUAL4, RESIDUAL8 };

static const struct way {
    int framebuffer;
    enum method method;
    const qv_blend *rgb, *rgba, *front_to_back; /* null: there is none */
} ways[] = {
    {8, OPACITIES, &qv_hardware_rgb888, &qv_hardware_rgba8888, &qv_under_rgb888},
    {8, RESULTS, &qv_over_rgb888, &qv_over_rgba8888, &qv_under_rgb888},
    {8, RESIDUAL4, &qv_over_rgb888_residual4, &qv_over_rgba8888_residual4, NULL},
    {8, RESIDUAL8, &qv_over_rgb888_residual8, &qv_over_rgba8888_residual8, NULL},
    {FRAMEBUFFER_565, OPACITIES, &qv_hardware_rgb565, NULL, NULL},
    {FRAMEBUFFER_565, RESULTS, &qv_over_rgb565, NULL, NULL},
    {12, OPACITIES, &qv_hardware_rgba12, &qv_hardware_rgba12, NULL},
    {12, RESULTS, &qv_over_rgba12, &qv_over_rgba12, NULL},
    /* without dither, results are rounded to nearest */
    {16, OPACITIES, &qv_over_rgb16, &qv_over_rgba16, &qv_under_rgb16},
    {16, RESULTS, &qv_over_rgb16, &qv_over_rgba16, &qv_under_rgb16},
    {24, OPACITIES, &qv_over_rgb24, &qv_over_rgba24, &qv_under_rgb24},
    {24, RESULTS, &qv_over_rgb24, &qv_over_rgba24, &qv_under_rgb24},
};

static enum method method_of(int kind, unsigned residual)
{
    switch (kind) {
    case DITHER_ROUNDING:
        return RESULTS;
    case DITHER_FEEDBACK:
        return residual == 4 ? RESIDUAL4 : RESIDUAL8;
    default:
        return OPACITIES;
    }
}

/* The settings were checked: there is one. */
static const struct way *way_of(int framebuffer, enum method method)
{
    const struct way *way = ways;
    while (way->framebuffer != framebuffer || way->method != method) {
        way++;
    }
    return way;
}

/* An opaque background makes every pixel opaque, so opacities need no room. */
static const qv_blend *blend_of(const struct slicing *slicing, const qv_scene *scene,
                                const struct settings *settings)
{
    const struct way *way = way_of(settings_framebuffer(settings),
                                   method_of(slicing->kind, settings_residual(settings)));
    bool opaque = scene->background[3] == 255;
    if (slicing->front_to_back) {
        return way->front_to_back;
    }
    return opaque && slicing->chunk == 0 && !slicing->in_bricks ? way->rgb : way->rgba;
}

static const qv_technique *technique_of(int kind, bool sloped)
{
    switch (kind) {
    case DITHER_RANDOM:
        return &qv_technique_random;
    case DITHER_ORDERED:
        return &qv_technique_ordered;
    case DITHER_BUMP:
        return sloped ? &qv_technique_bumped : &qv_technique_corrected;
    default:
        return &qv_technique_rounded;
    }
}

static int sequence_of(int kind, const struct slice_settings *s)
{
    if (s->sequence != SEQUENCE_BY_DITHER) {
        return s->sequence;
    }
    switch (kind) {
    case DITHER_RANDOM:
        return SEQUENCE_HASH;
    case DITHER_ROUNDING:
    case DITHER_FEEDBACK:
        return SEQUENCE_BLOCKS;
    case DITHER_BUMP:
        return s->slopes == 0 ? SEQUENCE_BLOCKS : SEQUENCE_ROUNDED;
    default:
        return SEQUENCE_ROUNDED;
    }
}

/* By enum sequence_kind. */
static qv_sequence *const sequences[] = {
    [SEQUENCE_ROUNDED] = qv_sequence_rounded,
    [SEQUENCE_GOLDEN] = qv_sequence_golden,
    [SEQUENCE_HASH] = qv_sequence_hash,
    [SEQUENCE_BLOCKS] = qv_sequence_blocks,
};

static int sequence_kind(qv_sequence *sequence)
{
    int kind = SEQUENCE_BLOCKS;
    while (sequences[kind] != sequence && kind > SEQUENCE_ROUNDED) {
        kind--;
    }
    return kind;
}

/* The dither that the settings ask for, or leave to the library. */
static void set_kind(struct slicing *slicing, const struct settings *settings)
{
    const struct advice *advice = &slicing->advice;
    slicing->kind = settings_dither(settings);
    if (slicing->kind != DITHER_AUTO) {
        slicing->sequence = sequence_of(slicing->kind, &settings->slices);
        return;
    }
    if (!advice->given) {
        usage_error("--dither", "the library recommends nothing for %u slices", advice->slices);
    }
    slicing->kind = advice_dither(advice);
    slicing->sequence = sequence_kind(advice->recommendation.sequence);
}

static void set_dither_values(struct slicing *slicing, const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    qv_dither *dither = &slicing->dither;
    settings_alpha(dither, settings);
    dither->sequence = sequences[slicing->sequence];
    dither->technique = technique_of(slicing->kind, s->slopes != 0);
    dither->frame = s->frame;
    dither->still = s->still;
}

static void set_bricks_of(struct slicing *slicing, const qv_volume *volume,
                          const uint32_t bricks[3])
{
    slicing->in_bricks = bricks[0] != 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        slicing->bricks[axis] = bricks[axis];
        if (bricks[axis] > volume->size[axis]) {
            usage_error("--bricks", "%u on an axis of %u voxels", bricks[axis], volume->size[axis]);
        }
    }
}

void slicing_create(struct slicing *slicing, const qv_scene *scene, const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    memset(slicing, 0, sizeof *slicing);
    advice_ask(&slicing->advice, scene, settings);
    set_kind(slicing, settings);
    slicing->front_to_back = !settings_back_to_front(settings);
    slicing->chunk = s->chunk;
    set_bricks_of(slicing, &scene->volume, s->bricks);
    slicing->blend = blend_of(slicing, scene, settings);
    set_dither_values(slicing, settings);
}
