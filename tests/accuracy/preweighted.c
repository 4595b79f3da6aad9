/*
 * Sampling of associated colours against the double-precision reference: what its short numbers
 * cost, what weighting colours in 8 bits costs beside that, and one sample alone. The bounds are
 * those of core/qvol.h.
 */
#include "check.h"
#include "comparison.h"
#include "preweighted.h"
#include "random.h"

#include <math.h>
#include <stdio.h>

#define SCENES 200

static const qv_sampling *const orders[2] = {&qv_preweighted_associated8,
                                             &qv_preweighted_associated8_back_to_front};

/* The scene of a seed in a storage, sampled so. */
static void make(seeded_scene *made, uint32_t seed, qv_storage storage, const qv_sampling *sampling)
{
    assert_int_equal(seeded_make(made, seed, storage), QV_OK);
    made->scene.sampling = sampling;
}

/* ---- Short numbers: the reference samples the same associated voxels -------- */

static void test_arithmetic(void **state)
{
    static const char *const names[2] = {"front to back", "back to front"};
    (void)state;
    for (unsigned order = 0; order < 2; order++) {
        tally total = {0};
        double least = 1;
        for (uint32_t seed = 1; seed <= SCENES; seed++) {
            seeded_scene made;
            tally scene = {0};
            make(&made, seed, QV_STORAGE_ASSOCIATED8, orders[order]);
            assert_int_equal(compare_scene(&scene, &made, REF_WEIGHTED, REF_STORED_CAMERA), QV_OK);
            seeded_free(&made);
            tally_add(&total, &scene);
            least = fmin(least, tally_share(&scene));
        }
        tally_print(names[order], &total);
        printf("#   worst scene %.4f %% equal\n", 100 * least);
        assert_true(total.worst <= 1);
        assert_true(tally_share(&total) >= 0.97);
    }
}

/* ---- Colours of 8 bits: the reference samples colours that are not weighted - */

static void test_colours(void **state)
{
    tally exact = {0}, weighted = {0};
    (void)state;
    for (uint32_t seed = 1; seed <= SCENES; seed++) {
        seeded_scene made, straight;
        make(&straight, seed, QV_STORAGE_RGBA8, &qv_weighted_rgba8);
        make(&made, seed, QV_STORAGE_ASSOCIATED8, orders[0]);
        assert_int_equal(compare_scene(&exact, &straight, REF_WEIGHTED, REF_STORED_CAMERA), QV_OK);
        assert_int_equal(
            compare_scenes(&weighted, &made, &straight, REF_WEIGHTED, REF_STORED_CAMERA), QV_OK);
        seeded_free(&made);
        seeded_free(&straight);
    }
    tally_print("weighted, exact", &exact);
    tally_print("preweighted", &weighted);
    assert_true(exact.worst <= 1);
    assert_true(weighted.worst <= 36);
}

/* ---- One sample -------------------------------------------------------------- */

/* The worst of all fractions for corners that are all or nothing, and for random ones. */
static double worst_sample(uint32_t *seed, int extreme)
{
    uint32_t words[8];
    double worst = 0;
    for (unsigned corner = 0; corner < 8; corner++)
        words[corner] = extreme ? (random_below(seed, 2) ? 0xFFFFFFFFu : 0) : random_next(seed);
    for (uint32_t yz = 0; yz < 65536; yz++) {
        const uint32_t y = yz % 256, z = yz / 256;
        qv_passage passage = {.next = {4, 8, 16},
                              .place = {0, y << 24, z << 24},
                              .base = (qv_address)words,
                              .samples = 1};
        qv_ends ends;
        double exact = 0;
        qv_passage_next(&ends, &passage);
        for (unsigned row = 0; row < 4; row++) {
            const double weight = (row & 1 ? y : 256 - y) / 256.0 * (row & 2 ? z : 256 - z) / 256.0;
            exact += weight * (words[2 * row] & 255);
        }
        worst = fmax(worst, fabs((ends.low.red_blue & 0xFFFF) / 256.0 - exact));
    }
    return worst;
}

static void test_sample(void **state)
{
    uint32_t seed = 8;
    double extreme = 0, random = 0;
    (void)state;
    for (unsigned i = 0; i < 64; i++)
        extreme = fmax(extreme, worst_sample(&seed, 1));
    for (unsigned i = 0; i < 64; i++)
        random = fmax(random, worst_sample(&seed, 0));
    printf("# a sample is off by at most %.4f of 255, of random voxels %.4f\n", extreme, random);
    assert_true(extreme <= 255.0 / 256 && extreme > 0.9);
}

/* ---- Thin fogs --------------------------------------------------------------- */

/* Up to 20000 samples of one opacity, a weight / 256 of that of a voxel: what gets through, and
   the light of white. */
static double worst_of_fog(uint32_t weight, uint32_t opacity, unsigned axis)
{
    const uint32_t words[2] = {0, opacity * 0x01010101u}; /* a clear voxel, and the fog's */
    qv_passage passage = {.transmittance = QV_UNDIMMED, .enough = QV_NOTHING};
    double exact = 1, worst = 0;
    for (unsigned i = 0; i < 20000 && passage.transmittance > QV_NOTHING; i++) {
        passage.base = (qv_address)words;
        passage.next[axis] = 4;
        passage.place[axis] = weight << 24;
        passage.samples = 1;
        qv_passage_under(&passage);
        exact *= 1 - weight / 256.0 * opacity / 255.0;
        worst = fmax(worst, fabs((passage.transmittance - 65536.0) / QV_WHOLE - exact));
        worst = fmax(worst, fabs((double)passage.light[0] / QV_WHOLE - (1 - exact)));
    }
    return worst;
}

/* Light along y or z: within 2^-15. Along x shares are cut to 2^-16, so that a ray that stays
   beside a voxel may lose the last 2^-8 / weight. */
static void test_fogs(void **state)
{
    (void)state;
    for (unsigned axis = 0; axis < 3; axis++) {
        double worst = 0;
        for (uint32_t weight = 1; weight < 256; weight *= 2) {
            double of_weight = 0;
            for (uint32_t opacity = 1; opacity < 256; opacity++)
                of_weight = fmax(of_weight, worst_of_fog(weight, opacity, axis));
            assert_true(of_weight <= 0x1p-15 + (axis == 0 ? 0x1p-8 / weight : 0));
            worst = fmax(worst, of_weight);
        }
        printf("# fogs between voxels on %c: off by at most %.2f * 2^-16\n", "xyz"[axis],
               worst * 65536);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_arithmetic),
        cmocka_unit_test(test_colours),
        cmocka_unit_test(test_sample),
        cmocka_unit_test(test_fogs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
