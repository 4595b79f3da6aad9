/*
 * Figure 4 of Kraus and Buerger 2008: the opacity of a ray through one opaque vertex
 * among transparent ones, by the step d and the place r of its samples.
 *
 * The paper leaves the set-up open. Assumed: the ray runs along an axis through the
 * column of vertices, samples lie at r + k d, and opacities hold for the step. What
 * changes with r is error, and so the spread over r is what is compared: of the
 * library with 16-bit storage, of the reference at the positions rounded to 1/256
 * voxel, and of the formula.
 */
#include "check.h"
#include "fine.h"
#include "reference.h"

#include <math.h>
#include <stdio.h>

#define DEPTH        7 /* voxels; the vertex of the middle one is seen 1 to each side */
#define PLACES       256
#define STEPS        6
#define TAUS         3
#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static const double ln2 = 0.69314718055994530942;
static const double taus[TAUS] = {1, 4, 8};
static const double steps[STEPS] = {0.5, 0.6, 0.8, 1.0, 1.2, 1.6};

typedef enum domain { OPACITY, EXTINCTION, DOMAINS } domain;

static const char *const domain_names[DOMAINS] = {"opacity", "extinction"};

/* Spread over r in double precision, to four decimals. */
static const double table[DOMAINS][TAUS][STEPS] = {
    {{0.0126, 0.0582, 0.0926, 0.0999, 0.2179, 0.5043},
     {0.0323, 0.0725, 0.1535, 0.2409, 0.3557, 0.6389},
     {0.0349, 0.0729, 0.1597, 0.2498, 0.3600, 0.6400}},
    {{0.0000, 0.0433, 0.0566, 0.0000, 0.0817, 0.3254},
     {0.0000, 0.0082, 0.0102, 0.0000, 0.0133, 0.0756},
     {0.0000, 0.0003, 0.0003, 0.0000, 0.0004, 0.0060}},
};

typedef struct range {
    double least, most;
} range;

static void widen(range *r, double value)
{
    r->least = fmin(r->least, value);
    r->most = fmax(r->most, value);
}

static double spread(const range *r)
{
    return r->most - r->least;
}

/* ---- The formula --------------------------------------------------------------- */

/* Opacity of a ray with samples at r + k d. */
static double ray_opacity(domain by, double tau, double d, double r)
{
    const double vertex = DEPTH / 2.0, alpha = -expm1(-tau * d);
    double transmittance = 1;
    for (double s = r; s < DEPTH; s += d) {
        const double weight = fmax(0, 1 - fabs(s - vertex));
        transmittance *= by == OPACITY ? 1 - weight * alpha : exp(-tau * d * weight);
    }
    return 1 - transmittance;
}

static void test_table(void **state)
{
    const int places = 16000;
    const double last_place = 1e-4;
    double worst = 0;
    (void)state;
    for (int i = 0; i < DOMAINS * TAUS * STEPS; i++) {
        const domain by = (domain)(i / (TAUS * STEPS));
        const double tau = taus[i / STEPS % TAUS], d = steps[i % STEPS];
        range found = {1, 0};
        for (int place = 0; place < places; place++) {
            widen(&found, ray_opacity(by, tau, d, place * d / places));
        }
        worst = fmax(worst, fabs(spread(&found) - table[by][i / STEPS % TAUS][i % STEPS]));
    }
    printf("# the table is at most %.6f off the formula\n", worst);
    assert_true(worst <= last_place);
}

/* ---- The library and the reference ---------------------------------------------- */

/* A column of voxels along z, one of them with a fourth channel. */
typedef struct column {
    uint16_t voxels[DEPTH][4];
    qv_scene scene;
} column;

