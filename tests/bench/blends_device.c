/*
 * blends_device.c - instructions of each blend: one measured region (port/measure.h) for
 * each, PIXELS pixels of SLICES slices, blended as qv_slice does it: with the loop, the dither
 * value and the call. The first two are the blends that an engineer would write by hand for 8
 * bits, the third is the dither value of a pixel.
 *
 * Prints a line for each: name, bytes of a pixel and beside it, and a checksum of the results,
 * which is the same on every machine; a bar between them.
 */
#include "buffer.h"
#include "console.h"
#include "measure.h"

enum { PIXELS = 128, SLICES = 4, FRAGMENTS = PIXELS + SLICES };
enum { PIXEL_BYTES_MOST = 12, BESIDE_BYTES_MOST = 4 };

static qv_fragment fragments[FRAGMENTS];
static uint8_t plain_fragments[FRAGMENTS * 4]; /* the same, as bytes: R, G, B not weighted, A */
static uint8_t pixels[PIXELS * PIXEL_BYTES_MOST];
static uint8_t beside[PIXELS * BESIDE_BYTES_MOST];

/* Colours at random; opacities of 1 and below, each octave down to 1/256 as often. */
static void make_fragments(void)
{
    for (uint32_t i = 0; i < FRAGMENTS; i++) {
        uint32_t opacity = ((fx_hash(i) >> 8) + 0xFF000000u) >> (i & 7u);
        uint8_t *plain = plain_fragments + i * 4;
        for (unsigned c = 0; c < 3; c++) {
            plain[c] = (uint8_t)(fx_hash(i + FRAGMENTS * (c + 1u)) >> 24);
            fragments[i].light[c] = fx_light_of_colour(plain[c], fx_opacity_q23(opacity));
        }
        fragments[i].opacity = opacity;
        plain[3] = (uint8_t)(opacity >> 24);
    }
}

static uint32_t checksum(const uint8_t *bytes, unsigned count)
{
    uint32_t sum = 0;
    while (count-- != 0)
        sum = sum * 31u + *bytes++;
    return sum;
}

static void report(const char *name, unsigned bytes, unsigned beside_bytes, uint32_t sum)
{
    console_text(name);
    console_text("|");
    console_decimal(bytes);
    console_text("|");
    console_decimal(beside_bytes);
    console_text("|");
    console_decimal(sum);
    console_text("\n");
}

/* ---- By hand ---------------------------------------------------------------- */

/* Equation 1, exactly rounded. */
static inline uint8_t mixed(uint32_t to, uint32_t from, uint32_t opacity, uint32_t rest)
{
    uint32_t sum = from * opacity + to * rest + 128u;
    return (uint8_t)((sum + (sum >> 8)) >> 8);
}

/* A row of R, G, B blended with a row of R, G, B, A. */
static void blend_by_hand(uint8_t *to, const uint8_t *from, unsigned count)
{
    for (; count != 0; count--, to += 3, from += 4) {
        uint32_t opacity = from[3], rest = 255u - opacity;
        to[0] = mixed(to[0], from[0], opacity, rest);
        to[1] = mixed(to[1], from[1], opacity, rest);
        to[2] = mixed(to[2], from[2], opacity, rest);
    }
}

/* The same with accumulated opacity, equations 6 and 7; R, G, B weighted by A. */
static void blend_by_hand_rgba(uint8_t *to, const uint8_t *from, unsigned count)
{
    for (; count != 0; count--, to += 4, from += 4) {
        uint32_t rest = 255u - from[3];
        to[0] = (uint8_t)(from[0] + mixed(to[0], 0, 0, rest));
        to[1] = (uint8_t)(from[1] + mixed(to[1], 0, 0, rest));
        to[2] = (uint8_t)(from[2] + mixed(to[2], 0, 0, rest));
        to[3] = (uint8_t)(from[3] + mixed(to[3], 0, 0, rest));
    }
}

static void measure_by_hand(void)
{
    measure_begin();
    for (unsigned slice = 0; slice < SLICES; slice++)
        blend_by_hand(pixels, plain_fragments + slice * 4, PIXELS);
    measure_end();
    report("by_hand_rgb", 3, 0, checksum(pixels, PIXELS * 3));
    measure_begin();
    for (unsigned slice = 0; slice < SLICES; slice++)
        blend_by_hand_rgba(pixels, plain_fragments + slice * 4, PIXELS);
    measure_end();
    report("by_hand_rgba", 4, 0, checksum(pixels, PIXELS * 4));
}

/* ---- Blends ----------------------------------------------------------------- */

