/*
 * Light of lamps on voxels: against real arithmetic on the same bytes, for every storage; shadows;
 * blocks, orders and records; and what is refused.
 */
#include "check.h"
#include "downsample_fixture.h"
#include "freevoxels.h"

#include <math.h>
#include <stdio.h>

enum { VOXELS = 7 * 6 * 5, RECORD = 40, LIT_BYTES = VOXELS * 8 };

static const uint16_t size[3] = {7, 6, 5};
static const qv_block whole = {{0, 0, 0}, {7, 6, 5}};

static source s;
static uint8_t bytes[VOXELS][QV_DIRECTIONS]; /* of all directions, x fastest */

static qv_attenuation attenuation;
static qv_lighting lighting;

/* Voxels, their bytes, of which one in 16 is 0 and one in 16 is 255, and all directions kept. */
static void make(uint8_t storage, uint32_t *seed)
{
    source_make(&s, storage, size, NOISE, seed);
    for (unsigned v = 0; v < VOXELS; v++)
        for (unsigned d = 0; d < QV_DIRECTIONS; d++) {
            const uint32_t any = random_next(seed) >> 12;
            bytes[v][d] = (uint8_t)(any % 16 == 0 ? 0 : any % 16 == 1 ? 255 : any >> 4);
        }
    memset(&attenuation, 0, sizeof attenuation);
    memcpy(attenuation.size, size, sizeof size);
    attenuation.records = bytes[0];
    attenuation.bytes = sizeof bytes;
    attenuation.directions = QV_DIRECTIONS_ALL;
}

/* Along an axis, along a diagonal, a little beside it, or anywhere. */
static void random_direction(int16_t direction[3], uint32_t *seed)
{
    const uint32_t kind = random_below(seed, 4);
    do {
        for (unsigned axis = 0; axis < 3; axis++) {
            const int side = (int)random_below(seed, 3) - 1;
            const int any = (int)random_below(seed, 65536) - 32768;
            direction[axis] = (int16_t)(kind == 0 ? 300 * side : kind == 1 ? 300 * side + 1 : any);
        }
    } while (direction[0] == 0 && direction[1] == 0 && direction[2] == 0);
}

static void random_lighting(unsigned count, unsigned brightest, uint32_t *seed)
{
    memset(&lighting, 0, sizeof lighting);
    lighting.count = (uint8_t)count;
    for (unsigned c = 0; c < 3; c++)
        lighting.ambient[c] = (uint16_t)random_below(seed, brightest + 1);
    for (unsigned lamp = 0; lamp < count; lamp++) {
        random_direction(lighting.lamps[lamp].direction, seed);
        for (unsigned c = 0; c < 3; c++)
            lighting.lamps[lamp].colour[c] = (uint16_t)random_below(seed, brightest + 1);
    }
}

static qv_status light(void *lit, uint8_t interpolation)
{
    return qv_illuminate(lit, LIT_BYTES, &s.volume, &attenuation, &lighting, interpolation, &whole);
}

/* A channel of a lit voxel, and the same voxel's in the volume. */
static unsigned lit_channel(const uint8_t *lit, unsigned voxel, unsigned channel)
{
    uint16_t wide;
    if (!source_is_wide(s.volume.storage))
        return lit[4 * voxel + channel];
    memcpy(&wide, lit + 8 * voxel + 2 * channel, sizeof wide);
    return wide;
}

static unsigned own_channel(unsigned voxel, unsigned channel)
{
    const uint8_t storage = s.volume.storage;
    if (!source_is_indexed(storage))
        return lit_channel(s.volume.voxels, voxel, channel);
    return lit_channel(s.volume.palette, s.volume.voxels[voxel], channel);
}

/* ---- Against real arithmetic -------------------------------------------------------- */

/* Light of one channel on a voxel, at most 1. */
static double exact_light(const ref_bytes *of, const int32_t at[3], unsigned channel)
{
    double sum = lighting.ambient[channel] / 65535.0;
    for (unsigned lamp = 0; lamp < lighting.count; lamp++) {
        double v[3];
        for (unsigned axis = 0; axis < 3; axis++) {
            const uint32_t spacing = s.volume.spacing[axis] ? s.volume.spacing[axis] : QV_ONE_Q16;
            v[axis] = (double)lighting.lamps[lamp].direction[axis] / spacing;
        }
        sum += lighting.lamps[lamp].colour[channel] / 65535.0 *
               exp2(-ref_depth_of_bytes(of, 0, at, v));
    }
    return lighting.count == 0 && sum == 0 ? 1 : fmin(sum, 1);
}

