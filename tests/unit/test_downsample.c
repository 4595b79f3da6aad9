/*
 * Downsampling against sums over 64 taps in real numbers, for every storage, filter and
 * domain.
 */
#include "check.h"
#include "downsample.h"
#include "downsample_fixture.h"
#include "reference.h"

#include <math.h>
#include <stdio.h>

static const qv_filter *const filters[] = {&qv_filter_box2, &qv_filter_box4, &qv_filter_quad4};

#define FILTERS 3u

static const double reference_filters[FILTERS][2] = {
    {0, 0.5}, {0.25, 0.25}, {13.0 / 64, 19.0 / 64}};

/* A level, at an odd address, and what comes after it. */
static unsigned char memory[SOURCE_VOXELS * 8 + 2];
static unsigned char *const level = &memory[1];

/* Greatest deviations in units of the last place. */
typedef struct worst {
    double fourth, colour, weighted; /* weighted: colour times the result's opacity */
} worst;

static void downsample(const source *s, unsigned filter, const qv_domain *domain)
{
    const uint16_t slices = (uint16_t)((s->volume.size[2] + 1) / 2);
    const size_t bytes = source_coarser_bytes(&s->volume);
    memset(memory, 0xA5, sizeof memory);
    assert_int_equal(qv_downsample(level, bytes, &s->volume, filters[filter], domain, 0, slices),
                     QV_OK);
    assert_int_equal(level[-1], 0xA5);
    assert_int_equal(level[bytes], 0xA5);
}

/* The level that was made, as a volume. */
static void result_volume(qv_volume *result, const qv_volume *finer)
{
    int32_t stride = source_entry_bytes(finer->storage);
    *result = *finer;
    result->voxels = level;
    result->storage = source_is_wide(finer->storage) ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
    for (unsigned axis = 0; axis < 3; axis++) {
        result->size[axis] = (uint16_t)((finer->size[axis] + 1) / 2);
        result->stride[axis] = stride;
        stride *= result->size[axis];
    }
}

static void compare_voxel(worst *w, const double actual[4], const double expected[4], double unit)
{
    w->fourth = fmax(w->fourth, fabs(actual[3] - expected[3]) * unit);
    for (int c = 0; c < 3; c++) {
        const double off = fabs(actual[c] - expected[c]) * unit;
        w->colour = fmax(w->colour, off);
        w->weighted = fmax(w->weighted, off * expected[3]);
    }
}

/* Compares the level that was made with the reference's. */
static void compare(worst *w, const qv_volume *finer, unsigned filter, ref_domain domain)
{
    qv_volume result;
    const double unit = source_is_wide(finer->storage) ? 65535 : 255;
    result_volume(&result, finer);
    for (int32_t z = 0; z < result.size[2]; z++)
        for (int32_t y = 0; y < result.size[1]; y++)
            for (int32_t x = 0; x < result.size[0]; x++) {
                const int32_t at[3] = {x, y, z};
                double actual[4], expected[4];
                ref_voxel(actual, &result, at);
                ref_downsample(expected, finer, reference_filters[filter], domain, at);
                compare_voxel(w, actual, expected, unit);
            }
}

static void random_size(uint16_t size[3], uint32_t *seed)
{
    for (unsigned axis = 0; axis < 3; axis++)
        size[axis] = (uint16_t)(1 + random_below(seed, 9));
    if (size[0] == 1 && size[1] == 1 && size[2] == 1)
        size[random_below(seed, 3)] = 2;
}

/* Random volumes of a storage, each with every filter. */
static void compare_random(worst *w, uint8_t storage, source_filling filling,
                           const qv_domain *domain, ref_domain reference)
{
    static source s;
    uint32_t seed = 7u + storage + 16u * filling;
    for (unsigned round = 0; round < 60; round++) {
        uint16_t size[3];
        random_size(size, &seed);
        source_make(&s, storage, size, filling, &seed);
        for (unsigned axis = 0; axis < 3; axis++)
            if ((round >> axis & 1) != 0)
                source_turn(&s, axis);
        for (unsigned filter = 0; filter < FILTERS; filter++) {
            downsample(&s, filter, domain);
            compare(w, &s.volume, filter, reference);
        }
    }
}

