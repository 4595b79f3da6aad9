/*
 * Where the bytes of FreeVoxels lie, and what qv_attenuate refuses.
 */
#include "attenuation_fixture.h"

static lit l;

/* ---- Descriptors ---- */

static void bytes_of_records(void **state)
{
    qv_attenuation a;
    (void)state;

    memset(&a, 0, sizeof a);
    a.directions = QV_DIRECTIONS_ALL;
    a.size[0] = 3;
    a.size[1] = 4;
    a.size[2] = 5;
    assert_int_equal(qv_blocks_bytes(a.size),
                     4 * ((a.size[0] + 1) / 2) * ((a.size[1] + 1) / 2) * ((a.size[2] + 1) / 2));
    const uint16_t most[3] = {4096, 4096, 4096}, none[3] = {4, 0, 4};
    assert_true(qv_blocks_bytes(most) == (uint64_t)1 << 35);
    assert_true(qv_blocks_bytes(none) == 0 && qv_blocks_bytes(NULL) == 0);
    assert_int_equal(qv_attenuation_bytes(&a), 60 * 26);
    a.record = 30;
    assert_int_equal(qv_attenuation_bytes(&a), 59 * 30 + 26);
    a.directions = QV_DIRECTIONS_FACES;
    assert_int_equal(qv_attenuation_bytes(&a), 59 * 30 + 6);
    a.record = 6;
    assert_int_equal(qv_attenuation_bytes(&a), 60 * 6);
    a.record = 65535;
    a.size[0] = a.size[1] = a.size[2] = QV_AXIS_MAX;
    assert_int_equal(qv_attenuation_bytes(&a), ((uint64_t)65535 << 36) - 65529);
}

static void wrong_records_have_no_bytes(void **state)
{
    static const uint16_t size[3] = {3, 4, 5};
    (void)state;

    assert_int_equal(qv_attenuation_bytes(NULL), 0);
    lit_records(&l, size, 0, 0, NULL);
    assert_int_equal(l.attenuation.bytes, 0);
    lit_records(&l, size, 1u << 26, 0, NULL);
    assert_int_equal(l.attenuation.bytes, 0);
    lit_records(&l, size, QV_DIRECTIONS_FACES, 5, NULL);
    assert_int_equal(l.attenuation.bytes, 0);
    for (unsigned axis = 0; axis < 3; axis++) {
        uint16_t bad[3] = {3, 4, 5};
        bad[axis] = 0;
        lit_records(&l, bad, QV_DIRECTIONS_FACES, 0, NULL);
        assert_int_equal(l.attenuation.bytes, 0);
        bad[axis] = QV_AXIS_MAX + 1;
        lit_records(&l, bad, QV_DIRECTIONS_FACES, 0, NULL);
        assert_int_equal(l.attenuation.bytes, 0);
    }
}

static void the_bytes_of_a_voxel(void **state)
{
    static const uint16_t size[3] = {5, 3, 6};
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        const qv_order *order = orders[i] ? orders[i] : &qv_order_linear;
        lit_records(&l, size, QV_DIRECTIONS_FACES, 9, orders[i]);
        for (uint64_t index = 0; index < 90; index++) {
            uint16_t at[3];
            assert_int_equal(qv_order_position(at, order, size, index), QV_OK);
            assert_true(qv_attenuation_at(&l.attenuation, at) == l.memory + 9 * index);
        }
    }
}

static void no_bytes_of_what_is_no_voxel(void **state)
{
    static const uint16_t size[3] = {5, 3, 6}, last[3] = {4, 2, 5};
    (void)state;

    lit_records(&l, size, QV_DIRECTIONS_FACES, 9, NULL);
    assert_non_null(qv_attenuation_at(&l.attenuation, last));
    assert_null(qv_attenuation_at(&l.attenuation, NULL));
    assert_null(qv_attenuation_at(NULL, last));
    for (unsigned axis = 0; axis < 3; axis++) {
        uint16_t at[3] = {4, 2, 5};
        at[axis]++;
        assert_null(qv_attenuation_at(&l.attenuation, at));
    }
    l.attenuation.bytes--;
    assert_null(qv_attenuation_at(&l.attenuation, last));
    lit_records(&l, size, QV_DIRECTIONS_FACES, 9, NULL);
    l.attenuation.records = NULL;
    assert_null(qv_attenuation_at(&l.attenuation, last));
    lit_records(&l, size, QV_DIRECTIONS_FACES, 5, NULL);
    l.attenuation.bytes = sizeof l.memory;
    assert_null(qv_attenuation_at(&l.attenuation, last));
}

/* ---- What is refused ---- */

/* A good call, which a test then spoils. */
typedef struct call {
    void *to;
    size_t bytes;
    uint32_t *blocks;
    const qv_domain *domain;
    uint8_t direction;
} call;

