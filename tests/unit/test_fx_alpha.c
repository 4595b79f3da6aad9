/*
 * Opacities of 8 bits by each technique: against exact fractions, and what they stand for
 * after a rounded blend.
 */
#include "check.h"
#include "fx_alpha.h"
#include "fx_blend.h"
#include "random.h"

#define OPAQUE     (255u * 65536u)
#define ONE        65536u
#define PERIOD_MAX 64u

static fx_alpha plain_of(uint32_t slices)
{
    const fx_alpha of = {fx_period_of(slices), {ONE, ONE}, 255};
    return of;
}

/* Levels as they come, and the ends. */
static uint32_t random_opacity(uint32_t *seed)
{
    const uint32_t v = random_next(seed);
    switch (v & 15u) {
    case 0:
        return 0;
    case 1:
        return OPAQUE;
    case 2:
        return OPAQUE - (v >> 20);
    default:
        return random_below(seed, OPAQUE + 1) >> (v >> 4 & 15u);
    }
}

/* round(opacity * slope), ties upwards, at most 1. */
static uint32_t multiplied(uint32_t opacity, uint32_t slope)
{
    const uint64_t product = ((uint64_t)opacity * slope + 32768) >> 16;
    return product < OPAQUE ? (uint32_t)product : OPAQUE;
}

static void rounded(void **state)
{
    (void)state;
    for (uint32_t opacity = 0; opacity <= OPAQUE; opacity += 37)
        assert_int_equal(fx_alpha_rounded(opacity), (opacity / 32768 + 1) / 2);
    assert_int_equal(fx_alpha_rounded(32767), 0);
    assert_int_equal(fx_alpha_rounded(32768), 1);
    assert_int_equal(fx_alpha_rounded(OPAQUE), 255);
}

/* ---- Simple dither -------------------------------------------------------- */

static void check_simple(const fx_alpha *of, uint32_t opacity)
{
    const uint32_t slices = of->period.slices, wanted = multiplied(opacity, of->slope[0]);
    const uint32_t base = wanted >> 16, hits = fx_hits(&of->period, wanted, base, 1);
    uint32_t sum = 0;
    for (uint32_t k = 0; k < slices; k++) {
        const uint32_t u = (uint32_t)(((uint64_t)(2 * k + 1) << 31) / slices);
        sum += fx_alpha_ordered(of, opacity, k);
        assert_int_equal(fx_alpha_ordered(of, opacity, k),
                         base + fx_hit_ordered(&of->period, hits, k));
        assert_int_equal(fx_alpha_random(of, opacity, u), base + (k < hits));
    }
    assert_int_equal(sum, slices * base + hits);
}

/* Every period; without a slope, with less and with more than opacity 1 can take. */
static void simple_dither(void **state)
{
    uint32_t seed = 5;
    (void)state;
    for (uint32_t slices = 2; slices <= PERIOD_MAX; slices++) {
        fx_alpha of = plain_of(slices);
        for (uint32_t i = 0; i < 900; i++) {
            of.slope[0] = i % 3 == 0 ? ONE : random_below(&seed, i % 3 == 1 ? 2 * ONE : 1u << 24);
            check_simple(&of, random_opacity(&seed));
        }
        of.slope[0] = ONE;
        check_simple(&of, 0);
        check_simple(&of, OPAQUE);
        check_simple(&of, OPAQUE - 1);
    }
}

/* Opacity 1 and 0 stay what they are in all slices. */
static void ends(void **state)
{
    const fx_alpha of = plain_of(32);
    (void)state;
    for (uint32_t value = 0; value < 256; value++)
        for (uint32_t k = 0; k < 32; k++) {
            const uint32_t u = k << 27 | 0x07FFFFFFu;
            assert_int_equal(fx_alpha_random(&of, 0, u), 0);
            assert_int_equal(fx_alpha_ordered(&of, 0, k), 0);
            assert_int_equal(fx_alpha_bumped(&of, 0, k, value), 0);
            assert_int_equal(fx_alpha_bumped_random(&of, 0, u, value), 0);
            assert_int_equal(fx_alpha_random(&of, OPAQUE, u), 255);
            assert_int_equal(fx_alpha_ordered(&of, OPAQUE, k), 255);
            assert_int_equal(fx_alpha_bumped(&of, OPAQUE, k, value), 255);
            assert_int_equal(fx_alpha_bumped_random(&of, OPAQUE, u, value), 255);
        }
}

/* Opacities above the cutoff are rounded, whatever the slope; those up to it are not. */
static void cutoff(void **state)
{
    fx_alpha of = {fx_period_of(4), {ONE / 2, ONE / 2}, 3};
    (void)state;
    for (uint32_t k = 0; k < 4; k++) {
        const uint32_t u = k << 30;
        assert_int_equal(fx_alpha_ordered(&of, 3 * ONE + 1, k), 3);
        assert_int_equal(fx_alpha_random(&of, 3 * ONE + 32768, u), 4);
        assert_int_equal(fx_alpha_bumped(&of, 40 * ONE + 1, k, 200), 40);
        assert_int_equal(fx_alpha_bumped_random(&of, 40 * ONE + 1, u, 200), 40);
        assert_int_equal(fx_alpha_ordered(&of, 3 * ONE, k), 1 + k % 2);
        assert_int_equal(fx_alpha_random(&of, 3 * ONE, u), k < 2 ? 2 : 1);
        assert_int_equal(fx_alpha_bumped(&of, 3 * ONE, k, 0), 1 + k % 2);
        assert_int_equal(fx_alpha_bumped_random(&of, 3 * ONE, u, 0), k < 2 ? 2 : 1);
    }
    of.cutoff = 0;
    assert_int_equal(fx_alpha_ordered(&of, 32767, 3), 0);
    assert_int_equal(fx_alpha_ordered(&of, 32768, 0), 1);
}

