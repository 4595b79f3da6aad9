/*
 * Unit vectors, the least gradient, and shading, against real numbers.
 */
#include "check.h"
#include "classify_reference.h"
#include "random.h"
#include "shade.h"
#include "unit_vector.h"

#include <math.h>
#include <string.h>

#define ROUNDS 200000

static const uint32_t CUBIC[3] = {0, 0, 0};

/* A component of either sign up to `limit`: often tiny, often the limit. */
static int32_t component(uint32_t *seed, int32_t limit)
{
    int32_t any = (int32_t)random_below(seed, 2 * (uint32_t)limit + 1) - limit;
    switch (random_below(seed, 4)) {
    case 0:
        return any % 3;
    case 1:
        return any % 300;
    case 2:
        return any < 0 ? -limit : limit;
    default:
        return any;
    }
}

/* Spacings from end to end of their range, 1 among them. */
static void random_spacing(uint32_t spacing[3], uint32_t *seed)
{
    for (unsigned a = 0; a < 3; a++) {
        uint32_t octave = 4096u << random_below(seed, 13);
        spacing[a] = octave == 1u << 24 ? octave : octave + random_below(seed, octave);
        if (random_below(seed, 4) == 0)
            spacing[a] = 0;
    }
}

static double spacing_of(const uint32_t spacing[3], unsigned axis)
{
    return spacing[axis] != 0 ? spacing[axis] / 65536.0 : 1;
}

static void unit_vectors(void **state)
{
    uint32_t seed = 17;
    double worst = 0;
    (void)state;

    for (unsigned i = 0; i < ROUNDS; i++) {
        uint32_t spacing[3];
        int32_t v[3], unit[3];
        qv_gradient g;
        double part[3], square = 0;

        random_spacing(spacing, &seed);
        qv_gradient_init(&g, spacing, 0, 1);
        for (unsigned a = 0; a < 3; a++) {
            v[a] = component(&seed, 65535);
            part[a] = v[a] / spacing_of(spacing, a);
            square += part[a] * part[a];
        }
        if (square == 0)
            continue;
        qv_unit_vector(unit, v, g.scale);
        for (unsigned a = 0; a < 3; a++) {
            worst = fmax(worst, fabs(part[a] / sqrt(square) - ldexp(unit[a], -30)));
            assert_true(unit[a] <= 1 << 30 && unit[a] >= -(1 << 30));
        }
    }
    assert_true(worst < ldexp(1, -27));
}

/* Along an axis a unit vector is 1 to 2^-27, however short or long the vector. */
static void unit_vectors_of_any_length(void **state)
{
    (void)state;

    for (unsigned bits = 0; bits < 64; bits++) {
        const uint64_t scale[3] = {(uint64_t)1 << bits, 1, 0};
        const int32_t v[3] = {-1, 0, 5};
        int32_t unit[3];

        qv_unit_vector(unit, v, scale);
        assert_in_range(-unit[0], (1 << 30) - 8, 1 << 30);
        assert_int_equal(unit[1], 0);
        assert_int_equal(unit[2], 0);
    }
}

static void cosines_are_clamped(void **state)
{
    const int32_t x[3] = {1 << 30, 0, 0}, back[3] = {-(1 << 30), 0, 0}, y[3] = {0, 1 << 30, 0};
    const int32_t long_one[3] = {1 << 30, 4096, 1 << 20};
    (void)state;

    assert_int_equal(qv_unit_cosine(x, x), 1 << 30);
    assert_int_equal(qv_unit_cosine(x, back), 0);
    assert_int_equal(qv_unit_cosine(x, y), 0);
    assert_int_equal(qv_unit_cosine(long_one, long_one), 1 << 30);
}

/* Whether a difference is long enough for a least gradient. */
static int long_enough(int32_t x, int32_t y, int32_t z, uint32_t spacing, uint16_t least,
                       uint32_t window)
{
    const uint32_t spacings[3] = {spacing, spacing, spacing};
    const int32_t d[3] = {x, y, z};
    int32_t normal[3];
    qv_gradient g;

    qv_gradient_init(&g, spacings, least, window);
    return qv_gradient_normal(normal, &g, d);
}

