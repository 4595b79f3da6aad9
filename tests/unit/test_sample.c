/*
 * Cells and the three sampling modes against exact integer arithmetic, for every
 * storage; and a sample's opacity as Q0.32.
 */
#include "check.h"
#include "sample.h"
#include "scene_fixture.h"

static const qv_sampling *const storages[4] = {&qv_nearest_rgba8, &qv_nearest_rgba16,
                                               &qv_nearest_indexed8, &qv_nearest_indexed8_16};
static fixture f;

static int wide(unsigned storage)
{
    return storage == QV_STORAGE_RGBA16 || storage == QV_STORAGE_INDEXED8_16;
}

/* ---- Voxels by the book ---- */

static int32_t clamp(int32_t v, int32_t size)
{
    if (v < 0)
        return 0;
    return v < size ? v : size - 1;
}

/* Channels of a voxel; outside of the volume those of the nearest one. */
static void voxel_at(uint32_t rgba[4], const int32_t at[3])
{
    const qv_volume *volume = &f.scene.volume;
    const uint8_t *entry = (const uint8_t *)f.voxels;
    const int indexed = volume->palette != NULL;
    uint16_t channel;
    for (unsigned axis = 0; axis < 3; axis++)
        entry += clamp(at[axis], volume->size[axis]) * volume->stride[axis];
    if (indexed)
        entry =
            wide(volume->storage) ? (const uint8_t *)f.palette16.rgba[*entry] : f.palette8[*entry];
    for (unsigned c = 0; c < 4; c++) {
        rgba[c] = entry[c];
        if (wide(volume->storage)) {
            memcpy(&channel, entry + 2 * c, 2);
            rgba[c] = channel;
        }
    }
}

/* ---- Points ---- */

/* A point in 256ths of a voxel, and a ray whose sample it is. */
typedef struct point {
    int32_t at[3];
} point;

static qv_ray ray_at(const point *p)
{
    qv_ray ray = {.samples = 1};
    for (unsigned axis = 0; axis < 3; axis++) /* less 1/2 and plus 1/512, as a ray holds it */
        ray.place[axis] = p->at[axis] * (VOXEL / 256) - VOXEL / 2 + VOXEL / 512;
    return ray;
}

static point random_point(uint32_t *seed)
{
    point p;
    for (unsigned axis = 0; axis < 3; axis++)
        p.at[axis] = (int32_t)random_below(seed, f.scene.volume.size[axis] * 256u);
    return p;
}

/* What the eight corners of a point hold, and their weights. */
typedef struct corners {
    uint32_t rgba[8][4];
    uint64_t weight[8];
} corners;

static void corners_of(corners *eight, const point *p)
{
    fx_fraction fraction[3];
    fx_weight weight[8];
    for (unsigned axis = 0; axis < 3; axis++) /* >= -128, so that 384 more are positive */
        fraction[axis] = fx_fraction_of((uint32_t)(p->at[axis] - 128 + 512) % 256);
    qv_weights(weight, fraction);
    for (unsigned i = 0; i < 8; i++) {
        int32_t at[3];
        for (unsigned axis = 0; axis < 3; axis++)
            at[axis] = (p->at[axis] - 128 + 256) / 256 - 1 + (int32_t)(i >> axis & 1);
        voxel_at(eight->rgba[i], at);
        eight->weight[i] = fx_weight_bits(weight[i]);
    }
}

/* ---- Exact samples ---- */

typedef struct exact {
    uint64_t light[3], opacity;
} exact;

/* Equation 11 as a sum of products; 16-bit terms are cut to 32 bits one by one. */
static exact weighted(const corners *eight, unsigned storage)
{
    exact sum = {{0, 0, 0}, 0};
    for (unsigned i = 0; i < 8; i++) {
        const uint64_t share = eight->weight[i] * eight->rgba[i][3];
        sum.opacity += share;
        for (unsigned c = 0; c < 3; c++)
            sum.light[c] += share * eight->rgba[i][c] >> (wide(storage) ? 16 : 0);
    }
    return sum;
}