static void expect_at_most(double off, double most, const char *what)
{
    if (!(off <= most))
        fail_msg("%s: %.4f units off, not %.4f", what, off, most);
}

/* Exact sums, rounded once; the double sums of the reference take .0001. */
static void what_is_stored_is_averaged_exactly(void **state)
{
    worst w = {0, 0, 0};
    (void)state;

    for (unsigned i = 0; i < SOURCE_STORAGES; i++)
        for (source_filling filling = NOISE; filling < FILLINGS; filling++)
            compare_random(&w, source_storages[i], filling, &qv_domain_stored, REF_AVERAGE_STORED);
    printf("# stored: fourth channel %.5f, colour %.5f units off\n", w.fourth, w.colour);
    expect_at_most(w.fourth, 0.5001, "fourth channel");
    expect_at_most(w.colour, 0.5001, "colour");
}

/* The bound of 16-bit colours, .5 + .0009 / least opacity, for the least of a filling. */
static double most_off_16(source_filling filling)
{
    return 0.5 + 0.0009 / (filling == DENSE ? 13107 / 65535.0 : 1 / 65535.0);
}

static void extinction_is_averaged(void **state)
{
    (void)state;

    for (unsigned i = 0; i < 4; i++)
        for (source_filling filling = NOISE; filling < FILLINGS; filling++) {
            const int wide = source_is_wide(source_storages[i]);
            worst w = {0, 0, 0};
            compare_random(&w, source_storages[i], filling, &qv_domain_extinction,
                           REF_AVERAGE_EXTINCTION);
            printf("# extinction, storage %u, filling %u: fourth channel %.5f, colour %.5f, "
                   "times opacity %.5f units off\n",
                   (unsigned)source_storages[i], (unsigned)filling, w.fourth, w.colour, w.weighted);
            expect_at_most(w.fourth, 0.51, "fourth channel");
            expect_at_most(w.weighted, 0.51, "colour times opacity");
            expect_at_most(w.colour, wide ? most_off_16(filling) : 0.51, "colour");
        }
}

/* A row of four by the filter (13 19 19 13) / 64, mirrored: worked on paper. */
static void a_row_on_paper(void **state)
{
    static const uint16_t size[3] = {4, 1, 1};
    static const uint8_t row[4][4] = {
        {64, 0, 0, 64}, {0, 64, 0, 128}, {0, 0, 255, 0}, {0, 0, 128, 192}};
    /* first: 13 a + 19 a + 19 b + 13 c; second: 13 b + 19 c + 19 d + 13 d */
    static const uint8_t expected[2][4] = {{29, 35, 0, 70}, {0, 14, 101, 122}};
    static source s;
    (void)state;

    source_shape(&s, QV_STORAGE_RGBA8, size);
    memcpy(s.voxels, row, sizeof row);
    downsample(&s, 2, &qv_domain_stored);
    assert_memory_equal(level, expected, sizeof expected);
}

static void ties_go_upwards(void **state)
{
    static const uint16_t size[3] = {2, 1, 1};
    static const uint8_t pair[2][4] = {{1, 2, 5, 100}, {2, 3, 5, 100}};
    static const uint8_t expected[4] = {2, 3, 5, 100};
    static source s;
    (void)state;

    source_shape(&s, QV_STORAGE_RGBA8, size);
    memcpy(s.voxels, pair, sizeof pair);
    downsample(&s, 0, &qv_domain_stored);
    assert_memory_equal(level, expected, sizeof expected);
}

/* Opaque white, whose sums are the greatest, and every single opacity. */
static void homogeneous_volumes_stay(void **state)
{
    static const uint16_t size[3] = {3, 4, 5};
    static source s;
    (void)state;

    source_shape(&s, QV_STORAGE_RGBA16, size);
    for (uint32_t opacity = 1; opacity < 65536; opacity += opacity < 65000 ? 37 : 1) {
        const uint16_t voxel[4] = {65535, (uint16_t)(opacity * 40503u), 0, (uint16_t)opacity};
        const unsigned filter = opacity % FILTERS;
        for (unsigned i = 0; i < 60; i++)
            memcpy(&s.voxels[4 * i], voxel, sizeof voxel);
        downsample(&s, filter, &qv_domain_extinction);
        for (unsigned i = 0; i < 2 * 2 * 3; i++)
            assert_memory_equal(&level[8 * i], voxel, sizeof voxel);
    }
}

