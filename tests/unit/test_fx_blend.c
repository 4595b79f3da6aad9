/*
 * Blends of one channel against exact fractions, which 64 bits and a division hold, and
 * the facts that fx_blend.h states of them.
 */
#include "check.h"
#include "fx_blend.h"
#include "fx_dither.h"
#include "random.h"

#define FULL32 UINT32_MAX /* opacity 1, Q0.32 */

static const unsigned fractions[] = {0, 4, 8};
static const unsigned wide_fractions[] = {0, 4, 8, 16};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* Opacities as they come, the ends, and small ones, Q0.32. */
static uint32_t random_opacity(uint32_t *seed)
{
    const uint32_t v = random_next(seed);
    switch (v & 7u) {
    case 0:
        return 0;
    case 1:
        return FULL32;
    case 2:
        return v;
    default:
        return v >> (v >> 3 & 31u);
    }
}

/* round(n / d), ties upwards. */
static uint64_t rounded(uint64_t n, uint64_t d)
{
    return (2 * n + d) / (2 * d);
}

/* ---- Opacity and light ---------------------------------------------------- */

static void opacity_of_23_bits(void **state)
{
    uint32_t seed = 1;
    (void)state;
    assert_int_equal(fx_opacity_q23(FULL32), FX_ONE_Q23);
    assert_int_equal(fx_opacity_q23(255), 0);
    assert_int_equal(fx_opacity_q23(256), 1);
    for (uint32_t i = 0; i < 1000000; i++) {
        const uint32_t o = random_opacity(&seed);
        assert_int_equal(fx_opacity_q23(o), rounded(o, 512));
    }
}

/* level * (2^32 - 1) / (255 * 65536), cut, within 3 units. */
static void opacity_of_levels(void **state)
{
    (void)state;
    for (uint32_t level = 0; level <= 255 * 65536; level++) {
        const uint64_t exact = (uint64_t)level * FULL32 / (255 * 65536);
        const uint32_t opacity = fx_opacity_of_level(level);
        assert_in_range(opacity + (uint64_t)3, exact, exact + 4);
    }
    assert_int_equal(fx_opacity_of_level(255 * 65536), FULL32);
}

static void light_of_colours(void **state)
{
    uint32_t seed = 2;
    (void)state;
    assert_int_equal(fx_light_of_colour(255, FX_ONE_Q23), FX_LIGHT_ONE);
    assert_int_equal(fx_light_of_colour32(255, FULL32), FX_LIGHT_ONE);
    for (uint32_t i = 0; i < 1000000; i++) {
        const uint32_t o = random_opacity(&seed), c = random_below(&seed, 256);
        assert_int_equal(fx_light_of_colour(c, fx_opacity_q23(o)), (uint64_t)c * fx_opacity_q23(o));
        assert_int_equal(fx_light_of_colour32(c, o), rounded((uint64_t)c * o, 512));
    }
}

/* Units of 1: of 8- and 16-bit storage, of extinction, and of light itself. */
static void light_of_other_units(void **state)
{
    static const uint64_t ones[] = {2130739200, 2147418112, 1073725440, FX_LIGHT_ONE};
    uint32_t seed = 3;
    (void)state;
    for (unsigned i = 0; i < COUNT(ones); i++) {
        const uint64_t one = ones[i], scaled = (uint64_t)255 << 54;
        const uint32_t factor = (uint32_t)rounded(scaled, one);
        assert_int_equal(rounded(scaled, one), factor);
        assert_int_equal(fx_light_within(fx_light_of((uint32_t)one, factor), FX_LIGHT_ONE),
                         FX_LIGHT_ONE);
        assert_int_equal(
            fx_light_within(fx_light_of((uint32_t)one + (1u << 22), factor), FX_LIGHT_ONE),
            FX_LIGHT_ONE);
        assert_int_equal(fx_light_within(fx_light_of((uint32_t)one, factor), 12345), 12345);
        for (unsigned n = 0; n < 100000; n++) {
            const uint64_t v = random_below(&seed, (uint32_t)one + 1);
            const int64_t twice = (int64_t)(2 * v * FX_LIGHT_ONE / one);
            const int64_t light = fx_light_within(fx_light_of((uint32_t)v, factor), FX_LIGHT_ONE);
            assert_in_range(2 * light - twice + 4, 1, 7); /* 3 halves, and what is cut here */
        }
    }
}