static call good_call(void)
{
    static const uint16_t size[3] = {4, 3, 5};
    uint32_t seed = 9;
    source_make(&l.from, QV_STORAGE_RGBA16, size, NOISE, &seed);
    lit_records(&l, size, QV_DIRECTIONS_FACES, 0, NULL);
    const call good = {l.memory, (size_t)l.attenuation.bytes, l.blocks, &qv_domain_extinction, 4};
    return good;
}

static qv_status run(const call *c)
{
    return qv_attenuate(c->to, c->bytes, c->blocks, &l.attenuation, &l.from.volume, c->domain,
                        c->direction);
}

/* Neither bytes nor sums, nor voxels, are touched. */
static void expect_refused(const call *c, qv_status expected)
{
    static unsigned char memory[sizeof l.memory];
    static uint32_t blocks[SOURCE_VOXELS];
    static source from;
    memset(l.blocks, UNTOUCHED, sizeof l.blocks);
    memcpy(blocks, l.blocks, sizeof blocks);
    memcpy(memory, l.memory, sizeof memory);
    memcpy(&from, &l.from, sizeof from);
    assert_int_equal(run(c), expected);
    assert_memory_equal(l.blocks, blocks, sizeof blocks);
    assert_memory_equal(l.memory, memory, sizeof memory);
    assert_memory_equal(&l.from, &from, sizeof from);
}

static void null_pointers_are_refused(void **state)
{
    call c = good_call();
    (void)state;

    assert_int_equal(run(&c), QV_OK);
    assert_int_equal(
        qv_attenuate(c.to, c.bytes, c.blocks, NULL, &l.from.volume, c.domain, c.direction),
        QV_ERROR_NULL);
    assert_int_equal(
        qv_attenuate(c.to, c.bytes, c.blocks, &l.attenuation, NULL, c.domain, c.direction),
        QV_ERROR_NULL);
    c.to = NULL;
    expect_refused(&c, QV_ERROR_NULL);
    c = good_call();
    c.domain = NULL;
    expect_refused(&c, QV_ERROR_NULL);
    c = good_call();
    l.from.volume.voxels = NULL;
    expect_refused(&c, QV_ERROR_NULL);
}

static void wrong_volumes_are_refused(void **state)
{
    call c = good_call();
    (void)state;

    l.from.volume.storage = QV_STORAGE_ASSOCIATED8 + 1;
    expect_refused(&c, QV_ERROR_STORAGE);
    c = good_call();
    c.domain = &qv_domain_stored;
    expect_refused(&c, QV_ERROR_STORAGE);
    c = good_call();
    l.from.volume.storage = QV_STORAGE_RGBT16;
    expect_refused(&c, QV_ERROR_STORAGE);
    c.domain = &qv_domain_stored;
    assert_int_equal(run(&c), QV_OK);
    l.from.volume.voxels_bytes--;
    expect_refused(&c, QV_ERROR_STRIDE);
    c = good_call();
    l.from.volume.spacing[1] = 1;
    expect_refused(&c, QV_ERROR_SPACING);
    c = good_call();
    l.from.volume.storage = QV_STORAGE_INDEXED8;
    expect_refused(&c, QV_ERROR_PALETTE);
    c = good_call();
    l.from.volume.size[2] = 0;
    expect_refused(&c, QV_ERROR_SIZE);
}

/* A step of 2^12 unit distances is the longest, one of 2^-12 the shortest. */
static void wrong_units_are_refused(void **state)
{
    call c = good_call();
    (void)state;

    l.from.volume.unit_distance = 16;
    assert_int_equal(run(&c), QV_OK);
    l.from.volume.unit_distance = 15;
    expect_refused(&c, QV_ERROR_UNIT);
    l.from.volume.unit_distance = QV_ONE_Q16 << 12;
    assert_int_equal(run(&c), QV_OK);
    l.from.volume.unit_distance = (QV_ONE_Q16 << 12) + 1;
    expect_refused(&c, QV_ERROR_UNIT);

    l.from.volume.storage = QV_STORAGE_RGBT16;
    c.domain = &qv_domain_stored;
    l.from.volume.extinction = 4096 * QV_ONE_Q16 - 1;
    assert_int_equal(run(&c), QV_OK);
    l.from.volume.extinction = 4096 * QV_ONE_Q16;
    expect_refused(&c, QV_ERROR_EXTINCTION);
    l.from.volume.extinction = 0;
    expect_refused(&c, QV_ERROR_EXTINCTION);
}

static void wrong_records_are_refused(void **state)
{
    call c = good_call();
    (void)state;

    c.direction = 5;
    expect_refused(&c, QV_ERROR_DIRECTION);
    c.direction = 26;
    expect_refused(&c, QV_ERROR_DIRECTION);
    c = good_call();
    l.attenuation.directions = 0;
    expect_refused(&c, QV_ERROR_DIRECTION);
    l.attenuation.directions = 1u << 26 | 1u << 4;
    expect_refused(&c, QV_ERROR_DIRECTION);
    for (unsigned axis = 0; axis < 3; axis++) {
        c = good_call();
        l.attenuation.size[axis]--;
        expect_refused(&c, QV_ERROR_SIZE);
    }
    c = good_call();
    l.attenuation.record = 5;
    expect_refused(&c, QV_ERROR_ATTENUATION);
    c = good_call();
    c.bytes--;
    expect_refused(&c, QV_ERROR_ATTENUATION);
}

