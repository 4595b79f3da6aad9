/*
 * The worked examples S38 .. S44 of tests/SPEC.md: optical depth. The same inputs
 * and results as there, written out.
 */
#include "check.h"
#include "fx_correct.h"
#include "fx_log.h"
#include "fx_phi.h"

/* An input and its result. */
typedef struct example {
    uint64_t input, result;
} example;

#define expect_examples(function, type, examples)                                                  \
    do {                                                                                           \
        for (unsigned i = 0; i < sizeof(examples) / sizeof *(examples); i++)                       \
            assert_true(function((type)(examples)[i].input) == (examples)[i].result);              \
    } while (0)

static void S38_transmittance(void **state)
{
    static const example examples[] = {{0, 2147483648u},          {1, 2147483648u},
                                       {0x80000000u, 1518500250}, {0x100000000, 1073741824},
                                       {0x123456789, 975943388},  {0x1FFFFFFFFF, 1},
                                       {0x2000000000, 0}};
    (void)state;
    expect_examples(fx_transmittance, fx_depth, examples);
}

static void S39_transmittance_of_16_bits(void **state)
{
    static const example examples[] = {{0, 65535},        {1, 65535},         {0x258, 65533},
                                       {0x800000, 46340}, {0x1000000, 32768}, {0x1234567, 29783},
                                       {0x10FFFFFF, 0},   {0x11000000, 0}};
    (void)state;
    expect_examples(fx_transmittance16, uint32_t, examples);
}

static void S40_depth(void **state)
{
    static const example examples[] = {{0xFFFFFFFFu, 0},           {0xFFFF0000u, 0x17154},
                                       {0x80000000u, 0x100000006}, {0x12345678, 0x3D053F6CC},
                                       {1, 0x2000000006},          {0, 0x4000000000}};
    (void)state;
    expect_examples(fx_depth_of_transmittance, uint32_t, examples);
}

static void S41_extinction(void **state)
{
    static const example wide[] = {{0, 0},
                                   {1, 0x171},
                                   {12345, 0x4D1595},
                                   {32768, 0x1000171},
                                   {65534, 0xFFFFE8F},
                                   {65535, 0x40000000}};
    static const example narrow[] = {
        {1, 0x17382}, {128, 0x1017382}, {254, 0x7FE8DF2}, {255, 0x40000000}};
    (void)state;
    expect_examples(fx_extinction_of_unorm16, fx_unorm16, wide);
    expect_examples(fx_extinction_of_unorm8, fx_unorm8, narrow);
}

static void S42_reciprocal(void **state)
{
    static const example examples[] = {{0x80000000u, 0x8000000},
                                       {0x7FFFFFFF, 0x8000000},
                                       {0x55555555, 0xBFFFFFF},
                                       {0x40000000, 0xFFFFF1D},
                                       {0x0B504F33, 0x5A827933}};
    (void)state;
    expect_examples(fx_reciprocal, uint32_t, examples);
}

static void S43_phi(void **state)
{
    static const example examples[] = {{0, 0x80000000u},          {0x40000000, 0x7585FFA0},
                                       {0x1FFFFFFFF, 0x453FD630}, {0x200000000, 0x453FD630},
                                       {0x512345678, 0x2354F4C5}, {0x2000000000, 0x5C551D9},
                                       {0x123456789ABCDEF, 0xA2}};
    (void)state;
    expect_examples(fx_phi, fx_depth, examples);
}

static void S44_correction(void **state)
{
    static const struct {
        fx_unorm16 opacity;
        uint32_t ratio, corrected, factor;
    } examples[] = {{1, 4096, 0, 0x80003B},          {1, 1048576, 16, 0x7FFC3FD0},
                    {12345, 32768, 6494, 0x43561DC}, {12345, 200000, 30873, 0x1401C3D1},
                    {65534, 4096, 32767, 0x40003B9}, {65535, 4096, 65535, 0x8000000}};
    (void)state;
    assert_true(fx_depth_scale(0xF12345678, 100000) == 0x16FF271C70);
    for (unsigned i = 0; i < sizeof examples / sizeof *examples; i++) {
        assert_int_equal(fx_correct_opacity(examples[i].opacity, examples[i].ratio),
                         examples[i].corrected);
        assert_int_equal(fx_correct_colour(examples[i].opacity, examples[i].ratio),
                         examples[i].factor);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S38_transmittance), cmocka_unit_test(S39_transmittance_of_16_bits),
        cmocka_unit_test(S40_depth),         cmocka_unit_test(S41_extinction),
        cmocka_unit_test(S42_reciprocal),    cmocka_unit_test(S43_phi),
        cmocka_unit_test(S44_correction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
