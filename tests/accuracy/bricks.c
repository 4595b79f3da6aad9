/*
 * Two bricks of a fog that share its slices in every way: how far their combination is from one
 * brick with all of them (the AAP error of Williams et al., sections 2.3 and 7), in percent of
 * that. Opacities of half a level and above, colour 255, 32 phases of the dither.
 */
#include "check.h"
#include "fx_alpha.h"
#include "fx_blend.h"
#include "fx_dither.h"
#include "pixel.h"
#include "qvol.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#define ONE        65536u
#define PHASES     32 /* phase << 27 shifts the dither */
#define SLICES_MAX 1000
#define OPACITIES  100

typedef struct technique {
    ref_pixel_technique is;
    double most[2], aim[2]; /* percent, over 200 and 1000 slices */
} technique;

static const uint32_t counts[2] = {200, 1000};

/* .5 .. 255, evenly by ratio. */
static ref_pixel_fog nth_fog(unsigned i)
{
    return ref_pixel_fog_of(.5 * pow(510, i / (OPACITIES - 1.0)), 255);
}

/* ---- Bricks --------------------------------------------------------------- */

/* Numbers of a brick's slices, in the order in which they are blended. */
typedef struct numbers {
    uint32_t first, step;
} numbers;

static const numbers from_zero = {0, 1};               /* as in the paper */
static const numbers rendered = {REF_PIXEL_MIDDLE, 1}; /* as in the renderer */

/* states[n] after n slices, of which the first is the `skipped`-th of the numbers. */
static void accumulate(uint32_t *states, uint32_t count, const ref_pixel_technique *by,
                       const ref_pixel_fog *fog, numbers numbered, uint32_t skipped, uint32_t phase)
{
    states[0] = 0;
    for (uint32_t n = 0; n < count; n++) {
        const uint32_t index = numbered.first + numbered.step * (skipped + n);
        const ref_moment at = ref_moment_of(by, index, phase << 27);
        states[n + 1] = by->blend(states[n], fog, &at);
    }
}

/* Equation 8 of two levels, exact, as in the paper. */
static double over(double near, double far)
{
    return near + (1 - near / 255) * far;
}

/*
 * A near brick over a far one. States of 8 bits by equation 8; others before they are read out,
 * the near one as if it were a slice, by the blend of the slices. Its light is limited to that
 * of the opacity, which is rounded.
 */
static double combined(const ref_pixel_technique *by, uint32_t near, uint32_t far)
{
    const unsigned fraction = by->fraction;
    const uint32_t opacity32 = fx_opacity_of_level(near << (16 - fraction));
    const uint32_t opacity23 = fx_opacity_q23(opacity32);
    const uint32_t light = near << (23 - fraction), most = fx_light_of_colour(255, opacity23);
    if (fraction == 0)
        return over(near, far);
    if (fraction == 16)
        return fx_blend_8_16(far, light, opacity32, FX_NO_DITHER);
    return fx_blend_dithered(far, light < most ? light : most, opacity23, FX_NO_DITHER, fraction);
}

typedef struct seam {
    double percent, opacity;
} seam;

static void add_error(seam *worst, double combination, uint32_t whole, const ref_pixel_fog *fog)
{
    const double percent = 100 * fabs(combination / whole - 1);
    if (percent > worst->percent) {
        worst->percent = percent;
        worst->opacity = fog->level;
    }
}

/* Both bricks number their slices alike. */
static void add_alike(seam *worst, const ref_pixel_technique *by, const ref_pixel_fog *fog,
                      uint32_t count, numbers numbered)
{
    uint32_t states[SLICES_MAX + 1];
    for (uint32_t phase = 0; phase < PHASES; phase++) {
        accumulate(states, count, by, fog, numbered, 0, phase);
        for (uint32_t n = 0; n <= count; n++)
            add_error(worst, combined(by, states[n], states[count - n]), states[count], fog);
    }
}

