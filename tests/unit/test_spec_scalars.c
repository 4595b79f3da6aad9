/*
 * The worked examples S31 .. S36 of tests/SPEC.md: from scalars to voxels. The same
 * inputs and results as there, written out.
 */
#include "check.h"
#include "shade.h"
#include "unit_vector.h"

#include <string.h>

#define expect_vector(v, x, y, z)                                                                  \
    do {                                                                                           \
        assert_int_equal((v)[0], x);                                                               \
        assert_int_equal((v)[1], y);                                                               \
        assert_int_equal((v)[2], z);                                                               \
    } while (0)

static void S31_transfer_table(void **state)
{
    static const qv_control_point points[] = {{10, {0, 65535, 100, 0}}, {14, {3, 0, 100, 65535}}};
    static const uint16_t expected[][4] = {{0, 65535, 100, 0},
                                           {1, 49151, 100, 16384},
                                           {2, 32768, 100, 32768},
                                           {2, 16384, 100, 49151},
                                           {3, 0, 100, 65535}};
    static const uint8_t entry[] = {9, 11, 12, 13, 200};
    qv_transfer table;
    (void)state;
    assert_int_equal(qv_transfer_build(&table, points, 2), QV_OK);
    for (unsigned i = 0; i < sizeof entry; i++)
        assert_memory_equal(table.rgba[entry[i]], expected[i], sizeof expected[i]);
}

/* Compares the indices of scalars, at most seven. */
static void expect_indices(const int16_t *scalars, uint16_t count, int32_t low, int32_t high,
                           const uint8_t *expected)
{
    const void *values = scalars;
    const qv_classifier classifier = {.scalars = {.values = (qv_address)values,
                                                  .values_bytes = 2u * count,
                                                  .stride = {2, 0, 0},
                                                  .size = {count, 1, 1},
                                                  .type = QV_SCALAR_S16},
                                      .low = low,
                                      .high = high};
    const qv_block whole = {{0, 0, 0}, {count, 1, 1}};
    uint8_t index[7];
    assert_int_equal(qv_classify(index, count, QV_STORAGE_INDEXED8, &classifier, &whole), QV_OK);
    assert_memory_equal(index, expected, count);
}

static void S32_index(void **state)
{
    static const int16_t scalars[] = {-5, 0, 1, 2, 3, 509, 510};
    static const uint8_t indices[] = {0, 0, 1, 1, 2, 255, 255};
    static const int16_t scalar[] = {123};
    static const uint8_t index[] = {95};
    (void)state;
    expect_indices(scalars, 7, 0, 510, indices);
    expect_indices(scalar, 1, -1000, 2000, index);
}

static const uint32_t spacing[3] = {65536, 98304, 43691};

/* Whether differences make a gradient that is long enough. */
static int long_enough(const int32_t difference[3], const uint32_t lengths[3], uint16_t least,
                       uint32_t window)
{
    qv_gradient gradient;
    int32_t normal[3];
    qv_gradient_init(&gradient, lengths, least, window);
    return qv_gradient_normal(normal, &gradient, difference);
}

static const int32_t difference[3] = {300, -20, 7};

static void S33_least_gradient(void **state)
{
    static const int32_t one[3] = {1, 0, 0};
    static const uint32_t cubic[3] = {65536, 65536, 65536};
    static const uint32_t coarse[3] = {1 << 24, 1 << 24, 1 << 24};
    (void)state;
    assert_true(long_enough(difference, spacing, 38, 1000));
    assert_false(long_enough(difference, spacing, 39, 1000));
    assert_true(long_enough(one, cubic, 1, 128));
    assert_false(long_enough(one, cubic, 2, 128));
    assert_false(long_enough(one, coarse, 32768, 512));
}

static void S34_unit_vectors(void **state)
{
    static const int32_t v[3] = {3, -4, 0};
    static const uint64_t equal[3] = {1, 1, 1};
    qv_gradient gradient;
    int32_t unit[3];
    (void)state;
    qv_gradient_init(&gradient, spacing, 0, 1000);
    assert_true(qv_gradient_normal(unit, &gradient, difference));
    expect_vector(unit, -1072027794, 47645680, -37520687);
    qv_unit_vector(unit, v, equal);
    expect_vector(unit, 644245094, -858993459, 0);
}

static void S35_shading(void **state)
{
    static const qv_shading shading = {.light = {-300, -500, 400},
                                       .viewer = {0, -1, 0},
                                       .ambient = 80,
                                       .diffuse = 170,
                                       .specular = 60,
                                       .gloss = 4,
                                       .least_gradient = 2};
    static const int32_t towards[3] = {100, 200, -50}, away[3] = {-100, -200, 50};
    uint16_t lit[4] = {50000, 20000, 65535, 7}, dark[4] = {50000, 20000, 65535, 7};
    qv_shader shader;
    (void)state;
    assert_int_equal(qv_shader_init(&shader, &shading, spacing, 1000), QV_OK);
    expect_vector(shader.light, -455550075, -759250125, 607400100);
    expect_vector(shader.half, -246541924, -992008094, 328722566);
    qv_shade(lit, &shader, towards);
    expect_vector(lit, 52601, 23700, 65535);
    qv_shade(dark, &shader, away);
    expect_vector(dark, 15625, 6250, 20480);
}

/* Numbers for which every rounding of the highlight shows. */
static void S35_roundings_of_the_highlight(void **state)
{
    static const qv_shading shading = {.light = {-531, 944, -370},
                                       .viewer = {-84, -32, -12},
                                       .ambient = 177,
                                       .diffuse = 21,
                                       .specular = 41,
                                       .gloss = 4};
    static const int32_t slope[3] = {270, -252, -85};
    uint16_t lit[4] = {10982, 23195, 59214, 7};
    qv_shader shader;
    (void)state;
    assert_int_equal(qv_shader_init(&shader, &shading, spacing, 1000), QV_OK);
    expect_vector(shader.half, -971074740, 329636004, -318238055);
    qv_shade(lit, &shader, slope);
    expect_vector(lit, 8290, 17386, 44209);
}

static void S36_reduction(void **state)
{
    static const int16_t values[6] = {-5, -2, 4, 9, -30000, 32767};
    static const int16_t expected[2] = {-7499, 16386};
    static const uint8_t factor[3] = {2, 2, 1};
    const void *address = values;
    const qv_scalars scalars = {.values = (qv_address)address,
                                .values_bytes = sizeof values,
                                .stride = {2, 6, 12},
                                .size = {3, 2, 1},
                                .type = QV_SCALAR_S16};
    int16_t means[2];
    (void)state;
    assert_int_equal(qv_reduce(means, sizeof means, &scalars, factor, 0, 1), QV_OK);
    assert_memory_equal(means, expected, sizeof means);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S31_transfer_table), cmocka_unit_test(S32_index),
        cmocka_unit_test(S33_least_gradient), cmocka_unit_test(S34_unit_vectors),
        cmocka_unit_test(S35_shading),        cmocka_unit_test(S35_roundings_of_the_highlight),
        cmocka_unit_test(S36_reduction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
