/*
 * pixels.c - from light to the bits of a display: read-out, narrower channels, grey and display
 * dither.
 */
#include "search.h"

#include "composite.h"
#include "fx_unorm.h"
#include "pixels.h"

#include <string.h>

#define LEVEL_ONE 16711680u /* 255 * 65536 */

static void tell_number(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "%llu", (unsigned long long)input[0]);
}

/* ---- Read-out ----------------------------------------------------------------------------- */

/* Units of light that sampling leaves, and what reads half of them. */
static const struct {
    double unit;
    uint32_t read_out;
} storages[] = {{65536 * 255. * 255, QV_READ_OUT_8},
                {65535 * 65535., QV_READ_OUT_16},
                {2147483648. * 65535 / 65536, QV_READ_OUT_CONVERTED},
                {255 * 16777216., QV_READ_OUT_ASSOCIATED}};

static double read_out_error(const uint64_t light[], unsigned storage)
{
    const long double half = (long double)storages[storage].unit / 2;
    const uint32_t found = fx_high_product((uint32_t)light[0], storages[storage].read_out);
    if ((long double)light[0] > half)
        return NO_SUCH_INPUT;
    return (double)(found - light[0] / half * LEVEL_ONE);
}

static void measure_read_out(measured *m, unsigned storage)
{
    static const search s = {read_out_error, tell_number, 1, {1u << 31}};
    search_worst(m, &s, storage);
}

/* ---- Narrower channels -------------------------------------------------------------------- */

/* Every level with 16 fraction bits. */
static void measure_level(measured *m, unsigned unused)
{
    (void)unused;
    for (uint32_t v = 0; v <= LEVEL_ONE; v++) {
        const qv_pixel pixel = {{v, v, v, v}, 0, 0};
        uint8_t bytes[4];
        qv_format_rgba8888.store(bytes, 0, 0, &pixel);
        if (measured_add(m, bytes[0] - v / 65536.))
            measured_input(m, "%u", v);
    }
}

static void measure_to8(measured *m, unsigned unused)
{
    (void)unused;
    for (uint32_t a = 0; a <= 65535; a++)
        if (measured_add(m, fx_unorm16_to_unorm8((fx_unorm16)a) - a * 255. / 65535))
            measured_input(m, "%u", a);
}

/* Colour and opacity. */
static double associated_error(const uint64_t input[], unsigned unused)
{
    const uint16_t colour = (uint16_t)input[0], opacity = (uint16_t)input[1];
    const uint16_t entry[4] = {colour, colour, colour, opacity};
    const qv_entries from = {(qv_address)entry, 1, 0, 0, QV_STORAGE_RGBA16};
    uint8_t bytes[4];
    (void)unused;
    (void)qv_opacity_to_associated(bytes, sizeof bytes, &from);
    return bytes[0] - 255. * colour * opacity / (65535. * 65535);
}

static void tell_associated(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "colour %u, opacity %u", (unsigned)input[0], (unsigned)input[1]);
}

static void measure_associated(measured *m, unsigned parameter)
{
    static const search s = {associated_error, tell_associated, 2, {65535, 65535}};
    search_worst(m, &s, parameter);
}

/* ---- Grey, and dither --------------------------------------------------------------------- */

static void tell_colour(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "channels %u, %u, %u", (unsigned)input[0], (unsigned)input[1],
                   (unsigned)input[2]);
}

static double grey_error(const uint64_t input[], unsigned unused)
{
    const qv_pixel pixel = {
        {(uint32_t)input[0], (uint32_t)input[1], (uint32_t)input[2], LEVEL_ONE}, 0, 0};
    uint8_t byte;
    (void)unused;
    qv_format_l8.store(&byte, 0, 0, &pixel);
    return byte - ldexp((double)(77 * input[0] + 150 * input[1] + 29 * input[2]), -24);
}

static void measure_grey(measured *m, unsigned parameter)
{
    static const search s = {grey_error, tell_colour, 3, {LEVEL_ONE, LEVEL_ONE, LEVEL_ONE}};
    search_worst(m, &s, parameter);
}

/* What a channel of such a grey becomes in a pixel: of 1, 4, 5 or 6 bits. */
static unsigned stored(uint32_t v, unsigned bits, uint32_t x, uint32_t y)
{
    const qv_pixel pixel = {{v, v, v, LEVEL_ONE}, x, y};
    uint8_t bytes[2] = {0, 0};
    switch (bits) {
    case 1:
        qv_format_mono_horizontal.store(bytes, 0, 0, &pixel);
        return bytes[0] >> 7;
    case 4:
        qv_format_grey4.store(bytes, 0, 0, &pixel);
        return bytes[0] >> 4;
    default:
        qv_format_rgb565_be.store(bytes, 0, 0, &pixel);
        return bits == 5 ? bytes[0] >> 3 : (bytes[0] & 7u) << 3 | bytes[1] >> 5;
    }
}