/* The near brick's slices have the numbers that they have without bricks. */
static void add_continued(seam *worst, const ref_pixel_technique *by, const ref_pixel_fog *fog,
                          uint32_t count)
{
    uint32_t whole[SLICES_MAX + 1], near[SLICES_MAX + 1];
    for (uint32_t phase = 0; phase < PHASES; phase += 4) {
        accumulate(whole, count, by, fog, rendered, 0, phase);
        for (uint32_t n = 1; n < count; n += 3) {
            accumulate(near, n, by, fog, rendered, count - n, phase);
            add_error(worst, combined(by, near[n], whole[count - n]), whole[count], fog);
        }
    }
}

static bool check_count(const technique *by, unsigned which)
{
    seam published = {0, 0}, alike = {0, 0}, continued = {0, 0};
    const uint32_t count = counts[which];
    for (unsigned i = 0; i < OPACITIES; i++) {
        const ref_pixel_fog fog = nth_fog(i);
        add_alike(&published, &by->is, &fog, count, from_zero);
        add_alike(&alike, &by->is, &fog, count, rendered);
        if (i % 3 == 0)
            add_continued(&continued, &by->is, &fog, count);
    }
    const double worst = fmax(published.percent, fmax(alike.percent, continued.percent));
    printf("# %-20s %6u %8.3f at %5.2f %8.3f at %5.2f %8.3f at %5.2f", by->is.name, count,
           published.percent, published.opacity, alike.percent, alike.opacity, continued.percent,
           continued.opacity);
    if (by->aim[which] > 0)
        printf("   aim %g: %s", by->aim[which],
               worst <= by->aim[which]               ? "reached"
               : published.percent <= by->aim[which] ? "reached from 0"
                                                     : "missed");
    printf("\n");
    return worst <= by->most[which];
}

static void check_all(const technique *techniques, size_t count)
{
    for (size_t i = 0; i < count; i++)
        for (unsigned which = 0; which < 2; which++)
            if (!check_count(&techniques[i], which))
                fail_msg("%s, %u slices: beyond its bound", techniques[i].is.name, counts[which]);
}

static void print_head(void)
{
    printf("# %-20s %6s %17s %17s %17s\n", "AAP error, %, at", "slices", "numbered from 0",
           "as rendered, alike", "numbered on");
}

#define CHECK_ALL(techniques) check_all(techniques, sizeof(techniques) / sizeof *(techniques))

static void of_8_bits(void **state)
{
    static const technique techniques[] = {
        {{"rounded", ref_pixel_rounded, NULL, 0}, {28.1, 49.9}, {0, 0}},
        {{"ordered", ref_pixel_ordered, NULL, 0}, {28.1, 49.9}, {0, 0}},
        {{"bumped", ref_pixel_bumped, NULL, 0}, {30.2, 25}, {0, 0}},
        {{"corrected, golden r.", ref_pixel_corrected, fx_dither_golden, 0}, {4, 1.15}, {3.5, 1}},
        {{"corrected, blocks", ref_pixel_corrected, fx_dither_blocks, 0}, {3.8, 1.4}, {3.5, 1}},
        {{"8 bits, golden ratio", ref_pixel_8, fx_dither_golden, 0}, {4, 1.15}, {3.5, 1}},
        {{"8 bits, hash", ref_pixel_8, fx_dither_hash, 0}, {19.5, 7.6}, {3.5, 1}},
        {{"8 bits, blocks", ref_pixel_8, fx_dither_blocks, 0}, {3.8, 1.4}, {3.5, 1}},
    };
    (void)state;
    print_head();
    CHECK_ALL(techniques);
}