static void nothing_is_black(void **state)
{
    static const uint16_t size[3] = {5, 5, 5};
    static const unsigned char black[27 * 4];
    static source s;
    unsigned char *bytes = (unsigned char *)s.voxels;
    (void)state;

    for (unsigned i = 0; i < SOURCE_STORAGES; i += 4) {
        source_shape(&s, source_storages[i], size);
        for (unsigned v = 0; v < 125; v++) {
            memset(&bytes[4 * v], 0xFF, 3);
            bytes[4 * v + 3] = 0;
        }
        downsample(&s, 1, &qv_domain_stored);
        assert_memory_equal(level, black, sizeof black);
    }
}

/* An axis of the greatest length, on each axis in turn. */
static void the_longest_axes(void **state)
{
    static unsigned char voxels[QV_AXIS_MAX][4], coarse[QV_AXIS_MAX / 2][4];
    qv_volume v;
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++) {
        memset(&v, 0, sizeof v);
        memset(voxels, 0xFF, sizeof voxels);
        voxels[QV_AXIS_MAX - 1][0] = 0;
        v.voxels = &voxels[0][0];
        v.voxels_bytes = sizeof voxels;
        v.storage = QV_STORAGE_RGBA8;
        v.size[0] = v.size[1] = v.size[2] = 1;
        v.size[axis] = QV_AXIS_MAX;
        v.stride[axis] = 4;
        assert_int_equal(qv_downsample(coarse, sizeof coarse, &v, &qv_filter_box2,
                                       &qv_domain_extinction, 0, axis == 2 ? 2048 : 1),
                         QV_OK);
        for (unsigned i = 0; i < 2048; i++)
            assert_int_equal(coarse[i][0], i == 2047 ? 128 : 255);
    }
}

static void slices_equal_the_whole(void **state)
{
    static const uint16_t size[3] = {7, 6, 9};
    static source s;
    unsigned char slices[4 * 3 * 5 * 8];
    uint32_t seed = 23;
    (void)state;

    for (unsigned i = 0; i < SOURCE_STORAGES; i++) {
        source_make(&s, source_storages[i], size, SPARSE, &seed);
        const size_t slice = 4 * 3 * (size_t)source_entry_bytes(source_storages[i]);
        downsample(&s, 2, &qv_domain_stored);
        for (uint16_t z = 0; z < 5; z++)
            assert_int_equal(qv_downsample(&slices[z * slice], slice, &s.volume, filters[2],
                                           &qv_domain_stored, z, (uint16_t)(z + 1)),
                             QV_OK);
        assert_memory_equal(level, slices, 5 * slice);
    }
}

/* ---- What is refused ---- */

static source good;

static void make_good(void)
{
    static const uint16_t size[3] = {4, 3, 4};
    uint32_t seed = 5;
    source_make(&good, QV_STORAGE_RGBA16, size, NOISE, &seed);
}

#define GOOD_BYTES (2u * 2u * 2u * 8u)

static void expect_refused(const qv_filter *filter, const qv_domain *domain, uint16_t first_z,
                           uint16_t end_z, size_t bytes, qv_status expected)
{
    unsigned char before[sizeof memory];
    memset(before, 0x3C, sizeof before);
    memset(memory, 0x3C, sizeof memory);
    assert_int_equal(qv_downsample(level, bytes, &good.volume, filter, domain, first_z, end_z),
                     expected);
    assert_memory_equal(memory, before, sizeof before);
}

static void expect_volume_refused(qv_status expected)
{
    expect_refused(&qv_filter_box4, &qv_domain_stored, 0, 2, GOOD_BYTES, expected);
}