/* The largest error of a colour, in its last place; opacities must be the same. */
static double worst_error(const uint8_t *lit, uint8_t interpolation)
{
    const ref_bytes of = {.volume = &s.volume,
                          .level = {bytes},
                          .light = (ref_light)interpolation,
                          .directions = attenuation.directions};
    double worst = 0;
    for (unsigned voxel = 0; voxel < VOXELS; voxel++) {
        const int32_t at[3] = {(int32_t)(voxel % 7), (int32_t)(voxel / 7 % 6),
                               (int32_t)(voxel / 42)};
        assert_int_equal(lit_channel(lit, voxel, 3), own_channel(voxel, 3));
        for (unsigned c = 0; c < 3; c++)
            worst = fmax(worst, fabs(own_channel(voxel, c) * exact_light(&of, at, c) -
                                     lit_channel(lit, voxel, c)));
    }
    return worst;
}

static double worst_of_scenes(uint8_t storage, uint8_t interpolation)
{
    double worst = 0;
    uint32_t seed = 1u + storage;
    for (unsigned scene = 0; scene < 20; scene++) {
        uint8_t lit[LIT_BYTES];
        make(storage, &seed);
        s.volume.unit_distance = scene % 3 == 0 ? 0 : QV_ONE_Q16;
        for (unsigned axis = 0; scene % 4 != 0 && axis < 3; axis++)
            s.volume.spacing[axis] = QV_ONE_Q16 / 2 + random_below(&seed, QV_ONE_Q16);
        random_lighting(scene % 5, scene % 2 == 0 ? 65535 : 20000, &seed);
        assert_int_equal(light(lit, interpolation), QV_OK);
        worst = fmax(worst, worst_error(lit, interpolation));
    }
    return worst;
}

static void lit_as_in_real_arithmetic(void **state)
{
    (void)state;
    for (unsigned i = 0; i < SOURCE_STORAGES; i++)
        for (uint8_t interpolation = 0; interpolation <= QV_BETWEEN_DEPTHS; interpolation++) {
            const double worst = worst_of_scenes(source_storages[i], interpolation);
            printf("# storage %u, interpolation %u: worst %.4f\n", source_storages[i],
                   interpolation, worst);
            assert_true(worst <= (source_is_wide(source_storages[i]) ? 1.5 : .51));
        }
}

/* ---- Where voxels and bytes lie ------------------------------------------------------- */

/* Index of a voxel, x fastest. */
static unsigned index_of(const uint16_t at[3])
{
    return at[0] + 7u * (at[1] + 6u * at[2]);
}

static void three_lamps(uint8_t storage, uint32_t *seed)
{
    make(storage, seed);
    random_lighting(3, 20000, seed);
}

/* The same bytes in records of a file, in another order. */
static void records_in_any_order(void **state)
{
    static const qv_order *const orders[] = {&qv_order_linear, &qv_order_morton, &qv_order_hilbert};
    static uint8_t records[VOXELS * RECORD];
    uint8_t lit[LIT_BYTES], again[LIT_BYTES];
    uint32_t seed = 1;
    (void)state;
    three_lamps(QV_STORAGE_RGBA8, &seed);
    assert_int_equal(light(lit, 0), QV_OK);
    for (unsigned o = 0; o < 3; o++) {
        for (unsigned index = 0; index < VOXELS; index++) {
            uint16_t at[3];
            assert_int_equal(qv_order_position(at, orders[o], size, index), QV_OK);
            memcpy(records + RECORD * index, bytes[index_of(at)], QV_DIRECTIONS);
        }
        attenuation.records = records;
        attenuation.bytes = sizeof records - (RECORD - QV_DIRECTIONS);
        attenuation.order = orders[o];
        attenuation.record = RECORD;
        memset(again, 0, sizeof again);
        assert_int_equal(light(again, 0), QV_OK);
        assert_memory_equal(again, lit, 4 * VOXELS);
    }
}

