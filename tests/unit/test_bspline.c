/*
 * The triquadratic B-spline: its weights for every fraction, the voxels that it reads, and
 * its samples against double precision.
 */
#include "check.h"
#include "bspline.h"
#include "random.h"
#include "reference.h"

#include <math.h>
#include <string.h>

#define VOXEL ((qv_coord)1 << 32)

/* ---- Weights ---- */

static qv_triple taps_of(uint32_t f)
{
    const qv_triple triple = {.tap = {fx_tap_of_square(256 - f), fx_tap_of_square(f)}};
    return triple;
}

/* The 27 weights at a place in 256ths, x fastest. */
static void weights_of(int32_t w[27], uint32_t x, uint32_t y, uint32_t z)
{
    const qv_triple on_x = taps_of(x), on_y = taps_of(y), on_z = taps_of(z);
    fx_weight slice[3], row[3], voxel[3];
    qv_part_one(slice, &on_z);
    for (unsigned k = 0; k < 3; k++) {
        qv_part(row, slice[k], &on_y);
        for (unsigned j = 0; j < 3; j++) {
            qv_part(voxel, row[j], &on_x);
            for (unsigned i = 0; i < 3; i++)
                w[9 * k + 3 * j + i] = (int32_t)fx_weight_bits(voxel[i]);
        }
    }
}

/* All 2^24 places: the sum is 1, and no weight is negative. */
static void every_fraction(void **state)
{
    uint32_t sums = 0, negative = 0;
    (void)state;

    for (uint32_t place = 0; place < 1u << 24; place++) {
        int32_t w[27], sum = 0, signs = 0;
        weights_of(w, place & 255, place >> 8 & 255, place >> 16);
        for (unsigned i = 0; i < 27; i++) {
            sum += w[i];
            signs |= w[i];
        }
        sums += sum != (int32_t)FX_WEIGHT_ONE;
        negative += signs < 0;
    }
    assert_int_equal(sums, 0);
    assert_int_equal(negative, 0);
}

/* The weight of one of three voxels on an axis, by de Boor: u from the middle one. */
static double exact(unsigned i, uint32_t f)
{
    const double u = f / 256.0 - 0.5;
    if (i == 1)
        return 0.75 - u * u;
    return i == 0 ? (0.5 - u) * (0.5 - u) / 2 : (0.5 + u) * (0.5 + u) / 2;
}

/* A part is off by 1/2, or in the middle by 1, and by its share of what the part before it
   is off by: 1 + 3/4 (1 + 3/4) at most. */
static void weights_are_those_of_real_numbers(void **state)
{
    double worst = 0;
    (void)state;

    for (uint32_t place = 0; place < 1u << 24; place += 61) {
        const uint32_t x = place & 255, y = place >> 8 & 255, z = place >> 16;
        int32_t w[27];
        weights_of(w, x, y, z);
        for (unsigned i = 0; i < 27; i++) {
            const double real = exact(i % 3, x) * exact(i / 3 % 3, y) * exact(i / 9, z);
            worst = fmax(worst, fabs(w[i] - real * 65536));
        }
    }
    assert_true(worst <= 2.3125);
    assert_true(worst > 0.5);
}

/* ---- Volumes ---- */

enum { NX = 5, NY = 4, NZ = 3, VOXELS = NX * NY * NZ };

static uint16_t wide[VOXELS][4];
static uint8_t narrow[VOXELS][4];

static qv_volume describe(uint8_t storage)
{
    const int32_t bytes = (int32_t)qv_entry_bytes(storage);
    const qv_volume volume = {.voxels = bytes == 8 ? (qv_address)wide : narrow[0],
                              .size = {NX, NY, NZ},
                              .stride = {bytes, bytes * NX, bytes * NX * NY},
                              .storage = storage,
                              .unit_distance = QV_ONE_Q16,
                              .extinction = QV_ONE_Q16};
    return volume;
}