static void light_of_5_and_6_bits(void **state)
{
    static const uint32_t fulls[] = {31, 63}, factors[] = {FX_FACTOR_5, FX_FACTOR_6};
    uint32_t seed = 4;
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        for (uint32_t a = 0; a <= FX_ONE_Q23; a += a == FX_ONE_Q23 ? 1 : 31)
            assert_int_equal(fx_light_narrow(255 * a, factors[i]), fulls[i] * a);
        assert_int_equal(fx_light_narrow(FX_LIGHT_ONE, factors[i]), fulls[i] * FX_ONE_Q23);
        for (unsigned n = 0; n < 1000000; n++) {
            const uint64_t light = random_below(&seed, FX_LIGHT_ONE + 1);
            const uint64_t narrow = fx_light_narrow((uint32_t)light, factors[i]);
            assert_in_range(narrow * 255 + 255, light * fulls[i], light * fulls[i] + 510);
        }
    }
}

/* ---- Plain blends --------------------------------------------------------- */

static void division_by_ones(void **state)
{
    static const unsigned bits[] = {5, 6, 7, 8, 9, 10, 11, 12};
    (void)state;
    for (unsigned i = 0; i < COUNT(bits); i++) {
        const uint32_t full = ((uint32_t)1 << bits[i]) - 1;
        for (uint32_t x = 0; x <= full * full; x++)
            if (fx_divide_by_ones(x, bits[i]) != (x + full / 2) / full)
                fail_msg("%u / %u", x, full);
    }
}

static void check_plain(uint32_t state, uint32_t colour, uint32_t opacity, unsigned bits)
{
    const uint32_t full = ((uint32_t)1 << bits) - 1;
    const uint32_t light = colour * opacity, kept = (full - opacity) * state;
    const uint32_t own = (2 * light + full) / (2 * full); /* associated, as hardware is given it */
    if (fx_blend_plain(state, colour, opacity, bits) != (2 * (light + kept) + full) / (2 * full))
        fail_msg("%u bits: %u over %u by %u", bits, colour, state, opacity);
    if (fx_blend_associated(state, own, opacity, bits) != own + (2 * kept + full) / (2 * full))
        fail_msg("%u bits: associated %u over %u by %u", bits, own, state, opacity);
    if (fx_blend_associated(state, own, opacity, bits) > full)
        fail_msg("%u bits: above full, %u over %u by %u", bits, own, state, opacity);
}

/* Every state, colour and opacity of 8 bits, and of 5 and 6 with their own or 8 bits of
   opacity. */
static void plain_blends_exhaustively(void **state)
{
    static const struct {
        unsigned bits;
        uint32_t full; /* of state and colour */
    } forms[] = {{5, 31}, {6, 63}, {8, 31}, {8, 63}, {8, 255}};
    (void)state;
    for (unsigned i = 0; i < COUNT(forms); i++)
        for (uint32_t a = 0; a >> forms[i].bits == 0; a++)
            for (uint32_t s = 0; s <= forms[i].full; s++)
                for (uint32_t c = 0; c <= forms[i].full; c++)
                    check_plain(s, c, a, forms[i].bits);
}

static void plain_blends_of_12_bits(void **state)
{
    uint32_t seed = 5;
    (void)state;
    for (uint32_t i = 0; i < 1000000; i++) {
        const uint32_t v = random_next(&seed);
        check_plain(v & 4095, v >> 12 & 4095, v >> 20, 12);
    }
    for (uint32_t a = 0; a < 4096; a++)
        for (uint32_t s = 0; s < 4096; s += 63) {
            check_plain(s, 4095, a, 12);
            check_plain(s, 0, a, 12);
            check_plain(s, s, a, 12);
            assert_int_equal(fx_blend_plain(s, s, a, 12), s);
        }
}

/* Section 2.3.1: 100 and 128 after 100 and 200 slices; the two bricks of 100. */
static void slices_of_the_paper(void **state)
{
    uint32_t value = 0;
    (void)state;
    for (uint32_t n = 1; n <= 200; n++) {
        value = fx_blend_plain(value, 255, 1, 8);
        assert_int_equal(value, n < 128 ? n : 128);
    }
    assert_int_equal(fx_blend_associated(100, 100, 100, 8), 161);
    assert_int_equal(fx_blend_plain(230, 255, 5, 8), 230);
}

