/*
 * Media of several materials (Kraus and Buerger 2008, section 3.1): the sums against
 * 64-bit arithmetic, voxels against double precision, and what the paper claims of them.
 */
#include "check.h"
#include "qvol.h"
#include "random.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define ROUNDS 20000
#define MOST   8   /* materials of a mixture */
#define SOME   255 /* of a percentage that may be multiplied by 256 */

typedef struct medium {
    qv_material material[MOST];
    uint16_t count;
} medium;

static void set_medium(medium *m, uint32_t *seed)
{
    m->count = (uint16_t)(1 + random_below(seed, MOST));
    for (uint16_t i = 0; i < m->count; i++) {
        for (unsigned c = 0; c < 3; c++)
            m->material[i].colour[c] = (uint16_t)random_next(seed);
        m->material[i].extinction = random_next(seed) >> random_below(seed, 32);
    }
}

/* Percentages that sum to at most `whole`. */
static void set_percentages(uint16_t p[MOST], uint16_t count, uint32_t whole, uint32_t *seed)
{
    for (uint16_t i = 0; i < count; i++) {
        p[i] = (uint16_t)random_below(seed, whole + 1);
        whole -= p[i];
    }
}

static qv_mixture mix(const medium *m, const uint16_t p[MOST])
{
    qv_mixture mixture;
    assert_int_equal(qv_mix(&mixture, m->material, p, m->count), QV_OK);
    return mixture;
}

/* Equations 6 and 7. */
static void sums_are_exact(void **state)
{
    uint32_t seed = 73;
    (void)state;
    for (unsigned round = 0; round < ROUNDS; round++) {
        medium m;
        uint16_t p[MOST];
        uint64_t extinction = 0, light[3] = {0, 0, 0};
        set_medium(&m, &seed);
        set_percentages(p, m.count, 65535, &seed);
        for (uint16_t i = 0; i < m.count; i++) {
            const uint64_t part = (uint64_t)p[i] * m.material[i].extinction;
            extinction += part;
            for (unsigned c = 0; c < 3; c++)
                light[c] += part * m.material[i].colour[c];
        }
        const qv_mixture mixture = mix(&m, p);
        assert_true(mixture.extinction == extinction);
        for (unsigned c = 0; c < 3; c++)
            assert_true(mixture.light[c] == light[c]);
    }
}

static void check_voxel(const qv_mixture *mixture, uint32_t extinction)
{
    uint16_t voxel[4];
    const double all = (double)mixture->extinction;
    qv_mixture_to_voxel(voxel, mixture, extinction);
    assert_true(fabs(voxel[3] - fmin(65535, all / extinction)) <= 0.5000001);
    for (unsigned c = 0; c < 3; c++)
        assert_true(fabs(voxel[c] - (all > 0 ? (double)mixture->light[c] / all : 0)) <= 0.5000001);
}

static void voxels_are_rounded_to_nearest(void **state)
{
    uint32_t seed = 79;
    (void)state;
    for (unsigned round = 0; round < ROUNDS; round++) {
        medium m;
        uint16_t p[MOST];
        set_medium(&m, &seed);
        set_percentages(p, m.count, 65535, &seed);
        const qv_mixture mixture = mix(&m, p);
        const uint32_t near = (uint32_t)(mixture.extinction / 65535u);
        check_voxel(&mixture, (random_next(&seed) >> random_below(&seed, 32)) + 1);
        check_voxel(&mixture, near != 0 ? near : 1);
        check_voxel(&mixture, near / 2 + 1);
    }
}

static void a_pure_material_keeps_its_colour(void **state)
{
    uint32_t seed = 83;
    (void)state;
    for (unsigned round = 0; round < ROUNDS; round++) {
        medium m;
        uint16_t p[MOST] = {0}, voxel[4];
        set_medium(&m, &seed);
        const uint16_t which = (uint16_t)random_below(&seed, m.count);
        const uint32_t extinction = m.material[which].extinction;
        p[which] = (uint16_t)(1 + random_below(&seed, 65535));
        const qv_mixture mixture = mix(&m, p);
        qv_mixture_to_voxel(voxel, &mixture, extinction != 0 ? extinction : 1);
        for (unsigned c = 0; c < 3; c++)
            assert_int_equal(voxel[c], extinction != 0 ? m.material[which].colour[c] : 0);
        assert_int_equal(voxel[3], extinction != 0 ? p[which] : 0);
    }
}