/* z fastest, y backwards. */
static void voxels_in_any_order(void **state)
{
    static uint8_t moved[VOXELS * 8];
    uint8_t lit[LIT_BYTES], again[LIT_BYTES];
    uint32_t seed = 2;
    uint16_t at[3];
    (void)state;
    three_lamps(QV_STORAGE_RGBA16, &seed);
    assert_int_equal(light(lit, 0), QV_OK);
    for (at[2] = 0; at[2] < 5; at[2]++)
        for (at[1] = 0; at[1] < 6; at[1]++)
            for (at[0] = 0; at[0] < 7; at[0]++)
                memcpy(moved + 8 * (at[2] + 5 * (5 - at[1] + 6 * at[0])),
                       s.volume.voxels + 8 * index_of(at), 8);
    s.volume.voxels = moved + 8 * 5 * 5;
    s.volume.stride[0] = 8 * 5 * 6;
    s.volume.stride[1] = -8 * 5;
    s.volume.stride[2] = 8;
    assert_int_equal(light(again, 0), QV_OK);
    assert_memory_equal(again, lit, 8 * VOXELS);
}

static void blocks_equal_the_whole(void **state)
{
    static const qv_block block = {{2, 1, 3}, {6, 2, 5}};
    uint8_t lit[LIT_BYTES], part[4 * 1 * 2 * 4 + 1];
    uint32_t seed = 3;
    const uint8_t *next = part;
    uint16_t at[3];
    (void)state;
    three_lamps(QV_STORAGE_INDEXED8_T8, &seed);
    assert_int_equal(light(lit, 0), QV_OK);
    part[sizeof part - 1] = 0xA5;
    assert_int_equal(
        qv_illuminate(part, sizeof part - 1, &s.volume, &attenuation, &lighting, 0, &block), QV_OK);
    for (at[2] = 3; at[2] < 5; at[2]++)
        for (at[1] = 1; at[1] < 2; at[1]++)
            for (at[0] = 2; at[0] < 6; at[0]++, next += 4)
                assert_memory_equal(next, lit + 4 * index_of(at), 4);
    assert_int_equal(part[sizeof part - 1], 0xA5);
}

/* Over the voxels themselves. */
static void voxels_are_lit_where_they_are(void **state)
{
    static const uint8_t storages[] = {QV_STORAGE_RGBA8, QV_STORAGE_RGBT16};
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        uint8_t lit[LIT_BYTES];
        uint32_t seed = 4;
        three_lamps(storages[i], &seed);
        assert_int_equal(light(lit, 0), QV_OK);
        assert_int_equal(light(s.voxels, 0), QV_OK);
        assert_memory_equal(s.voxels, lit, (size_t)source_entry_bytes(storages[i]) * VOXELS);
    }
}

/* ---- What light does --------------------------------------------------------------------- */

/* Colours stay as they are without light; lamps of no light make black, and no bytes are needed
   without lamps. */
static void light_of_nothing(void **state)
{
    uint8_t lit[LIT_BYTES];
    uint32_t seed = 5;
    (void)state;
    make(QV_STORAGE_RGBT16, &seed);
    random_lighting(0, 0, &seed);
    assert_int_equal(qv_illuminate(lit, sizeof lit, &s.volume, NULL, &lighting, 0, &whole), QV_OK);
    assert_memory_equal(lit, s.voxels, 8 * VOXELS);
    random_lighting(1, 0, &seed);
    assert_int_equal(light(lit, 0), QV_OK);
    for (unsigned voxel = 0; voxel < VOXELS; voxel++) {
        for (unsigned c = 0; c < 3; c++)
            assert_int_equal(lit_channel(lit, voxel, c), 0);
        assert_int_equal(lit_channel(lit, voxel, 3), own_channel(voxel, 3));
    }
}

/* round(colour * ambient), a channel each. */
static void ambient_light(void **state)
{
    uint8_t lit[LIT_BYTES];
    uint32_t seed = 6;
    (void)state;
    make(QV_STORAGE_RGBA16, &seed);
    random_lighting(0, 65535, &seed);
    lighting.ambient[1] = 65535;
    lighting.ambient[2] = 0;
    assert_int_equal(qv_illuminate(lit, sizeof lit, &s.volume, NULL, &lighting, 0, &whole), QV_OK);
    for (unsigned voxel = 0; voxel < VOXELS; voxel++)
        for (unsigned c = 0; c < 3; c++) {
            const double exact = own_channel(voxel, c) * (lighting.ambient[c] / 65535.0);
            assert_int_equal(lit_channel(lit, voxel, c), lround(exact));
        }
}

/* A lamp on +x, an opaque voxel in the middle of a row, a clear row beside: shadow falls behind the
   voxel and nowhere else. */
