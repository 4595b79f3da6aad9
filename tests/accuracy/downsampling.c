/*
 * Figures 2 and 3 of Kraus and Buerger 2008, and what opacity is lost where opacities are
 * averaged: eight voxels become one, four of them of one extinction, four transparent.
 * Through the shipped downsampling and conversions, with 16 bits a channel.
 */
#include "check.h"
#include "qvol.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define UNIT_DISTANCE QV_ONE_Q16

/* Eight voxels; a wall of four at z = 0. */
typedef uint16_t cube[8][4];

static void make_cube(cube voxels, uint16_t fourth)
{
    for (unsigned i = 0; i < 8; i++) {
        voxels[i][0] = voxels[i][1] = voxels[i][2] = 65535;
        voxels[i][3] = i < 4 ? fourth : 0;
    }
}

/* The one voxel that a cube becomes. */
static void make_coarse(uint16_t coarse[4], cube voxels, uint8_t storage, const qv_domain *domain)
{
    qv_volume v;
    memset(&v, 0, sizeof v);
    v.voxels = (qv_address)voxels;
    v.voxels_bytes = sizeof(cube);
    v.storage = storage;
    v.size[0] = v.size[1] = v.size[2] = 2;
    v.stride[0] = 8;
    v.stride[1] = 16;
    v.stride[2] = 32;
    assert_int_equal(qv_downsample(coarse, 8, &v, &qv_filter_box2, domain, 0, 1), QV_OK);
}

/* The opacity of a coarse voxel over its own width, two units. */
static double opacity_across(const uint16_t coarse[4], uint8_t storage, uint32_t extinction)
{
    uint16_t wide[4];
    const qv_entries from = {(qv_address)coarse, 1, UNIT_DISTANCE, extinction, storage};
    const qv_status status =
        storage == QV_STORAGE_RGBA16
            ? qv_opacity_to_opacity(wide, sizeof wide, QV_STORAGE_RGBA16, 2 * UNIT_DISTANCE, &from)
            : qv_extinction_to_opacity(wide, sizeof wide, QV_STORAGE_RGBA16, 2 * UNIT_DISTANCE,
                                       &from);
    assert_int_equal(status, QV_OK);
    return wide[3] / 65535.0;
}

static double stored_opacity(double tau)
{
    return round(-65535 * expm1(-tau));
}

/* Opacities stored: averaged as extinction, or as they are. */
static double coarse_opacity(double tau, const qv_domain *domain)
{
    cube voxels;
    uint16_t coarse[4];
    make_cube(voxels, (uint16_t)stored_opacity(tau));
    make_coarse(coarse, voxels, QV_STORAGE_RGBA16, domain);
    return opacity_across(coarse, QV_STORAGE_RGBA16, 0);
}

static void expect_near(double value, double expected, double most, const char *what)
{
    if (!(fabs(value - expected) <= most))
        fail_msg("%s: %.5f is not %.5f", what, value, expected);
}

static void figure_2(void **state)
{
    const double opacity = coarse_opacity(4, &qv_domain_extinction);
    (void)state;

    printf("# figure 2, opacities stored: %.5f (paper 0.98168)\n", opacity);
    expect_near(opacity, 0.98168, 0.0001, "figure 2");
}

static void figure_2_of_stored_extinction(void **state)
{
    const double depth = 4 / log(2), full = 8;
    cube voxels;
    uint16_t coarse[4];
    (void)state;

    make_cube(voxels, (uint16_t)round(65535 * depth / full));
    make_coarse(coarse, voxels, QV_STORAGE_RGBT16, &qv_domain_stored);
    const double opacity = opacity_across(coarse, QV_STORAGE_RGBT16, 8 * QV_ONE_Q16);
    printf("# figure 2, extinction stored: %.5f (paper 0.98168)\n", opacity);
    expect_near(opacity, 0.98168, 0.0001, "figure 2");
}

static void figure_3(void **state)
{
    cube voxels;
    uint16_t coarse[4];
    (void)state;

    make_cube(voxels, (uint16_t)stored_opacity(4));
    make_coarse(coarse, voxels, QV_STORAGE_RGBA16, &qv_domain_stored);
    const double corrected = opacity_across(coarse, QV_STORAGE_RGBA16, 0);
    printf("# figure 3: mean %.5f (paper 0.49084), corrected %.5f (paper 0.74076)\n",
           coarse[3] / 65535.0, corrected);
    expect_near(coarse[3] / 65535.0, 0.49084, 0.0001, "mean");
    expect_near(corrected, 0.74076, 0.0001, "figure 3");
}

/* Means of opacities lose what means of extinctions keep: the opacity of one voxel. */
static void opacity_lost(void **state)
{
    static const double taus[] = {0.1, 0.5, 1, 2, 4, 8};
    static const double losses[] = {.0023, .0387, .0999, .1869, .2409, .2498};
    (void)state;

    for (unsigned i = 0; i < sizeof taus / sizeof taus[0]; i++) {
        const double kept = coarse_opacity(taus[i], &qv_domain_extinction);
        const double lost = kept - coarse_opacity(taus[i], &qv_domain_stored);
        printf("# tau %.1f: opacity %.5f by extinction, %.5f lost by opacity (double %.4f)\n",
               taus[i], kept, lost, losses[i]);
        expect_near(kept, stored_opacity(taus[i]) / 65535, 2.0 / 65535, "opacity kept");
        expect_near(lost, losses[i], 0.0001, "opacity lost");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(figure_2),
        cmocka_unit_test(figure_2_of_stored_extinction),
        cmocka_unit_test(figure_3),
        cmocka_unit_test(opacity_lost),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
