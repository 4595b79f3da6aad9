/*
 * The worked examples S75 .. S77 of tests/SPEC.md: opacities for blends of 8 bits, and
 * replay. The same inputs and results as there, written out.
 */
#include "check.h"
#include "fx_alpha.h"
#include "qvol.h"

#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* In each phase of a period: base, or more where its bit is 1. */
static void check_ordered(const fx_alpha *of, uint32_t opacity, uint32_t base, uint32_t phases)
{
    for (uint32_t k = 0; k < of->period.slices; k++)
        assert_int_equal(fx_alpha_ordered(of, opacity, k), base + (phases >> k & 1));
}

static void check_bumped(const fx_alpha *of, uint32_t opacity, uint32_t value, uint32_t base,
                         uint32_t bump, uint32_t phases)
{
    for (uint32_t k = 0; k < of->period.slices; k++)
        assert_int_equal(fx_alpha_bumped(of, opacity, k, value),
                         base + (phases >> k & 1 ? bump : 0));
}

static void S75_opacities_by_equation_9(void **state)
{
    const fx_alpha one = {fx_period_of(32), {49152, 65536}, 255};
    const fx_alpha other = {fx_period_of(16), {65536, 65536}, 3};
    (void)state;
    check_ordered(&one, 65536, 0, 0xEEEEEEEEu);
    assert_int_equal(fx_alpha_random(&one, 65536, 0xBFFFFFFFu), 1);
    assert_int_equal(fx_alpha_random(&one, 65536, 0xC0000000u), 0);
    check_bumped(&one, 32768, 127, 0, 1, 0xA4A4A4A4u);
    check_bumped(&one, 32768, 128, 0, 3,
                 1u << 6 | 1u << 12 | 1u << 19 | 1u << 25 | (uint32_t)1 << 31);
    check_bumped(&one, 32768, 213, 0, 7, 1u << 15 | (uint32_t)1 << 31);
    check_bumped(&one, 32768, 250, 0, 31, (uint32_t)1 << 31);
    check_ordered(&other, 150733, 2, 1u << 3 | 1u << 6 | 1u << 9 | 1u << 12 | 1u << 15);
    assert_int_equal(fx_alpha_ordered(&other, 236608, 0), 4);
    assert_int_equal(fx_alpha_random(&other, 226608, 0), 3);
    check_bumped(&other, 163840, 213, 2, 7, 1u << 15);
    assert_int_equal(fx_alpha_bumped_random(&other, 163840, 0x0FFFFFFF, 213), 9);
    assert_int_equal(fx_alpha_bumped_random(&other, 163840, 0x10000000, 213), 2);
}

static void S76_corrected_opacities(void **state)
{
    static const uint32_t examples[][5] = {{65536, 255, 200, 0, 1},
                                           {65536, 255, 200, 0xE0000000u, 3},
                                           {32768, 255, 250, 0xFFFFFFFFu, 26},
                                           {32768, 255, 250, 0, 1},
                                           {98304, 10, 20, 0, 13},
                                           {98304, 10, 20, 0xFFFFFFFFu, 2},
                                           {98304, 100, 100, 5, 2},
                                           {16711680, 7, 250, 0, 255},
                                           {163840, 255, 50, 0x80000000u, 3},
                                           {300000, 0, 240, 0x12345678, 5}};
    (void)state;
    assert_int_equal(fx_alpha_rounded(32767), 0);
    assert_int_equal(fx_alpha_rounded(32768), 1);
    assert_int_equal(fx_alpha_rounded(150733), 2);
    for (unsigned i = 0; i < COUNT(examples); i++) {
        const uint32_t *e = examples[i];
        assert_int_equal(fx_alpha_corrected(e[0], e[1], e[2], e[3]), e[4]);
    }
}

static void S77_replay(void **state)
{
    static const struct {
        uint8_t rgba[4], far[4], near[4], result[4];
    } examples[] = {
        {{255, 255, 255, 1}, {100, 100, 100, 100}, {100, 100, 100, 100}, {128, 128, 128, 128}},
        {{200, 100, 0, 30}, {90, 46, 255, 200}, {129, 64, 0, 161}, {161, 82, 94, 235}},
        {{255, 255, 255, 3}, {255, 0, 0, 255}, {93, 93, 93, 93}, {255, 93, 93, 255}},
        {{10, 20, 30, 40}, {77, 77, 77, 77}, {1, 2, 3, 4}, {77, 78, 79, 80}},
        {{7, 8, 9, 0}, {1, 2, 3, 4}, {0, 0, 0, 0}, {1, 2, 3, 4}}};
    const qv_rect rect = {0, 0, 1, 1};
    (void)state;
    for (unsigned i = 0; i < COUNT(examples); i++) {
        uint8_t far[4], near[4];
        const qv_buffer behind = {far, NULL, 4, 0, 4, 0, &qv_hardware_rgba8888};
        const qv_buffer front = {near, NULL, 4, 0, 4, 0, &qv_hardware_rgba8888};
        memcpy(far, examples[i].far, 4);
        memcpy(near, examples[i].near, 4);
        assert_int_equal(qv_replay(&behind, &front, examples[i].rgba, &rect), QV_OK);
        assert_memory_equal(far, examples[i].result, 4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S75_opacities_by_equation_9),
        cmocka_unit_test(S76_corrected_opacities),
        cmocka_unit_test(S77_replay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