static void a_voxel_throws_a_shadow(void **state)
{
    static const uint16_t row[3] = {5, 2, 1};
    static const qv_block both = {{0, 0, 0}, {5, 2, 1}};
    static const uint8_t red[10] = {0, 0, 200, 200, 200, 200, 200, 200, 200, 200};
    const uint8_t along_x = qv_direction(1, 0, 0);
    uint8_t voxels[10][4], dark[10], lit[10][4];
    (void)state;
    source_shape(&s, QV_STORAGE_RGBA8, row);
    s.volume.voxels = voxels[0];
    s.volume.voxels_bytes = sizeof voxels;
    s.volume.unit_distance = QV_ONE_Q16;
    for (unsigned v = 0; v < 10; v++) {
        const uint8_t voxel[4] = {200, 100, 50, v == 2 ? 255 : 0};
        memcpy(voxels[v], voxel, sizeof voxel);
    }
    const qv_attenuation kept = {.records = dark,
                                 .bytes = sizeof dark,
                                 .directions = (uint32_t)1 << along_x,
                                 .size = {5, 2, 1}};
    const qv_lighting lamp = {.lamps = {{{77, 0, 0}, {65535, 32768, 0}}}, .count = 1};
    assert_int_equal(
        qv_attenuate(dark, sizeof dark, NULL, &kept, &s.volume, &qv_domain_extinction, along_x),
        QV_OK);
    assert_int_equal(qv_illuminate(lit, sizeof lit, &s.volume, &kept, &lamp, 0, &both), QV_OK);
    for (unsigned v = 0; v < 10; v++) {
        const uint8_t voxel[4] = {red[v], red[v] / 4, 0, v == 2 ? 255 : 0};
        assert_memory_equal(lit[v], voxel, sizeof voxel);
    }
}

/* ---- Refusals ------------------------------------------------------------------------------ */

static uint8_t untouched[LIT_BYTES];

/* A call that is refused writes nothing. */
static void refuse(uint8_t interpolation, const qv_block *block, size_t room, qv_status status)
{
    memset(untouched, 0xA5, sizeof untouched);
    assert_int_equal(
        qv_illuminate(untouched, room, &s.volume, &attenuation, &lighting, interpolation, block),
        status);
    for (unsigned i = 0; i < sizeof untouched; i++)
        assert_int_equal(untouched[i], 0xA5);
}

static void null_pointers_are_refused(void **state)
{
    uint8_t lit[LIT_BYTES];
    uint32_t seed = 7;
    (void)state;
    three_lamps(QV_STORAGE_RGBA8, &seed);
    const size_t room = sizeof lit;
    const qv_status null = QV_ERROR_NULL;
    const qv_volume *v = &s.volume;
    assert_int_equal(qv_illuminate(NULL, room, v, &attenuation, &lighting, 0, &whole), null);
    assert_int_equal(qv_illuminate(lit, room, NULL, &attenuation, &lighting, 0, &whole), null);
    assert_int_equal(qv_illuminate(lit, room, v, NULL, &lighting, 0, &whole), null);
    assert_int_equal(qv_illuminate(lit, room, v, &attenuation, NULL, 0, &whole), null);
    assert_int_equal(qv_illuminate(lit, room, v, &attenuation, &lighting, 0, NULL), null);
    attenuation.records = NULL;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_NULL);
}

static void bad_blocks_are_refused(void **state)
{
    uint32_t seed = 8;
    (void)state;
    three_lamps(QV_STORAGE_RGBA16, &seed);
    for (unsigned axis = 0; axis < 3; axis++) {
        qv_block block = whole;
        block.end[axis]++;
        refuse(0, &block, LIT_BYTES, QV_ERROR_SIZE);
        block.end[axis] = block.first[axis] = 3;
        refuse(0, &block, LIT_BYTES, QV_ERROR_SIZE);
    }
    refuse(0, &whole, LIT_BYTES - 1, QV_ERROR_BUFFER);
    s.volume.voxels_bytes--;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_STRIDE);
}

static void bad_lamps_are_refused(void **state)
{
    static const qv_lamp diagonal = {{1, 1, 1}, {1, 1, 1}}, between = {{3, 2, 1}, {1, 1, 1}};
    uint32_t seed = 9;
    (void)state;
    three_lamps(QV_STORAGE_RGBA8, &seed);
    lighting.count = QV_LAMPS_MAX + 1;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_LIGHT);
    lighting.count = 2;
    memset(lighting.lamps[1].direction, 0, sizeof lighting.lamps[1].direction);
    refuse(0, &whole, LIT_BYTES, QV_ERROR_LIGHT);
    lighting.count = 1;
    lighting.lamps[0] = diagonal;
    attenuation.directions = QV_DIRECTIONS_FACES;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_DIRECTION);
    lighting.lamps[0] = between;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_DIRECTION);
    assert_int_equal(light(untouched, QV_NEAREST), QV_OK);
    refuse(QV_BETWEEN_DEPTHS + 1, &whole, LIT_BYTES, QV_ERROR_DIRECTION);
}

