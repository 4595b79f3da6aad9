/*
 * Wide products, shifts and divisions against the compiler's 64-bit arithmetic.
 * test_fx_wide_narrow.c runs this file with the form for machines without a
 * wide multiplication.
 */
#include "check.h"
#include "fx_wide.h"
#include "random.h"

#define ROUNDS 2000000

static const uint32_t edges[] = {0,          1,          2,          3,          0x7FFF,
                                 0x8000,     0xFFFE,     0xFFFF,     0x10000,    0x10001,
                                 0x18000,    0x7FFFFFFF, 0x80000000, 0x80008000, 0xFFFF0000,
                                 0xFFFF8000, 0xFFFEFFFF, 0xFFFFFFFE, 0xFFFFFFFF};
#define EDGES (sizeof edges / sizeof edges[0])

/* A number of any length in bits. */
static uint32_t any_length(uint32_t *seed)
{
    return random_next(seed) >> random_below(seed, 32);
}

static uint64_t any_length64(uint32_t *seed)
{
    const uint64_t high = random_next(seed);
    return (high << 32 | random_next(seed)) >> random_below(seed, 64);
}

static void check_products(uint32_t a, uint32_t b)
{
    const uint64_t product = (uint64_t)a * b;
    const uint16_t half = (uint16_t)b;

    assert_true(fx_wide_product(a, b) == product);
    assert_true(fx_wide_product_narrow(a, b) == product);
    assert_int_equal(fx_high_product(a, b), (product + 0x80000000u) >> 32);
    assert_int_equal(fx_high_product_narrow(a, b), (product + 0x80000000u) >> 32);
    assert_int_equal(fx_high_product_digits(a, b), (product + 0x80000000u) >> 32);
    assert_int_equal(fx_add_high_product(half, a, b),
                     (uint32_t)(half + ((product + 0x80000000u) >> 32)));
    assert_int_equal(fx_product_shift16(a, half), (uint64_t)a * half >> 16);
}

static void products(void **state)
{
    uint32_t seed = 47;
    (void)state;

    for (unsigned i = 0; i < EDGES; i++)
        for (unsigned j = 0; j < EDGES; j++)
            check_products(edges[i], edges[j]);
    for (unsigned i = 0; i < ROUNDS; i++)
        check_products(any_length(&seed), any_length(&seed));
}

/* Halves: a * 2^31 / 2^32 for odd a. */
static void high_product_ties_go_upwards(void **state)
{
    (void)state;

    for (uint32_t a = 1; a < 0xFFFFFF00u; a += 65538) {
        assert_int_equal(fx_high_product(a, 0x80000000u), a / 2 + 1);
        assert_int_equal(fx_high_product_narrow(a, 0x80000000u), a / 2 + 1);
    }
}

/* floor(v / 2^n) by division, which truncates, for n <= 62. */
static int64_t floor_shift(int64_t v, unsigned n)
{
    const int64_t divisor = (int64_t)1 << n;
    return v / divisor - (v % divisor < 0);
}

static void shifts_floor(void **state)
{
    uint32_t seed = 53;
    (void)state;

    for (unsigned n = 0; n < 63; n++) {
        for (unsigned i = 0; i < 20000; i++) {
            const int64_t v = (int64_t)(any_length64(&seed) >> 1);
            assert_true(fx_shift_floor(v, n) == floor_shift(v, n));
            assert_true(fx_shift_floor(-v, n) == floor_shift(-v, n));
        }
        assert_true(fx_shift_floor(INT64_MIN, n) == floor_shift(INT64_MIN, n));
        assert_true(fx_shift_floor(INT64_MAX, n) == floor_shift(INT64_MAX, n));
        assert_true(fx_shift_floor(-1, n) == -1);
    }
}

static void multiplication_by_a_signed_number(void **state)
{
    uint32_t seed = 59;
    (void)state;

    for (unsigned i = 0; i < ROUNDS; i++) {
        const int32_t n = (int32_t)(any_length(&seed) >> 1) - (int32_t)(any_length(&seed) >> 1);
        const uint64_t size = any_length64(&seed) >> 1;
        const uint64_t limit =
            (uint64_t)INT64_MAX / (n == 0 ? 1 : (uint64_t)(n < 0 ? -(int64_t)n : n));
        const int64_t v = (int64_t)(size <= limit ? size : size % limit);

        assert_true(fx_multiply(v, n) == v * n);
        assert_true(fx_multiply(-v, n) == -v * n);
    }
    assert_true(fx_multiply((int64_t)1 << 31, INT32_MIN) == -((int64_t)1 << 62));
    assert_true(fx_multiply(-1, INT32_MIN) == (int64_t)1 << 31);
    assert_true(fx_multiply((int64_t)1 << 32, INT32_MIN) == INT64_MIN);
}