/* Up to the last byte before the voxels, and from the first behind them. */
static void overlaps_are_refused(void **state)
{
    call c = good_call();
    unsigned char *voxels = (unsigned char *)l.from.voxels;
    const size_t voxel_bytes = (size_t)l.from.volume.voxels_bytes;
    (void)state;

    for (unsigned axis = 0; axis < 4; axis++) {
        c.to = voxels + voxel_bytes - 1;
        expect_refused(&c, QV_ERROR_OVERLAP);
        c.to = voxels;
        expect_refused(&c, QV_ERROR_OVERLAP);
        c.to = voxels + voxel_bytes;
        assert_int_equal(run(&c), QV_OK);
        if (axis < 3)
            source_turn(&l.from, axis);
    }
    c = good_call();
    l.from.volume.voxels = voxels + 480;
    c.to = voxels + 480 - c.bytes;
    assert_int_equal(run(&c), QV_OK);
    c.to = voxels + 480 - c.bytes + 1;
    expect_refused(&c, QV_ERROR_OVERLAP);
}

static void overlapping_blocks_are_refused(void **state)
{
    call c = good_call();
    uint32_t *words = l.blocks; /* 2 * 2 * 3 sums */
    (void)state;

    c.to = words + 11;
    expect_refused(&c, QV_ERROR_OVERLAP);
    c.to = words + 12;
    assert_int_equal(run(&c), QV_OK);
    c.to = words;
    c.blocks = words + c.bytes / 4 - 1;
    expect_refused(&c, QV_ERROR_OVERLAP);
    c.blocks++;
    assert_int_equal(run(&c), QV_OK);
    c = good_call();
    l.from.volume.voxels = (qv_address)words;
    c.blocks = words + l.from.volume.voxels_bytes / 4 - 1;
    expect_refused(&c, QV_ERROR_OVERLAP);
}

static void palettes_are_read_too(void **state)
{
    static const uint16_t size[3] = {4, 3, 5};
    uint32_t seed = 9;
    (void)state;

    call c = good_call();
    source_make(&l.from, QV_STORAGE_INDEXED8, size, NOISE, &seed);
    c.to = (unsigned char *)l.from.palette + QV_PALETTE8_BYTES - 1;
    expect_refused(&c, QV_ERROR_OVERLAP);
    c = good_call();
    source_make(&l.from, QV_STORAGE_INDEXED8, size, NOISE, &seed);
    l.from.volume.palette = (qv_address)l.blocks;
    c.blocks = l.blocks + QV_PALETTE8_BYTES / 4 - 1;
    expect_refused(&c, QV_ERROR_OVERLAP);
    c.blocks++;
    assert_int_equal(run(&c), QV_OK);
}

/* Voxels of 4 bytes in records of 10 leave the set's 6 just enough. */
static void voxels_must_fit_the_gaps(void **state)
{
    static const uint16_t size[3] = {4, 3, 5};
    (void)state;

    for (unsigned place = 0; place <= 10; place++) {
        call c = good_call();
        unsigned char *voxels = (unsigned char *)l.from.voxels + 100;
        l.from.volume.storage = QV_STORAGE_RGBA8;
        l.from.volume.voxels = voxels;
        l.from.volume.stride[0] = 10;
        l.from.volume.stride[1] = 40;
        l.from.volume.stride[2] = 120;
        l.from.volume.voxels_bytes = 700;
        lit_records(&l, size, QV_DIRECTIONS_FACES, 10, NULL);
        c.bytes = 600;
        for (unsigned side = 0; side < 2; side++) {
            c.to = side ? voxels + place : voxels - place;
            if (place % 10 == (side ? 4 : 6))
                assert_int_equal(run(&c), QV_OK);
            else
                expect_refused(&c, QV_ERROR_OVERLAP);
        }
        c.to = voxels - 6;
        l.from.volume.stride[2] = 125;
        expect_refused(&c, QV_ERROR_OVERLAP);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_of_records),
        cmocka_unit_test(wrong_records_have_no_bytes),
        cmocka_unit_test(the_bytes_of_a_voxel),
        cmocka_unit_test(no_bytes_of_what_is_no_voxel),
        cmocka_unit_test(null_pointers_are_refused),
        cmocka_unit_test(wrong_volumes_are_refused),
        cmocka_unit_test(wrong_units_are_refused),
        cmocka_unit_test(wrong_records_are_refused),
        cmocka_unit_test(overlaps_are_refused),
        cmocka_unit_test(overlapping_blocks_are_refused),
        cmocka_unit_test(palettes_are_read_too),
        cmocka_unit_test(voxels_must_fit_the_gaps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
