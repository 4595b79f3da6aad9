/*
 * The worked examples S64 .. S74 of tests/SPEC.md: frame buffers of few bits. The same
 * inputs and results as there, written out.
 */
#include "check.h"
#include "composite.h"
#include "fx_blend.h"
#include "fx_correct.h"
#include "fx_dither.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

static void S64_dither_values(void **state)
{
    static const uint32_t hashes[][2] = {{0, 0},
                                         {1, 0x688990C0},
                                         {2, 0xD1132181u},
                                         {0x12345678, 0xF5E71C96u},
                                         {0xFFFFFFFFu, 0x6768824A}};
    static const uint32_t slices[][4] = {
        {1, 0x9E3779B9u, 0x53F1E9DD, 0xA0000000u},
        {8, 0xF1BBCDC8u, 0x4CA56AE5, 0x13C6EF37},
        {1000, 0x8B37AA8, 0xFDDCDCC4u, 0x95340002u},
        {0xFFFFFFFFu, 0x61C88647, 0x6768824A, 0xFEE045EBu},
    };
    (void)state;
    for (unsigned i = 0; i < COUNT(hashes); i++)
        assert_int_equal(fx_hash(hashes[i][0]), hashes[i][1]);
    for (unsigned i = 0; i < COUNT(slices); i++) {
        assert_int_equal(fx_dither_golden(slices[i][0]), slices[i][1]);
        assert_int_equal(fx_dither_hash(slices[i][0]), slices[i][2]);
        assert_int_equal(fx_dither_blocks(slices[i][0]), slices[i][3]);
    }
    assert_int_equal(fx_dither_at(0x95340002u, 3, 2, 7), 0x50396C58);
    assert_int_equal(fx_dither_at(0, 0xFFFFFFFFu, 0, 0xFFFFFFFFu), 0xA088DC9Eu);
}

static void S65_hits(void **state)
{
    static const uint32_t examples[][5] = {{16, 147456, 2, 1, 4},    {16, 150733, 2, 1, 5},
                                           {32, 1966, 0, 1, 1},      {32, 49152, 0, 3, 8},
                                           {5, 16711680, 0, 255, 5}, {64, 16711680, 0, 1, 64},
                                           {7, 65536, 0, 7, 1}};
    (void)state;
    for (unsigned i = 0; i < COUNT(examples); i++) {
        const uint32_t *e = examples[i];
        const fx_period period = fx_period_of(e[0]);
        assert_int_equal(fx_hits(&period, e[1], e[2], e[3]), e[4]);
    }
}

/* Bit k: whether phase k hits. */
static uint32_t pattern_of(uint32_t slices, uint32_t hits)
{
    const fx_period period = fx_period_of(slices);
    uint32_t pattern = 0;
    for (uint32_t k = 0; k < slices; k++)
        pattern |= fx_hit_ordered(&period, hits, k) << k;
    return pattern;
}

static void S66_patterns(void **state)
{
    const fx_period period = fx_period_of(32);
    (void)state;
    assert_int_equal(pattern_of(16, 5), 1 << 3 | 1 << 6 | 1 << 9 | 1 << 12 | 1 << 15);
    assert_int_equal(pattern_of(7, 3), 1 << 2 | 1 << 4 | 1 << 6);
    assert_int_equal(fx_hit_random(&period, 1, 0x07FFFFFF), 1);
    assert_int_equal(fx_hit_random(&period, 1, 0x08000000), 0);
}

static void S67_plateaus(void **state)
{
    static const uint32_t plateaus[][3] = {{1, 255, 128},   {3, 255, 213},    {7, 255, 237},
                                           {255, 255, 255}, {1, 31, 16},      {2, 63, 48},
                                           {1, 4095, 2048}, {100, 4095, 4075}};
    static const uint32_t least[][3] = {{127, 255, 1},   {128, 255, 2},   {243, 255, 11},
                                        {254, 255, 128}, {255, 255, 256}, {15, 31, 1},
                                        {16, 31, 2},     {4000, 4095, 22}};
    static const uint32_t bumps[][3] = {{0, 0, 1},    {128, 0, 3},    {213, 2, 7},
                                        {250, 3, 31}, {255, 200, 55}, {255, 255, 0}};
    (void)state;
    for (unsigned i = 0; i < COUNT(plateaus); i++)
        assert_int_equal(fx_plateau(plateaus[i][0], plateaus[i][1]), plateaus[i][2]);
    for (unsigned i = 0; i < COUNT(least); i++)
        assert_int_equal(fx_overcoming(least[i][0], least[i][1]), least[i][2]);
    for (unsigned i = 0; i < COUNT(bumps); i++)
        assert_int_equal(fx_bump(bumps[i][0], bumps[i][1]), bumps[i][2]);
}