static void bad_attenuation_is_refused(void **state)
{
    uint32_t seed = 10;
    (void)state;
    three_lamps(QV_STORAGE_RGBA8, &seed);
    attenuation.bytes--;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_ATTENUATION);
    attenuation.bytes++;
    attenuation.record = QV_DIRECTIONS - 1;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_ATTENUATION);
    attenuation.record = 0;
    attenuation.directions |= (uint32_t)1 << QV_DIRECTIONS;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_DIRECTION);
    attenuation.directions = QV_DIRECTIONS_ALL;
    attenuation.size[1]--;
    refuse(0, &whole, LIT_BYTES, QV_ERROR_SIZE);
}

/* Whether a block at this place of its own sources is refused. */
static void expect_overlap(const void *place, size_t room, const qv_block *block, int refused)
{
    void *to;
    memcpy(&to, &place, sizeof to); /* what is read elsewhere is constant */
    assert_int_equal(qv_illuminate(to, room, &s.volume, &attenuation, &lighting, 0, block),
                     refused ? QV_ERROR_OVERLAP : QV_OK);
}

static void overlaps_are_refused(void **state)
{
    static const qv_block part = {{0, 0, 0}, {7, 6, 4}}, voxel = {{1, 1, 1}, {2, 2, 2}};
    uint32_t seed = 11;
    (void)state;
    three_lamps(QV_STORAGE_RGBA8, &seed);
    const unsigned char *voxels = (const unsigned char *)s.voxels;
    expect_overlap(voxels + 4, 4 * VOXELS, &whole, 1);
    expect_overlap(voxels, 4 * VOXELS, &part, 1);
    expect_overlap(voxels + 4 * VOXELS, 4, &voxel, 0);
    expect_overlap(voxels + 4 * VOXELS - 1, 4, &voxel, 1);
    expect_overlap(bytes[VOXELS - 1], 4, &voxel, 1);
    source_turn(&s, 2);
    expect_overlap(voxels, 4 * VOXELS, &whole, 1);
    three_lamps(QV_STORAGE_INDEXED8, &seed);
    expect_overlap(s.palette, 4, &voxel, 1);
    expect_overlap(voxels, 4, &voxel, 1);
    expect_overlap(voxels + VOXELS, 4, &voxel, 0);
    lighting.count = 0; /* the bytes are not read */
    expect_overlap(bytes[VOXELS - 1], 4, &voxel, 0);
}

/* Which stride an axis of one voxel has does not matter; but one byte is not 4. */
static void overlaps_of_few_voxels(void **state)
{
    static const qv_block row = {{0, 0, 0}, {7, 1, 1}}, one = {{0, 0, 0}, {1, 1, 1}};
    uint32_t seed = 12;
    (void)state;
    three_lamps(QV_STORAGE_RGBA8, &seed);
    lighting.count = 0;
    s.volume.size[1] = s.volume.size[2] = 1;
    s.volume.stride[1] = 3;
    expect_overlap(s.voxels, sizeof s.voxels, &row, 0);
    s.volume.stride[0] = 8;
    expect_overlap(s.voxels, sizeof s.voxels, &row, 1);
    three_lamps(QV_STORAGE_INDEXED8, &seed);
    lighting.count = 0;
    s.volume.size[0] = s.volume.size[1] = s.volume.size[2] = 1;
    expect_overlap(s.voxels, sizeof s.voxels, &one, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lit_as_in_real_arithmetic),
        cmocka_unit_test(records_in_any_order),
        cmocka_unit_test(voxels_in_any_order),
        cmocka_unit_test(blocks_equal_the_whole),
        cmocka_unit_test(voxels_are_lit_where_they_are),
        cmocka_unit_test(light_of_nothing),
        cmocka_unit_test(ambient_light),
        cmocka_unit_test(a_voxel_throws_a_shadow),
        cmocka_unit_test(null_pointers_are_refused),
        cmocka_unit_test(bad_blocks_are_refused),
        cmocka_unit_test(bad_lamps_are_refused),
        cmocka_unit_test(bad_attenuation_is_refused),
        cmocka_unit_test(overlaps_are_refused),
        cmocka_unit_test(overlaps_of_few_voxels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
