/*
 * scenes.c - the golden scenes, each made from its number.
 *
 * Sampling modes and formats follow each other; the rest is drawn from small tables
 * by a generator seeded with the number. Whoever changes anything here runs `make
 * golden-update`.
 */
#include "splitmix.h"
#include "scenes.h"

/* A binary angle from whole degrees; negative ones wrap as angles do. */
#define DEGREES(d) ((qv_angle)((int64_t)(d)*0x100000000 / 360))

/* n / d with 16 fraction bits. */
#define Q16(n, d) ((n)*65536u / (d))

#define COUNT(table) (sizeof(table) / sizeof *(table))

/* Each fits GOLDEN_VOXEL_BYTES with 8-byte voxels and gaps, and GOLDEN_SCALARS. */
static const uint16_t sizes[][3] = {
    {7, 8, 6}, {5, 9, 7}, {6, 6, 9}, {8, 7, 8}, {12, 6, 5}, {4, 3, 20}, {9, 1, 9}, {3, 2, 4},
};

static const uint32_t spacings[][3] = {
    {Q16(1, 1), Q16(1, 1), Q16(1, 1)},
    {Q16(3, 4), Q16(1, 1), Q16(3, 2)},
    {Q16(2, 1), Q16(5, 4), Q16(1, 2)},
    {0, 0, 0}, /* the default */
};

/* Along and across the axes, and in between. */
static const qv_angle angles[] = {
    0,           DEGREES(90), DEGREES(-64), DEGREES(-17),
    DEGREES(30), DEGREES(57), DEGREES(113), DEGREES(201),
    1, /* the smallest turn */
};

static const qv_angle fields_of_view[] = {0, DEGREES(20), 0, DEGREES(45), 0, DEGREES(90)};

static const uint32_t steps[] = {
    Q16(1, 1), Q16(1, 2), Q16(3, 4), Q16(3, 2), Q16(5, 16), Q16(1, 7),
};

/* Of modes that weigh by length. */
static const uint32_t long_steps[] = {
    Q16(1, 16), Q16(1, 4), Q16(3, 4), Q16(1, 1), Q16(5, 2), Q16(16, 1),
};

/* Of scenes by slices: not too many slices for the devices. */
static const uint32_t slice_steps[] = {Q16(1, 2), Q16(3, 4), Q16(1, 1), Q16(3, 2), Q16(5, 2)};

/* Unit distances in 1/16 step; 0: the step, not named. */
static const uint32_t unit_ratios[] = {0, 16, 1, 9, 20, 48, 256};

static const uint32_t extinctions[] = {Q16(1, 1), Q16(5, 2), Q16(16, 1), Q16(40, 1) + 1};

static const qv_filter *const filters[] = {&qv_filter_box2, &qv_filter_box4, &qv_filter_quad4};

static const uint16_t phases[] = {0, 0x8000, 0x5555, 1, 0xFFFF};

static const uint16_t terminations[] = {0, QV_TERMINATION_DEFAULT, 0x1999, 0, 1};

static const uint8_t backgrounds[][4] = {
    {0, 0, 0, 0},
    {255, 255, 255, 255},
    {32, 64, 96, 255},
    {200, 10, 90, 128},
};

static const uint32_t slopes[] = {0, Q16(1, 1), Q16(3, 4), Q16(2, 1), Q16(16, 1)};

static const uint8_t cutoffs[] = {0, 255, 3, 40};

/* Index into a table for this draw. */
#define DRAW(state, table) random_below(state, COUNT(table))

static void draw_volume(golden_scene *golden, uint32_t *state)
{
    uint32_t size = DRAW(state, sizes);
    uint32_t spacing = DRAW(state, spacings);
    for (unsigned axis = 0; axis < 3; axis++) {
        golden->size[axis] = sizes[size][axis];
        golden->spacing[axis] = spacings[spacing][axis];
    }
    golden->content = (golden_content)random_below(state, GOLDEN_CONTENTS);
    golden->layout = (golden_layout)random_below(state, GOLDEN_LAYOUTS);
    if (golden->content == GOLDEN_CLASSIFIED)
        golden->layout = GOLDEN_PACKED; /* as qv_classify stores them */
}

/* Mean of the two shorter edges of the box, in world units: what most views see
   of it at least. */
static uint32_t visible_extent(const golden_scene *golden)
{
    uint32_t sum = 0, longest = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t spacing = golden->spacing[axis] == 0 ? QV_ONE_Q16 : golden->spacing[axis];
        uint32_t edge = golden->size[axis] * spacing; /* at most 40 * 2^16 */
        sum += edge;
        longest = edge > longest ? edge : longest;
    }
    return (sum - longest) / 2;
}

static bool by_length(const golden_scene *golden)
{
    return golden->mode->family >= GOLDEN_CORRECTED;
}

static bool by_slices(const golden_scene *golden)
{
    return golden->slices.blend != NULL;
}

static uint32_t draw_step(const golden_scene *golden, uint32_t *state)
{
    if (by_slices(golden))
        return slice_steps[DRAW(state, slice_steps)];
    return by_length(golden) ? long_steps[DRAW(state, long_steps)] : steps[DRAW(state, steps)];
}

/* By slices frames are small, as their pixels take more bytes. */
static void draw_frame(golden_scene *golden, uint32_t *state)
{
    golden->width =
        (uint16_t)(by_slices(golden) ? 5 + random_below(state, 4) : 11 + random_below(state, 15));
    golden->height =
        (uint16_t)(by_slices(golden) ? 5 + random_below(state, 4) : 9 + random_below(state, 11));
}

