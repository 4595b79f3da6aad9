/*
 * Checks of volumes: each error by itself, both sides of each limit, and strides
 * against the bytes that they really reach.
 */
#include "check.h"
#include "scene_fixture.h"

#include <stdlib.h>

static const uint8_t storages[4] = {QV_STORAGE_RGBA8, QV_STORAGE_RGBA16, QV_STORAGE_INDEXED8,
                                    QV_STORAGE_INDEXED8_16};

/* What a volume of more bytes than 32-bit offsets reach is, apart from its size. */
#define BEYOND_32_BITS (sizeof(qv_offset) > 4 ? QV_OK : QV_ERROR_STRIDE)

static fixture f;
static qv_volume *const volume = &f.scene.volume;

static void make(uint8_t storage)
{
    fixture_volume(&f, storage, 1);
}

static void expect(qv_status status)
{
    assert_int_equal(qv_volume_check(volume), status);
}

/* ---- What is there at all ---- */

static void every_storage_is_accepted(void **state)
{
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        make(storages[i]);
        expect(QV_OK);
    }
}

static void null_pointers(void **state)
{
    (void)state;

    assert_int_equal(qv_volume_check(NULL), QV_ERROR_NULL);
    make(QV_STORAGE_RGBA8);
    volume->voxels = NULL;
    expect(QV_ERROR_NULL);
}

static void unknown_storages(void **state)
{
    static const uint8_t unknown[] = {0, QV_STORAGE_ASSOCIATED8 + 1, 128, 255};
    (void)state;

    for (unsigned i = 0; i < sizeof unknown; i++) {
        make(QV_STORAGE_RGBA8);
        volume->storage = unknown[i];
        expect(QV_ERROR_STORAGE);
    }
}

/* ---- Sizes ---- */

/* Whatever the strides are: the axis may be the one of the smallest. */
static void sizes_out_of_range(void **state)
{
    static const uint16_t bad[] = {0, QV_AXIS_MAX + 1, 65535};
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++)
        for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
            make(QV_STORAGE_RGBA8);
            volume->size[axis] = bad[i];
            expect(QV_ERROR_SIZE);
            volume->stride[axis] = 4;
            volume->stride[(axis + 1) % 3] = 1 << 10;
            volume->stride[(axis + 2) % 3] = 1 << 20;
            expect(QV_ERROR_SIZE);
        }
}

/* No voxel is read: only the descriptor is large. */
static void the_largest_volume(void **state)
{
    (void)state;

    make(QV_STORAGE_INDEXED8);
    for (unsigned axis = 0; axis < 3; axis++) {
        volume->size[axis] = QV_AXIS_MAX;
        volume->stride[axis] = 1 << (12 * axis);
    }
    volume->voxels_bytes = (uint64_t)1 << 36;
    expect(BEYOND_32_BITS);
    volume->voxels_bytes--;
    expect(QV_ERROR_STRIDE);
}

static void a_single_voxel_needs_no_strides(void **state)
{
    static const int32_t any[] = {0, 1, -3, INT32_MAX, INT32_MIN};
    (void)state;

    for (unsigned i = 0; i < sizeof any / sizeof any[0]; i++) {
        make(QV_STORAGE_RGBA16);
        volume->voxels_bytes = 8;
        for (unsigned axis = 0; axis < 3; axis++) {
            volume->size[axis] = 1;
            volume->stride[axis] = any[i];
        }
        expect(QV_OK);
        volume->voxels_bytes = 7;
        expect(QV_ERROR_STRIDE);
    }
}

/* ---- Strides ---- */

static void memory_one_byte_too_small(void **state)
{
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        make(storages[i]);
        volume->voxels_bytes--;
        expect(QV_ERROR_STRIDE);
        volume->voxels_bytes = 0;
        expect(QV_ERROR_STRIDE);
    }
}

static void strides_that_overlap(void **state)
{
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        const int32_t least = storages[i] == QV_STORAGE_RGBA16 ? 2 : 1;
        for (unsigned axis = 0; axis < 3; axis++) {
            make(storages[i]);
            volume->stride[axis] -= least;
            expect(QV_ERROR_STRIDE);
            volume->stride[axis] = 0;
            expect(QV_ERROR_STRIDE);
            volume->stride[axis] = -volume->stride[(axis + 1) % 3];
            expect(QV_ERROR_STRIDE);
        }
    }
}