/* ---- Bumps ---------------------------------------------------------------- */

static void check_bumped(const fx_alpha *of, uint32_t opacity, uint32_t value)
{
    const uint32_t slices = of->period.slices;
    const uint32_t knee = fx_plateau(opacity < 2 * ONE ? 1 : opacity >> 16, 255);
    const uint32_t wanted = multiplied(opacity, of->slope[value >= knee]);
    const uint32_t base = wanted >> 16, bump = fx_bump(value, base);
    const uint32_t hits = fx_hits(&of->period, wanted, base, bump);
    for (uint32_t k = 0; k < slices; k++) {
        const uint32_t u = (uint32_t)(((uint64_t)(2 * k + 1) << 31) / slices);
        assert_int_equal(fx_alpha_bumped(of, opacity, k, value),
                         base + fx_hit_ordered(&of->period, hits, k) * bump);
        assert_int_equal(fx_alpha_bumped_random(of, opacity, u, value), base + (k < hits) * bump);
    }
}

/* Every period and value. The knee as in section 4: plateau(1) up to opacity 1, else that
   of the opacity's whole part. */
static void exponential_bumps(void **state)
{
    uint32_t seed = 6;
    (void)state;
    for (uint32_t slices = 2; slices <= PERIOD_MAX; slices++) {
        fx_alpha of = plain_of(slices);
        for (uint32_t value = 0; value < 256; value++) {
            of.slope[0] = random_below(&seed, 2 * ONE);
            of.slope[1] = random_below(&seed, 2 * ONE);
            check_bumped(&of, random_opacity(&seed), value);
            check_bumped(&of, random_below(&seed, 3 * ONE), value);
        }
    }
}

/*
 * What bumps are for: the rounded blend of some slices of a period raises the value. From 253 on
 * the bump is 127, and .5 * 64 / 127 hits are none.
 */
static void bumps_overcome_plateaus(void **state)
{
    const fx_alpha of = plain_of(64);
    (void)state;
    for (uint32_t value = 0; value < fx_plateau(63, 255); value++) {
        uint32_t most = 0;
        for (uint32_t k = 0; k < 64; k++) {
            const uint32_t opacity = fx_alpha_bumped(&of, 5 * ONE / 2, k, value);
            most = opacity > most ? opacity : most;
        }
        assert_true(fx_blend_plain(value, 255, most, 8) > value);
    }
}

/* ---- Corrected ------------------------------------------------------------ */

static uint32_t distance(uint32_t a, uint32_t b)
{
    return a < b ? b - a : a - b;
}

/* By trying all opacities: that nearest to the rounded one which gives the wanted state. */
static uint32_t nearest_that_gives(uint32_t wanted, uint32_t colour, uint32_t value,
                                   uint32_t opacity)
{
    uint32_t best = 1000;
    for (uint32_t a = 0; a < 256; a++)
        if (fx_blend_plain(value, colour, a, 8) == wanted &&
            distance(a, opacity) < distance(best, opacity))
            best = a;
    return best;
}

static void check_corrected(uint32_t opacity, uint32_t colour, uint32_t value, uint32_t u)
{
    const uint32_t q23 = fx_opacity_q23(fx_opacity_of_level(opacity));
    const uint32_t wanted = fx_blend_dithered(value, colour * q23, q23, u, 0);
    const uint32_t own = fx_alpha_corrected(opacity, colour, value, u);
    if (own != nearest_that_gives(wanted, colour, value, fx_alpha_rounded(opacity)))
        fail_msg("opacity %u, colour %u over %u, u %u: %u", opacity, colour, value, u, own);
}

/* Every colour and value, at the least and the greatest u too. */
static void corrected_opacities(void **state)
{
    uint32_t seed = 8;
    (void)state;
    for (uint32_t colour = 0; colour < 256; colour++)
        for (uint32_t value = 0; value < 256; value++) {
            check_corrected(random_opacity(&seed), colour, value, 0);
            check_corrected(random_opacity(&seed), colour, value, UINT32_MAX);
            for (unsigned i = 0; i < 4; i++)
                check_corrected(random_opacity(&seed), colour, value, random_next(&seed));
            assert_int_equal(fx_alpha_corrected(0, colour, value, random_next(&seed)), 0);
            assert_int_equal(fx_alpha_corrected(OPAQUE, colour, value, random_next(&seed)), 255);
        }
}

/* Where the value has the colour already, no opacity changes it: the rounded one is taken. */
static void nothing_to_correct(void **state)
{
    uint32_t seed = 9;
    (void)state;
    for (uint32_t colour = 0; colour < 256; colour++) {
        const uint32_t opacity = random_opacity(&seed);
        assert_int_equal(fx_alpha_corrected(opacity, colour, colour, random_next(&seed)),
                         fx_alpha_rounded(opacity));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rounded),
        cmocka_unit_test(simple_dither),
        cmocka_unit_test(ends),
        cmocka_unit_test(cutoff),
        cmocka_unit_test(exponential_bumps),
        cmocka_unit_test(bumps_overcome_plateaus),
        cmocka_unit_test(corrected_opacities),
        cmocka_unit_test(nothing_to_correct),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