static void S68_number_of_slices(void **state)
{
    static const uint32_t examples[][4] = {{0x12345678, 128, 600, 0x3FF40C8},
                                           {50529, 1, 2, 0x62B0},
                                           {0x80000000u, 1, 2, 0x4AFB0CCC},
                                           {0x12345678, 600, 128, 0x4AD63494},
                                           {0xFFFFFFFEu, 1, 65535, 0x162D64},
                                           {0xFFFFFFFFu, 1, 65535, 0xFFFFFFFFu},
                                           {77777, 3, 3, 77777}};
    (void)state;
    for (unsigned i = 0; i < COUNT(examples); i++) {
        const uint32_t *e = examples[i];
        assert_int_equal(fx_correct_slices(e[0], e[1], e[2]), e[3]);
    }
}

static void S69_opacity_and_light(void **state)
{
    static const uint32_t opacities[][2] = {
        {255, 0}, {256, 1}, {50529, 99}, {0x12345678, 596523}, {0xFFFFFFFFu, 8388608}};
    static const uint32_t levels[][2] = {
        {65536, 0x1010101}, {8355840, 0x7FFFFFFF}, {16711680, 0xFFFFFFFFu}, {12345, 0x306969}};
    static const uint32_t light[][3] = {
        {2139095040, 260046848, 528482304}, {3147975, 382695, 777735}, {1000000, 121569, 247059}};
    (void)state;
    for (unsigned i = 0; i < COUNT(opacities); i++)
        assert_int_equal(fx_opacity_q23(opacities[i][0]), opacities[i][1]);
    for (unsigned i = 0; i < COUNT(levels); i++)
        assert_int_equal(fx_opacity_of_level(levels[i][0]), levels[i][1]);
    assert_int_equal(fx_light_of_colour32(255, 0xFFFFFFFFu), 2139095040);
    assert_int_equal(fx_light_of_colour32(200, 50529), 19738);
    assert_int_equal(fx_light_of_colour32(128, 0x12345678), 76354974);
    assert_int_equal(fx_light_within(fx_light_of(54578080, QV_LIGHT_OF(QV_READ_OUT_8)),
                                     fx_light_of_colour(255, fx_opacity_q23(1136903107))),
                     54792112);
    assert_int_equal(QV_LIGHT_OF(QV_READ_OUT_8), 2155905153u);
    assert_int_equal(QV_LIGHT_OF(QV_READ_OUT_16), 2139160321u);
    assert_int_equal(QV_LIGHT_OF(QV_READ_OUT_CONVERTED), 4278255361u);
    for (unsigned i = 0; i < COUNT(light); i++) {
        assert_int_equal(fx_light_narrow(light[i][0], FX_FACTOR_5), light[i][1]);
        assert_int_equal(fx_light_narrow(light[i][0], FX_FACTOR_6), light[i][2]);
    }
}

static void S70_plain_blends(void **state)
{
    static const uint32_t plain[][5] = {{230, 255, 5, 8, 230},      {100, 200, 37, 8, 115},
                                        {1000, 4095, 17, 12, 1013}, {20, 31, 100, 8, 24},
                                        {20, 31, 9, 5, 23},         {40, 10, 33, 6, 24}};
    static const uint32_t associated[][5] = {
        {100, 100, 100, 8, 161}, {157, 0, 7, 8, 153}, {2000, 100, 1000, 12, 1612}};
    (void)state;
    for (unsigned i = 0; i < COUNT(plain); i++) {
        const uint32_t *e = plain[i];
        assert_int_equal(fx_blend_plain(e[0], e[1], e[2], e[3]), e[4]);
    }
    for (unsigned i = 0; i < COUNT(associated); i++) {
        const uint32_t *e = associated[i];
        assert_int_equal(fx_blend_associated(e[0], e[1], e[2], e[3]), e[4]);
    }
}

