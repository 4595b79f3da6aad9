/*
 * Classification of scalar volumes against real numbers.
 */
#include "check.h"
#include "classify_reference.h"
#include "qvol.h"
#include "random.h"

#include <math.h>
#include <string.h>

#define NX     7u
#define NY     6u
#define NZ     5u
#define VOXELS (NX * NY * NZ)

static const uint8_t TYPES[3] = {QV_SCALAR_U8, QV_SCALAR_U16, QV_SCALAR_S16};
static const qv_block WHOLE = {{0, 0, 0}, {NX, NY, NZ}};
static const qv_shading SHADING = {{-3, -5, 7}, {0, -100, 0}, 64, 192, 128, 4, 3};

static uint16_t values[2 * VOXELS];
static qv_transfer table;

/* Random values and colours, and a classifier that packs them x fastest. */
static qv_classifier random_classifier(uint8_t type, uint32_t seed)
{
    const int32_t bytes = type == QV_SCALAR_U8 ? 1 : 2;
    qv_classifier c;

    for (unsigned i = 0; i < 2 * VOXELS; i++)
        values[i] = (uint16_t)random_next(&seed);
    for (unsigned i = 0; i < 4 * QV_PALETTE_ENTRIES; i++)
        table.rgba[i / 4][i % 4] = (uint16_t)random_next(&seed);
    memset(&c, 0, sizeof c);
    c.scalars.values = (qv_address)values;
    c.scalars.values_bytes = VOXELS * (unsigned)bytes;
    c.scalars.type = type;
    c.scalars.size[0] = NX;
    c.scalars.size[1] = NY;
    c.scalars.size[2] = NZ;
    c.scalars.stride[0] = bytes;
    c.scalars.stride[1] = bytes * (int32_t)NX;
    c.scalars.stride[2] = bytes * (int32_t)(NX * NY);
    c.low = type == QV_SCALAR_S16 ? -30000 : 10;
    c.high = type == QV_SCALAR_U8 ? 200 : 32000;
    c.transfer = &table;
    return c;
}

/* ---- The table index ---- */

/* Every value of a type through a window, as 256 rows of 256 or one of 256. */
static void expect_indices(uint8_t type, int32_t low, int32_t high)
{
    static uint16_t all[65536];
    static uint8_t small[256], index[65536];
    const uint16_t rows = type == QV_SCALAR_U8 ? 1 : 256;
    const qv_block block = {{0, 0, 0}, {256, rows, 1}};
    qv_classifier c = random_classifier(type, 1);

    for (unsigned i = 0; i < 65536; i++)
        all[i] = (uint16_t)i;
    for (unsigned i = 0; i < 256; i++)
        small[i] = (uint8_t)i;
    c.scalars.values = type == QV_SCALAR_U8 ? (qv_address)small : (qv_address)all;
    c.scalars.size[0] = 256;
    c.scalars.size[1] = rows;
    c.scalars.size[2] = 1;
    c.scalars.stride[1] = 256 * c.scalars.stride[0];
    c.scalars.values_bytes = type == QV_SCALAR_U8 ? sizeof small : sizeof all;
    c.low = low;
    c.high = high;
    c.transfer = NULL;
    assert_int_equal(qv_classify(index, sizeof index, QV_STORAGE_INDEXED8, &c, &block), QV_OK);
    for (int i = 0; i < rows * 256; i++) {
        int expected = ref_table_index(ref_scalar(&c.scalars, i % 256, i / 256, 0), &c);
        if (index[i] != expected)
            fail_msg("%d in %d .. %d: %d, not %d", i, low, high, index[i], expected);
    }
}

