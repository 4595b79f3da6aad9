/*
 * Pixel formats: bytes of each, neighbours left alone, rounding, and the dither.
 */
#include "check.h"
#include "pixels.h"
#include "random.h"

#include <string.h>

#define LEVEL 65536u         /* one of 255 */
#define FULL  (255u * LEVEL) /* 1 */

enum { FORMATS = 9 };
static const qv_format *const formats[FORMATS] = {
    &qv_format_rgba8888,  &qv_format_bgra8888,        &qv_format_rgb888,
    &qv_format_rgb565_le, &qv_format_rgb565_be,       &qv_format_l8,
    &qv_format_grey4,     &qv_format_mono_horizontal, &qv_format_mono_vertical};

static qv_pixel pixel_of(uint32_t r, uint32_t g, uint32_t b, uint32_t a)
{
    const qv_pixel pixel = {{r * LEVEL, g * LEVEL, b * LEVEL, a * LEVEL}, 0, 0};
    return pixel;
}

static qv_pixel grey_at(uint32_t channel, uint32_t x, uint32_t y)
{
    const qv_pixel pixel = {{channel, channel, channel, FULL}, x, y};
    return pixel;
}

/* ---- Bytes ---- */

/* The third pixel of a row, at threshold 0, so that narrow channels round down:
   24.3 of 31, 24.7 of 63, 6.1 of 31; grey 124.4 of 255, 7.3 of 15. */
static void every_format_in_bytes(void **state)
{
    static const uint8_t expected[FORMATS][12] = {
        {0, 0, 0, 0, 0, 0, 0, 0, 200, 100, 50, 220},
        {0, 0, 0, 0, 0, 0, 0, 0, 50, 100, 200, 220},
        {0, 0, 0, 0, 0, 0, 200, 100, 50},
        {0, 0, 0, 0, 0x06, 0xC3},
        {0, 0, 0, 0, 0xC3, 0x06},
        {0, 0, 124},
        {0, 0x70},
        {0},
        {0},
    };
    const qv_pixel pixel = pixel_of(200, 100, 50, 220);
    (void)state;

    for (unsigned i = 0; i < FORMATS; i++) {
        uint8_t row[12] = {0};
        formats[i]->store(row, 2, 0, &pixel);
        assert_memory_equal(row, expected[i], sizeof row);
    }
}

static void grey_has_its_weights(void **state)
{
    static const uint8_t expected[5] = {77, 149, 29, 255, 0}; /* 76.7, 149.4, 28.9 */
    const qv_pixel pixels[5] = {pixel_of(255, 0, 0, 255), pixel_of(0, 255, 0, 255),
                                pixel_of(0, 0, 255, 255), pixel_of(255, 255, 255, 255),
                                pixel_of(0, 0, 0, 255)};
    (void)state;

    for (unsigned i = 0; i < 5; i++) {
        uint8_t byte = 1;
        qv_format_l8.store(&byte, 0, 0, &pixels[i]);
        assert_int_equal(byte, expected[i]);
    }
}

/* On both sides of the middle between two levels, of which the upper one has it. */
static void channels_of_8_bits_round_to_nearest(void **state)
{
    (void)state;

    for (uint32_t level = 0; level < 255; level++) {
        const uint32_t middle = level * LEVEL + LEVEL / 2;
        for (unsigned i = 0; i < 3; i++) {
            const qv_pixel low = grey_at(middle - 1, 0, 0), high = grey_at(middle, 0, 0);
            uint8_t bytes[4];
            formats[i]->store(bytes, 0, 0, &low);
            assert_int_equal(bytes[1], level);
            formats[i]->store(bytes, 0, 0, &high);
            assert_int_equal(bytes[1], level + 1);
        }
    }
}

/* ---- Neighbours ---- */

/* Bits of a row that belong to a pixel. */
static void mask_of(uint8_t mask[8], const qv_format *format, unsigned column, unsigned line)
{
    memset(mask, 0, 8);
    for (unsigned bit = 0; bit < format->bits; bit++) {
        const unsigned at = column * format->bits + bit;
        mask[at / 8] |= (uint8_t)(0x80u >> at % 8);
    }
    if (format == &qv_format_mono_vertical)
        mask[column] = (uint8_t)(1u << line);
}