/* round(v * factor / 2^30), ties upwards, on two parts of v. */
static int64_t scaled(int64_t v, int32_t factor)
{
    const int64_t whole = floor_shift(v, 30), rest = v - whole * 0x40000000;
    return whole * factor + floor_shift(rest * factor + 0x20000000, 30);
}

static void scaling_by_a_fraction(void **state)
{
    const int32_t one = 0x40000000;
    uint32_t seed = 61;
    (void)state;

    for (unsigned i = 0; i < ROUNDS; i++) {
        const int64_t v = (int64_t)(any_length64(&seed) >> 3) * (i % 2 != 0 ? 1 : -1);
        const int32_t factor = (int32_t)(any_length(&seed) >> 1) * (i % 4 < 2 ? 1 : -1);
        assert_true(fx_scale_q30(v, factor) == scaled(v, factor));
        assert_true(fx_scale_q30(v, one) == v);
        assert_true(fx_scale_q30(v, -one) == -v);
    }
    assert_true(fx_scale_q30(1, one / 2) == 1);
    assert_true(fx_scale_q30(-1, one / 2) == 0);
    assert_true(fx_scale_q30(-3, one / 2) == -1);
    assert_true(fx_scale_q30(1, one / 2 - 1) == 0);
    assert_true(fx_scale_q30(((int64_t)1 << 61) - 1, INT32_MIN) == 2 - ((int64_t)1 << 62));
}

static void division(void **state)
{
    uint32_t seed = 67;
    (void)state;

    for (unsigned i = 0; i < ROUNDS / 4; i++) {
        const uint64_t n = any_length64(&seed);
        const uint32_t d = 1 + any_length(&seed) % 0x7FFFFFFFu;
        assert_true(fx_divide(n, d) == n / d);
    }
    assert_true(fx_divide(UINT64_MAX, 1) == UINT64_MAX);
    assert_true(fx_divide(UINT64_MAX, 0x7FFFFFFF) == UINT64_MAX / 0x7FFFFFFF);
    assert_true(fx_divide(0, 5) == 0);
}

/* round(n / d), ties upwards, without n + d / 2. */
static uint64_t rounded(uint64_t n, uint64_t d)
{
    return n / d + (n % d >= d - d / 2);
}

static void quotients_of_16_bits(void **state)
{
    uint32_t seed = 71;
    (void)state;

    for (unsigned i = 0; i < ROUNDS; i++) {
        const uint64_t d = any_length64(&seed) + 1;
        const uint64_t any = any_length64(&seed), limit = UINT64_MAX - d / 2;
        const uint64_t n = any < limit ? any : limit;
        const uint64_t near = (d >> 17) * random_below(&seed, 131072) + random_below(&seed, 2);
        assert_int_equal(fx_quotient16(n, d), rounded(n, d) < 65535 ? rounded(n, d) : 65535);
        if (near < limit)
            assert_int_equal(fx_quotient16(near, d), rounded(near, d));
    }
    assert_int_equal(fx_quotient16(5, 10), 1);
    assert_int_equal(fx_quotient16(4, 10), 0);
    assert_int_equal(fx_quotient16(4, 9), 0);
    assert_int_equal(fx_quotient16(5, 9), 1);
    assert_int_equal(fx_quotient16(131068, 2), 65534);
    assert_int_equal(fx_quotient16(131069, 2), 65535);
    assert_int_equal(fx_quotient16(131071, 2), 65535);
    assert_int_equal(fx_quotient16(0xFFFF0000FFFFu, 0x100000001u), 65535);
    assert_int_equal(fx_quotient16(UINT64_MAX, 1), 65535);
    assert_int_equal(fx_quotient16(1, 0), 65535);
    assert_int_equal(fx_quotient16(0, 0), 65535);
    assert_int_equal(fx_quotient16(0, UINT64_MAX), 0);
    assert_int_equal(fx_quotient16(UINT64_MAX >> 1, UINT64_MAX), 0);
    assert_int_equal(fx_quotient16((uint64_t)1 << 63, UINT64_MAX), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products),
        cmocka_unit_test(high_product_ties_go_upwards),
        cmocka_unit_test(shifts_floor),
        cmocka_unit_test(multiplication_by_a_signed_number),
        cmocka_unit_test(scaling_by_a_fraction),
        cmocka_unit_test(division),
        cmocka_unit_test(quotients_of_16_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
