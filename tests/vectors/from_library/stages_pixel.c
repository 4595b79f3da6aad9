/*
 * stages_pixel.c - a pixel's channels to the formats of displays: section 17.
 */
#include "stages.h"

#include "composite.h"
#include "pixels.h"

typedef struct pixel_row {
    uint64_t channel[4];
    int64_t x, y;
    uint64_t threshold, grey, rgba8888, bgra8888, rgb888, rgb565_le, rgb565_be, l8, grey4, mono;
} pixel_row;

/* The bytes of a pixel in a format, first byte highest. */
static uint64_t stored(const qv_format *format, const qv_pixel *pixel)
{
    uint8_t bytes[4] = {0, 0, 0, 0};
    uint64_t value = 0;
    format->store(bytes, 0, 0, pixel);
    for (unsigned i = 0; i < (format->bits + 7u) / 8u; i++)
        value = value << 8 | bytes[i];
    return value;
}

/* The threshold t of section 17 as it shows: grey v is 1 of 1 where v >= 130560 (127 - 2 t), so t
   + 1 of the odd multiples of 130560 are. */
static uint64_t threshold_of(qv_pixel pixel)
{
    uint64_t lit = 0;
    for (uint32_t v = 130560; v < 16711680u; v += 261120u) {
        for (unsigned c = 0; c < 3; c++)
            pixel.channel[c] = v;
        lit += stored(&qv_format_mono_horizontal, &pixel) >> 7;
    }
    return lit - 1u;
}

static unsigned pixel_compute(void *columns)
{
    pixel_row *row = columns;
    qv_pixel pixel = {{0, 0, 0, 0}, (uint32_t)row->x, (uint32_t)row->y};
    for (unsigned c = 0; c < 4; c++)
        pixel.channel[c] = (uint32_t)row->channel[c];
    row->threshold = threshold_of(pixel);
    row->grey = (77 * row->channel[0] + 150 * row->channel[1] + 29 * row->channel[2] + 128) / 256;
    row->rgba8888 = stored(&qv_format_rgba8888, &pixel);
    row->bgra8888 = stored(&qv_format_bgra8888, &pixel);
    row->rgb888 = stored(&qv_format_rgb888, &pixel);
    row->rgb565_le = stored(&qv_format_rgb565_le, &pixel);
    row->rgb565_be = stored(&qv_format_rgb565_be, &pixel);
    row->l8 = stored(&qv_format_l8, &pixel);
    row->grey4 = stored(&qv_format_grey4, &pixel) >> 4;
    row->mono = stored(&qv_format_mono_horizontal, &pixel) >> 7;
    return (row->channel[0] & 0xFFFFu) == 0x8000u ? VECTOR_TIE : 0;
}

static void pixel_draw(void *columns, vector_random *random)
{
    pixel_row *row = columns;
    row->channel[3] = vector_any(random, 24) % (QV_LEVEL_ONE + 1u);
    for (unsigned c = 0; c < 3; c++)
        row->channel[c] = vector_any(random, 24) % (row->channel[3] + 1u);
    row->x = vector_between(random, -32767, 32766);
    row->y = vector_between(random, -32767, 32766);
}

/* Each threshold with a channel that it just lifts and one that it just does not; ties of 8
   bits. */
static void pixel_edges(vector_set *set)
{
    for (unsigned i = 0; i < 64; i++) {
        uint64_t reached = (16711680u - 130560u * (2u * i + 1u) + 30u) / 31u;
        const pixel_row row = {.channel = {reached, reached / 2u, reached - 1u, QV_LEVEL_ONE},
                               .x = (int64_t)(i % 8) - 8,
                               .y = i / 8};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (unsigned i = 0; i < 256; i++) {
        uint64_t half = i < 255 ? (uint64_t)i * 65536u + 32768u : QV_LEVEL_ONE;
        const pixel_row row = {.channel = {half, half - 1u, (uint64_t)i * 65536u, half}, .x = i};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Greys on both sides of a half: 77 R + 150 G + 29 B is 256 * 32768 - 129 and one more. */
static void add_greys(vector_set *set)
{
    static const uint64_t colours[][3] = {{0, 11, 289201}, {0, 17, 289170}};
    for (unsigned i = 0; i < sizeof colours / sizeof colours[0]; i++) {
        const pixel_row row = {
            .channel = {colours[i][0], colours[i][1], colours[i][2], QV_LEVEL_ONE}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* The least channel that a threshold lifts to level 1 of `top`, at each place of the pattern. */
static uint64_t lifted(const qv_pixel *pixel, uint64_t top)
{
    return (16711680u - 130560u * (2u * threshold_of(*pixel) + 1u) + top - 1u) / top;
}

static void pixel_added(vector_set *set)
{
    add_greys(set);
    for (uint32_t i = 0; i < 64; i++) {
        const qv_pixel pixel = {{0, 0, 0, 0}, i % 8, i / 8};
        const pixel_row below = {.channel = {lifted(&pixel, 31) - 1u, lifted(&pixel, 63) - 1u,
                                             lifted(&pixel, 31), QV_LEVEL_ONE},
                                 .x = i % 8,
                                 .y = i / 8};
        vector_add(set, &below, VECTOR_EDGE);
    }
}

static const vector_field pixel_fields[] = {
    {"channel", 4, 'i', "u24.16", "channel [i]: levels, at most 16711680"},
    {"x", 1, 'i', "s16", "absolute column"},
    {"y", 1, 'i', "s16", "absolute line"},
    {"threshold", 1, 'm', "u6", "t of the table in section 17, by x mod 8 and y mod 8"},
    {"grey", 1, 'm', "u24.16", "floor((77 channel0 + 150 channel1 + 29 channel2 + 128) / 256)"},
    {"rgba8888", 1, 'o', "u32", "bytes level8(channel 0, 1, 2, 3), the first highest"},
    {"bgra8888", 1, 'o', "u32", "bytes level8(channel 2, 1, 0, 3), the first highest"},
    {"rgb888", 1, 'o', "u24", "bytes level8(channel 0, 1, 2), the first highest"},
    {"rgb565_le", 1, 'o', "u16", "bytes of rgb565_le, the first highest"},
    {"rgb565_be", 1, 'o', "u16",
     "2048 dither(channel0, 31) + 32 dither(channel1, 63) + "
     "dither(channel2, 31), with the threshold"},
    {"l8", 1, 'o', "u8", "floor((grey + 32768) / 65536)"},
    {"grey4", 1, 'o', "u4", "floor((15 grey + 130560 (2 threshold + 1)) / 16711680)"},
    {"mono", 1, 'o', "u1", "floor((grey + 130560 (2 threshold + 1)) / 16711680)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_pixel = {
    .name = "pixel",
    .section = "17",
    .title = "a pixel's channels to the formats of displays",
    .rounding = "8 bits to nearest, ties upwards; narrower ones dithered",
    .saturation = "none",
    .fields = pixel_fields,
    .columns = VECTOR_COLUMNS(pixel_row),
    .seed = 17,
    .random_rows = 300,
    .edges = pixel_edges,
    .added = pixel_added,
    .draw = pixel_draw,
    .compute = pixel_compute,
};