static void of_more_bits(void **state)
{
    static const technique techniques[] = {
        {{"8.4, blocks", ref_pixel_8_4, fx_dither_blocks, 4}, {.55, .16}, {0, 0}},
        {{"8.8, golden ratio", ref_pixel_8_8, fx_dither_golden, 8}, {.04, .02}, {.05, .05}},
        {{"8.8, hash", ref_pixel_8_8, fx_dither_hash, 8}, {.08, .04}, {.05, .05}},
        {{"8.8, blocks", ref_pixel_8_8, fx_dither_blocks, 8}, {.05, .03}, {.05, .05}},
        {{"8.16", ref_pixel_8_16, NULL, 16}, {.001, .001}, {.05, .05}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

/* ---- Chunks --------------------------------------------------------------- */

/*
 * Section 7: each brick is put together from the images of chunks of its slices, with simple
 * dither and one slope, each chunk from slice 0 on. chunk[n] is one of n slices.
 */
static double brick_of_chunks(const uint32_t *chunk, uint32_t size, uint32_t count)
{
    double brick = chunk[count % size];
    for (uint32_t n = size; n <= count; n += size)
        brick = over(brick, chunk[size]);
    return brick;
}

static double seam_of_chunks(double opacity, double slope, uint32_t size, uint32_t count)
{
    const fx_alpha by = {fx_period_of(REF_PIXEL_PERIOD), {(uint32_t)(slope * ONE + .5), ONE}, 255};
    const ref_pixel_fog fog = ref_pixel_fog_of(opacity, 255);
    uint32_t chunk[SLICES_MAX + 1] = {0};
    double worst = 0;
    for (uint32_t n = 0; n < count; n++)
        chunk[n + 1] = fx_blend_plain(chunk[n], 255,
                                      fx_alpha_ordered(&by, fog.opacity, n % REF_PIXEL_PERIOD), 8);
    const double whole = brick_of_chunks(chunk, size, count);
    for (uint32_t n = 0; n <= count; n++) {
        const double near = brick_of_chunks(chunk, size, n);
        const double far = brick_of_chunks(chunk, size, count - n);
        worst = fmax(worst, 100 * fabs(over(near, far) / whole - 1));
    }
    return worst;
}

/* Figures 42 to 54. One chunk of all slices is no chunking. */
static void chunks(void **state)
{
    static const struct {
        double opacity, slope;
        uint32_t count, size;
        double most;
    } figures[] = {
        {.5, .75, 1000, 100, .3},   {.5, .75, 1000, 200, .8},    {.5, .75, 1000, 300, .85},
        {.5, .75, 1000, 400, 2.6},  {.5, .75, 1000, 1000, 49.9}, {.75, .75, 1000, 100, .2},
        {.75, .75, 1000, 200, .6},  {.75, .75, 1000, 300, 2.2},  {.75, .75, 1000, 1000, 49.9},
        {1, .85, 1000, 100, .1},    {1, .85, 1000, 200, .5},     {1, .85, 1000, 300, 2.4},
        {1, .85, 1000, 1000, 49.9}, {1.5, 1, 500, 100, .1},      {1.5, 1, 500, 200, .25},
        {1.5, 1, 500, 300, 1.8},    {1.5, 1, 500, 500, 24.8}};
    (void)state;
    for (unsigned i = 0; i < sizeof figures / sizeof *figures; i++) {
        const double percent =
            seam_of_chunks(figures[i].opacity, figures[i].slope, figures[i].size, figures[i].count);
        printf("# opacity %4.2f, slope %4.2f, %4u slices in chunks of %4u: %6.2f %%\n",
               figures[i].opacity, figures[i].slope, figures[i].count, figures[i].size, percent);
        assert_true(percent <= figures[i].most);
    }
}

/* Dithered blends in chunks, whose slices go on being numbered. bricks[n] has n slices. */
static void dithered_chunks(double *bricks, uint32_t size, uint32_t count, const ref_pixel_fog *fog,
                            uint32_t phase)
{
    static const ref_pixel_technique golden = {"", ref_pixel_8, fx_dither_golden, 0};
    uint32_t state = 0;
    double behind = 0;
    bricks[0] = 0;
    for (uint32_t n = 0; n < count; n++) {
        if (n % size == 0) {
            behind = bricks[n];
            state = 0;
        }
        const ref_moment at = ref_moment_of(&golden, REF_PIXEL_MIDDLE + n, phase << 27);
        state = golden.blend(state, fog, &at);
        bricks[n + 1] = over(state, behind);
    }
}

static double seam_of_dithered_chunks(uint32_t size, uint32_t count)
{
    double bricks[SLICES_MAX + 1], worst = 0;
    for (unsigned i = 0; i < OPACITIES; i++)
        for (uint32_t phase = 0; phase < PHASES; phase++) {
            const ref_pixel_fog fog = nth_fog(i);
            dithered_chunks(bricks, size, count, &fog, phase);
            for (uint32_t n = 0; n <= count; n++) {
                const double both = over(bricks[n], bricks[count - n]);
                worst = fmax(worst, 100 * fabs(both / bricks[count] - 1));
            }
        }
    return worst;
}

/* The same with dithered blends of 8 bits. */
static void chunks_of_dithered_blends(void **state)
{
    static const double most[][3] = {{8, 2.6, .4}, {25, 3.7, .4}, {100, 3.7, .45}, {200, 3.2, .45}};
    (void)state;
    for (unsigned i = 0; i < sizeof most / sizeof *most; i++)
        for (unsigned which = 0; which < 2; which++) {
            const uint32_t size = (uint32_t)most[i][0];
            const double percent = seam_of_dithered_chunks(size, counts[which]);
            printf("# 8 bits, golden ratio, %4u slices in chunks of %3u: %5.2f %%\n", counts[which],
                   size, percent);
            assert_true(percent <= most[i][1 + which]);
        }
}

/* ---- Replay --------------------------------------------------------------- */

static void write_pixel(uint8_t pixel[4], uint32_t level)
{
    for (unsigned c = 0; c < 4; c++)
        pixel[c] = (uint8_t)level;
}

/* A row of all ways of sharing the slices: each becomes the last of the levels. */
static void replay_row(const uint32_t *levels, uint32_t count, uint8_t opacity)
{
    static uint8_t far[4 * (SLICES_MAX + 1)], near[4 * (SLICES_MAX + 1)];
    const size_t bytes = 4 * (count + (size_t)1);
    const qv_buffer behind = {far, NULL, bytes, 0, (ptrdiff_t)bytes, 0, &qv_hardware_rgba8888};
    const qv_buffer front = {near, NULL, bytes, 0, (ptrdiff_t)bytes, 0, &qv_hardware_rgba8888};
    const qv_rect rect = {0, 0, (int32_t)count + 1, 1};
    const uint8_t rgba[4] = {255, 255, 255, opacity};
    for (uint32_t n = 0; n <= count; n++) {
        write_pixel(near + 4 * n, levels[n]);
        write_pixel(far + 4 * n, levels[count - n]);
    }
    assert_int_equal(qv_replay(&behind, &front, rgba, &rect), QV_OK);
    for (size_t i = 0; i < bytes; i++)
        assert_int_equal(far[i], levels[count]);
}

/* Every opacity of 8 bits and every way of sharing: one brick, to the bit. */
static void replay(void **state)
{
    uint32_t levels[SLICES_MAX + 1] = {0};
    (void)state;
    for (uint32_t opacity = 1; opacity <= 255; opacity++) {
        for (uint32_t n = 0; n < SLICES_MAX; n++)
            levels[n + 1] = fx_blend_plain(levels[n], 255, opacity, 8);
        for (unsigned which = 0; which < 2; which++)
            replay_row(levels, counts[which], (uint8_t)opacity);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_8_bits), cmocka_unit_test(of_more_bits),
        cmocka_unit_test(chunks),    cmocka_unit_test(chunks_of_dithered_blends),
        cmocka_unit_test(replay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