static void every_value_through_many_windows(void **state)
{
    static const int32_t edges[][2] = {
        {-65536, 131071}, {-65536, -65535}, {131070, 131071}, {0, 65535},      {0, 1},
        {65534, 65535},   {-32768, 32767},  {0, 255},         {0, 510},        {0, 254},
        {-1, 0},          {1000, 1100},     {-65536, 0},      {65535, 131071}, {-32769, 32768}};
    uint32_t seed = 5;
    (void)state;

    for (unsigned t = 0; t < 3; t++) {
        for (unsigned i = 0; i < sizeof edges / sizeof edges[0]; i++)
            expect_indices(TYPES[t], edges[i][0], edges[i][1]);
        for (unsigned i = 0; i < 30; i++) {
            int32_t low = (int32_t)random_below(&seed, 131072) - 65536;
            int32_t high = low + 1 + (int32_t)random_below(&seed, (uint32_t)(131071 - low));
            expect_indices(TYPES[t], low, high);
        }
    }
}

/* Index 1 begins at 1/2: 1 of a window of 510 is 1/2 exactly. */
static void index_ties_go_upwards(void **state)
{
    qv_classifier c = random_classifier(QV_SCALAR_U8, 1);
    const uint8_t scalars[4] = {0, 1, 2, 3}, expected[4] = {0, 1, 1, 2};
    const qv_block block = {{0, 0, 0}, {4, 1, 1}};
    uint8_t index[4];
    (void)state;

    c.scalars.values = scalars;
    c.scalars.values_bytes = 4;
    c.scalars.size[0] = 4;
    c.scalars.size[1] = c.scalars.size[2] = 1;
    c.low = 0;
    c.high = 510;
    assert_int_equal(qv_classify(index, 4, QV_STORAGE_INDEXED8_16, &c, &block), QV_OK);
    assert_memory_equal(index, expected, 4);
}

/* ---- Colours ---- */

/* Classifies the whole volume and returns the greatest distance, in levels of
   the storage, from the real colours. */
static double colour_error(const qv_classifier *c, uint8_t storage)
{
    static uint16_t voxels[VOXELS][4];
    const uint8_t *bytes = (const uint8_t *)voxels;
    const int wide = storage == QV_STORAGE_RGBA16;
    double expected[4], worst = 0;

    assert_int_equal(qv_classify(voxels, wide ? VOXELS * 8 : VOXELS * 4, storage, c, &WHOLE),
                     QV_OK);
    for (unsigned i = 0; i < VOXELS; i++) {
        ref_classify(expected, c, (int)(i % NX), (int)(i / NX % NY), (int)(i / (NX * NY)));
        for (unsigned channel = 0; channel < 4; channel++) {
            double actual = wide ? voxels[i][channel] : bytes[4 * i + channel];
            worst = fmax(worst, fabs(actual - expected[channel] / (wide ? 1 : 257)));
        }
    }
    return worst;
}

static void colours_are_those_of_the_table(void **state)
{
    (void)state;

    for (uint32_t seed = 1; seed <= 30; seed++) {
        qv_classifier c = random_classifier(TYPES[seed % 3], seed);
        assert_true(colour_error(&c, QV_STORAGE_RGBA16) == 0);
        assert_true(colour_error(&c, QV_STORAGE_RGBA8) <= 0.5);
    }
}

/* Random shading and spacing; double differences of 16 bits among the values. */
static void shaded_colours(void **state)
{
    (void)state;

    for (uint32_t seed = 1; seed <= 300; seed++) {
        qv_classifier c = random_classifier(TYPES[seed % 3], seed);
        qv_shading shading = SHADING;
        uint32_t more = seed;

        c.shading = &shading;
        for (unsigned a = 0; a < 3; a++) {
            shading.light[a] = (int16_t)(1 + random_below(&more, 30000));
            shading.viewer[a] = (int16_t)(random_below(&more, 30000) - 300);
            c.scalars.spacing[a] = 4096u + random_below(&more, 1u << (10 + seed % 10));
            c.scalars.spacing[a] *= seed % 4 != 0;
        }
        shading.gloss = (uint8_t)(seed % 8);
        shading.least_gradient = (uint16_t)(seed % 2 * random_below(&more, 2000));
        assert_true(colour_error(&c, QV_STORAGE_RGBA16) < 0.75);
        assert_true(colour_error(&c, QV_STORAGE_RGBA8) < 0.51);
    }
}

