/*
 * stages_buffer.c - pixels of frame buffers: sections 58 to 60.
 */
#include "stages.h"

#include "blend.h"
#include "fx_unorm.h"
#include "pixels.h"

#include <string.h>

enum { BLENDS = 20, TECHNIQUES = 6, PIXEL_BYTES = 12, BESIDE_BYTES = 4 };

/* In the order of the table in section 59. */
static const qv_blend *const blends[BLENDS] = {&qv_over_rgb888,
                                               &qv_over_rgba8888,
                                               &qv_over_rgb888_residual4,
                                               &qv_over_rgba8888_residual4,
                                               &qv_over_rgb888_residual8,
                                               &qv_over_rgba8888_residual8,
                                               &qv_over_rgb565,
                                               &qv_over_rgba12,
                                               &qv_over_rgb16,
                                               &qv_over_rgba16,
                                               &qv_over_rgb24,
                                               &qv_over_rgba24,
                                               &qv_under_rgb888,
                                               &qv_under_rgb16,
                                               &qv_under_rgb24,
                                               &qv_hardware_rgb888,
                                               &qv_hardware_rgb565,
                                               &qv_hardware_rgba8888,
                                               &qv_hardware_rgba12,
                                               &qv_hand_out_rgba8888};

static const qv_technique *const techniques[TECHNIQUES] = {
    &qv_technique_rounded, &qv_technique_random,        &qv_technique_ordered,
    &qv_technique_bumped,  &qv_technique_bumped_random, &qv_technique_corrected};

/* A pixel and what lies beside it, as bytes and as columns. */
typedef struct bytes {
    uint8_t pixel[PIXEL_BYTES], beside[BESIDE_BYTES];
} bytes;

static bytes bytes_of(const uint64_t pixel[PIXEL_BYTES], const uint64_t beside[BESIDE_BYTES])
{
    bytes of;
    for (unsigned i = 0; i < PIXEL_BYTES; i++)
        of.pixel[i] = (uint8_t)pixel[i];
    for (unsigned i = 0; i < BESIDE_BYTES; i++)
        of.beside[i] = (uint8_t)beside[i];
    return of;
}

static void keep_bytes(uint64_t pixel[PIXEL_BYTES], uint64_t beside[BESIDE_BYTES], const bytes *of)
{
    for (unsigned i = 0; i < PIXEL_BYTES; i++)
        pixel[i] = of->pixel[i];
    for (unsigned i = 0; i < BESIDE_BYTES; i++)
        beside[i] = of->beside[i];
}

/* ---- A slice into a pixel --------------------------------------------------- */

typedef struct pixel_blend_row {
    uint64_t blend, light[3], o32, u, technique, k, period, slope[2], cutoff, pixel[PIXEL_BYTES],
        beside[BESIDE_BYTES], after[PIXEL_BYTES], beside_after[BESIDE_BYTES];
} pixel_blend_row;

static void blend_bytes(bytes *of, const pixel_blend_row *row)
{
    const qv_blend *blend = blends[row->blend];
    const qv_fragment fragment = {
        {(uint32_t)row->light[0], (uint32_t)row->light[1], (uint32_t)row->light[2]},
        (uint32_t)row->o32};
    qv_moment moment = {.u = (uint32_t)row->u, .phase = (uint32_t)row->k};
    if (blend->look != NULL) { /* it takes a technique */
        moment.technique = techniques[row->technique];
        moment.alpha.period = fx_period_of((uint32_t)row->period);
        moment.alpha.slope[0] = (uint32_t)row->slope[0];
        moment.alpha.slope[1] = (uint32_t)row->slope[1];
        moment.alpha.cutoff = (uint32_t)row->cutoff;
        qv_moment_opacity(&moment, blend, of->pixel, &fragment);
    }
    blend->blend(of->pixel, of->beside, &fragment, &moment);
}

static unsigned pixel_blend_compute(void *columns)
{
    pixel_blend_row *row = columns;
    bytes of = bytes_of(row->pixel, row->beside);
    blend_bytes(&of, row);
    keep_bytes(row->after, row->beside_after, &of);
    return 0;
}

static void draw_slice(pixel_blend_row *row, vector_random *random)
{
    row->o32 = vector_bits(random, 1) ? vector_bits(random, 32) : vector_any(random, 32);
    for (unsigned c = 0; c < 3; c++)
        row->light[c] = fx_light_of_colour32((uint32_t)vector_any(random, 8), (uint32_t)row->o32);
    row->u = vector_bits(random, 2) ? vector_bits(random, 32) : FX_NO_DITHER;
}

