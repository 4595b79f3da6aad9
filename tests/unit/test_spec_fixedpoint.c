/*
 * The worked examples S1 .. S7 of tests/SPEC.md: fixed-point operations. The same
 * inputs and results as there, written out.
 */
#include "check.h"
#include "fx_angle.h"
#include "fx_root.h"
#include "fx_unorm.h"
#include "fx_wide.h"

static void S1_high_product(void **state)
{
    (void)state;
    assert_int_equal(fx_high_product(0x7FFFFFFFu, 1), 0);
    assert_int_equal(fx_high_product(0x80000000u, 1), 1);
    assert_int_equal(fx_high_product(0xFFFFFFFFu, 0xFFFFFFFFu), 0xFFFFFFFEu);
    assert_int_equal(fx_high_product(0x80000000u, 0xFFFFFFFFu), 0x80000000u);
}

static void S2_product_cut(void **state)
{
    (void)state;
    assert_int_equal(fx_product_shift16(4294901760u, 65535), 4294836225u);
    assert_int_equal(fx_product_shift16(65537u, 65535), 65535);
}

static void S3_scale(void **state)
{
    (void)state;
    assert_int_equal(fx_scale_q30(3, 1 << 29), 2);
    assert_int_equal(fx_scale_q30(-3, 1 << 29), -1);
    assert_int_equal(fx_scale_q30(-0x123456789ABCDEF, 0x2AAAAAAB), -54657019503109588);
}

static void S4_divide(void **state)
{
    (void)state;
    assert_int_equal(fx_divide(0xFFFFFFFFFFFFFFFFu, 0x7FFFFFFFu), 8589934596);
    assert_int_equal(fx_divide(6, 7), 0);
}

static void S5_sine_cosine(void **state)
{
    static const struct {
        fx_angle angle;
        int32_t sine, cosine;
    } examples[] = {{0x00000000, 0, 1073741824},          {0x00000001, 2, 1073741824},
                    {0x15555555, 536870912, 929887697},   {0x20000000, 759250125, 759250125},
                    {0x2AAAAAAB, 929887697, 536870912},   {0x40000000, 1073741824, 0},
                    {0x9ABCDEF0, -655138360, -850714543}, {0x1FD443BD, 756059865, 762427037},
                    {0x1F5FB1B3, 747491899, 770829011}};
    (void)state;
    for (unsigned i = 0; i < sizeof examples / sizeof *examples; i++) {
        int32_t sine, cosine;
        fx_sine_cosine(&sine, &cosine, examples[i].angle);
        assert_int_equal(sine, examples[i].sine);
        assert_int_equal(cosine, examples[i].cosine);
    }
}

static void S6_reciprocal_root(void **state)
{
    static const struct {
        uint64_t n;
        uint32_t root;
        unsigned exponent;
    } examples[] = {{0, 2147483647u, 1},
                    {1, 2147483647u, 1},
                    {2, 1518500250u, 1},
                    {3, 1239850262u, 1},
                    {UINT64_C(1) << 46, 2147483647u, 24},
                    {UINT64_C(3) << 60, 1239850262u, 31},
                    {UINT64_MAX, 1073741824u, 32},
                    {0x9D53107F85AB705E, 1369688196u, 32}};
    (void)state;
    for (unsigned i = 0; i < sizeof examples / sizeof *examples; i++) {
        unsigned exponent;
        assert_int_equal(fx_rsqrt(examples[i].n, &exponent), examples[i].root);
        assert_int_equal(exponent, examples[i].exponent);
    }
}

static void S7_unorm(void **state)
{
    (void)state;
    assert_int_equal(fx_unorm16_to_unorm8(128), 0);
    assert_int_equal(fx_unorm16_to_unorm8(129), 1);
    assert_int_equal(fx_unorm16_to_unorm8(33025), 129);
    assert_int_equal(fx_unorm16_to_unorm8(65535), 255);
    assert_int_equal(fx_div255_round(127), 0);
    assert_int_equal(fx_div255_round(128), 1);
    assert_int_equal(fx_div255_round(65025), 255);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S1_high_product), cmocka_unit_test(S2_product_cut),
        cmocka_unit_test(S3_scale),        cmocka_unit_test(S4_divide),
        cmocka_unit_test(S5_sine_cosine),  cmocka_unit_test(S6_reciprocal_root),
        cmocka_unit_test(S7_unorm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
