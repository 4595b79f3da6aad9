/*
 * Dither values, and alpha dithering against exact fractions and the paper's figures.
 */
#include "check.h"
#include "fx_dither.h"
#include "hash_inverse.h"
#include "random.h"

#include <math.h>

#define SLICES_MAX 64

/* ---- Dither values -------------------------------------------------------- */

static void hash_is_a_bijection(void **state)
{
    uint32_t seed = 7;
    (void)state;
    assert_int_equal(fx_hash(0), 0);
    for (uint32_t i = 0; i < 1000000; i++) {
        const uint32_t v = i & 1 ? random_next(&seed) : i;
        assert_int_equal(hash_inverse(fx_hash(v)), v);
    }
}

/* A change of one bit changes each bit of the hash in about half of all cases. */
static void hash_avalanches(void **state)
{
    const uint32_t tries = 4096;
    (void)state;
    for (unsigned in = 0; in < 32; in++)
        for (unsigned out = 0; out < 32; out++) {
            uint32_t seed = 99, changes = 0;
            for (uint32_t i = 0; i < tries; i++) {
                const uint32_t v = random_next(&seed);
                changes += (fx_hash(v) ^ fx_hash(v ^ (uint32_t)1 << in)) >> out & 1u;
            }
            assert_in_range(changes, tries * 43 / 100, tries * 57 / 100);
        }
}

static double fraction(double x)
{
    return x - floor(x);
}

/* Constants by their definitions: off by at most half a unit of 2^-32. */
static void constants(void **state)
{
    const double golden = (sqrt(5) - 1) / 2;
    double r = 1.3;
    (void)state;
    for (int i = 0; i < 100; i++)
        r = cbrt(r + 1);
    assert_true(fabs(ldexp(golden, 32) - FX_GOLDEN) <= .5);
    assert_true(fabs(ldexp(1 / r, 32) - FX_LATTICE_X) <= .5);
    assert_true(fabs(ldexp(1 / (r * r), 32) - FX_LATTICE_Y) <= .5);
}

/* n * golden, whose constant is off by less than 2^-33. */
static void golden_ratio(void **state)
{
    const double golden = (sqrt(5) - 1) / 2;
    (void)state;
    for (uint32_t n = 0; n < 1000000; n++) {
        const double u = ldexp(fx_dither_golden(n), -32);
        const double off = fraction(u - fraction(n * golden) + .5) - .5;
        assert_true(fabs(off) <= ldexp(n, -33) + 1e-9);
    }
}

/* 3 bits of the place and 29 of what is below are apart: each block of 8 has each eighth once. */
static void blocks_have_each_eighth(void **state)
{
    (void)state;
    for (uint32_t block = 0; block < 100000; block++) {
        const uint32_t low = (FX_GOLDEN * block + fx_hash(block >> 6)) >> 3;
        uint32_t seen = 0;
        for (uint32_t n = 8 * block; n < 8 * block + 8; n++) {
            assert_int_equal(fx_dither_blocks(n) & 0x1FFFFFFFu, low);
            seen |= (uint32_t)1 << (fx_dither_blocks(n) >> 29);
        }
        assert_int_equal(seen, 255);
    }
}

/* The mean of every sequence over many slices is 1/2. */
static void means(void **state)
{
    const uint32_t count = 1000000;
    double golden = 0, hash = 0, blocks = 0;
    (void)state;
    for (uint32_t n = 0; n < count; n++) {
        golden += ldexp(fx_dither_golden(n), -32);
        hash += ldexp(fx_dither_hash(n), -32);
        blocks += ldexp(fx_dither_blocks(n), -32);
    }
    assert_true(fabs(golden / count - .5) < 1e-5);
    assert_true(fabs(hash / count - .5) < 1e-3); /* 3.5 standard deviations */
    /* 512 slices at a time are up to .0026 off, each 512 by another hash: 4 standard deviations */
    assert_true(fabs(blocks / count - .5) < 1e-4);
}