/* White on black and black on white, of every pixel among the first eight bytes. */
static void neighbours_keep_their_bits(void **state)
{
    const qv_pixel black = pixel_of(0, 0, 0, 0), white = pixel_of(255, 255, 255, 255);
    (void)state;

    for (unsigned i = 0; i < FORMATS; i++) {
        const unsigned lines = 1u << formats[i]->line_shift;
        for (unsigned column = 0; column < 64u / formats[i]->bits; column++)
            for (unsigned line = 0; line < lines; line++) {
                uint8_t mask[8], on[8], off[8], inverse[8];
                mask_of(mask, formats[i], column, line);
                for (unsigned b = 0; b < 8; b++)
                    inverse[b] = (uint8_t)~mask[b];
                memset(on, 0, 8);
                memset(off, 255, 8);
                formats[i]->store(on, column, line + lines, &white); /* of the next row of bytes */
                formats[i]->store(off, column, line, &black);
                assert_memory_equal(on, mask, 8);
                assert_memory_equal(off, inverse, 8);
            }
    }
}

/* The left pixel of 4 bits in the high ones, 8 pixels from the MSB, 8 rows from
   the LSB. */
static void bits_lie_as_documented(void **state)
{
    const qv_pixel black = pixel_of(0, 0, 0, 255), white = pixel_of(255, 255, 255, 255);
    uint8_t byte = 0;
    (void)state;

    qv_format_grey4.store(&byte, 0, 0, &white);
    assert_int_equal(byte, 0xF0);
    qv_format_grey4.store(&byte, 1, 0, &white);
    qv_format_grey4.store(&byte, 0, 0, &black);
    assert_int_equal(byte, 0x0F);
    byte = 0;
    qv_format_mono_horizontal.store(&byte, 0, 5, &white);
    assert_int_equal(byte, 0x80);
    byte = 0;
    qv_format_mono_vertical.store(&byte, 0, 0, &white);
    assert_int_equal(byte, 0x01);
    qv_format_mono_vertical.store(&byte, 0, 7, &white);
    assert_int_equal(byte, 0x81);
}

/* ---- Dither ---- */

/* The level of a narrow grey pixel, 0 .. 15 or 0 .. 1. */
static uint32_t level_of(const qv_format *format, const qv_pixel *pixel)
{
    uint8_t byte = 0;
    format->store(&byte, 0, 0, pixel);
    if (format == &qv_format_grey4)
        return byte >> 4;
    return format == &qv_format_mono_horizontal ? byte >> 7 : byte;
}

/* Of greys n/64 those with n + t >= 64 are lit, t of them among 1 .. 63. */
static uint32_t threshold_at(uint32_t x, uint32_t y)
{
    uint32_t lit = 0;
    for (uint32_t n = 1; n < 64; n++) {
        const qv_pixel pixel = grey_at(n * (FULL / 64), x, y);
        lit += level_of(&qv_format_mono_horizontal, &pixel);
    }
    return lit;
}