/* Section 5: opacity hits with 7, colour, dithered apart from it, does not: 157 falls to 153. */
static void separate_dither_of_the_paper(void **state)
{
    (void)state;
    assert_int_equal(fx_blend_associated(157, 0, 7, 8), 153);
}

/* ---- Dithered blends ------------------------------------------------------ */

/* With S = state / 2^f: light + B S, plus u, cut; in units of 2^-(32+f) of a unit. */
static void check_dithered(uint32_t state, uint32_t light, uint32_t a, uint32_t u, unsigned f)
{
    const uint64_t rest = FX_ONE_Q23 - a;
    const uint64_t exact = ((uint64_t)light << f) + rest * state; /* 2^23 is a unit of the state */
    const uint32_t result = fx_blend_dithered(state, light, a, u, f);
    const uint64_t cut = (exact >> f) + (u >> (9 + f));
    if (result != cut >> (23 - f))
        fail_msg("8.%u: %u, light %u, opacity %u, u %u: %u", f, state, light, a, u, result);
    if (result < exact >> 23 || result > (exact + FX_ONE_Q23 - 1) >> 23)
        fail_msg("8.%u: %u, light %u, opacity %u, u %u: not beside", f, state, light, a, u);
}

static void dithered_blends(void **state)
{
    uint32_t seed = 6;
    (void)state;
    for (unsigned i = 0; i < COUNT(fractions); i++)
        for (uint32_t n = 0; n < 2000000; n++) {
            const unsigned f = fractions[i];
            const uint32_t a = fx_opacity_q23(random_opacity(&seed));
            const uint32_t light = a == 0 ? 0 : random_below(&seed, 255 * a + 1);
            check_dithered(random_below(&seed, (255u << f) + 1), light, a, random_next(&seed), f);
        }
}

/* Over all values of u that differ: the exact result, less what was cut. */
static void dither_is_right_on_average(void **state)
{
    uint32_t seed = 7;
    (void)state;
    for (unsigned i = 0; i < COUNT(fractions); i++)
        for (uint32_t n = 0; n < 2000; n++) {
            const unsigned f = fractions[i];
            const uint32_t s = random_below(&seed, (255u << f) + 1);
            const uint32_t a = fx_opacity_q23(random_opacity(&seed));
            const uint32_t light = 255 * a / 3;
            const uint64_t exact = ((uint64_t)light << f) + (uint64_t)(FX_ONE_Q23 - a) * s;
            /* the least u, of 23 - f bits, at which the result is one more */
            const uint32_t least = fx_blend_dithered(s, light, a, 0, f);
            uint32_t low = 0, high = FX_ONE_Q23 >> f;
            while (low < high) {
                const uint32_t middle = (low + high) / 2;
                if (fx_blend_dithered(s, light, a, middle << (9 + f), f) > least)
                    high = middle;
                else
                    low = middle + 1;
            }
            const uint64_t mean = ((uint64_t)least << 23) + ((FX_ONE_Q23 >> f) - low) * (1u << f);
            assert_in_range(exact - mean, 0, (1u << f) - 1);
        }
}

/* Levels stay, the ends are right: for all levels and some opacities, whatever u. */
static void fixed_points_of_dithered_blends(void **state)
{
    uint32_t seed = 8;
    (void)state;
    for (unsigned i = 0; i < COUNT(fractions); i++)
        for (uint32_t n = 0; n < 2000; n++) {
            const unsigned f = fractions[i];
            const uint32_t a = fx_opacity_q23(random_opacity(&seed)), u = random_next(&seed);
            const uint32_t any = random_below(&seed, (255u << f) + 1);
            for (uint32_t c = 0; c < 256; c++) {
                assert_int_equal(fx_blend_dithered(c << f, c * a, a, UINT32_MAX, f), c << f);
                assert_int_equal(fx_blend_dithered(c << f, c * a, a, 0, f), c << f);
                assert_int_equal(fx_blend_dithered(any, c << 23, FX_ONE_Q23, u, f), c << f);
            }
            assert_int_equal(fx_blend_dithered(any, 0, 0, UINT32_MAX, f), any);
        }
}