static void places_and_frames(void **state)
{
    (void)state;
    assert_int_equal(fx_dither_at(12345, 0, 0, 0), 12345);
    assert_int_equal(fx_dither_at(5, 1, 0, 0), 5 + FX_LATTICE_X);
    assert_int_equal(fx_dither_at(5, 0, 1, 0), 5 + FX_LATTICE_Y);
    assert_int_equal(fx_dither_at(5, 0, 0, 1), 5 + FX_GOLDEN);
    assert_int_equal(fx_dither_at(5, 3, 2, 7),
                     (uint32_t)(5 + 3 * (uint64_t)FX_LATTICE_X + 2 * (uint64_t)FX_LATTICE_Y +
                                7 * (uint64_t)FX_GOLDEN));
}

/* ---- Alpha dithering ------------------------------------------------------ */

static void phases(void **state)
{
    uint32_t seed = 3;
    (void)state;
    for (uint32_t slices = 2; slices <= SLICES_MAX; slices++) {
        const fx_period period = fx_period_of(slices);
        for (uint32_t n = 0; n < 1000; n++) {
            const uint32_t any = random_next(&seed);
            assert_int_equal(fx_phase(&period, n), n % slices);
            assert_int_equal(fx_phase(&period, any), any % slices);
            assert_int_equal(fx_phase(&period, UINT32_MAX - n), (UINT32_MAX - n) % slices);
        }
    }
}

/* floor(slices * (opacity - base) / bump + 1/2) in 64 bits. */
static void check_hits(const fx_period *period, uint32_t opacity, uint32_t base, uint32_t bump)
{
    const uint64_t n = (uint64_t)period->slices * (opacity - base * 65536);
    const uint64_t d = (uint64_t)bump * 65536;
    const uint64_t hits = (2 * n + d) / (2 * d);
    assert_int_equal(fx_hits(period, opacity, base, bump),
                     hits < period->slices ? hits : period->slices);
}

/* Every period and bump; opacities at random, at ties and at the ends. */
static void equation_9(void **state)
{
    uint32_t seed = 17;
    (void)state;
    for (uint32_t slices = 2; slices <= SLICES_MAX; slices++) {
        const fx_period period = fx_period_of(slices);
        for (uint32_t bump = 1; bump < 256; bump++) {
            for (uint32_t i = 0; i < 40; i++) {
                const uint32_t opacity = random_below(&seed, 255 * 65536 + 1);
                check_hits(&period, opacity, opacity >> 16, bump);
                check_hits(&period, opacity, random_below(&seed, (opacity >> 16) + 1), bump);
            }
            for (uint32_t h = 0; h < slices; h++) {
                const uint32_t tie = (2 * h + 1) * bump * 32768 / slices; /* below 255 * 2^16 */
                check_hits(&period, tie, 0, bump);
                check_hits(&period, tie + 1, 0, bump);
            }
            check_hits(&period, 0, 0, bump);
            check_hits(&period, 255 * 65536, 0, bump);
            check_hits(&period, 255 * 65536, 255, bump);
        }
        assert_int_equal(fx_hits(&period, 255 * 65536, 255, 0), slices);
    }
}

/* 2.25 and 2.3 over 16 slices, as the paper has them; .03 over 32 by rounding to nearest. */
static void hits_of_the_paper(void **state)
{
    const fx_period sixteen = fx_period_of(16), thirty_two = fx_period_of(32);
    (void)state;
    assert_int_equal(fx_hits(&sixteen, 2 * 65536 + 16384, 2, 1), 4);
    assert_int_equal(fx_hits(&sixteen, 2 * 65536 + 19661, 2, 1), 5);
    assert_int_equal(fx_hits(&thirty_two, 1966, 0, 1), 1);
    assert_int_equal(fx_hits(&thirty_two, 49152, 0, 1), 24);
    assert_int_equal(fx_hits(&thirty_two, 49152, 0, 3), 8);
}

/* The definition, and hits in a row are never more than one from their share. */
static void ordered_hits(void **state)
{
    (void)state;
    for (uint32_t slices = 2; slices <= SLICES_MAX; slices++) {
        const fx_period period = fx_period_of(slices);
        for (uint32_t hits = 0; hits <= slices; hits++) {
            uint32_t sum = 0;
            for (uint32_t phase = 0; phase < slices; phase++) {
                const uint32_t before = phase * hits / slices;
                sum += fx_hit_ordered(&period, hits, phase);
                assert_int_equal(before + fx_hit_ordered(&period, hits, phase),
                                 (phase + 1) * hits / slices);
            }
            assert_int_equal(sum, hits);
        }
    }
}