static void draw_view(golden_scene *golden, uint32_t *state)
{
    golden->azimuth = angles[DRAW(state, angles)];
    golden->elevation = angles[DRAW(state, angles)];
    golden->roll = angles[DRAW(state, angles)];
    golden->field_of_view = fields_of_view[DRAW(state, fields_of_view)];
    golden->step = draw_step(golden, state);
    golden->phase = phases[DRAW(state, phases)];
    golden->termination = terminations[DRAW(state, terminations)];
    uint32_t background = DRAW(state, backgrounds);
    for (unsigned channel = 0; channel < 4; channel++)
        golden->background[channel] = backgrounds[background][channel];
    draw_frame(golden, state);
    golden->pitch = visible_extent(golden) / golden->height;
}

/* A part of the frame; sometimes with pixels that lie beyond it. */
static void draw_rect(golden_scene *golden, uint32_t *state)
{
    qv_rect *rect = &golden->rect;
    int32_t beyond = by_slices(golden) ? 1 : 2;
    rect->left = (int32_t)random_below(state, 2u * (uint32_t)beyond + 1) - beyond;
    rect->top = (int32_t)random_below(state, 2u * (uint32_t)beyond + 1) - beyond;
    rect->right = golden->width + 1 - (int32_t)random_below(state, 3);
    rect->bottom = golden->height + 1 - (int32_t)random_below(state, 3);
}

static void draw_rows(golden_scene *golden, uint32_t *state)
{
    golden->padding = (int32_t)random_below(state, 4);
    golden->bottom_up = random_below(state, 2) != 0;
    golden->strip =
        (uint16_t)(golden->format == GOLDEN_MONO_VERTICAL ? 1 : 2 + random_below(state, 6));
    golden->piece = (uint16_t)(1 + random_below(state, 100));
}

/* A level everywhere or, of half the eyes, one that rises from 1 to 16 world units on. */
static void draw_levels(golden_scene *golden, uint32_t *state)
{
    uint32_t most = qv_pyramid_levels(golden->size) * 256u;
    golden->filter = filters[DRAW(state, filters)];
    golden->level = (uint16_t)random_below(state, most + 1);
    if (golden->field_of_view != 0 && random_below(state, 2) != 0) {
        golden->level = golden->level / 2 & 0x100;
        golden->level_distance = 1 + ((1 + random_below(state, 16)) << 16) / golden->step;
    }
}

/* Thin voxels stand for little length, or nothing would be seen; nearly opaque ones for a
   step at least, or the last bits of weights would be seen. */
static uint32_t draw_unit_distance(const golden_scene *golden, uint32_t *state)
{
    uint32_t step = golden->step, unit = step * unit_ratios[DRAW(state, unit_ratios)] / 16;
    if (golden->content == GOLDEN_THIN && step >= QV_ONE_Q16)
        return QV_ONE_Q16 / 4;
    if (golden->content == GOLDEN_BALL && unit < step)
        return step;
    return unit;
}

static void draw_lengths(golden_scene *golden, uint32_t *state)
{
    golden->unit_distance = draw_unit_distance(golden, state);
    golden->extinction = extinctions[DRAW(state, extinctions)];
    if (golden->mode->order == GOLDEN_LEVELS)
        draw_levels(golden, state);
}

static void draw_dither(qv_dither *dither, const golden_blends *of, uint32_t *state)
{
    dither->sequence = of->sequence[random_below(state, GOLDEN_SEQUENCES)];
    dither->technique = of->technique[random_below(state, GOLDEN_TECHNIQUES)];
    for (unsigned i = 0; i < 2; i++)
        dither->slope[i] = slopes[DRAW(state, slopes)];
    dither->frame = random16(state);
    dither->period = (uint8_t)(2 + random_below(state, 63));
    dither->cutoff = cutoffs[DRAW(state, cutoffs)];
    dither->still = (uint8_t)random_below(state, 2);
}

/* Every other scene that blends back to front does so in chunks. */
static void draw_slices(golden_scene *golden, const golden_blends *of, uint32_t *state)
{
    golden_slicing *slices = &golden->slices;
    draw_dither(&slices->dither, of, state);
    golden->strip = (uint16_t)(2 + random_below(state, 3));
    golden->piece = (uint16_t)(1 + random_below(state, 4));
    if (slices->blend->direction == GOLDEN_OVER && random_below(state, 2) != 0) {
        slices->front = &of->blend[random_below(state, GOLDEN_FRONTS)];
        slices->chunk = (uint16_t)(1 + random_below(state, 8));
    }
}

void golden_describe(golden_scene *golden, const golden_set *set, uint32_t number)
{
    uint32_t state = number, place = number - set->first;
    *golden = (golden_scene){.render = set->render,
                             .mode = &set->modes[place % set->mode_count],
                             .format = (golden_format)(number % GOLDEN_FORMATS)};
    if (set->blends)
        golden->slices.blend = &set->blends->blend[place % set->blends->count];
    if (set->splats)
        golden->splats.how = &set->splats->splat[place % set->splats->count];
    draw_volume(golden, &state);
    draw_view(golden, &state);
    draw_rect(golden, &state);
    draw_rows(golden, &state);
    if (by_length(golden))
        draw_lengths(golden, &state);
    if (set->blends)
        draw_slices(golden, set->blends, &state);
    if (set->draw)
        set->draw(golden, set, place % set->mode_count, &state);
    golden->seed = state;
}