/* Pythagorean triples and quadruples hit the least gradient exactly. */
static void least_gradient_is_exact(void **state)
{
    (void)state;

    for (int32_t k = 1; k <= 13107; k += 13) {
        const uint16_t least = (uint16_t)k; /* |d| = 5k, window 640: 5k/2 * 256/640 = k */
        assert_true(long_enough(3 * k, -4 * k, 0, 0, least, 640));
        assert_false(long_enough(3 * k, -4 * k, 0, 0, (uint16_t)(least + 1), 640));
        assert_false(long_enough(3 * k, -4 * k + 1, 0, 0, least, 640));
        assert_false(long_enough(3 * k - 1, -4 * k, 0, 0, least, 640));
        assert_true(long_enough(3 * k, -4 * k, 1, 0, least, 640));
    }
    assert_true(long_enough(6, 10, -15, 65536 / 16, 19 * 8, 256));
    assert_false(long_enough(6, 10, -15, 65536 / 16 + 1, 19 * 8, 256));
    assert_true(long_enough(-6, 10, 15, 0, 19 * 128, 1));
    assert_false(long_enough(-6, 10, 14, 0, 19 * 128, 1));
    /* 65537^2 = 65535^2 + 512^2; |d| * 2^23 = 64 * 2^17 * 65537 */
    assert_true(long_enough(65535, 512, 0, 65537, 64, 131072));
    assert_false(long_enough(65535, 511, 0, 65537, 64, 131072));
    assert_true(long_enough(65535, 511, 32, 65537, 64, 131072));
    assert_false(long_enough(65535, 511, 31, 65537, 64, 131072));
}

/* Spacings that differ, and the ends of every range. */
static void least_gradient_over_its_range(void **state)
{
    uint32_t seed = 23;
    unsigned passed = 0;
    (void)state;

    for (unsigned i = 0; i < ROUNDS; i++) {
        uint32_t spacing[3], window = 1 + random_below(&seed, 196607);
        uint16_t least = (uint16_t)(random_next(&seed) >> (16 + random_below(&seed, 16)));
        int32_t d[3], normal[3];
        double square = 0;
        qv_gradient g;

        random_spacing(spacing, &seed);
        qv_gradient_init(&g, spacing, least, window);
        for (unsigned a = 0; a < 3; a++) {
            d[a] = component(&seed, 65535);
            square += pow(d[a] / (2 * spacing_of(spacing, a)), 2);
        }
        double excess = sqrt(square) * 256 / window - least;
        int expected = square > 0 && excess >= 0;
        int actual = qv_gradient_normal(normal, &g, d);
        /* Doubles cannot tell a tie; the test above does. */
        if (fabs(excess) > 1e-9 * least)
            assert_int_equal(actual, expected);
        passed += (unsigned)actual;
    }
    assert_in_range(passed, ROUNDS / 10, ROUNDS - ROUNDS / 10);
}

static void no_gradient_has_no_normal(void **state)
{
    (void)state;

    assert_false(long_enough(0, 0, 0, 0, 0, 1));
    assert_true(long_enough(0, 0, -1, 0, 0, 196607));
    assert_true(long_enough(0, 1, 0, 1 << 20, 0, 196607));
    assert_false(long_enough(0, 1, 0, 1 << 20, 1, 196607));
    assert_true(long_enough(65535, 65535, 65535, 4096, 1182, 196607));
    assert_false(long_enough(65535, 65535, 65535, 4096, 1183, 196607));
}

/* Shades one colour both ways and returns the greater distance in levels. */
static double shading_error(const qv_shading *shading, const uint32_t spacing[3],
                            const int32_t d[3], const uint16_t colour[4])
{
    uint16_t rgba[4];
    double expected[4], gradient[3], worst = 0;
    qv_shader shader;

    assert_int_equal(qv_shader_init(&shader, shading, spacing, 1000), QV_OK);
    for (unsigned c = 0; c < 4; c++)
        expected[c] = rgba[c] = colour[c];
    for (unsigned a = 0; a < 3; a++)
        gradient[a] = d[a] / (2 * spacing_of(spacing, a));
    qv_shade(rgba, &shader, d);
    ref_shade(expected, gradient, shading, 1000);
    for (unsigned c = 0; c < 4; c++)
        worst = fmax(worst, fabs(expected[c] - rgba[c]));
    assert_int_equal(rgba[3], colour[3]);
    return worst;
}