static double level_of(uint64_t v, unsigned bits)
{
    return (double)v * ((1u << bits) - 1) / LEVEL_ONE;
}

/* Numbers of an input: the channel, x, y. */
static double dither_error(const uint64_t input[], unsigned bits)
{
    return stored((uint32_t)input[0], bits, (uint32_t)input[1], (uint32_t)input[2]) -
           level_of(input[0], bits);
}

static void tell_dither(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "channel %u at (%u, %u)", (unsigned)input[0], (unsigned)input[1],
                   (unsigned)input[2]);
}

static void measure_dither(measured *m, unsigned bits)
{
    static const search s = {dither_error, tell_dither, 3, {LEVEL_ONE, 7, 7}};
    search_worst(m, &s, bits);
}

/* The mean of 8 x 8 pixels of one channel; every 257th of all of them. */
static void measure_dither_mean(measured *m, unsigned bits)
{
    for (uint32_t v = 0; v <= LEVEL_ONE; v += 257) {
        unsigned sum = 0;
        for (uint32_t place = 0; place < 64; place++)
            sum += stored(v, bits, place % 8, place / 8);
        if (measured_add(m, sum / 64. - level_of(v, bits)))
            measured_input(m, "channel %u", v);
    }
}

/* ---- The chapter -------------------------------------------------------------------------- */

#define READ_OUT(name, storage)                                                                    \
    {                                                                                              \
        "read-out, " name, "u32 to u32.16 levels", "product, to nearest", "2^-16 level", .76, 2,   \
            "search", measure_read_out, storage, NULL                                              \
    }
#define DITHER(bits, format)                                                                       \
    {"dither to u" #bits ", " format,                                                              \
     "u32.16 levels to u" #bits,                                                                   \
     "ordered, 64 thresholds",                                                                     \
     "own level",                                                                                  \
     127 / 128.,                                                                                   \
     2,                                                                                            \
     "search",                                                                                     \
     measure_dither,                                                                               \
     bits,                                                                                         \
     NULL},                                                                                        \
    {                                                                                              \
        "mean of 8 x 8 pixels of u" #bits, "u32.16 levels to u" #bits, "ordered, 64 thresholds",   \
            "own level", 1 / 128., 2, "every 257th channel", measure_dither_mean, bits, NULL       \
    }

static const stage stages[] = {
    READ_OUT("8-bit storage", 0),
    READ_OUT("16-bit storage", 1),
    READ_OUT("extinction of opacities", 2),
    READ_OUT("associated8", 3),
    {"level of 8 bits", "u32.16 levels to u8", "to nearest", "1/255", .5, 2, "all 16711681",
     measure_level, 0, NULL},
    {"unorm8 of unorm16", "unorm16 to unorm8", "to nearest", "1/255", .5, 2, "all 65536",
     measure_to8, 0, NULL},
    {"associated colour of 16 bits", "2 unorm16 to unorm8", "to nearest", "1/255", .5, 2, "search",
     measure_associated, 0, NULL},
    {"grey of 8 bits", "3 u32.16 levels to u8", "to nearest, twice", "1/255", .50001, 2, "search",
     measure_grey, 0, NULL},
    DITHER(6, "G of rgb565"),
    DITHER(5, "R, B of rgb565"),
    DITHER(4, "grey4"),
    DITHER(1, "mono"),
};

const chapter chapter_pixels = {
    "Read-out and pixel formats (SPEC 2.3, 16, 17, 69)",
    "**Read-out.** The product is rounded, by 1/2 of 2^-16, and its constant, by 1/2, which an\n"
    "E of at most 2^31 of 2^32 turns into 1/4; limits and differences with the background's\n"
    "share are products of the same kind.\n\n"
    "**Eight bits.** One rounding to nearest each: 1/2 level. Grey is rounded to 16 fraction\n"
    "bits before: 2^-17 more.\n\n"
    "**Dither.** A level v becomes floor(v + (2 t + 1) / 128), t = 0 .. 63: off by less than\n"
    "127 / 128 of its own level upwards and downwards. Over all t the number of those that\n"
    "round up is 64 times the fraction of v, to nearest: their mean is within 1/128. Grey adds\n"
    "2^-17 of a level of 255 where it comes before; it does not show in these digits.\n",
    stages, COUNT(stages)};