static void dithered_blends_are_monotone(void **state)
{
    uint32_t seed = 9;
    (void)state;
    for (unsigned i = 0; i < COUNT(fractions); i++)
        for (uint32_t n = 0; n < 500000; n++) {
            const unsigned f = fractions[i];
            const uint32_t a = fx_opacity_q23(random_opacity(&seed)), u = random_next(&seed);
            const uint32_t s = random_below(&seed, 255u << f);
            const uint32_t light = a == 0 ? 0 : random_below(&seed, 255 * a);
            const uint32_t least = fx_blend_dithered(s, light, a, u, f);
            assert_true(fx_blend_dithered(s + 1, light, a, u, f) >= least);
            if (a != 0)
                assert_true(fx_blend_dithered(s, light + 1, a, u, f) >= least);
            assert_true(fx_blend_dithered(255u << f, 255 * a, a, UINT32_MAX, f) <= 255u << f);
        }
}

/* Colours of random slices stay below the opacity, and equal ones equal. */
static void colours_stay_below_opacity(void **state)
{
    uint32_t seed = 10;
    (void)state;
    for (unsigned i = 0; i < COUNT(fractions); i++) {
        const unsigned f = fractions[i];
        uint32_t colour[2] = {0, 0}, opacity = 0;
        for (uint32_t n = 0; n < 500000; n++) {
            const uint32_t a = fx_opacity_q23(random_opacity(&seed) >> 6);
            const uint32_t light = (n & 256 ? 255 : random_below(&seed, 256)) * a;
            const uint32_t u = random_next(&seed);
            if (n % 1000 == 0)
                colour[0] = colour[1] = opacity = 0;
            for (unsigned c = 0; c < 2; c++)
                colour[c] = fx_blend_dithered(colour[c], light, a, u, f);
            opacity = fx_blend_dithered(opacity, 255 * a, a, u, f);
            assert_int_equal(colour[0], colour[1]);
            assert_true(colour[0] <= opacity && opacity <= 255u << f);
        }
    }
}

/* States of 5 and 6 bits, which take light of their own scale. */
static void blends_of_5_and_6_bits(void **state)
{
    static const uint32_t fulls[] = {31, 63}, factors[] = {FX_FACTOR_5, FX_FACTOR_6};
    uint32_t seed = 11;
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        uint32_t colour = 0, opacity = 0;
        for (uint32_t n = 0; n < 1000000; n++) {
            const uint32_t a = fx_opacity_q23(random_opacity(&seed) >> 6);
            const uint32_t light = a * random_below(&seed, 256), u = random_next(&seed);
            colour = fx_blend_dithered(colour, fx_light_narrow(light, factors[i]), a, u, 0);
            opacity = fx_blend_dithered(opacity, fx_light_narrow(255 * a, factors[i]), a, u, 0);
            assert_true(colour <= opacity && opacity <= fulls[i]);
            if (n % 1000 == 0)
                colour = opacity = 0;
        }
    }
}

/* ---- 8.16 ----------------------------------------------------------------- */

/* state + 2^-7 light - state A, in units of 2^-32 of the state's: within 1/2 + 2^-7 units, for
   an opacity of o / (2^32 - 1). */
static void check_8_16(uint32_t state, uint32_t light, uint32_t o)
{
    const int64_t lost = (int64_t)rounded((uint64_t)state * o, 4096); /* 2^-20 of a unit */
    const int64_t exact = ((int64_t)state << 20) + ((int64_t)light << 13) - lost;
    const int64_t off = ((int64_t)fx_blend_8_16(state, light, o, FX_NO_DITHER) << 20) - exact;
    if (off > (1 << 19) + (1 << 13) || off < -(1 << 19) - (1 << 13))
        fail_msg("8.16: %u, light %u, opacity %u: %d off", state, light, o, (int)off);
}

static void blends_of_8_16(void **state)
{
    uint32_t seed = 12;
    (void)state;
    for (uint32_t n = 0; n < 2000000; n++) {
        const uint32_t o = random_opacity(&seed), most = fx_light_of_colour32(255, o);
        check_8_16(random_below(&seed, (255u << 16) + 1), random_below(&seed, most + 1), o);
    }
    assert_int_equal(fx_blend_8_16(0, 63, 1, FX_NO_DITHER), 0);
    assert_int_equal(fx_blend_8_16(0, 64, 1, FX_NO_DITHER), 1); /* a tie */
}