/* Colour and opacity on their own; their product to nearest. */
static exact separate(const corners *eight, unsigned storage)
{
    exact sum = {{0, 0, 0}, 0};
    const unsigned shift = wide(storage) ? 32 : 16;
    for (unsigned i = 0; i < 8; i++)
        sum.opacity += eight->weight[i] * eight->rgba[i][3];
    for (unsigned c = 0; c < 3; c++) {
        uint64_t colour = 0;
        for (unsigned i = 0; i < 8; i++)
            colour += eight->weight[i] * eight->rgba[i][c];
        sum.light[c] = (colour * sum.opacity + ((uint64_t)1 << (shift - 1))) >> shift;
    }
    return sum;
}

static exact nearest(const point *p, unsigned storage)
{
    const int32_t at[3] = {p->at[0] / 256, p->at[1] / 256, p->at[2] / 256};
    uint32_t rgba[4];
    exact sample;
    voxel_at(rgba, at);
    sample.opacity = 65536u * rgba[3];
    for (unsigned c = 0; c < 3; c++)
        sample.light[c] = (uint64_t)rgba[3] * rgba[c] * (wide(storage) ? 1 : 65536);
    return sample;
}

static void expect_sample(qv_mode *mode, const point *p, const exact *expected)
{
    const unsigned storage = f.scene.volume.storage;
    const qv_ray ray = ray_at(p);
    qv_sample sample = {{fx_sum_of(0), fx_sum_of(0), fx_sum_of(0)}, fx_share_of(0), 0};
    const int seen = mode(&sample, &ray, &f.scene.volume, storage);
    assert_int_equal(fx_share_bits(sample.opacity), expected->opacity);
    for (unsigned c = 0; c < 3; c++)
        assert_int_equal(fx_sum_bits(sample.light[c]), expected->light[c]);
    if (expected->opacity != 0)
        assert_true(seen);
}

/* ---- Modes ---- */

static void expect_all_modes(const point *p)
{
    const unsigned storage = f.scene.volume.storage;
    corners eight;
    corners_of(&eight, p);
    const exact by_weight = weighted(&eight, storage), by_channel = separate(&eight, storage);
    const exact by_voxel = nearest(p, storage);
    expect_sample(qv_sample_weighted, p, &by_weight);
    expect_sample(qv_sample_separate, p, &by_channel);
    expect_sample(qv_sample_nearest, p, &by_voxel);
}

static void random_points_of_every_storage(void **state)
{
    uint32_t seed = 19;
    (void)state;

    for (unsigned s = 0; s < 4; s++) {
        fixture_make(&f, storages[s], 23);
        for (unsigned i = 0; i < 30000; i++) {
            const point p = random_point(&seed);
            expect_all_modes(&p);
        }
    }
}

/* Colours and opacities of 0 and the type's greatest: sums of 32 bits are full. */
static void greatest_values(void **state)
{
    uint32_t seed = 29;
    (void)state;

    for (unsigned s = 0; s < 2; s++) {
        fixture_make(&f, storages[s], 1);
        for (unsigned i = 0; i < sizeof f.voxels; i++)
            ((uint8_t *)f.voxels)[i] = (uint8_t)(random_below(&seed, 8) != 0 ? 255 : 0);
        for (unsigned i = 0; i < 20000; i++) {
            const point p = random_point(&seed);
            expect_all_modes(&p);
        }
    }
}

/* At a voxel's centre all modes give that voxel. */
static void centres_are_exact(void **state)
{
    (void)state;

    for (unsigned s = 0; s < 4; s++) {
        fixture_make(&f, storages[s], 31);
        for (int32_t i = 0; i < FIXTURE_VOXELS; i++) {
            const int32_t x = i % FIXTURE_NX, y = i / FIXTURE_NX % FIXTURE_NY;
            const point p = {
                {x * 256 + 128, y * 256 + 128, i / (FIXTURE_NX * FIXTURE_NY) * 256 + 128}};
            const exact expected = nearest(&p, f.scene.volume.storage);
            expect_sample(qv_sample_nearest, &p, &expected);
            expect_sample(qv_sample_weighted, &p, &expected);
            expect_sample(qv_sample_separate, &p, &expected);
        }
    }
}