/* Any colour; of the opacities, those above the limit are 0. */
static void fill(uint32_t seed, uint32_t most)
{
    for (unsigned i = 0; i < VOXELS; i++)
        for (unsigned c = 0; c < 4; c++) {
            uint32_t value = random_next(&seed) >> 16;
            if (c == 3 && value > most)
                value = 0;
            wide[i][c] = (uint16_t)value;
            narrow[i][c] = (uint8_t)(value >> 8);
        }
}

static void clear(void)
{
    memset(narrow, 0, sizeof narrow);
    memset(wide, 0, sizeof wide);
}

/* A point in 256ths of a voxel, as a ray has it; the bits below do not count. */
static qv_ray ray_at(const int32_t point[3], uint32_t below)
{
    qv_ray ray = {.samples = 1};
    for (unsigned axis = 0; axis < 3; axis++)
        ray.place[axis] = point[axis] * (VOXEL / 256) + below % (VOXEL / 256) - VOXEL / 2;
    return ray;
}

/* Up to 1/64 beyond the faces, as far as a piece's middle may lie there. */
static void random_point(int32_t point[3], uint32_t *seed)
{
    static const uint16_t size[3] = {NX, NY, NZ};
    for (unsigned axis = 0; axis < 3; axis++)
        point[axis] = (int32_t)random_below(seed, size[axis] * 256u + 9u) - 4;
}

/* ---- Samples ---- */

/* A sample as parts of 1, or as depth per world unit. */
static void to_real(double real[4], const qv_sample *sample, unsigned storage, int converted)
{
    const double one = converted ? ldexp(1, 25) : qv_channel_bytes(storage) == 1 ? 255 : 65535;
    const double unit = converted ? one : 65536 * one;
    const double colour = converted ? 65535 / 65536.0 : one == 255 ? 255 : 65535 / 65536.0;
    real[3] = ldexp(fx_share_bits(sample->opacity) / unit, -(int)sample->scale);
    for (unsigned c = 0; c < 3; c++)
        real[c] = ldexp(fx_sum_bits(sample->light[c]) / (unit * colour), -(int)sample->scale);
}

typedef struct family {
    qv_mode *mode;
    uint8_t storage;
    ref_mode reference;
} family;

/* 27 weights, each off by up to 2.3 of 65536: .001 of the greatest value. */
static void expect_near(const family *of, const int32_t at[3], uint32_t below, double greatest)
{
    const qv_volume volume = describe(of->storage);
    const qv_ray ray = ray_at(at, below);
    const double point[3] = {at[0] / 256.0, at[1] / 256.0, at[2] / 256.0};
    double real[4], found[4];
    qv_sample sample = {.scale = 0};
    ref_reconstruct(real, &volume, of->reference, point);
    if (!of->mode(&sample, &ray, &volume, of->storage)) {
        assert_true(real[3] == 0);
        return;
    }
    to_real(found, &sample, of->storage, of->mode == qv_bspline_converted);
    for (unsigned c = 0; c < 4; c++)
        assert_true(fabs(found[c] - real[c]) < 0.0005 * greatest);
}

static void samples_are_those_of_real_numbers(void **state)
{
    static const family families[] = {
        {qv_bspline_weighted, QV_STORAGE_RGBA8, REF_BSPLINE_WEIGHTED},
        {qv_bspline_weighted, QV_STORAGE_RGBA16, REF_BSPLINE_WEIGHTED},
        {qv_bspline_weighted, QV_STORAGE_RGBT8, REF_BSPLINE_EXTINCTION},
        {qv_bspline_weighted, QV_STORAGE_RGBT16, REF_BSPLINE_EXTINCTION},
        {qv_bspline_converted, QV_STORAGE_RGBA8, REF_BSPLINE_EXTINCTION},
        {qv_bspline_converted, QV_STORAGE_RGBA16, REF_BSPLINE_EXTINCTION}};
    uint32_t seed = 1;
    (void)state;

    for (unsigned i = 0; i < 60000; i++) {
        int32_t at[3];
        if (i % 100 == 0)
            fill(1 + i, i % 300 == 0 ? 0x1000 : 0xF000); /* depths of up to 4 */
        random_point(at, &seed);
        expect_near(&families[i % 6], at, random_next(&seed), i % 6 >= 4 ? 4 : 1);
    }
}

