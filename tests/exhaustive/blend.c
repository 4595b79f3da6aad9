/*
 * Dither and blends wherever all inputs are at most 2^32: the hash, opacity in 23 bits,
 * every state of 8 bits with every opacity, and every state of 8.16 and 24 bits at some
 * opacities.
 */
#include "check.h"
#include "fx_blend.h"
#include "fx_dither.h"
#include "hash_inverse.h"

static void hash_is_a_bijection(void **state)
{
    uint32_t v = 0;
    (void)state;
    do {
        if (hash_inverse(fx_hash(v)) != v)
            fail_msg("hash of %u", v);
    } while (++v != 0);
}

static void opacity_of_23_bits(void **state)
{
    uint32_t v = 0;
    (void)state;
    do {
        if (fx_opacity_q23(v) != ((uint64_t)v + 256) / 512)
            fail_msg("opacity %u", v);
    } while (++v != 0);
}

/* One state and opacity, with the light of black, of white and of the state itself. */
static void check_8_bits(uint32_t s, uint32_t a)
{
    const uint64_t kept = (uint64_t)(FX_ONE_Q23 - a) * s;
    const uint32_t white = 255 * a;
    if (fx_blend_dithered(s, 0, a, 0, 0) != kept >> 23 ||
        fx_blend_dithered(s, 0, a, UINT32_MAX, 0) != (kept + FX_ONE_Q23 - 1) >> 23)
        fail_msg("%u under black of %u", s, a);
    if (fx_blend_dithered(s, white, a, 0, 0) != (kept + white) >> 23 ||
        fx_blend_dithered(s, white, a, UINT32_MAX, 0) != (kept + white + FX_ONE_Q23 - 1) >> 23)
        fail_msg("%u under white of %u", s, a);
    if (fx_blend_dithered(s, s * a, a, 0, 0) != s ||
        fx_blend_dithered(s, s * a, a, UINT32_MAX, 0) != s)
        fail_msg("%u under itself of %u", s, a);
}

static void states_of_8_bits(void **state)
{
    (void)state;
    for (uint32_t a = 0; a <= FX_ONE_Q23; a++)
        for (uint32_t s = 0; s < 256; s++)
            check_8_bits(s, a);
}

static const uint32_t opacities[] = {0,          1,          255,        50529,      1u << 20,
                                     0x12345678, 0x7FFFFFFF, 0x80000000, 0xFEDCBA98, UINT32_MAX};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* Levels stay, nothing falls as the state rises, and white goes no higher than 255. */
static void states_of_8_16(void **state)
{
    (void)state;
    for (unsigned i = 0; i < COUNT(opacities); i++) {
        const uint32_t o = opacities[i], white = fx_light_of_colour32(255, o);
        uint32_t before = 0;
        for (uint32_t s = 0; s <= 255u << 16; s++) {
            const uint32_t black = fx_blend_8_16(s, 0, o, FX_NO_DITHER);
            if (black < before || fx_blend_8_16(s, white, o, FX_NO_DITHER) > 255u << 16)
                fail_msg("%u under %u", s, o);
            before = black;
            if ((s & 0xFFFFu) == 0 &&
                fx_blend_8_16(s, fx_light_of_colour32(s >> 16, o), o, FX_NO_DITHER) != s)
                fail_msg("%u under itself of %u", s, o);
        }
    }
}

static void transmittances(void **state)
{
    (void)state;
    for (unsigned i = 0; i < COUNT(opacities); i++) {
        uint32_t before = 0;
        for (uint32_t t = 0; t <= FX_CLEAR_Q24; t++) {
            const uint32_t left = fx_transmit(t, opacities[i]);
            if (left < before || left > t)
                fail_msg("%u through %u", t, opacities[i]);
            before = left;
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hash_is_a_bijection), cmocka_unit_test(opacity_of_23_bits),
        cmocka_unit_test(states_of_8_bits),    cmocka_unit_test(states_of_8_16),
        cmocka_unit_test(transmittances),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