/* One opaque colour stays itself everywhere, exactly. */
static void an_opaque_volume_is_exactly_opaque(void **state)
{
    static const uint16_t colour[4] = {0xFFFF, 0x0101, 0xABAB, 0xFFFF}; /* in 8 bits too */
    uint32_t seed = 37;
    (void)state;

    for (unsigned s = 0; s < 2; s++) {
        fixture_make(&f, storages[s], 1);
        for (unsigned i = 0; i < FIXTURE_VOXELS * 4; i++)
            if (s == 0)
                ((uint8_t *)f.voxels)[i] = (uint8_t)colour[i % 4];
            else
                f.voxels[i] = colour[i % 4];
        for (unsigned i = 0; i < 5000; i++) {
            const point p = random_point(&seed);
            const exact expected = nearest(&p, f.scene.volume.storage);
            assert_int_equal(expected.opacity, s == 0 ? 65536u * 255 : 65536u * 65535);
            expect_sample(qv_sample_separate, &p, &expected);
            expect_sample(qv_sample_nearest, &p, &expected);
            if (s == 0) /* 16-bit terms are cut: at most 8 low, tested above */
                expect_sample(qv_sample_weighted, &p, &expected);
        }
    }
}

/* ---- What is not seen ---- */

static void cells_without_opacity_are_not_seen(void **state)
{
    static qv_mode *const modes[3] = {qv_sample_nearest, qv_sample_separate, qv_sample_weighted};
    uint32_t seed = 41;
    (void)state;

    for (unsigned s = 0; s < 4; s++) {
        fixture_make(&f, storages[s], 43);
        for (unsigned i = 0; i < 3000; i++) {
            const point p = random_point(&seed);
            const qv_ray ray = ray_at(&p);
            corners eight;
            uint32_t any = 0;
            corners_of(&eight, &p);
            for (unsigned c = 0; c < 8; c++)
                any |= eight.rgba[c][3];
            for (unsigned m = 0; m < 3; m++) {
                const uint64_t seen = m == 0 ? nearest(&p, f.scene.volume.storage).opacity : any;
                qv_sample sample;
                assert_int_equal(modes[m](&sample, &ray, &f.scene.volume, f.scene.volume.storage),
                                 seen != 0);
            }
        }
    }
}

/* ---- Cells ---- */

/* Within half a voxel of a face, samples are those of the outermost centres. */
static void samples_are_clamped_at_the_faces(void **state)
{
    uint32_t seed = 47;
    (void)state;

    fixture_make(&f, &qv_nearest_rgba8, 53);
    for (unsigned i = 0; i < 20000; i++) {
        point p = random_point(&seed), q = p;
        corners eight;
        for (unsigned axis = 0; axis < 3; axis++) {
            const int32_t most = f.scene.volume.size[axis] * 256 - 128;
            q.at[axis] = q.at[axis] < 128 ? 128 : q.at[axis];
            q.at[axis] = q.at[axis] > most ? most : q.at[axis];
        }
        corners_of(&eight, &q);
        const exact expected = weighted(&eight, QV_STORAGE_RGBA8);
        expect_sample(qv_sample_weighted, &p, &expected);
    }
}

