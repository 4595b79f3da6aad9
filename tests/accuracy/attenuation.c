/*
 * How exact the bytes of FreeVoxels are: of long lines, of the picture of a uniform cube, of steps
 * of another length, and of an octree of eight levels. Beside them what would come of cutting the
 * bytes, of multiplying bytes, and of making levels of bytes.
 */
#include "check.h"
#include "qvol.h"
#include "random.h"
#include "reference/attenuation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void expect_at_most(double value, double most, const char *what)
{
    if (!(value <= most))
        fail_msg("%s: %.4f, not at most %.4f", what, value, most);
}

static void expect_within(double value, double low, double high, const char *what)
{
    if (!(value >= low && value <= high))
        fail_msg("%s: %.4f, not %.4f .. %.4f", what, value, low, high);
}

/* ---- Lines of one opacity ---- */

#define DEPTH 1000

static const double opacities[] = {.001, .002, .005, .01, .02, .05, .1, .2, .3, .5};

#define OPACITIES (sizeof opacities / sizeof opacities[0])

/* The bytes behind 0 .. DEPTH voxels of an opacity, along y. */
static void make_line(uint8_t bytes[DEPTH + 1], uint16_t opacity)
{
    static uint16_t voxels[DEPTH + 1][4];
    const uint8_t direction = qv_direction(0, -1, 0);
    const qv_attenuation records = {NULL, 0, NULL, 1u << direction, {1, DEPTH + 1, 1}, 0};
    qv_volume v;
    memset(&v, 0, sizeof v);
    v.voxels = (qv_address)voxels;
    v.voxels_bytes = sizeof voxels;
    v.storage = QV_STORAGE_RGBA16;
    v.size[0] = v.size[2] = 1;
    v.size[1] = DEPTH + 1;
    v.stride[1] = 8;
    for (unsigned i = 0; i <= DEPTH; i++)
        voxels[i][3] = opacity;
    assert_int_equal(
        qv_attenuate(bytes, DEPTH + 1, NULL, &records, &v, &qv_domain_extinction, direction),
        QV_OK);
}

/* How far a line of bytes is from exact: each byte, and the picture of so many voxels, the sum of
   opacity * byte, at the worst depth. */
typedef struct deviation {
    double byte, picture;
} deviation;

static deviation deviation_of(const uint8_t bytes[DEPTH + 1], double opacity)
{
    deviation off = {0, 0};
    double picture = 0;
    for (int i = 0; i <= DEPTH; i++) {
        const double exact = 255 * pow(1 - opacity, i);
        const double shown = 255 * -expm1((i + 1) * log1p(-opacity));
        picture += opacity * bytes[i];
        off.byte = fmax(off.byte, fabs(bytes[i] - exact));
        off.picture = fmax(off.picture, fabs(picture - shown));
    }
    return off;
}

/* What is not done: bytes cut, and bytes multiplied and rounded. */
static void cut_line(uint8_t bytes[DEPTH + 1], double opacity)
{
    for (int i = 0; i <= DEPTH; i++)
        bytes[i] = (uint8_t)(255 * pow(1 - opacity, i));
}

static void multiply_line(uint8_t bytes[DEPTH + 1], double opacity)
{
    bytes[0] = 255;
    for (int i = 1; i <= DEPTH; i++)
        bytes[i] = (uint8_t)floor(bytes[i - 1] * (1 - opacity) + 0.5);
}

static void long_lines(void **state)
{
    double cut = 0;
    (void)state;

    for (unsigned i = 0; i < OPACITIES; i++) {
        const uint16_t stored = (uint16_t)lround(65535 * opacities[i]);
        const double opacity = stored / 65535.0;
        uint8_t bytes[DEPTH + 1], others[DEPTH + 1];
        make_line(bytes, stored);
        const deviation off = deviation_of(bytes, opacity);
        cut_line(others, opacity);
        const deviation of_cut = deviation_of(others, opacity);
        multiply_line(others, opacity);
        const deviation of_product = deviation_of(others, opacity);
        printf("# opacity %.3f: byte %.4f, picture %.3f off; cut: %.3f, %.3f; product of bytes: "
               "%.1f, %.1f\n",
               opacities[i], off.byte, off.picture, of_cut.byte, of_cut.picture, of_product.byte,
               of_product.picture);
        expect_at_most(off.byte, 0.51, "byte");
        expect_at_most(off.picture, 1, "picture");
        cut = fmax(cut, of_cut.picture);
        if (opacities[i] == .01)
            expect_within(of_product.byte, 47, 51, "a product of bytes sticks");
    }
    expect_within(cut, 2, 4.5, "picture of cut bytes");
}