static void random_direction(int16_t v[3], uint32_t *seed)
{
    do {
        for (unsigned a = 0; a < 3; a++)
            v[a] = (int16_t)component(seed, 32767);
    } while (v[0] == 0 && v[1] == 0 && v[2] == 0);
}

static void random_shading(qv_shading *s, uint32_t *seed)
{
    random_direction(s->light, seed);
    random_direction(s->viewer, seed);
    s->ambient = (uint16_t)random_below(seed, 257);
    s->diffuse = (uint16_t)random_below(seed, 257);
    s->specular = (uint16_t)random_below(seed, 257);
    s->gloss = (uint8_t)random_below(seed, 8);
    s->least_gradient = 0;
}

/* Differences whose normal lies close to the half vector: the sharpest part of
   the highlight. */
static void towards_highlight(int32_t d[3], const qv_shading *s, const uint32_t spacing[3],
                              uint32_t *seed)
{
    qv_shader shader;
    double part[3], most = 0;

    assert_int_equal(qv_shader_init(&shader, s, spacing, 1000), QV_OK);
    if (shader.specular == 0)
        return;
    for (unsigned a = 0; a < 3; a++) {
        part[a] = shader.half[a] * spacing_of(spacing, a);
        most = fmax(most, fabs(part[a]));
    }
    for (unsigned a = 0; a < 3; a++)
        d[a] = (int32_t)lrint(-part[a] / most * 60000) + (int32_t)random_below(seed, 4001) - 2000;
}

static void shading_is_close_to_real_arithmetic(void **state)
{
    uint32_t seed = 29;
    double worst = 0;
    (void)state;

    for (unsigned i = 0; i < ROUNDS; i++) {
        uint16_t colour[4] = {65535, (uint16_t)random_next(&seed), 1, 12345};
        qv_shading s;
        uint32_t spacing[3];
        int32_t d[3];

        random_shading(&s, &seed);
        random_spacing(spacing, &seed);
        for (unsigned a = 0; a < 3; a++)
            d[a] = component(&seed, 65535);
        if (i % 2 == 0)
            towards_highlight(d, &s, spacing, &seed);
        worst = fmax(worst, shading_error(&s, spacing, d, colour));
    }
    assert_true(worst < 0.75);
}

/* Light and viewer 1/100 of a radian and less from opposite. */
static void grazing_highlights(void **state)
{
    uint32_t seed = 31;
    double worst = 0;
    (void)state;

    for (unsigned i = 0; i < ROUNDS; i++) {
        const uint16_t colour[4] = {0, 0, 0, 0};
        qv_shading s;
        int32_t d[3];

        random_shading(&s, &seed);
        s.specular = 256;
        s.gloss = 7;
        for (unsigned a = 0; a < 3; a++) {
            s.light[a] = (int16_t)(s.light[a] / 2);
            s.viewer[a] = (int16_t)((int32_t)random_below(&seed, 401) - 200 - s.light[a]);
            d[a] = component(&seed, 65535);
        }
        if (s.light[0] == 0 && s.light[1] == 0 && s.light[2] == 0)
            continue;
        if (s.viewer[0] == 0 && s.viewer[1] == 0 && s.viewer[2] == 0)
            continue;
        towards_highlight(d, &s, CUBIC, &seed);
        worst = fmax(worst, shading_error(&s, CUBIC, d, colour));
    }
    assert_true(worst < 0.75);
}

static void shaded(uint16_t rgba[4], const qv_shading *s, int32_t x, int32_t y, int32_t z)
{
    const int32_t d[3] = {x, y, z};
    qv_shader shader;

    assert_int_equal(qv_shader_init(&shader, s, CUBIC, 256), QV_OK);
    qv_shade(rgba, &shader, d);
}