static void strides_of_any_order_and_sign(void **state)
{
    (void)state;

    make(QV_STORAGE_RGBA16);
    volume->stride[2] = -8;
    volume->stride[0] = 8 * FIXTURE_NZ;
    volume->stride[1] = -8 * FIXTURE_NZ * FIXTURE_NX;
    expect(QV_OK);
    volume->stride[1] += 2;
    expect(QV_ERROR_STRIDE);
}

static void odd_strides_of_16_bit_voxels(void **state)
{
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++)
        for (unsigned i = 0; i < 4; i++) {
            make(storages[i]);
            volume->voxels_bytes = UINT64_MAX;
            volume->stride[2] += 40; /* room for the odd byte below it */
            volume->stride[1] += axis == 0 ? 8 : 0;
            volume->stride[axis] += 1;
            expect(storages[i] == QV_STORAGE_RGBA16 ? QV_ERROR_STRIDE : QV_OK);
        }
}

static void odd_addresses_of_16_bit_data(void **state)
{
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        make(storages[i]);
        volume->voxels++;
        expect(storages[i] == QV_STORAGE_RGBA16 ? QV_ERROR_STRIDE : QV_OK);
        make(storages[i]);
        if (volume->palette) {
            volume->palette++;
            expect(storages[i] == QV_STORAGE_INDEXED8_16 ? QV_ERROR_PALETTE : QV_OK);
        }
    }
}

/* The farthest byte that a stride of 32 bits reaches on one axis, and beyond all
   memory on three. */
static void strides_of_32_bits(void **state)
{
    static const int32_t extreme[2] = {INT32_MIN, INT32_MAX - 3};
    static const uint64_t size[2] = {0x80000000u, 0x7FFFFFFCu};
    (void)state;

    for (unsigned i = 0; i < 2; i++)
        for (unsigned axis = 0; axis < 3; axis++) {
            make(QV_STORAGE_RGBA8);
            volume->size[0] = volume->size[1] = volume->size[2] = 1;
            volume->size[axis] = QV_AXIS_MAX;
            volume->stride[axis] = extreme[i];
            volume->voxels_bytes = size[i] * (QV_AXIS_MAX - 1) + 4;
            expect(BEYOND_32_BITS);
            volume->voxels_bytes--;
            expect(QV_ERROR_STRIDE);
            volume->size[0] = volume->size[1] = volume->size[2] = QV_AXIS_MAX;
            volume->stride[0] = volume->stride[1] = volume->stride[2] = extreme[i];
            volume->voxels_bytes = UINT64_MAX;
            expect(QV_ERROR_STRIDE);
        }
}

/* Two voxels as far apart as a signed offset of 32 bits can tell, and one byte more. */
static void memory_beyond_an_offset(void **state)
{
    (void)state;

    make(QV_STORAGE_INDEXED8);
    volume->size[0] = volume->size[1] = 1;
    volume->size[2] = 2;
    volume->stride[2] = INT32_MAX - 1;
    volume->voxels_bytes = UINT64_MAX;
    expect(QV_OK);
    volume->stride[2]++;
    expect(BEYOND_32_BITS);
}

/* ---- Strides against the bytes that they reach ---- */

enum { SPAN = 16384 }; /* two steps of 801 bytes on three axes reach 4814 either way */

/* Marks every byte of every voxel; returns 0 where one is marked twice. Also
   the distance from the lowest to the highest. */
static int voxels_are_apart(uint32_t *span)
{
    uint8_t taken[SPAN] = {0};
    const int32_t bytes = fixture_voxel_bytes(volume->storage);
    int32_t low = SPAN, high = 0;

    for (int32_t i = 0; i < volume->size[0] * volume->size[1] * volume->size[2]; i++) {
        const int32_t x = i % volume->size[0], yz = i / volume->size[0];
        const int32_t at = SPAN / 2 + x * volume->stride[0] +
                           yz % volume->size[1] * volume->stride[1] +
                           yz / volume->size[1] * volume->stride[2];
        for (int32_t b = at; b < at + bytes; b++)
            if (taken[b]++ != 0)
                return 0;
        low = at < low ? at : low;
        high = at + bytes > high ? at + bytes : high;
    }
    *span = (uint32_t)(high - low);
    return 1;
}

/* Whether each axis lies outside the extent of those with smaller strides. */
static int axes_nest(void)
{
    for (unsigned a = 0; a < 3; a++) {
        int32_t extent = fixture_voxel_bytes(volume->storage);
        for (unsigned b = 0; b < 3; b++)
            if (b != a && volume->size[b] > 1 && abs(volume->stride[b]) <= abs(volume->stride[a]))
                extent += (volume->size[b] - 1) * abs(volume->stride[b]);
        if (volume->size[a] > 1 && abs(volume->stride[a]) < extent)
            return 0;
    }
    return 1;
}