/* ---- Steps of another length ---- */

#define CUBE 40

/* Light behind a way of so many world units in a cube of opacity .05, between two bytes. */
static double light_behind(double way, const int step[3], uint32_t unit_distance)
{
    static uint8_t voxels[CUBE * CUBE * CUBE][4], bytes[CUBE * CUBE * CUBE];
    const double length = sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
    const uint8_t direction = qv_direction(step[0], step[1], step[2]);
    qv_attenuation records = {bytes, sizeof bytes, NULL, 1u << direction, {CUBE, CUBE, CUBE}, 0};
    qv_volume v;
    double light[2];
    memset(&v, 0, sizeof v);
    v.voxels = &voxels[0][0];
    v.voxels_bytes = sizeof voxels;
    v.storage = QV_STORAGE_RGBA8;
    v.unit_distance = unit_distance;
    for (unsigned axis = 0; axis < 3; axis++) {
        v.size[axis] = CUBE;
        v.stride[axis] = axis == 0 ? 4 : axis == 1 ? 4 * CUBE : 4 * CUBE * CUBE;
    }
    for (unsigned i = 0; i < CUBE * CUBE * CUBE; i++)
        voxels[i][3] = 13; /* 13 / 255 = .051 */
    assert_int_equal(
        qv_attenuate(bytes, sizeof bytes, NULL, &records, &v, &qv_domain_extinction, direction),
        QV_OK);
    const double steps = way / length;
    for (unsigned i = 0; i < 2; i++) {
        const uint16_t last = (uint16_t)(CUBE - 1 - floor(steps) - i);
        const uint16_t at[3] = {step[0] ? last : 0, step[1] ? last : 0, last};
        light[i] = log2(qv_attenuation_at(&records, at)[0] / 255.0);
    }
    return exp2(light[0] + (light[1] - light[0]) * (steps - floor(steps)));
}

/* The same way through the same medium in three directions: without a unit distance, as published,
   its light depends on the direction. */
