/*
 * The worked examples S120 .. S122 of tests/SPEC.md: bricks and pages. The same inputs and results as
 * there, written out.
 */
#include "check.h"
#include "pages.h"

#include <string.h>

enum { MOST_PAGES = 320 };

static uint8_t memory[MOST_PAGES * 4096];
static qv_page table[MOST_PAGES];
static qv_brick last; /* that was read */

static int read_brick(void *user, void *page, const qv_brick *brick)
{
    (void)user;
    (void)page;
    last = *brick;
    return 0;
}

static void make(qv_pages *pages, const uint16_t size[3], const uint8_t shift[3], uint16_t count)
{
    qv_volume volume = {.storage = QV_STORAGE_RGBA16};
    *pages = (qv_pages){.read = read_brick,
                        .memory = memory,
                        .bytes = sizeof memory,
                        .table = table,
                        .count = count};
    memcpy(volume.size, size, sizeof volume.size);
    memcpy(pages->shift, shift, sizeof pages->shift);
    assert_int_equal(qv_pages_init(pages, &volume), QV_OK);
}

/* The byte of a voxel, counted from the first page. */
static uint32_t place_of(qv_pages *pages, const uint16_t voxel[3])
{
    return (uint32_t)(qv_pages_voxel(pages, voxel) - memory);
}

static void S120_bricks(void **state)
{
    static const uint16_t size[3] = {100, 50, 9};
    static const uint8_t shift[3] = {3, 2, 12};
    static const uint16_t voxels[4][3] = {{99, 49, 8}, {13, 6, 3}, {15, 7, 5}, {98, 48, 0}};
    static const uint32_t numbers[4] = {168, 14, 14, 168}, bytes[4] = {2136, 936, 1528, 16};
    static const qv_block block = {{96, 48, 0}, {100, 50, 9}};
    qv_pages pages;
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        make(&pages, size, shift, 20);
        assert_int_equal(place_of(&pages, voxels[i]) % 2304, bytes[i]);
        assert_int_equal(last.number, numbers[i]);
        assert_int_equal(last.bytes, 2304);
        assert_int_equal(last.row, 64);
        assert_int_equal(last.slice, 256);
        if (i == 0)
            assert_memory_equal(&last.block, &block, sizeof block);
    }
}

static void S121_order_of_use(void **state)
{
    static const uint16_t size[3] = {64, 64, 64};
    static const uint8_t shift[3] = {3, 3, 3};
    static const uint16_t voxels[11][3] = {{0, 0, 0},  {8, 0, 0},  {16, 0, 0}, {24, 0, 0},
                                           {32, 0, 0}, {40, 0, 0}, {48, 0, 0}, {56, 0, 0},
                                           {0, 8, 0},  {8, 0, 0},  {0, 0, 0}};
    static const uint32_t expected[11] = {7, 6, 5, 4, 3, 2, 1, 0, 7, 6, 5};
    qv_pages pages;
    (void)state;

    make(&pages, size, shift, 8);
    assert_int_equal(pages.sets, 1);
    assert_int_equal(pages.ways, 8);
    for (unsigned i = 0; i < 11; i++)
        assert_int_equal(place_of(&pages, voxels[i]) / 4096, expected[i]);
    assert_int_equal(pages.reads, 10);
}

static void S122_sets(void **state)
{
    static const uint16_t size[3] = {5, 4, 3}, large[3] = {4096, 4096, 1};
    static const uint8_t shift[3] = {0, 0, 0}, rows[3] = {4, 4, 0};
    static const uint32_t sets[6] = {0, 25, 10, 35, 20, 5};
    qv_pages pages;
    (void)state;

    make(&pages, size, shift, 60);
    assert_int_equal(pages.sets, 2);
    assert_int_equal(pages.ways, 30);
    make(&pages, large, rows, 320);
    assert_int_equal(pages.sets, 40);
    for (uint32_t i = 0; i < 6; i++) {
        const uint32_t number = 12345 * i; /* of 256 x 256 bricks */
        const uint16_t voxel[3] = {(uint16_t)(16 * (number % 256)), (uint16_t)(16 * (number / 256)),
                                   0};
        assert_int_equal(place_of(&pages, voxel) / 2048 / pages.ways, sets[i]);
        assert_int_equal(last.number, number);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S120_bricks),
        cmocka_unit_test(S121_order_of_use),
        cmocka_unit_test(S122_sets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
