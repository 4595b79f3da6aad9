/*
 * A field of 64 x 64 pixels of a fog of one opacity: how much of what it is off lies in low
 * spatial frequencies, which the eye sees, with the dither the same for all pixels and with
 * that of fx_dither_at, which permutes it from pixel to pixel. Powers are squares of levels of 8
 * bits, as they are shown; means over fogs of several opacities and numbers of slices. Printed
 * are the whole power, still and permuted; of the latter what all pixels share (even), what
 * is low, and what would be low of white noise.
 */
#include "check.h"
#include "fx_dither.h"
#include "pixel.h"

#include <math.h>
#include <stdio.h>

#define SIZE      64
#define READ_OUTS 3
#define LOW       4 /* waves over the field, along each axis, that count as low */

/* After so many slices the levels are read. */
static const uint32_t read_outs[READ_OUTS] = {50, 200, 1000};

typedef struct technique {
    ref_pixel_technique is;
    double most_even, most_low; /* permuted: power that all pixels share, and in low frequencies */
} technique;

typedef double field[SIZE][SIZE];

/* fields[r][y][x]: what the level is off after read_outs[r] slices. */
static void render_pixel(field fields[READ_OUTS], uint32_t x, uint32_t y, uint32_t shift,
                         const ref_pixel_technique *by, const ref_pixel_fog *fog)
{
    uint32_t state = 0, n = 0;
    for (unsigned r = 0; r < READ_OUTS; r++) {
        for (; n < read_outs[r]; n++) {
            const ref_moment at = ref_moment_of(by, REF_PIXEL_MIDDLE + n, shift);
            state = by->blend(state, fog, &at);
        }
        fields[r][y][x] = ref_pixel_shown(by, state) - ref_pixel_exact(fog, read_outs[r]);
    }
}

typedef struct powers {
    double even, low, all;
} powers;

/* The power of one wave: |sum of v e^-i(kx x + ky y)|^2 / pixels^2. */
static double power_of(field of, int kx, int ky)
{
    double re = 0, im = 0;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const double angle = 2 * acos(-1) / SIZE * ((kx * x + ky * y) % SIZE);
            re += of[y][x] * cos(angle);
            im -= of[y][x] * sin(angle);
        }
    return (re * re + im * im) / ((double)SIZE * SIZE * SIZE * SIZE);
}

static void add_powers(powers *sums, field of)
{
    for (int ky = -LOW; ky <= LOW; ky++)
        for (int kx = -LOW; kx <= LOW; kx++)
            if (kx != 0 || ky != 0)
                sums->low += power_of(of, kx, ky);
    sums->even += power_of(of, 0, 0);
    for (unsigned y = 0; y < SIZE; y++)
        for (unsigned x = 0; x < SIZE; x++)
            sums->all += of[y][x] * of[y][x] / (SIZE * SIZE);
}

/* All pixels alike: one stands for them. */
static double still_power(const ref_pixel_technique *by, const ref_pixel_fog *fog)
{
    field fields[READ_OUTS];
    double sum = 0;
    render_pixel(fields, 0, 0, 0, by, fog);
    for (unsigned r = 0; r < READ_OUTS; r++)
        sum += fields[r][0][0] * fields[r][0][0];
    return sum;
}

static void add_permuted(powers *sums, const ref_pixel_technique *by, const ref_pixel_fog *fog)
{
    static field fields[READ_OUTS];
    for (uint32_t y = 0; y < SIZE; y++)
        for (uint32_t x = 0; x < SIZE; x++)
            render_pixel(fields, x, y, fx_dither_at(0, x, y, 0), by, fog);
    for (unsigned r = 0; r < READ_OUTS; r++)
        add_powers(sums, fields[r]);
}

static void check_technique(const technique *by)
{
    static const double levels[] = {.03, .1, .25, .5, .75, 1, 1.5, 2.3, 5, 20};
    const unsigned count = sizeof levels / sizeof *levels;
    powers permuted = {0, 0, 0};
    double still = 0;
    for (unsigned i = 0; i < count; i++) {
        const ref_pixel_fog fog = ref_pixel_fog_of(levels[i], 255);
        still += still_power(&by->is, &fog) / (count * READ_OUTS);
        add_permuted(&permuted, &by->is, &fog);
    }
    permuted.even /= count * READ_OUTS;
    permuted.low /= count * READ_OUTS;
    permuted.all /= count * READ_OUTS;
    const double waves = (2 * LOW + 1) * (2 * LOW + 1) - 1;
    const double uneven = fmax(permuted.all - permuted.even, 0);
    printf("# %-24s %9.3f %9.3f %9.3f %9.5f %9.5f\n", by->is.name, still, permuted.all,
           permuted.even, permuted.low, uneven * waves / (SIZE * SIZE - 1));
    if (permuted.even > by->most_even || permuted.low > by->most_low)
        fail_msg("%s: beyond its bounds", by->is.name);
}

static void check_all(const technique *techniques, size_t count)
{
    printf("# %-24s %9s %9s %9s %9s %9s\n", "power", "still", "permuted", "even", "low",
           "if white");
    for (size_t i = 0; i < count; i++)
        check_technique(&techniques[i]);
}

#define CHECK_ALL(techniques) check_all(techniques, sizeof(techniques) / sizeof *(techniques))

/* Of these, plateaus are most of the error, which no permutation spreads. */
static void of_hardware(void **state)
{
    static const technique techniques[] = {
        {{"rounded", ref_pixel_rounded, NULL, 0}, 2839, 1e-9},
        {{"random, hash", ref_pixel_random, fx_dither_hash, 0}, 1490, .006},
        {{"ordered", ref_pixel_ordered, NULL, 0}, 1490, .0001},
        {{"bumped", ref_pixel_bumped, NULL, 0}, 625, .0002},
        {{"corrected, golden ratio", ref_pixel_corrected, fx_dither_golden, 0}, .028, .002},
        {{"corrected, hash", ref_pixel_corrected, fx_dither_hash, 0}, .022, .0075},
        {{"corrected, blocks", ref_pixel_corrected, fx_dither_blocks, 0}, .022, .0025},
    };
    (void)state;
    CHECK_ALL(techniques);
}

static void of_8_bits(void **state)
{
    static const technique techniques[] = {
        {{"8 bits, golden ratio", ref_pixel_8, fx_dither_golden, 0}, .028, .002},
        {{"8 bits, hash", ref_pixel_8, fx_dither_hash, 0}, .022, .0075},
        {{"8 bits, blocks", ref_pixel_8, fx_dither_blocks, 0}, .022, .0025},
    };
    (void)state;
    CHECK_ALL(techniques);
}

/* Read out to nearest, which all pixels share: 1/12 of it is that. */
static void of_more_bits(void **state)
{
    static const technique techniques[] = {
        {{"8.4, blocks", ref_pixel_8_4, fx_dither_blocks, 4}, .045, .0003},
        {{"8.8, golden ratio", ref_pixel_8_8, fx_dither_golden, 8}, .07, .0001},
        {{"8.8, hash", ref_pixel_8_8, fx_dither_hash, 8}, .065, .0001},
        {{"8.8, blocks", ref_pixel_8_8, fx_dither_blocks, 8}, .07, .0001},
        {{"8.16", ref_pixel_8_16, NULL, 16}, .08, 1e-9},
    };
    (void)state;
    CHECK_ALL(techniques);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_hardware),
        cmocka_unit_test(of_8_bits),
        cmocka_unit_test(of_more_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