/* An axis of one voxel: its stride is not read. */
static void a_flat_volume_ignores_the_stride(void **state)
{
    uint32_t seed = 59;
    (void)state;

    fixture_make(&f, &qv_nearest_rgba8, 61);
    for (unsigned axis = 0; axis < 3; axis++)
        f.scene.volume.size[axis] = 1;
    f.scene.volume.stride[0] = INT32_MIN;
    f.scene.volume.stride[1] = INT32_MAX;
    for (unsigned i = 0; i < 1000; i++) {
        const point p = random_point(&seed), middle = {{128, 128, 128}};
        const exact expected = nearest(&middle, QV_STORAGE_RGBA8);
        expect_sample(qv_sample_weighted, &p, &expected);
    }
}

/* Points round to 1/256 voxel, ties upwards. */
static void points_round_to_nearest(void **state)
{
    static const qv_coord offset[4] = {0, VOXEL / 512 - 1, VOXEL / 512, 3 * VOXEL / 512 - 1};
    static const uint32_t fraction[4] = {0, 0, 1, 1};
    (void)state;

    fixture_make(&f, &qv_nearest_rgba8, 1);
    for (unsigned i = 0; i < 4; i++)
        for (unsigned axis = 0; axis < 3; axis++) {
            qv_ray ray = {.samples = 0};
            qv_cell cell;
            ray.place[axis] = VOXEL + offset[i] + VOXEL / 512;
            qv_cell_locate(&cell, &f.scene.volume, &ray);
            assert_int_equal(fx_fraction_bits(cell.fraction[axis]), fraction[i]);
            assert_true(cell.base == f.scene.volume.voxels + f.scene.volume.stride[axis]);
        }
}

/* ---- Opacity as Q0.32 ---- */

/* Of 1 = unit: never above share * 2^32 / unit, at most 3 below, and 2^32 - 1
   for 1 itself. */
static void expect_q32(uint32_t share, unsigned storage)
{
    const uint64_t unit = wide(storage) ? (uint64_t)65536 * 65535 : 65536 * 255;
    const uint64_t numerator = (uint64_t)share << 32;
    const uint32_t opacity = qv_opacity_q32(fx_share_of(share), storage);
    const int above = opacity * unit > numerator;
    const int below = (uint64_t)(opacity + UINT64_C(3)) * unit < numerator;
    if (above || below)
        fail_msg("opacity of share %u: %u", share, opacity);
}

static void opacity_of_every_8_bit_share(void **state)
{
    (void)state;

    for (uint32_t share = 0; share <= 65536 * 255; share++)
        expect_q32(share, QV_STORAGE_RGBA8);
    assert_int_equal(qv_opacity_q32(fx_share_of(0), QV_STORAGE_RGBA8), 0);
    assert_int_equal(qv_opacity_q32(fx_share_of(65536 * 255), QV_STORAGE_RGBA8), 0xFFFFFFFF);
}

/* Those of one voxel with all the weight, and every 251st of the others. */
static void opacity_of_16_bit_shares(void **state)
{
    const uint32_t unit = 65536u * 65535;
    (void)state;

    for (uint32_t opacity = 0; opacity <= 65535; opacity++)
        expect_q32(opacity * 65536, QV_STORAGE_INDEXED8_16);
    for (uint32_t share = 0; share < unit - 251; share += 251)
        expect_q32(share, QV_STORAGE_RGBA16);
    assert_int_equal(qv_opacity_q32(fx_share_of(0), QV_STORAGE_RGBA16), 0);
    assert_int_equal(qv_opacity_q32(fx_share_of(unit), QV_STORAGE_RGBA16), 0xFFFFFFFF);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_points_of_every_storage),
        cmocka_unit_test(greatest_values),
        cmocka_unit_test(centres_are_exact),
        cmocka_unit_test(an_opaque_volume_is_exactly_opaque),
        cmocka_unit_test(cells_without_opacity_are_not_seen),
        cmocka_unit_test(samples_are_clamped_at_the_faces),
        cmocka_unit_test(a_flat_volume_ignores_the_stride),
        cmocka_unit_test(points_round_to_nearest),
        cmocka_unit_test(opacity_of_every_8_bit_share),
        cmocka_unit_test(opacity_of_16_bit_shares),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