static void S71_blends_of_light(void **state)
{
    static const uint32_t dithered[][6] = {{100, 19800, 99, 0xFFFF1234u, 0, 101},
                                           {100, 19800, 99, 0, 0, 100},
                                           {4000, 6172800, 123456, 0x87654321u, 4, 3953},
                                           {12345, 1081710, 4242, 0x87654321u, 8, 12372},
                                           {65280, 1081710, 4242, 0xFFFFFFFFu, 8, 65280},
                                           {31, 3500000, 500000, 0xE0000000u, 0, 30}};
    static const uint32_t rounded[][4] = {{1234567, 200, 50529, 1234707},
                                          {16711680, 255, 0x12345678, 16711680},
                                          {16711680, 0, 0xFFFFFFFFu, 0},
                                          {5, 3, 0xFFFFFFFFu, 196608}};
    (void)state;
    for (unsigned i = 0; i < COUNT(dithered); i++) {
        const uint32_t *e = dithered[i];
        assert_int_equal(fx_blend_dithered(e[0], e[1], e[2], e[3], e[4]), e[5]);
    }
    for (unsigned i = 0; i < COUNT(rounded); i++) {
        const uint32_t *e = rounded[i];
        assert_int_equal(fx_blend_8_16(e[0], fx_light_of_colour32(e[1], e[2]), e[2], FX_NO_DITHER),
                         e[3]);
    }
    const uint32_t light = fx_light_of_colour32(255, 0x12345678);
    assert_int_equal(fx_blend_8_16(16711680, light, 0x12345678, 0xFFFFFFFFu), 16711680);
}

static void S72_transmittance_and_share(void **state)
{
    (void)state;
    assert_int_equal(FX_CLEAR_Q24, 0xFFFFFF);
    assert_int_equal(fx_transmit(0xFFFFFF, 50529), 16777018);
    assert_int_equal(fx_transmit(0xFFFFFF, 0x80000000u), 8388608);
    assert_int_equal(fx_transmit(12345, 0x12345678), 11467);
    assert_int_equal(fx_transmit(0xFFFFFF, 0xFFFFFFFFu), 0);
    assert_int_equal(fx_opaque_share(255, 0xFFFFFF, 16), 1);
    assert_int_equal(fx_opaque_share(200, 12345678, 0), 53);
    assert_int_equal(fx_opaque_share(200, 12345678, 8), 13524);
    assert_int_equal(fx_opaque_share(200, 12345678, 16), 3462139);
    assert_int_equal(fx_opaque_share(255, 0, 16), 16711680);
}

static void S73_front_to_back(void **state)
{
    static const uint32_t examples[][5] = {{50, 0x87654321u, 0, 60, 60},
                                           {800, 0x87654321u, 4, 968, 967},
                                           {12345, 0x87654321u, 8, 15024, 15024},
                                           {3210987, FX_NO_DITHER, 16, 3896858, 3896858}};
    const uint32_t before = 12345678, opacity = 0x12345678, after = 11467763;
    const uint32_t light = fx_light_of_colour32(200, opacity);
    (void)state;
    assert_int_equal(fx_transmit(before, opacity), after);
    for (unsigned i = 0; i < COUNT(examples); i++) {
        const uint32_t *e = examples[i];
        assert_int_equal(fx_front_colour(e[0], 200, before, after, e[2]), e[3]);
        assert_int_equal(fx_front_light(e[0], light, before, after, e[1], e[2]), e[4]);
    }
    assert_int_equal(fx_front_light(fx_opaque_share(255, before, 8),
                                    fx_light_of_colour32(255, opacity), before, after, 0xFFFFFFFFu,
                                    8),
                     20659);
}

static void S74_residual(void **state)
{
    static const int32_t examples[][4] = {{12345, 8, 48, 57}, {127, 8, 0, 127},  {128, 8, 1, -128},
                                          {65280, 8, 255, 0}, {1000, 4, 63, -8}, {1001, 4, 63, -7},
                                          {4080, 4, 255, 0}};
    (void)state;
    for (unsigned i = 0; i < COUNT(examples); i++) {
        const uint32_t held = (uint32_t)examples[i][0], level = (uint32_t)examples[i][2];
        const unsigned fraction = (unsigned)examples[i][1];
        const int32_t residual = fx_residual_of(held, fraction);
        assert_int_equal(fx_level_of(held, fraction), level);
        assert_int_equal(residual, examples[i][3]);
        assert_int_equal(fx_state_of(level, residual, fraction), held);
    }
    assert_int_equal(fx_level_of(8421504, 16), 129);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S64_dither_values),
        cmocka_unit_test(S65_hits),
        cmocka_unit_test(S66_patterns),
        cmocka_unit_test(S67_plateaus),
        cmocka_unit_test(S68_number_of_slices),
        cmocka_unit_test(S69_opacity_and_light),
        cmocka_unit_test(S70_plain_blends),
        cmocka_unit_test(S71_blends_of_light),
        cmocka_unit_test(S72_transmittance_and_share),
        cmocka_unit_test(S73_front_to_back),
        cmocka_unit_test(S74_residual),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