/* Bayer 1973. */
static void thresholds_are_the_ordered_pattern(void **state)
{
    static const uint8_t bayer[8][8] = {
        {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
        {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
        {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
        {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21}};
    (void)state;

    for (uint32_t y = 0; y < 8; y++)
        for (uint32_t x = 0; x < 8; x++)
            assert_int_equal(threshold_at(x, y), bayer[y][x]);
}

/* Every tile, also to the left of and above the frame, holds each threshold once. */
static void every_tile_is_a_permutation(void **state)
{
    (void)state;

    for (int32_t top = -24; top <= 24; top += 8)
        for (int32_t left = -24; left <= 24; left += 8) {
            uint64_t seen = 0;
            for (int32_t i = 0; i < 64; i++)
                seen |= UINT64_C(1)
                        << threshold_at((uint32_t)(left + i % 8), (uint32_t)(top + i / 8));
            assert_true(seen == UINT64_MAX);
        }
}

/* Black and full scale at every position. */
static void both_ends_are_exact(void **state)
{
    static const uint8_t white[FORMATS][4] = {{255, 255, 255, 255},
                                              {255, 255, 255, 255},
                                              {255, 255, 255},
                                              {255, 255},
                                              {255, 255},
                                              {255},
                                              {0xF0},
                                              {0x80},
                                              {0x01}};
    static const uint8_t black[4] = {0, 0, 0, 0};
    (void)state;

    for (unsigned i = 0; i < FORMATS; i++)
        for (uint32_t position = 0; position < 64; position++) {
            uint8_t bytes[4] = {0};
            qv_pixel pixel = {{0, 0, 0, 0}, position % 8, position / 8};
            formats[i]->store(bytes, 0, 0, &pixel);
            assert_memory_equal(bytes, black, 4);
            pixel.channel[0] = pixel.channel[1] = pixel.channel[2] = pixel.channel[3] = FULL;
            formats[i]->store(bytes, 0, 0, &pixel);
            assert_memory_equal(bytes, white[i], 4);
        }
}

/* The sum of a tile is 64 times the level, to nearest: its mean is the level. */
static void expect_mean(const qv_format *format, uint32_t top, uint32_t channel)
{
    const uint64_t twice = (uint64_t)channel * top * 128;
    uint32_t sum = 0;
    for (uint32_t i = 0; i < 64; i++) {
        const qv_pixel pixel = grey_at(channel, i % 8, i / 8);
        sum += level_of(format, &pixel);
    }
    assert_int_equal(sum, (twice + FULL) / (2 * FULL));
}

static void the_mean_of_dithered_grey_is_its_level(void **state)
{
    uint32_t seed = 1;
    (void)state;

    for (uint32_t i = 0; i <= 4000; i++) {
        const uint32_t channel = i <= 255 ? i * LEVEL : random_below(&seed, FULL + 1);
        expect_mean(&qv_format_grey4, 15, channel);
        expect_mean(&qv_format_mono_horizontal, 1, channel);
        expect_mean(&qv_format_mono_vertical, 1, channel);
    }
}

static uint32_t rgb565_at(const qv_pixel *pixel)
{
    uint8_t bytes[2];
    qv_format_rgb565_be.store(bytes, 0, 0, pixel);
    return (uint32_t)bytes[0] << 8 | bytes[1];
}

/* The same of each channel of 5 or 6 bits. */
static void the_mean_of_dithered_colour_is_its_level(void **state)
{
    static const uint32_t top[3] = {31, 63, 31};
    static const unsigned shift[3] = {11, 5, 0};
    uint32_t seed = 2;
    (void)state;

    for (uint32_t i = 0; i < 1000; i++) {
        uint32_t sum[3] = {0, 0, 0};
        qv_pixel pixel = {{0, 0, 0, FULL}, 0, 0};
        for (unsigned c = 0; c < 3; c++)
            pixel.channel[c] = random_below(&seed, FULL + 1);
        for (uint32_t position = 0; position < 64; position++) {
            pixel.x = position % 8;
            pixel.y = position / 8;
            for (unsigned c = 0; c < 3; c++)
                sum[c] += rgb565_at(&pixel) >> shift[c] & top[c];
        }
        for (unsigned c = 0; c < 3; c++)
            assert_int_equal(sum[c],
                             ((uint64_t)pixel.channel[c] * top[c] * 128 + FULL) / (2 * FULL));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_in_bytes),
        cmocka_unit_test(grey_has_its_weights),
        cmocka_unit_test(channels_of_8_bits_round_to_nearest),
        cmocka_unit_test(neighbours_keep_their_bits),
        cmocka_unit_test(bits_lie_as_documented),
        cmocka_unit_test(thresholds_are_the_ordered_pattern),
        cmocka_unit_test(every_tile_is_a_permutation),
        cmocka_unit_test(both_ends_are_exact),
        cmocka_unit_test(the_mean_of_dithered_grey_is_its_level),
        cmocka_unit_test(the_mean_of_dithered_colour_is_its_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