static void facts_of_8_16(void **state)
{
    uint32_t seed = 13;
    (void)state;
    for (uint32_t n = 0; n < 20000; n++) {
        const uint32_t o = random_opacity(&seed), s = random_below(&seed, 255u << 16);
        const uint32_t u = n % 4 == 0 ? 0 : n % 4 == 1 ? UINT32_MAX : random_next(&seed);
        const uint32_t light = fx_light_of_colour32(random_below(&seed, 255), o);
        for (uint32_t c = 0; c < 256; c++) {
            assert_int_equal(fx_blend_8_16(c << 16, fx_light_of_colour32(c, o), o, u), c << 16);
            assert_int_equal(fx_blend_8_16(s, c << 23, FULL32, u), c << 16);
        }
        assert_int_equal(fx_blend_8_16(s, 0, 0, u), s);
        assert_true(fx_blend_8_16(s + 1, light, o, u) >= fx_blend_8_16(s, light, o, u));
        assert_true(fx_blend_8_16(s, light + 1, o, u) >= fx_blend_8_16(s, light, o, u));
    }
}

/* Two images of 8.8, near over far, in 8.16: at most 1/2 of 2^-16, and 3 * 2^-32 of far. */
static void images_combine(void **state)
{
    uint32_t seed = 14;
    (void)state;
    for (uint32_t n = 0; n < 1000000; n++) {
        const uint32_t opacity = random_below(&seed, 65281),
                       near = random_below(&seed, opacity + 1);
        const uint32_t far = random_below(&seed, 65281), o = fx_opacity_of_level(opacity << 8);
        const uint32_t light =
            fx_light_within(fx_light_of(near << 15, 0x80000000u), fx_light_of_colour32(255, o));
        const int64_t exact = ((int64_t)near * 65280 + (int64_t)(65280 - opacity) * far) * 256;
        const int64_t off =
            (int64_t)fx_blend_8_16(far << 8, light, o, FX_NO_DITHER) * 65280 - exact;
        assert_in_range(off + 34000, 0, 68000); /* of 65280: .52 units */
    }
}

/* ---- Front to back -------------------------------------------------------- */

/* transmittance * (1 - opacity) within 1/2 + 2^-7 units, in 2^-32 of a unit. */
static void transmittances(void **state)
{
    uint32_t seed = 15;
    (void)state;
    for (uint32_t n = 0; n < 2000000; n++) {
        const uint32_t o = random_opacity(&seed), t = random_below(&seed, FX_CLEAR_Q24 + 1);
        const int64_t exact = (int64_t)((uint64_t)t * (FULL32 - o));
        const int64_t off = (int64_t)((uint64_t)fx_transmit(t, o) * FULL32) - exact;
        assert_true(off <= (int64_t)33 << 26 && off >= -((int64_t)33 << 26));
        assert_int_equal(fx_transmit(t, 0), t);
        assert_int_equal(fx_transmit(t, FULL32), 0);
        assert_true(fx_transmit(t, o) <= t);
        if (t != 0)
            assert_true(fx_transmit(t - 1, o) <= fx_transmit(t, o));
        if (o != 0)
            assert_true(fx_transmit(t, o) <= fx_transmit(t, o - 1));
    }
    assert_int_equal(fx_transmit(1, 0x80000000u), 1); /* a tie */
    assert_int_equal(fx_transmit(1, 0x80000001u), 1);
    assert_int_equal(fx_transmit(1, 0x81000000u), 0);
}

static void opaque_shares(void **state)
{
    uint32_t seed = 16;
    (void)state;
    for (unsigned i = 0; i < COUNT(wide_fractions); i++) {
        const unsigned f = wide_fractions[i];
        for (uint32_t c = 0; c < 256; c++) {
            assert_int_equal(fx_opaque_share(c, 0, f), c << f);
            assert_int_equal(fx_opaque_share(c, FX_CLEAR_Q24, f), f == 16 && c >= 128);
            for (unsigned n = 0; n < 1000; n++) {
                const uint32_t t = random_below(&seed, FX_CLEAR_Q24 + 1);
                const uint64_t exact = (uint64_t)c * ((1u << 24) - t);
                assert_int_equal(fx_opaque_share(c, t, f), rounded(exact << f, 1u << 24));
            }
        }
    }
}