/* A light straight ahead, an ambient light of 1, a highlight: all exact. */
static void exact_cases(void **state)
{
    qv_shading s = {{0, -7, 0}, {0, -300, 0}, 0, 256, 0, 0, 0};
    uint16_t rgba[4] = {65535, 12345, 0, 9};
    const uint16_t same[4] = {65535, 12345, 0, 9}, dark[4] = {0, 0, 0, 9};
    const uint16_t white[4] = {65535, 65535, 65535, 9}, half[4] = {32768, 6173, 0, 9};
    (void)state;

    shaded(rgba, &s, 0, 3, 0); /* rises along y, so the normal is -y */
    assert_memory_equal(rgba, same, sizeof rgba);
    s.ambient = 256;
    s.diffuse = 0;
    shaded(rgba, &s, 3, -4, 5);
    assert_memory_equal(rgba, same, sizeof rgba);
    s.ambient = 128;
    shaded(rgba, &s, 3, -4, 5); /* 32767.5, 6172.5 */
    assert_memory_equal(rgba, half, sizeof rgba);
    s.ambient = 0;
    s.specular = 256;
    s.gloss = 7;
    shaded(rgba, &s, 0, 1, 0);
    assert_memory_equal(rgba, white, sizeof rgba);
    shaded(rgba, &s, 0, -1, 0);
    assert_memory_equal(rgba, dark, sizeof rgba);
}

static void short_gradients_keep_the_colour(void **state)
{
    const qv_shading s = {{1, 0, 0}, {1, 0, 0}, 0, 0, 0, 0, 5};
    const uint16_t before[4] = {1, 2, 3, 4}, black[4] = {0, 0, 0, 4};
    uint16_t rgba[4] = {1, 2, 3, 4};
    (void)state;

    shaded(rgba, &s, 0, 0, 0);
    assert_memory_equal(rgba, before, sizeof rgba);
    shaded(rgba, &s, 9, 0, 0); /* 4.5 a unit */
    assert_memory_equal(rgba, before, sizeof rgba);
    shaded(rgba, &s, 10, 0, 0);
    assert_memory_equal(rgba, black, sizeof rgba);
}

static void opposite_light_has_no_highlight(void **state)
{
    qv_shading s = {{32767, 5, -3}, {-32767, -5, 3}, 0, 0, 256, 0, 0};
    const uint16_t black[4] = {0, 0, 0, 4};
    uint16_t rgba[4] = {0, 0, 0, 4};
    (void)state;

    shaded(rgba, &s, 0, 1, 1);
    assert_memory_equal(rgba, black, sizeof rgba);
    s.viewer[1] = 100; /* .003 radians apart */
    shaded(rgba, &s, 0, -1, 0);
    assert_memory_equal(rgba, black, sizeof rgba);
    s.viewer[1] = 130; /* .0041 radians: halfway is nearly +y */
    shaded(rgba, &s, 0, -1, 0);
    assert_true(rgba[0] > 65000);
}

static void bad_shading_is_refused(void **state)
{
    const qv_shading good = {{0, 0, 1}, {1, 0, 0}, 256, 256, 256, 7, 65535};
    qv_shading bad[6] = {good, good, good, good, good, good};
    qv_shading lambert = good;
    qv_shader shader;
    (void)state;

    assert_int_equal(qv_shader_init(&shader, &good, CUBIC, 1), QV_OK);
    bad[0].ambient = 257;
    bad[1].diffuse = 257;
    bad[2].specular = 257;
    bad[3].gloss = 8;
    bad[4].light[2] = 0;
    bad[5].viewer[0] = 0;
    for (unsigned i = 0; i < 6; i++)
        assert_int_equal(qv_shader_init(&shader, &bad[i], CUBIC, 1), QV_ERROR_LIGHT);
    lambert.viewer[0] = 0;
    lambert.specular = 0;
    assert_int_equal(qv_shader_init(&shader, &lambert, CUBIC, 1), QV_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unit_vectors),
        cmocka_unit_test(unit_vectors_of_any_length),
        cmocka_unit_test(cosines_are_clamped),
        cmocka_unit_test(least_gradient_is_exact),
        cmocka_unit_test(least_gradient_over_its_range),
        cmocka_unit_test(no_gradient_has_no_normal),
        cmocka_unit_test(shading_is_close_to_real_arithmetic),
        cmocka_unit_test(grazing_highlights),
        cmocka_unit_test(exact_cases),
        cmocka_unit_test(short_gradients_keep_the_colour),
        cmocka_unit_test(opposite_light_has_no_highlight),
        cmocka_unit_test(bad_shading_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