static void null_pointers_are_refused(void **state)
{
    (void)state;

    make_good();
    assert_int_equal(
        qv_downsample(NULL, GOOD_BYTES, &good.volume, &qv_filter_box2, &qv_domain_stored, 0, 2),
        QV_ERROR_NULL);
    assert_int_equal(
        qv_downsample(level, GOOD_BYTES, NULL, &qv_filter_box2, &qv_domain_stored, 0, 2),
        QV_ERROR_NULL);
    expect_refused(NULL, &qv_domain_stored, 0, 2, GOOD_BYTES, QV_ERROR_NULL);
    expect_refused(&qv_filter_box2, NULL, 0, 2, GOOD_BYTES, QV_ERROR_NULL);
    good.volume.voxels = NULL;
    expect_volume_refused(QV_ERROR_NULL);
}

static void bad_arguments_are_refused(void **state)
{
    static const qv_filter bad[] = {{16, 17}, {0, 0}, {13, 18}, {255, 33}};
    const qv_filter *box = &qv_filter_box2;
    const qv_domain *stored = &qv_domain_stored;
    (void)state;

    make_good();
    for (unsigned i = 0; i < 4; i++)
        expect_refused(&bad[i], stored, 0, 2, GOOD_BYTES, QV_ERROR_MIXTURE);
    expect_refused(box, stored, 0, 3, GOOD_BYTES * 2, QV_ERROR_SIZE);
    expect_refused(box, stored, 1, 1, GOOD_BYTES, QV_ERROR_SIZE);
    expect_refused(box, stored, 2, 1, GOOD_BYTES, QV_ERROR_SIZE);
    expect_refused(box, stored, 0, 2, GOOD_BYTES - 1, QV_ERROR_BUFFER);
    expect_refused(box, stored, 1, 2, 0, QV_ERROR_BUFFER);
    assert_int_equal(qv_downsample(level, GOOD_BYTES / 2, &good.volume, box, stored, 1, 2), QV_OK);
}

static void bad_volumes_are_refused(void **state)
{
    static const uint16_t single[3] = {1, 1, 1};
    (void)state;

    make_good();
    good.volume.storage = 0;
    expect_volume_refused(QV_ERROR_STORAGE);
    make_good();
    good.volume.size[0] = 0;
    expect_volume_refused(QV_ERROR_SIZE);
    make_good();
    good.volume.voxels_bytes--;
    expect_volume_refused(QV_ERROR_STRIDE);
    make_good();
    good.volume.storage = QV_STORAGE_INDEXED8;
    expect_volume_refused(QV_ERROR_PALETTE);
    make_good();
    source_shape(&good, QV_STORAGE_RGBA16, single);
    expect_volume_refused(QV_ERROR_LEVEL);
}

static void extinction_has_no_extinction(void **state)
{
    (void)state;

    for (unsigned i = 4; i < SOURCE_STORAGES; i++) {
        static const uint16_t size[3] = {4, 3, 4};
        source_shape(&good, source_storages[i], size);
        expect_refused(&qv_filter_box2, &qv_domain_extinction, 0, 2, GOOD_BYTES, QV_ERROR_STORAGE);
    }
}

/* A deep level's voxels may be wider than a volume's. */
static void spacing_is_not_read(void **state)
{
    (void)state;

    make_good();
    good.volume.spacing[1] = 0xFFFFFFFFu;
    assert_int_equal(
        qv_downsample(level, GOOD_BYTES, &good.volume, &qv_filter_box2, &qv_domain_stored, 0, 2),
        QV_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_stored_is_averaged_exactly),
        cmocka_unit_test(extinction_is_averaged),
        cmocka_unit_test(a_row_on_paper),
        cmocka_unit_test(ties_go_upwards),
        cmocka_unit_test(homogeneous_volumes_stay),
        cmocka_unit_test(nothing_is_black),
        cmocka_unit_test(the_longest_axes),
        cmocka_unit_test(slices_equal_the_whole),
        cmocka_unit_test(null_pointers_are_refused),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(bad_volumes_are_refused),
        cmocka_unit_test(extinction_has_no_extinction),
        cmocka_unit_test(spacing_is_not_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