/* A pixel that was cleared, and has seen up to three slices. */
static void draw_pixel(pixel_blend_row *row, vector_random *random)
{
    bytes of = {{0}, {0}};
    qv_fragment background = {{0, 0, 0}, 0x01010101u * (uint32_t)vector_any(random, 8)};
    for (unsigned c = 0; c < 3; c++)
        background.light[c] =
            fx_light_of_colour32((uint32_t)vector_any(random, 8), background.opacity);
    blends[row->blend]->clear(of.pixel, of.beside, &background);
    for (uint64_t slices = vector_bits(random, 2); slices != 0; slices--) {
        draw_slice(row, random);
        blend_bytes(&of, row);
    }
    keep_bytes(row->pixel, row->beside, &of);
}

static void pixel_blend_draw(void *columns, vector_random *random)
{
    static const uint32_t slopes[] = {65536, 49152, 98304};
    pixel_blend_row *row = columns;
    row->blend = (uint64_t)vector_between(random, 0, BLENDS - 1);
    row->technique = (uint64_t)vector_between(random, 0, TECHNIQUES - 1);
    row->period = (uint64_t)vector_between(random, 2, 64);
    row->k = (uint64_t)vector_between(random, 0, (int64_t)row->period - 1);
    row->slope[0] = slopes[vector_between(random, 0, 2)];
    row->slope[1] = slopes[vector_between(random, 0, 2)];
    row->cutoff = vector_bits(random, 2) ? 255 : vector_bits(random, 8);
    draw_pixel(row, random);
    draw_slice(row, random);
}

/* S93: each blend, with each technique where it has one, and slices of opacity 0 and 1. */
static void pixel_blend_edges(vector_set *set)
{
    static const uint64_t opacities[3] = {0x12345678, 0, 0xFFFFFFFF};
    for (unsigned i = 0; i < BLENDS * 3; i++) {
        const unsigned count = blends[i / 3]->look != NULL ? TECHNIQUES : 1;
        for (unsigned technique = 0; technique < count; technique++) {
            const uint64_t o32 = opacities[i % 3];
            pixel_blend_row row = {.blend = i / 3,
                                   .light = {150000000, 77777777, 5},
                                   .o32 = o32,
                                   .u = 0x87654321,
                                   .technique = technique,
                                   .k = 3,
                                   .period = 16,
                                   .slope = {65536, 49152},
                                   .cutoff = 255};
            vector_random random = {i};
            draw_pixel(&row, &random);
            for (unsigned c = 0; c < 3; c++)
                row.light[c] = fx_light_of_colour32(200 >> c, (uint32_t)o32);
            row.o32 = o32;
            row.u = 0x87654321;
            vector_add(set, &row, VECTOR_EDGE);
        }
    }
}

#define BLEND_FIELD                                                                                \
    {                                                                                              \
        "blend", 1, 'i', "u5",                                                                     \
            "0 over_rgb888, 1 over_rgba8888, 2 and 3 these with residual4, 4 and 5 with "          \
            "residual8, 6 over_rgb565, 7 over_rgba12, 8 over_rgb16, 9 over_rgba16, 10 "            \
            "over_rgb24, "                                                                         \
            "11 over_rgba24, 12 under_rgb888, 13 under_rgb16, 14 under_rgb24, 15 "                 \
            "hardware_rgb888, "                                                                    \
            "16 hardware_rgb565, 17 hardware_rgba8888, 18 hardware_rgba12, 19 hand_out_rgba8888"   \
    }