/* A ramp along each axis and direction: its lit side has the table's colour
   times 1, its other side is black. */
static void normals_point_against_the_gradient(void **state)
{
    static uint16_t rgba[VOXELS][4];
    qv_shading shading = {{0, 0, 0}, {0, 0, 0}, 0, 256, 0, 0, 0};
    (void)state;

    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2) {
            qv_classifier c = random_classifier(QV_SCALAR_S16, 3);
            for (unsigned i = 0; i < VOXELS; i++) {
                const unsigned at[3] = {i % NX, i / NX % NY, i / (NX * NY)};
                values[i] = (uint16_t)(sign * (int)at[axis] * 1000);
            }
            memset(&table, 0xFF, sizeof table);
            memset(shading.light, 0, sizeof shading.light);
            shading.light[axis] = -1;
            c.shading = &shading;
            assert_int_equal(qv_classify(rgba, sizeof rgba, QV_STORAGE_RGBA16, &c, &WHOLE), QV_OK);
            for (unsigned i = 0; i < VOXELS; i++)
                assert_int_equal(rgba[i][0], sign > 0 ? 65535 : 0);
        }
}

/* ---- Blocks and strides ---- */

/* Every block of a volume has the bytes of the whole. */
static void expect_blocks_equal(const qv_classifier *c, uint8_t storage, unsigned voxel_bytes,
                                uint32_t seed)
{
    static uint8_t whole[VOXELS * 8], part[VOXELS * 8 + 1];

    assert_int_equal(qv_classify(whole, sizeof whole, storage, c, &WHOLE), QV_OK);
    for (unsigned round = 0; round < 100; round++) {
        qv_block b;
        size_t bytes = voxel_bytes;
        for (unsigned a = 0; a < 3; a++) {
            b.first[a] = (uint16_t)random_below(&seed, WHOLE.end[a]);
            b.end[a] = (uint16_t)(b.first[a] + 1u +
                                  random_below(&seed, WHOLE.end[a] - (uint32_t)b.first[a]));
            bytes *= (size_t)b.end[a] - b.first[a];
        }
        part[bytes] = 0x77;
        assert_int_equal(qv_classify(part, bytes, storage, c, &b), QV_OK);
        assert_int_equal(part[bytes], 0x77);
        const uint8_t *row = part;
        for (unsigned z = b.first[2]; z < b.end[2]; z++)
            for (unsigned y = b.first[1]; y < b.end[1]; y++) {
                size_t row_bytes = (size_t)(b.end[0] - b.first[0]) * voxel_bytes;
                size_t offset = ((z * NY + y) * NX + b.first[0]) * voxel_bytes;
                assert_memory_equal(row, &whole[offset], row_bytes);
                row += row_bytes;
            }
    }
}

static void blocks_equal_the_whole(void **state)
{
    (void)state;

    for (uint32_t seed = 1; seed <= 6; seed++) {
        qv_classifier c = random_classifier(TYPES[seed % 3], seed);
        c.shading = seed % 2 != 0 ? &SHADING : NULL;
        expect_blocks_equal(&c, QV_STORAGE_RGBA8, 4, seed);
        expect_blocks_equal(&c, QV_STORAGE_RGBA16, 8, seed);
        expect_blocks_equal(&c, QV_STORAGE_INDEXED8, 1, seed);
    }
}