/* Weights sum to exactly 1: where all voxels are alike, a sample is one of them. */
static void equal_voxels_give_themselves(void **state)
{
    static const uint8_t entry[4] = {200, 1, 0, 77};
    const qv_volume volume = describe(QV_STORAGE_RGBA8);
    uint32_t seed = 2;
    (void)state;

    for (unsigned i = 0; i < VOXELS; i++)
        memcpy(narrow[i], entry, 4);
    for (unsigned i = 0; i < 20000; i++) {
        int32_t at[3];
        qv_sample sample;
        random_point(at, &seed);
        const qv_ray ray = ray_at(at, 0);
        assert_true(qv_bspline_weighted(&sample, &ray, &volume, QV_STORAGE_RGBA8));
        assert_int_equal(fx_share_bits(sample.opacity), 65536 * 77);
        assert_int_equal(fx_sum_bits(sample.light[0]), 65536 * 77 * 200);
        assert_int_equal(fx_sum_bits(sample.light[1]), 65536 * 77);
        assert_int_equal(fx_sum_bits(sample.light[2]), 0);
    }
}

/* ---- Voxels that are read ---- */

static int is_seen(const int32_t at[3], uint8_t storage)
{
    const qv_volume volume = describe(storage);
    const qv_ray ray = ray_at(at, 0);
    qv_sample sample = {.scale = 0};
    if (storage == QV_STORAGE_RGBA8)
        return qv_bspline_converted(&sample, &ray, &volume, storage);
    return qv_bspline_weighted(&sample, &ray, &volume, storage);
}

/* Whether a voxel is that which holds a point or a neighbour of it, clamped, on an axis. */
static int is_beside(uint32_t voxel, int32_t point, int32_t size)
{
    const int32_t index = point < 0 ? -1 : point / 256;
    int found = 0;
    for (int32_t i = index - 1; i <= index + 1; i++)
        found |= (int32_t)voxel == (i < 0 ? 0 : i < size ? i : size - 1);
    return found;
}

/* Each voxel alone, from every part of the volume. */
static void three_voxels_an_axis_are_read(void **state)
{
    uint32_t seed = 3, seen = 0;
    (void)state;

    for (unsigned i = 0; i < 40000; i++) {
        const unsigned alone = random_below(&seed, VOXELS);
        const uint8_t storage = i % 2 != 0 ? QV_STORAGE_RGBA8 : QV_STORAGE_RGBA16;
        int32_t at[3];
        random_point(at, &seed);
        clear();
        narrow[alone][3] = 1;
        wide[alone][3] = 1;
        const int expected = is_beside(alone % NX, at[0], NX) &&
                             is_beside(alone / NX % NY, at[1], NY) &&
                             is_beside(alone / (NX * NY), at[2], NZ);
        assert_int_equal(is_seen(at, storage), expected);
        seen += (uint32_t)expected;
    }
    assert_true(seen > 1000);
}

/* One voxel is its own neighbour on every side. */
static void one_voxel_fills_its_box(void **state)
{
    qv_volume volume = describe(QV_STORAGE_RGBA16);
    const int32_t corners[3] = {0, 128, 256};
    (void)state;

    clear();
    wide[0][0] = 65535;
    wide[0][3] = 12345;
    volume.size[0] = volume.size[1] = volume.size[2] = 1;
    for (unsigned i = 0; i < 27; i++) {
        const int32_t at[3] = {corners[i % 3], corners[i / 3 % 3], corners[i / 9]};
        const qv_ray ray = ray_at(at, 0);
        qv_sample sample;
        assert_true(qv_bspline_weighted(&sample, &ray, &volume, QV_STORAGE_RGBA16));
        assert_int_equal(fx_share_bits(sample.opacity), 65536u * 12345u);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fraction),
        cmocka_unit_test(weights_are_those_of_real_numbers),
        cmocka_unit_test(samples_are_those_of_real_numbers),
        cmocka_unit_test(equal_voxels_give_themselves),
        cmocka_unit_test(three_voxels_an_axis_are_read),
        cmocka_unit_test(one_voxel_fills_its_box),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