static void diagonals(void **state)
{
    static const int steps[3][3] = {{0, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    (void)state;

    for (unsigned i = 0; i < 3; i++) {
        const double exact = pow(1 - 13 / 255.0, 32);
        const double published = light_behind(32, steps[i], 0);
        const double corrected = light_behind(32, steps[i], QV_ONE_Q16);
        printf("# way of 32, step sqrt %u: light %.3f as published, %.3f by length, exact %.3f\n",
               i + 1, published, corrected, exact);
        expect_at_most(fabs(corrected - exact), 0.004, "by length");
        expect_at_most(fabs(published - pow(exact, 1 / sqrt(i + 1))), 0.004, "as published");
    }
}

/* ---- Levels ---- */

/* An octree of 256 voxels: eight levels. */
static const uint16_t size[3] = {256, 131, 175};

#define VOXELS (256u * 131u * 175u)
#define LEVELS 8
#define BLOCKS (128u * 66u * 88u)

static uint8_t voxels[VOXELS][4];
static uint8_t bytes[VOXELS], finer[BLOCKS], level_bytes[BLOCKS];
static uint32_t blocks[BLOCKS];

static void describe(qv_volume *v)
{
    memset(v, 0, sizeof *v);
    v->voxels = &voxels[0][0];
    v->voxels_bytes = sizeof voxels;
    v->storage = QV_STORAGE_RGBA8;
    v->unit_distance = QV_ONE_Q16;
    memcpy(v->size, size, sizeof v->size);
    v->stride[0] = 4;
    v->stride[1] = 4 * size[0];
    v->stride[2] = v->stride[1] * size[1];
}

/* Random opacities of 0 or 1, that leave light everywhere. */
static void make_mist(void)
{
    uint32_t seed = 314;
    for (unsigned i = 0; i < VOXELS; i++)
        voxels[i][3] = (uint8_t)(random_next(&seed) >> 31);
}

/* Random opacities, of which one in 64 is more. */
static void make_haze(void)
{
    uint32_t seed = 2718;
    for (unsigned i = 0; i < VOXELS; i++) {
        const uint32_t random = random_next(&seed) >> 8;
        voxels[i][3] = (uint8_t)(random % 64 == 0 ? random >> 6 : random >> 6 & 3);
    }
}

/* Nested shells in fog, an opaque core, and nothing in the corners. */
static void make_shells(void)
{
    for (unsigned i = 0; i < VOXELS; i++) {
        const double x = i % 256 - 127.5, y = i / 256 % 131 - 65.0, z = i / 256 / 131 - 87.0;
        const double r = sqrt(x * x / 4 + y * y + z * z * 0.6);
        voxels[i][3] = (uint8_t)(r > 60 ? 0 : r < 8 ? 255 : fmod(r, 16) < 1.5 ? 60 : 2);
    }
}

static void level_size(uint16_t of[3], unsigned level)
{
    for (unsigned axis = 0; axis < 3; axis++)
        of[axis] = (uint16_t)((size[axis] + (1u << level) - 1) >> level);
}

/* Voxels that one of a level stands for on an axis; 0 where there is none. */
static double voxels_of(unsigned at, unsigned level, unsigned axis)
{
    const int first = (int)(at << level), end = first + (1 << level);
    return fmax(0, fmin(end, size[axis]) - first);
}

/* What is not done: each level's bytes made of the bytes of the finer one, which are rounded. */
static uint8_t mean_of_bytes(const uint8_t *from, unsigned level, const uint16_t at[3])
{
    double sum = 0, count = 0;
    uint16_t of[3];
    level_size(of, level - 1);
    for (unsigned i = 0; i < 8; i++) {
        const unsigned x = 2u * at[0] + i % 2, y = 2u * at[1] + i / 2 % 2, z = 2u * at[2] + i / 4;
        const double weight =
            voxels_of(x, level - 1, 0) * voxels_of(y, level - 1, 1) * voxels_of(z, level - 1, 2);
        if (weight == 0)
            continue;
        const uint8_t byte = from[x + of[0] * (y + (size_t)of[1] * z)];
        sum += weight * (byte == 0 ? 64 : -log2(byte / 255.0));
        count += weight;
    }
    return (uint8_t)lround(ref_attenuation(sum / count));
}

/* How far a level is from exact, and how far one made of the finer level's bytes. */
typedef struct level_deviation {
    double ours, of_bytes;
} level_deviation;

/* Leaves the level made of bytes as the finer one of the next. */
static level_deviation compare_level(uint8_t number, uint8_t direction, const double *depths)
{
    qv_attenuation a = {level_bytes, sizeof level_bytes, NULL, 1u << direction, {0, 0, 0}, 0};
    level_deviation off = {0, 0};
    uint16_t at[3];
    static uint8_t made[BLOCKS];
    size_t i = 0;
    level_size(a.size, number);
    assert_int_equal(
        qv_attenuate_level(level_bytes, sizeof level_bytes, &a, blocks, size, number, direction),
        QV_OK);
    for (at[2] = 0; at[2] < a.size[2]; at[2]++)
        for (at[1] = 0; at[1] < a.size[1]; at[1]++)
            for (at[0] = 0; at[0] < a.size[0]; at[0]++, i++) {
                const int32_t block[3] = {at[0], at[1], at[2]};
                const double exact = ref_attenuation(ref_mean_depth(depths, size, number, block));
                made[i] = mean_of_bytes(number == 1 ? bytes : finer, number, at);
                off.ours = fmax(off.ours, fabs(level_bytes[i] - exact));
                off.of_bytes = fmax(off.of_bytes, fabs(made[i] - exact));
            }
    memcpy(finer, made, i);
    return off;
}

/* Returns how far levels made of bytes are off. */
static double compare_octree(const char *name, int dx, int dy, int dz)
{
    const uint8_t direction = qv_direction(dx, dy, dz);
    qv_attenuation a = {bytes, sizeof bytes, NULL, 1u << direction, {0, 0, 0}, 0};
    double *depths = malloc(VOXELS * sizeof *depths), off = 0, of_bytes = 0;
    qv_volume v;
    assert_non_null(depths);
    describe(&v);
    memcpy(a.size, size, sizeof a.size);
    ref_outer_depths(depths, &v, direction);
    assert_int_equal(
        qv_attenuate(bytes, sizeof bytes, blocks, &a, &v, &qv_domain_extinction, direction), QV_OK);
    for (unsigned i = 0; i < VOXELS; i++)
        off = fmax(off, fabs(bytes[i] - ref_attenuation(depths[i])));
    printf("# %s, direction %d %d %d: level 0 %.4f off", name, dx, dy, dz, off);
    for (uint8_t number = 1; number <= LEVELS; number++) {
        const level_deviation of = compare_level(number, direction, depths);
        printf(", %u %.4f (of bytes %.2f)", (unsigned)number, of.ours, of.of_bytes);
        off = fmax(off, of.ours);
        of_bytes = fmax(of_bytes, of.of_bytes);
    }
    printf("\n");
    free(depths);
    expect_at_most(off, 0.51, name);
    return of_bytes;
}

static void an_octree_of_eight_levels(void **state)
{
    (void)state;

    assert_int_equal(qv_pyramid_levels(size), LEVELS);
    make_mist();
    expect_within(compare_octree("mist", 1, 0, 0), .6, 2, "levels of bytes");
    expect_within(compare_octree("mist", -1, 1, -1), .6, 2, "levels of bytes");
    make_haze();
    compare_octree("haze", 1, 0, 0);
    compare_octree("haze", -1, 1, -1);
    make_shells();
    compare_octree("shells", 0, -1, 0);
    compare_octree("shells", 1, 0, 1);
}

/* ---- The geometric mean ---- */

/* Light of eight voxels: of each column, of the voxel behind and of the one in front. */
static const double light[4][2] = {{.1, .9}, {.2, .8}, {.3, 1}, {.4, .5}};

static uint16_t opacity_between(double behind, double before)
{
    return (uint16_t)lround(65535 * (1 - behind / before));
}

/* Columns of three on z: one that darkens the block's upper voxel, that voxel, and the lower. */
static void eight_voxels(void **state)
{
    static uint16_t column[4][4][4];
    const uint8_t up = qv_direction(0, 0, 1);
    const qv_attenuation fine = {NULL, 0, NULL, 1u << up, {2, 2, 4}, 0};
    const qv_attenuation coarse = {NULL, 0, NULL, 1u << up, {1, 1, 2}, 0};
    uint8_t of_voxels[16], of_blocks[2];
    uint32_t sums[2];
    double product = 1, sum = 0;
    qv_volume v;
    (void)state;

    memset(&v, 0, sizeof v);
    v.voxels = (qv_address)column;
    v.voxels_bytes = sizeof column;
    v.storage = QV_STORAGE_RGBA16;
    v.size[0] = v.size[1] = 2;
    v.size[2] = 4;
    v.stride[0] = 8;
    v.stride[1] = 16;
    v.stride[2] = 32;
    for (unsigned i = 0; i < 4; i++) {
        column[1][i][3] = opacity_between(light[i][0], light[i][1]);
        column[2][i][3] = opacity_between(light[i][1], 1);
        product *= light[i][0] * light[i][1];
        sum += light[i][0] + light[i][1];
    }
    assert_int_equal(qv_attenuate(of_voxels, 16, sums, &fine, &v, &qv_domain_extinction, up),
                     QV_OK);
    assert_int_equal(qv_attenuate_level(of_blocks, 2, &coarse, sums, v.size, 1, up), QV_OK);
    const double mean = exp2(sums[0] / -4194304.0 / 8);
    printf("# eight voxels: geometric mean %.5f, byte %u; exact %.5f, arithmetic %.3f\n", mean,
           (unsigned)of_blocks[0], pow(product, .125), sum / 8);
    expect_within(sum / 8, .52499, .52501, "arithmetic mean");
    expect_within(mean, .41405, .41407, "geometric mean");
    assert_int_equal(of_blocks[0], 106); /* 105.6 */
    assert_int_equal(of_blocks[1], 255);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_lines),
        cmocka_unit_test(diagonals),
        cmocka_unit_test(an_octree_of_eight_levels),
        cmocka_unit_test(eight_voxels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