/* Every order of axes, every combination of signs, with gaps. */
static void strides_of_any_order_and_sign(void **state)
{
    static const unsigned orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                          {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    (void)state;

    for (unsigned i = 0; i < 48; i++) {
        qv_classifier c = random_classifier(QV_SCALAR_S16, i + 1);
        qv_scalars *s = &c.scalars;
        int32_t stride = i % 8 == 7 ? 4 : 2;
        int32_t start = 0;

        for (unsigned j = 0; j < 3; j++) {
            unsigned axis = orders[i / 8][j];
            int negative = i >> j & 1;
            s->stride[axis] = negative ? -stride : stride;
            start += negative ? stride * (s->size[axis] - 1) : 0;
            stride *= s->size[axis];
        }
        s->values += start;
        s->values_bytes = sizeof values;
        c.shading = &SHADING;
        assert_true(colour_error(&c, QV_STORAGE_RGBA16) < 0.75);
    }
}

static void axes_of_one_voxel_have_no_stride(void **state)
{
    qv_classifier c = random_classifier(QV_SCALAR_U16, 9);
    const qv_block block = {{0, 0, 0}, {1, 1, 1}};
    const uint16_t *expected;
    uint16_t rgba[4];
    (void)state;

    for (unsigned a = 0; a < 3; a++) {
        c.scalars.size[a] = 1;
        c.scalars.stride[a] = INT32_MIN;
    }
    c.shading = &SHADING;
    assert_int_equal(qv_classify(rgba, sizeof rgba, QV_STORAGE_RGBA16, &c, &block), QV_OK);
    expected = table.rgba[ref_table_index(values[0], &c)];
    assert_memory_equal(rgba, expected, sizeof rgba);
}

/* ---- Errors ---- */

static uint8_t untouched[VOXELS * 8];

static void expect_refused(const qv_classifier *c, const qv_block *block, uint8_t storage,
                           size_t bytes, qv_status expected)
{
    static uint8_t before[VOXELS * 8];

    memset(untouched, 0x99, sizeof untouched);
    memset(before, 0x99, sizeof before);
    assert_int_equal(qv_classify(untouched, bytes, storage, c, block), expected);
    assert_memory_equal(untouched, before, sizeof before);
}

/* A classifier that is refused for a whole volume in a buffer that suffices. */
static void expect_bad(const qv_classifier *c, qv_status expected)
{
    expect_refused(c, &WHOLE, QV_STORAGE_RGBA8, sizeof untouched, expected);
}

static void bad_arguments_are_refused(void **state)
{
    const qv_classifier c = random_classifier(QV_SCALAR_U16, 1);
    const size_t bytes = sizeof untouched;
    (void)state;

    assert_int_equal(qv_classify(NULL, bytes, QV_STORAGE_RGBA8, &c, &WHOLE), QV_ERROR_NULL);
    expect_refused(NULL, &WHOLE, QV_STORAGE_RGBA8, bytes, QV_ERROR_NULL);
    expect_refused(&c, NULL, QV_STORAGE_RGBA8, bytes, QV_ERROR_NULL);
    expect_refused(&c, &WHOLE, 0, bytes, QV_ERROR_STORAGE);
    expect_refused(&c, &WHOLE, 5, bytes, QV_ERROR_STORAGE);
    expect_refused(&c, &WHOLE, QV_STORAGE_RGBA16, VOXELS * 8 - 1, QV_ERROR_BUFFER);
    expect_refused(&c, &WHOLE, QV_STORAGE_RGBA8, VOXELS * 4 - 1, QV_ERROR_BUFFER);
    expect_refused(&c, &WHOLE, QV_STORAGE_INDEXED8, VOXELS - 1, QV_ERROR_BUFFER);
    expect_refused(&c, &WHOLE, QV_STORAGE_INDEXED8_16, 0, QV_ERROR_BUFFER);
    assert_int_equal(qv_classify(untouched, VOXELS * 8, QV_STORAGE_RGBA16, &c, &WHOLE), QV_OK);
    assert_int_equal(qv_classify(untouched, VOXELS, QV_STORAGE_INDEXED8, &c, &WHOLE), QV_OK);
}

static void bad_blocks_are_refused(void **state)
{
    const qv_classifier c = random_classifier(QV_SCALAR_U16, 1);
    (void)state;

    for (unsigned a = 0; a < 3; a++) {
        qv_block empty = WHOLE, backwards = WHOLE, outside = WHOLE;
        empty.first[a] = empty.end[a];
        backwards.first[a] = 3;
        backwards.end[a] = 2;
        outside.end[a]++;
        expect_refused(&c, &empty, QV_STORAGE_RGBA8, sizeof untouched, QV_ERROR_SIZE);
        expect_refused(&c, &backwards, QV_STORAGE_RGBA8, sizeof untouched, QV_ERROR_SIZE);
        expect_refused(&c, &outside, QV_STORAGE_RGBA8, sizeof untouched, QV_ERROR_SIZE);
    }
}

static void bad_scalars_are_refused(void **state)
{
    const qv_classifier good = random_classifier(QV_SCALAR_U16, 1);
    qv_classifier bad[10];
    static const qv_status expected[10] = {
        QV_ERROR_NULL,   QV_ERROR_STORAGE, QV_ERROR_STORAGE, QV_ERROR_SIZE,    QV_ERROR_SIZE,
        QV_ERROR_STRIDE, QV_ERROR_STRIDE,  QV_ERROR_SPACING, QV_ERROR_SPACING, QV_ERROR_STRIDE};
    (void)state;

    for (unsigned i = 0; i < 10; i++)
        bad[i] = good;
    bad[0].scalars.values = NULL;
    bad[1].scalars.type = 0;
    bad[2].scalars.type = 4;
    bad[3].scalars.size[0] = 0;
    bad[4].scalars.size[2] = QV_AXIS_MAX + 1;
    bad[5].scalars.stride[1] -= 1;
    bad[6].scalars.values_bytes -= 1;
    bad[7].scalars.spacing[0] = 4095;
    bad[8].scalars.spacing[2] = (256u << 16) + 1;
    bad[9].scalars.values++; /* an odd address */
    for (unsigned i = 0; i < 10; i++)
        expect_bad(&bad[i], expected[i]);
}

static void bad_windows_are_refused(void **state)
{
    static const int32_t bad[][2] = {
        {5, 5},         {6, 5},         {-65537, 0},           {0, 131072},
        {INT32_MIN, 0}, {0, INT32_MAX}, {INT32_MAX, INT32_MIN}};
    qv_classifier c = random_classifier(QV_SCALAR_U16, 1);
    (void)state;

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        c.low = bad[i][0];
        c.high = bad[i][1];
        expect_bad(&c, QV_ERROR_WINDOW);
    }
}