static void random_strides(uint32_t *seed)
{
    static const int32_t ranges[3] = {4, 20, 100};
    const int32_t unit = volume->storage == QV_STORAGE_RGBA16 ? 2 : 1;

    for (unsigned axis = 0; axis < 3; axis++) {
        const int32_t range = ranges[random_below(seed, 3)] * fixture_voxel_bytes(volume->storage);
        const int32_t stride = (int32_t)random_below(seed, (uint32_t)(range + 2)) / unit * unit;
        volume->size[axis] = (uint16_t)(1 + random_below(seed, 3));
        volume->stride[axis] = random_below(seed, 2) != 0 ? stride : -stride;
    }
}

static void what_is_accepted_does_not_overlap(void **state)
{
    uint32_t seed = 2, accepted = 0;
    (void)state;

    for (unsigned i = 0; i < 100000; i++) {
        uint32_t span = 0;
        make(storages[i % 2]);
        random_strides(&seed);
        volume->voxels_bytes = UINT64_MAX;
        const qv_status status = qv_volume_check(volume);
        assert_int_equal(status, axes_nest() ? QV_OK : QV_ERROR_STRIDE);
        if (status != QV_OK)
            continue;
        accepted++;
        assert_true(voxels_are_apart(&span));
        volume->voxels_bytes = span;
        expect(QV_OK);
        volume->voxels_bytes = span - 1;
        expect(QV_ERROR_STRIDE);
    }
    assert_in_range(accepted, 10000, 90000);
}

/* ---- Palettes ---- */

static void palettes_of_the_wrong_size(void **state)
{
    static const uint32_t bad[] = {0, 1, 1023, 1025, 2047, 2049, UINT32_MAX};
    (void)state;

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++)
        for (unsigned s = 2; s < 4; s++) {
            make(storages[s]);
            volume->palette_bytes = bad[i];
            expect(QV_ERROR_PALETTE);
        }
    make(QV_STORAGE_INDEXED8);
    volume->palette_bytes = QV_PALETTE16_BYTES;
    expect(QV_ERROR_PALETTE);
    make(QV_STORAGE_INDEXED8_16);
    volume->palette_bytes = QV_PALETTE8_BYTES;
    expect(QV_ERROR_PALETTE);
}

static void palettes_that_lack_or_should(void **state)
{
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        const int indexed = i >= 2;
        make(storages[i]);
        volume->palette = indexed ? NULL : (qv_address)f.palette8;
        expect(QV_ERROR_PALETTE);
        make(storages[i]);
        volume->palette_bytes = indexed ? 0 : QV_PALETTE8_BYTES;
        expect(QV_ERROR_PALETTE);
    }
}

/* ---- Spacing ---- */

static void spacing_out_of_range(void **state)
{
    static const uint32_t bad[] = {1, QV_ONE_Q16 / 16 - 1, QV_ONE_Q16 * 256 + 1, UINT32_MAX};
    static const uint32_t good[] = {0, QV_ONE_Q16 / 16, QV_ONE_Q16, QV_ONE_Q16 * 256};
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++)
        for (unsigned i = 0; i < 4; i++) {
            make(QV_STORAGE_RGBA8);
            volume->spacing[axis] = bad[i];
            expect(QV_ERROR_SPACING);
            volume->spacing[axis] = good[i];
            expect(QV_OK);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_storage_is_accepted),
        cmocka_unit_test(null_pointers),
        cmocka_unit_test(unknown_storages),
        cmocka_unit_test(sizes_out_of_range),
        cmocka_unit_test(the_largest_volume),
        cmocka_unit_test(a_single_voxel_needs_no_strides),
        cmocka_unit_test(memory_one_byte_too_small),
        cmocka_unit_test(strides_that_overlap),
        cmocka_unit_test(strides_of_any_order_and_sign),
        cmocka_unit_test(odd_strides_of_16_bit_voxels),
        cmocka_unit_test(odd_addresses_of_16_bit_data),
        cmocka_unit_test(strides_of_32_bits),
        cmocka_unit_test(memory_beyond_an_offset),
        cmocka_unit_test(what_is_accepted_does_not_overlap),
        cmocka_unit_test(palettes_of_the_wrong_size),
        cmocka_unit_test(palettes_that_lack_or_should),
        cmocka_unit_test(spacing_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