static const vector_field pixel_blend_fields[] = {
    BLEND_FIELD,
    {"light", 3, 'i', "u32.23", "of the slice, channel [i]"},
    {"o32", 1, 'i', "u32.32", "of the slice"},
    {"u", 1, 'i', "u32.32", "dither value"},
    {"technique", 1, 'i', "u3",
     "of blends 15, 16, 17 and 19: 0 rounded, 1 random, 2 ordered, 3 bumped, 4 bumped_random, 5 "
     "corrected"},
    {"k", 1, 'i', "u6", "phase"},
    {"period", 1, 'i', "u7", "P"},
    {"slope", 2, 'i', "u24.16", "s[i]"},
    {"cutoff", 1, 'i', "u8", "level"},
    {"pixel", PIXEL_BYTES, 'i', "u8", "byte [i] of the pixel before; 0 beyond it"},
    {"beside", BESIDE_BYTES, 'i', "u8", "byte [i] beside it; 0 beyond"},
    {"after", PIXEL_BYTES, 'o', "u8", "byte [i] of the pixel after the slice, section 59"},
    {"beside_after", BESIDE_BYTES, 'o', "u8", "byte [i] beside it after the slice"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_pixel_blend = {
    .name = "pixel_blend",
    .section = "58, 59",
    .title = "a slice into a pixel of a frame buffer",
    .rounding = "as the blend has it",
    .saturation = "light at that of the opacity",
    .fields = pixel_blend_fields,
    .columns = VECTOR_COLUMNS(pixel_blend_row),
    .seed = 59,
    .random_rows = 800,
    .edges = pixel_blend_edges,
    .draw = pixel_blend_draw,
    .compute = pixel_blend_compute,
};

/* ---- Clearing and read-out -------------------------------------------------- */

typedef struct pixel_show_row {
    uint64_t blend, background[4], pixel[PIXEL_BYTES], beside[BESIDE_BYTES];
    uint64_t cleared[PIXEL_BYTES], beside_cleared[BESIDE_BYTES], light[3], o32, channel[4];
} pixel_show_row;

static void keep_channels(uint8_t *to, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)column;
    (void)line;
    memcpy(to, pixel->channel, sizeof pixel->channel);
}

static const qv_format channels = {keep_channels, 8 * sizeof(uint32_t[4]), 0};

/* The background of section 16, as a scene has it. */
static void set_background(qv_context *context, const uint64_t background[4])
{
    for (unsigned c = 0; c < 4; c++) {
        uint32_t p = (uint32_t)(background[3] * (c < 3 ? background[c] : 255u));
        context->background[c] = 2u * (257u * p + fx_div255_round(p));
        context->scene.background[c] = (uint8_t)background[c];
    }
}

static unsigned pixel_show_compute(void *columns)
{
    static const qv_rect one = {0, 0, 1, 1};
    static const qv_context none;
    pixel_show_row *row = columns;
    bytes of = bytes_of(row->pixel, row->beside), empty = {{0}, {0}};
    uint32_t channel[4];
    qv_context context = none;
    qv_fragment shown;
    const qv_image image = {channel, sizeof channel, sizeof channel, &channels};
    const qv_buffer buffer = {.pixels = of.pixel,
                              .bytes = PIXEL_BYTES,
                              .stride = PIXEL_BYTES,
                              .beside = of.beside,
                              .beside_bytes = BESIDE_BYTES,
                              .beside_stride = BESIDE_BYTES,
                              .blend = blends[row->blend]};
    set_background(&context, row->background);
    buffer.blend->read(&shown, of.pixel, of.beside);
    if (qv_read_out(&image, &buffer, &context, &one) != QV_OK)
        vector_fail("pixel_show", "buffer", "refused");
    of = empty;
    if (qv_clear(&buffer, &context, &one) != QV_OK)
        vector_fail("pixel_show", "buffer", "refused");
    keep_bytes(row->cleared, row->beside_cleared, &of);
    row->o32 = shown.opacity;
    for (unsigned c = 0; c < 3; c++)
        row->light[c] = shown.light[c];
    for (unsigned c = 0; c < 4; c++)
        row->channel[c] = channel[c];
    return 0;
}

static void pixel_show_draw(void *columns, vector_random *random)
{
    pixel_show_row *row = columns;
    pixel_blend_row drawn;
    memset(&drawn, 0, sizeof drawn);
    pixel_blend_draw(&drawn, random);
    row->blend = drawn.blend;
    memcpy(row->pixel, drawn.pixel, sizeof row->pixel);
    memcpy(row->beside, drawn.beside, sizeof row->beside);
    for (unsigned c = 0; c < 4; c++)
        row->background[c] = vector_any(random, 8);
}

/* Backgrounds that are clear, opaque and between, of each blend. */
static void pixel_show_edges(vector_set *set)
{
    for (unsigned i = 0; i < BLENDS * 3; i++) {
        static const uint64_t opacities[3] = {0, 128, 255};
        pixel_show_row row = {.blend = i / 3, .background = {200, 10, 90, opacities[i % 3]}};
        row.beside[0] = row.beside[1] = row.beside[2] = i / 3 >= 12 && i / 3 < 15 ? 255 : 0;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field pixel_show_fields[] = {
    BLEND_FIELD,
    {"background", 4, 'i', "unorm8", "B[[i]] of section 16"},
    {"pixel", PIXEL_BYTES, 'i', "u8", "byte [i] of a pixel; 0 beyond it"},
    {"beside", BESIDE_BYTES, 'i', "u8", "byte [i] beside it; 0 beyond"},
    {"cleared", PIXEL_BYTES, 'o', "u8", "byte [i] of a pixel that was cleared, section 60"},
    {"beside_cleared", BESIDE_BYTES, 'o', "u8", "byte [i] beside it"},
    {"light", 3, 'o', "u32.23", "that the pixel shows, channel [i]"},
    {"o32", 1, 'o', "u32.32", "that the pixel shows"},
    {"channel", 4, 'o', "u24.16", "channel [i] that the pixel is read out as"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_pixel_show = {
    .name = "pixel_show",
    .section = "60",
    .title = "clearing, and what a pixel of a frame buffer shows",
    .rounding = "to nearest, ties upwards",
    .saturation = "colours at the opacity",
    .fields = pixel_show_fields,
    .columns = VECTOR_COLUMNS(pixel_show_row),
    .seed = 60,
    .random_rows = 400,
    .edges = pixel_show_edges,
    .draw = pixel_show_draw,
    .compute = pixel_show_compute,
};