/* By opacity it holds for the step; by extinction the full value is the vertex's. */
static void make_column(column *made, domain by, double tau, double d)
{
    const qv_coord one = (qv_coord)1 << 32;
    qv_scene *scene = &made->scene;
    memset(made, 0, sizeof *made);
    scene->camera.step = (uint32_t)floor(d * QV_ONE_Q16 + 0.5);
    const double opacity = -expm1(-tau * d);
    made->voxels[DEPTH / 2][3] = by == OPACITY ? (uint16_t)floor(opacity * 65535 + 0.5) : 65535;
    scene->volume.voxels = (const unsigned char *)made->voxels;
    scene->volume.voxels_bytes = sizeof made->voxels;
    scene->volume.storage = by == OPACITY ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBT16;
    scene->volume.extinction = (uint32_t)floor(tau / ln2 * QV_ONE_Q16 + 0.5);
    for (int axis = 0; axis < 3; axis++) {
        scene->volume.size[axis] = axis == 2 ? DEPTH : 1;
        scene->volume.stride[axis] = sizeof made->voxels[0];
    }
    scene->camera.origin[0] = one / 2;
    scene->camera.origin[1] = one / 2;
    scene->camera.across[0] = one;
    scene->camera.down[1] = one;
    scene->camera.along[2] = (qv_coord)scene->camera.step << 16;
    scene->camera.projection = &qv_projection_orthographic;
    scene->sampling = by == OPACITY ? &qv_corrected_rgba16 : &qv_extinction_rgbt16;
}

/* Opacities over r, of the library and of the reference. */
static void run_places(range *library, range *reference, domain by, double tau, double d)
{
    column made;
    fine_pixel pixel;
    ref_pixel expected;
    make_column(&made, by, tau, d);
    *library = *reference = (range){1, 0};
    for (uint32_t place = 0; place < PLACES; place++) {
        made.scene.phase = (uint16_t)(place * (65536 / PLACES));
        assert_int_equal(render_fine(&pixel, &made.scene), QV_OK);
        ref_render(&expected, &made.scene, by == OPACITY ? REF_CORRECTED : REF_EXTINCTION, 0, 0);
        widen(library, pixel.channel[3] / FINE_ONE);
        widen(reference, expected.opacity);
    }
}

static void test_spread(void **state)
{
    /* Points are rounded to 1/256 voxel: 4 %. The table has 4 digits. */
    const double most_off_quantised = 1e-6, most_share = 0.04, half_digit = 0.00005;
    double off_quantised = 0, share = 0;
    (void)state;
    for (int i = 0; i < DOMAINS * TAUS * STEPS; i++) {
        const domain by = (domain)(i / (TAUS * STEPS));
        const double tau = taus[i / STEPS % TAUS], d = steps[i % STEPS];
        const double real = table[by][i / STEPS % TAUS][i % STEPS];
        range library, reference;
        run_places(&library, &reference, by, tau, d);
        printf("# %-10s tau %.0f, d %.1f: table %.4f, rounded places %.4f, library %.4f\n",
               domain_names[by], tau, d, real, spread(&reference), spread(&library));
        off_quantised = fmax(off_quantised, fabs(spread(&library) - spread(&reference)));
        const double off = fabs(spread(&library) - real) - half_digit;
        share = fmax(share, off > 0 ? off / real : 0);
    }
    printf("# at most %.6f off at rounded places, %.4f of it off the table\n", off_quantised,
           share);
    assert_true(off_quantised <= most_off_quantised);
    assert_true(share <= most_share);
}

/* Where a whole number of steps makes a voxel, linear weights sum to the same for every r. */
static void test_constant(void **state)
{
    static const double whole[] = {1, 0.5, 0.25, 0.125}, all_taus[] = {1, 2, 4, 8};
    double worst = 0;
    (void)state;
    for (size_t i = 0; i < COUNT(whole) * COUNT(all_taus); i++) {
        range library, reference;
        run_places(&library, &reference, EXTINCTION, all_taus[i % COUNT(all_taus)],
                   whole[i / COUNT(all_taus)]);
        worst = fmax(worst, spread(&library));
    }
    printf("# by extinction, 1/d whole: spread %.3f of 65535\n", worst * 65535);
    assert_true(worst <= 2.0 / 65535);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_spread),
        cmocka_unit_test(test_constant),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