/* Colours need a table and, if any, a good light; indices need neither. */
static void tables_and_lights_where_they_are_used(void **state)
{
    qv_classifier c = random_classifier(QV_SCALAR_U16, 1);
    qv_shading dark = SHADING;
    (void)state;

    memset(dark.light, 0, sizeof dark.light);
    c.shading = &dark;
    expect_bad(&c, QV_ERROR_LIGHT);
    assert_int_equal(qv_classify(untouched, VOXELS, QV_STORAGE_INDEXED8, &c, &WHOLE), QV_OK);
    c.shading = NULL;
    c.transfer = NULL;
    expect_bad(&c, QV_ERROR_NULL);
    expect_refused(&c, &WHOLE, QV_STORAGE_RGBA16, sizeof untouched, QV_ERROR_NULL);
    assert_int_equal(qv_classify(untouched, VOXELS, QV_STORAGE_INDEXED8_16, &c, &WHOLE), QV_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_value_through_many_windows),
        cmocka_unit_test(index_ties_go_upwards),
        cmocka_unit_test(colours_are_those_of_the_table),
        cmocka_unit_test(shaded_colours),
        cmocka_unit_test(normals_point_against_the_gradient),
        cmocka_unit_test(blocks_equal_the_whole),
        cmocka_unit_test(strides_of_any_order_and_sign),
        cmocka_unit_test(axes_of_one_voxel_have_no_stride),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(bad_blocks_are_refused),
        cmocka_unit_test(bad_scalars_are_refused),
        cmocka_unit_test(bad_windows_are_refused),
        cmocka_unit_test(tables_and_lights_where_they_are_used),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