/* Of the 65536 upper halves of u, hits / slices hit, but for one at most. */
static void random_hits(void **state)
{
    (void)state;
    for (uint32_t slices = 2; slices <= SLICES_MAX; slices++) {
        const fx_period period = fx_period_of(slices);
        for (uint32_t hits = 0; hits <= slices; hits += slices / 2) {
            uint32_t sum = 0;
            for (uint32_t u = 0; u < 65536; u++)
                sum += fx_hit_random(&period, hits, (u << 16) + 0xFFFFu);
            assert_in_range(sum, 65536 * hits / slices, 65536 * hits / slices + 1);
        }
    }
}

/* ---- Plateaus ------------------------------------------------------------- */

/* The state after a slice of full colour, by a division. */
static uint32_t blended(uint32_t value, uint32_t opacity, uint32_t full)
{
    return (2 * (full * opacity + (full - opacity) * value) + full) / (2 * full);
}

static void equation_10(void **state)
{
    static const unsigned bits[] = {5, 6, 8, 12};
    (void)state;
    for (unsigned i = 0; i < sizeof bits / sizeof *bits; i++) {
        const uint32_t full = ((uint32_t)1 << bits[i]) - 1;
        assert_int_equal(fx_plateau(0, full), 0);
        for (uint32_t opacity = 1; opacity <= full; opacity++) {
            const uint32_t end = fx_plateau(opacity, full);
            assert_int_equal(end, (uint32_t)ceil(full - full / (2.0 * opacity)));
            assert_int_equal(blended(end, opacity, full), end);
            assert_true(blended(end - 1, opacity, full) > end - 1);
        }
    }
}

static void least_opacity_that_overcomes(void **state)
{
    static const unsigned bits[] = {5, 6, 8};
    (void)state;
    for (unsigned i = 0; i < sizeof bits / sizeof *bits; i++) {
        const uint32_t full = ((uint32_t)1 << bits[i]) - 1;
        for (uint32_t value = 0; value < full; value++) {
            uint32_t least = 1;
            while (blended(value, least, full) == value)
                least++;
            assert_int_equal(fx_overcoming(value, full), least);
        }
        assert_int_equal(fx_overcoming(full, full), full + 1);
    }
}

/* Its rows are the plateaus one after the other: what overcomes one leads to the next. */
static void table_1(void **state)
{
    static const uint32_t rows[][2] = {
        {128, 2},  {192, 3},  {213, 4},  {224, 5},  {230, 6},  {234, 7},  {237, 8},
        {240, 9},  {241, 10}, {243, 11}, {244, 12}, {245, 13}, {246, 15}, {247, 16},
        {248, 19}, {249, 22}, {250, 26}, {251, 32}, {252, 43}, {253, 64}, {254, 128}};
    const unsigned count = sizeof rows / sizeof *rows;
    (void)state;
    assert_int_equal(count, 21);
    assert_int_equal(fx_plateau(1, 255), rows[0][0]);
    for (unsigned i = 0; i < count; i++) {
        assert_int_equal(fx_overcoming(rows[i][0], 255), rows[i][1]);
        assert_int_equal(fx_plateau(rows[i][1], 255), i + 1 < count ? rows[i + 1][0] : 255);
    }
}

static void bumps(void **state)
{
    (void)state;
    for (uint32_t value = 0; value < 256; value++)
        for (uint32_t base = 0; base < 256; base++) {
            uint32_t bump = 1;
            while (bump < 255 && value >= fx_plateau(bump, 255))
                bump = 2 * bump + 1;
            assert_int_equal(fx_bump(value, base), bump + base > 255 ? 255 - base : bump);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hash_is_a_bijection),
        cmocka_unit_test(hash_avalanches),
        cmocka_unit_test(constants),
        cmocka_unit_test(golden_ratio),
        cmocka_unit_test(blocks_have_each_eighth),
        cmocka_unit_test(means),
        cmocka_unit_test(places_and_frames),
        cmocka_unit_test(phases),
        cmocka_unit_test(equation_9),
        cmocka_unit_test(hits_of_the_paper),
        cmocka_unit_test(ordered_hits),
        cmocka_unit_test(random_hits),
        cmocka_unit_test(equation_10),
        cmocka_unit_test(least_opacity_that_overcomes),
        cmocka_unit_test(table_1),
        cmocka_unit_test(bumps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