/* Slices of one colour: within 1/2 unit of what the transmittance says, after any number. */
static void one_colour_front_to_back(void **state)
{
    uint32_t seed = 17;
    (void)state;
    for (unsigned i = 0; i < COUNT(wide_fractions); i++)
        for (unsigned n = 0; n < 200; n++) {
            const unsigned f = wide_fractions[i];
            const uint32_t c = random_below(&seed, 256);
            uint32_t s = 0, t = FX_CLEAR_Q24;
            for (unsigned slice = 0; slice < 500; slice++) {
                const uint32_t after = fx_transmit(t, random_opacity(&seed) >> 8);
                s = fx_front_colour(s, c, t, after, f);
                t = after;
                assert_in_range(fx_opaque_share(c, t, f) - s, 0, f == 16);
            }
        }
}

/* Random slices: never above the opacity; each off by the roundings that are stated. */
static void light_front_to_back(void **state)
{
    uint32_t seed = 18;
    (void)state;
    for (unsigned i = 0; i < COUNT(wide_fractions); i++)
        for (uint32_t n = 0; n < 500000; n++) {
            const unsigned f = wide_fractions[i];
            const uint32_t before = random_below(&seed, FX_CLEAR_Q24 + 1);
            const uint32_t o = random_opacity(&seed), after = fx_transmit(before, o);
            const uint32_t light = fx_light_of_colour32(random_below(&seed, 256), o);
            const uint32_t u = f == 16 ? FX_NO_DITHER : random_next(&seed);
            const uint32_t most = fx_opaque_share(255, after, f);
            const uint32_t s = fx_opaque_share(random_below(&seed, 256), before, f);
            const uint32_t result = fx_front_light(s, light, before, after, u, f);
            /* in 2^-47 of a level: light is Q8.23, transmittance Q0.24 */
            const int64_t exact = (int64_t)((uint64_t)light * before);
            const int64_t off = (int64_t)((uint64_t)(result - s) << (47 - f)) - exact;
            assert_true(result <= most);
            if (result < most)
                assert_true(off <= (int64_t)1 << (47 - f) && off >= -((int64_t)1 << (47 - f)));
        }
}

/* ---- What is shown, and the residual -------------------------------------- */

static void residuals(void **state)
{
    static const unsigned bits[] = {4, 8};
    (void)state;
    for (unsigned i = 0; i < COUNT(bits); i++) {
        const unsigned f = bits[i];
        const int32_t half = 1 << (f - 1);
        for (uint32_t s = 0; s <= 255u << f; s++) {
            const uint32_t level = fx_level_of(s, f);
            const int32_t residual = fx_residual_of(s, f);
            assert_int_equal(level, (s + (uint32_t)half) / (1u << f));
            assert_true(level <= 255 && residual >= -half && residual < half);
            assert_int_equal(fx_state_of(level, residual, f), s);
        }
    }
    assert_int_equal(fx_level_of(255u << 16, 16), 255);
    assert_int_equal(fx_level_of(0x7FFF, 16), 0);
    assert_int_equal(fx_level_of(0x8000, 16), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(opacity_of_23_bits),
        cmocka_unit_test(opacity_of_levels),
        cmocka_unit_test(light_of_colours),
        cmocka_unit_test(light_of_other_units),
        cmocka_unit_test(light_of_5_and_6_bits),
        cmocka_unit_test(division_by_ones),
        cmocka_unit_test(plain_blends_exhaustively),
        cmocka_unit_test(plain_blends_of_12_bits),
        cmocka_unit_test(slices_of_the_paper),
        cmocka_unit_test(separate_dither_of_the_paper),
        cmocka_unit_test(dithered_blends),
        cmocka_unit_test(dither_is_right_on_average),
        cmocka_unit_test(fixed_points_of_dithered_blends),
        cmocka_unit_test(dithered_blends_are_monotone),
        cmocka_unit_test(colours_stay_below_opacity),
        cmocka_unit_test(blends_of_5_and_6_bits),
        cmocka_unit_test(blends_of_8_16),
        cmocka_unit_test(facts_of_8_16),
        cmocka_unit_test(images_combine),
        cmocka_unit_test(transmittances),
        cmocka_unit_test(opaque_shares),
        cmocka_unit_test(one_colour_front_to_back),
        cmocka_unit_test(light_front_to_back),
        cmocka_unit_test(residuals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