/* The greatest of everything, at once and in 65535 parts. */
static void the_greatest_sums(void **state)
{
    static qv_material materials[65535];
    static uint16_t parts[65535];
    const uint16_t whole = 65535;
    const uint64_t extinction = 65535ull * 0xFFFFFFFFu;
    uint16_t voxel[4];
    qv_mixture one, many;
    (void)state;
    for (unsigned i = 0; i < 65535; i++) {
        materials[i].extinction = 0xFFFFFFFFu;
        memset(materials[i].colour, 0xFF, sizeof materials[i].colour);
        parts[i] = 1;
    }
    assert_int_equal(qv_mix(&one, materials, &whole, 1), QV_OK);
    assert_int_equal(qv_mix(&many, materials, parts, 65535), QV_OK);
    assert_true(one.extinction == extinction && many.extinction == extinction);
    for (unsigned c = 0; c < 3; c++)
        assert_true(one.light[c] == extinction * 65535u && many.light[c] == extinction * 65535u);
    qv_mixture_to_voxel(voxel, &many, 0xFFFFFFFFu);
    for (unsigned c = 0; c < 4; c++)
        assert_int_equal(voxel[c], 65535);
    qv_mixture_to_voxel(voxel, &many, 1);
    assert_int_equal(voxel[3], 65535);
}

static void nothing_is_black(void **state)
{
    const qv_material material = {{1000, 2000, 3000}, 65536};
    const uint16_t none = 0;
    uint16_t voxel[4] = {1, 1, 1, 1};
    qv_mixture mixture;
    (void)state;
    assert_int_equal(qv_mix(&mixture, &material, &none, 1), QV_OK);
    qv_mixture_to_voxel(voxel, &mixture, 65536);
    for (unsigned c = 0; c < 4; c++)
        assert_int_equal(voxel[c], 0);
    assert_int_equal(qv_mix(&mixture, &material, &none, 0), QV_OK);
    assert_true(mixture.extinction == 0);
}

static void errors(void **state)
{
    const qv_material materials[2] = {{{1, 2, 3}, 4}, {{5, 6, 7}, 8}};
    const uint16_t good[2] = {65534, 1}, bad[2] = {65535, 1};
    qv_mixture mixture, untouched;
    (void)state;
    memset(&mixture, 0xA5, sizeof mixture);
    memset(&untouched, 0xA5, sizeof untouched);
    assert_int_equal(qv_mix(NULL, materials, good, 2), QV_ERROR_NULL);
    assert_int_equal(qv_mix(&mixture, NULL, good, 2), QV_ERROR_NULL);
    assert_int_equal(qv_mix(&mixture, materials, NULL, 2), QV_ERROR_NULL);
    assert_int_equal(qv_mix(&mixture, materials, bad, 2), QV_ERROR_MIXTURE);
    assert_memory_equal(&mixture, &untouched, sizeof mixture);
    assert_int_equal(qv_mix(&mixture, materials, good, 2), QV_OK);
}

/*
 * Equations 18 to 21 in integers: the mixture of interpolated percentages is the
 * interpolation of the mixtures, bit for bit. Weights are f / 256, percentages at most
 * 255, so that no product needs more bits than a mixture has.
 */
static void mixing_is_linear(void **state)
{
    uint32_t seed = 89;
    (void)state;
    for (unsigned round = 0; round < ROUNDS; round++) {
        medium m;
        uint16_t p[MOST], q[MOST], between[MOST];
        const uint32_t f = random_below(&seed, 257);
        set_medium(&m, &seed);
        set_percentages(p, m.count, SOME, &seed);
        set_percentages(q, m.count, SOME, &seed);
        for (uint16_t i = 0; i < m.count; i++)
            between[i] = (uint16_t)((256 - f) * p[i] + f * q[i]);
        const qv_mixture at_p = mix(&m, p), at_q = mix(&m, q), mixed = mix(&m, between);
        assert_true(mixed.extinction == (256 - f) * at_p.extinction + f * at_q.extinction);
        for (unsigned c = 0; c < 3; c++)
            assert_true(mixed.light[c] == (256 - f) * at_p.light[c] + f * at_q.light[c]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_are_exact),
        cmocka_unit_test(voxels_are_rounded_to_nearest),
        cmocka_unit_test(a_pure_material_keeps_its_colour),
        cmocka_unit_test(the_greatest_sums),
        cmocka_unit_test(nothing_is_black),
        cmocka_unit_test(errors),
        cmocka_unit_test(mixing_is_linear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