static qv_moment moment_of(const qv_dither *dither, const qv_blend *blend, unsigned slice)
{
    qv_moment moment;
    if (qv_moment_of(&moment, dither, blend, (int32_t)slice) != QV_OK)
        console_text("the dither is refused\n");
    return moment;
}

/* A slice of one row, as qv_slice and qv_combine go along it; a function of its own, so that
   what surrounds it does not cost it registers. */
static __attribute__((noinline)) void blend_slice(const qv_buffer *row, const qv_moment *slice,
                                                  const qv_fragment *fragment)
{
    const qv_rect rect = {0, 0, PIXELS, 1};
    const qv_blend *blend = row->blend;
    qv_place place = qv_place_of(row, slice, &rect, 0);
    qv_moment moment = *slice;
    uint32_t step = qv_dither_step(slice->spread);
    for (unsigned x = 0; x < PIXELS; x++) {
        qv_place_blend(&place, blend, fragment++, &moment);
        qv_place_next(&place, blend, step);
    }
}

static void measure_blend(const char *name, const qv_blend *blend, const qv_technique *technique)
{
    const qv_fragment black = {{0, 0, 0}, 0};
    const qv_dither dither = {.sequence = qv_sequence_blocks, .technique = technique, .period = 16};
    const qv_buffer row = {pixels, beside, sizeof pixels, sizeof beside, 0, 0, blend};
    qv_moment moments[SLICES];
    for (unsigned slice = 0; slice < SLICES; slice++)
        moments[slice] = moment_of(&dither, blend, slice);
    for (unsigned x = 0; x < PIXELS; x++) {
        uint8_t *pixel = pixels + x * QV_FIELD(blend, bytes);
        QV_FIELD(blend, clear)(pixel, beside + x * QV_FIELD(blend, beside), &black);
    }
    measure_begin();
    for (unsigned slice = 0; slice < SLICES; slice++)
        blend_slice(&row, &moments[slice], fragments + slice);
    measure_end();
    report(name, QV_FIELD(blend, bytes), QV_FIELD(blend, beside),
           checksum(pixels, (unsigned)PIXELS * QV_FIELD(blend, bytes)) +
               checksum(beside, (unsigned)PIXELS * QV_FIELD(blend, beside)));
}

int main(void)
{
    static const struct {
        const char *name;
        const qv_blend *blend;
        const qv_technique *technique;
    } subjects[] = {
        {"over_rgb888", &qv_over_rgb888, 0},
        {"over_rgba8888", &qv_over_rgba8888, 0},
        {"over_rgb888_residual4", &qv_over_rgb888_residual4, 0},
        {"over_rgba8888_residual4", &qv_over_rgba8888_residual4, 0},
        {"over_rgb888_residual8", &qv_over_rgb888_residual8, 0},
        {"over_rgba8888_residual8", &qv_over_rgba8888_residual8, 0},
        {"over_rgb565", &qv_over_rgb565, 0},
        {"over_rgba12", &qv_over_rgba12, 0},
        {"over_rgb16", &qv_over_rgb16, 0},
        {"over_rgba16", &qv_over_rgba16, 0},
        {"over_rgb24", &qv_over_rgb24, 0},
        {"over_rgba24", &qv_over_rgba24, 0},
        {"under_rgb888", &qv_under_rgb888, 0},
        {"under_rgb16", &qv_under_rgb16, 0},
        {"under_rgb24", &qv_under_rgb24, 0},
        {"hardware_rgb888 rounded", &qv_hardware_rgb888, &qv_technique_rounded},
        {"hardware_rgba8888 rounded", &qv_hardware_rgba8888, &qv_technique_rounded},
        {"hardware_rgba8888 random", &qv_hardware_rgba8888, &qv_technique_random},
        {"hardware_rgba8888 ordered", &qv_hardware_rgba8888, &qv_technique_ordered},
        {"hardware_rgba8888 bumped", &qv_hardware_rgba8888, &qv_technique_bumped},
        {"hardware_rgba8888 corrected", &qv_hardware_rgba8888, &qv_technique_corrected},
        {"hardware_rgb565 rounded", &qv_hardware_rgb565, &qv_technique_rounded},
        {"hardware_rgba12 rounded", &qv_hardware_rgba12, &qv_technique_rounded},
        {"hand_out_rgba8888 ordered", &qv_hand_out_rgba8888, &qv_technique_ordered},
    };
    make_fragments();
    measure_by_hand();
    for (unsigned i = 0; i < sizeof subjects / sizeof *subjects; i++)
        measure_blend(subjects[i].name, subjects[i].blend, subjects[i].technique);
    return 0;
}
