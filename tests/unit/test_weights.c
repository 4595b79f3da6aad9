/*
 * The weights of trilinear interpolation for every fraction.
 */
#include "check.h"
#include "weights.h"

/* Weights as plain numbers, of places in 256ths. */
static void weights_of(int32_t w[8], uint32_t x, uint32_t y, uint32_t z)
{
    const fx_fraction f[3] = {fx_fraction_of(x), fx_fraction_of(y), fx_fraction_of(z)};
    fx_weight weight[8];
    qv_weights(weight, f);
    for (unsigned i = 0; i < 8; i++)
        w[i] = (int32_t)fx_weight_bits(weight[i]);
}

/* The exact weight of a corner times 256: bit 0 of i is x, bit 2 z. */
static int32_t exact(unsigned i, int32_t x, int32_t y, int32_t z)
{
    const int32_t on_x = (i & 1) != 0 ? x : 256 - x;
    const int32_t on_y = (i & 2) != 0 ? y : 256 - y;
    const int32_t on_z = (i & 4) != 0 ? z : 256 - z;
    return on_x * on_y * on_z;
}

/* All 2^24 places: the sum is 1, no weight is negative, and each is that of the
   real numbers to nearest, up to the direction of ties. */
static void every_fraction(void **state)
{
    uint32_t sums = 0, negative = 0, far = 0;
    (void)state;

    for (uint32_t place = 0; place < 1u << 24; place++) {
        const uint32_t x = place & 255, y = place >> 8 & 255, z = place >> 16;
        int32_t w[8], sum = 0;
        weights_of(w, x, y, z);
        for (unsigned i = 0; i < 8; i++) {
            const int32_t error = w[i] * 256 - exact(i, (int32_t)x, (int32_t)y, (int32_t)z);
            sum += w[i];
            negative += w[i] < 0;
            far += error < -128 || error > 128;
        }
        sums += sum != (int32_t)FX_WEIGHT_ONE;
    }
    assert_int_equal(sums, 0);
    assert_int_equal(negative, 0);
    assert_int_equal(far, 0);
}

/* The one rounding is that of xyz, to nearest with ties upwards; so the weights of
   each face sum to the exact fraction. */
static void faces_sum_to_the_fraction(void **state)
{
    uint32_t wrong = 0;
    (void)state;

    for (uint32_t place = 0; place < 1u << 24; place += 7) {
        const uint32_t x = place & 255, y = place >> 8 & 255, z = place >> 16;
        int32_t w[8];
        weights_of(w, x, y, z);
        wrong += w[7] != (int32_t)((x * y * z + 128) >> 8);
        wrong += w[1] + w[3] + w[5] + w[7] != (int32_t)(x << 8);
        wrong += w[2] + w[3] + w[6] + w[7] != (int32_t)(y << 8);
        wrong += w[4] + w[5] + w[6] + w[7] != (int32_t)(z << 8);
    }
    assert_int_equal(wrong, 0);
}

static void a_corner_has_all_the_weight(void **state)
{
    int32_t w[8];
    (void)state;

    weights_of(w, 0, 0, 0);
    for (unsigned i = 0; i < 8; i++)
        assert_int_equal(w[i], i == 0 ? FX_WEIGHT_ONE : 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fraction),
        cmocka_unit_test(faces_sum_to_the_fraction),
        cmocka_unit_test(a_corner_has_all_the_weight),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
