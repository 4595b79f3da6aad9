/*
 * Orders of voxels: every index of every small box, both ways, against curves that are made
 * otherwise; large boxes by samples; and what the curves are for.
 */
#include "check.h"
#include "order.h"
#include "random.h"

#include <stdio.h>
#include <string.h>

enum { SMALL = 9 };

static const qv_order *const orders[] = {&qv_order_linear, &qv_order_morton, &qv_order_hilbert};
enum { LINEAR, MORTON, HILBERT, ORDERS };

/* ---- The curves of a cube of 2^bits voxels, made otherwise ---------------------- */

/* Bits of the coordinates by turns. */
static void morton_of_cube(uint16_t position[3], unsigned bits, uint64_t index)
{
    memset(position, 0, 3 * sizeof position[0]);
    for (unsigned bit = 0; bit < 3 * bits; bit++)
        position[bit % 3] |= (uint16_t)((index >> bit & 1) << bit / 3);
}

static unsigned gray(unsigned v)
{
    return v ^ v >> 1;
}

static unsigned trailing_ones(unsigned v)
{
    unsigned ones = 0;
    for (; v & 1; v >>= 1)
        ones++;
    return ones;
}

static unsigned rotated(unsigned v, unsigned by)
{
    return (v << by | v >> (3 - by)) & 7;
}

/*
 * Hamilton, Compact Hilbert Indices (2006), by his formulas instead of a table: octant w of a cube
 * that is entered at e and left along axis d lies at gray(w), turned and mirrored, and is entered
 * at gray(2 floor((w - 1) / 2)).
 */
static void hilbert_of_cube(uint16_t position[3], unsigned bits, uint64_t index)
{
    unsigned e = 0, d = 2;
    memset(position, 0, 3 * sizeof position[0]);
    for (unsigned bit = bits; bit-- > 0;) {
        const unsigned w = (unsigned)(index >> 3 * bit & 7), by = (d + 1) % 3;
        const unsigned octant = rotated(gray(w), by) ^ e;
        for (unsigned axis = 0; axis < 3; axis++)
            position[axis] |= (uint16_t)((octant >> axis & 1) << bit);
        e ^= rotated(w == 0 ? 0 : gray((w - 1) & ~1u), by);
        d = (d + 1 + (w == 0 ? 0 : trailing_ones(w % 2 ? w : w - 1))) % 3;
    }
}

typedef void of_cube(uint16_t position[3], unsigned bits, uint64_t index);

static unsigned bits_of(const uint16_t size[3])
{
    unsigned bits = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        while (size[axis] > 1u << bits)
            bits++;
    return bits;
}

/* ---- Small boxes: all of them ---------------------------------------------------- */

static int same(const uint16_t a[3], const uint16_t b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Voxel `position` has this index, and the other way round. */
static void expect_pair(const qv_order *order, const uint16_t size[3], const uint16_t position[3],
                        uint64_t index)
{
    uint16_t found[3];
    uint64_t number;
    assert_int_equal(qv_order_index(&number, order, size, position), QV_OK);
    assert_true(number == index);
    assert_int_equal(qv_order_position(found, order, size, index), QV_OK);
    assert_true(same(found, position));
}

/* The box's voxels in the order of the cube's. */
static void expect_curve(const qv_order *order, of_cube *curve, const uint16_t size[3])
{
    const unsigned bits = bits_of(size);
    uint64_t index = 0;
    for (uint64_t i = 0; i < (uint64_t)1 << 3 * bits; i++) {
        uint16_t position[3];
        curve(position, bits, i);
        if (qv_box_holds(size, position))
            expect_pair(order, size, position, index++);
    }
    assert_true(index == (uint64_t)size[0] * size[1] * size[2]);
}

static void for_small_boxes(void (*expect)(const uint16_t size[3]))
{
    uint16_t size[3];
    for (size[0] = 1; size[0] <= SMALL; size[0]++)
        for (size[1] = 1; size[1] <= SMALL; size[1]++)
            for (size[2] = 1; size[2] <= SMALL; size[2]++)
                expect(size);
}

static void expect_linear(const uint16_t size[3])
{
    uint16_t at[3];
    uint64_t index = 0;
    for (at[2] = 0; at[2] < size[2]; at[2]++)
        for (at[1] = 0; at[1] < size[1]; at[1]++)
            for (at[0] = 0; at[0] < size[0]; at[0]++)
                expect_pair(&qv_order_linear, size, at, index++);
}

static void expect_morton(const uint16_t size[3])
{
    expect_curve(&qv_order_morton, morton_of_cube, size);
}

static void expect_hilbert(const uint16_t size[3])
{
    expect_curve(&qv_order_hilbert, hilbert_of_cube, size);
}

static void linear_in_small_boxes(void **state)
{
    (void)state;
    for_small_boxes(expect_linear);
}

static void morton_in_small_boxes(void **state)
{
    (void)state;
    for_small_boxes(expect_morton);
}

static void hilbert_in_small_boxes(void **state)
{
    (void)state;
    for_small_boxes(expect_hilbert);
}

/* ---- Large boxes: samples --------------------------------------------------------- */

static const uint16_t large[][3] = {
    {4096, 4096, 4096}, {4095, 4096, 4093}, {4096, 1, 1},    {1, 1, 4096},    {3, 4096, 1},
    {2049, 17, 4096},   {256, 256, 124},    {1, 2047, 2048}, {1025, 1, 1023}, {2731, 1365, 5},
    {4096, 4095, 2049}, {65, 4096, 4096},   {4096, 2, 4096}};
enum { LARGE = sizeof large / sizeof large[0], SAMPLES = 2000 };

static void sample_position(uint16_t position[3], const uint16_t size[3], uint32_t *seed)
{
    for (unsigned axis = 0; axis < 3; axis++)
        position[axis] = (uint16_t)(random_below(seed, size[axis]));
}

static uint64_t random_wide(uint32_t *seed)
{
    const uint64_t high = random_next(seed);
    return high << 32 | random_next(seed);
}

/* One and the same curve both ways: random voxels, random indices and both ends. */
static void there_and_back_in_large_boxes(void **state)
{
    uint64_t index;
    uint32_t seed = 1;
    uint16_t position[3];
    (void)state;
    for (unsigned box = 0; box < LARGE; box++)
        for (unsigned o = 0; o < ORDERS; o++) {
            const uint16_t *size = large[box];
            const uint64_t voxels = (uint64_t)size[0] * size[1] * size[2];
            for (unsigned i = 0; i < SAMPLES; i++) {
                sample_position(position, size, &seed);
                assert_int_equal(qv_order_index(&index, orders[o], size, position), QV_OK);
                assert_true(index < voxels);
                expect_pair(orders[o], size, position, index);
                index = i == 0 ? 0 : i == 1 ? voxels - 1 : random_wide(&seed) % voxels;
                assert_int_equal(qv_order_position(position, orders[o], size, index), QV_OK);
                assert_true(qv_box_holds(size, position));
                expect_pair(orders[o], size, position, index);
            }
        }
}

static void curves_of_the_largest_cube(void **state)
{
    uint32_t seed = 2;
    (void)state;
    for (unsigned i = 0; i < SAMPLES; i++) {
        const uint64_t index = random_wide(&seed) >> 28;
        uint16_t position[3];
        morton_of_cube(position, 12, index);
        expect_pair(&qv_order_morton, large[0], position, index);
        hilbert_of_cube(position, 12, index);
        expect_pair(&qv_order_hilbert, large[0], position, index);
    }
}

/* What lies outside of a box takes no index, and changes no order: any two voxels follow each
   other as they do in the cube. */
static void boxes_keep_the_order_of_the_cube(void **state)
{
    uint32_t seed = 3;
    (void)state;
    for (unsigned box = 0; box < LARGE; box++)
        for (unsigned o = MORTON; o < ORDERS; o++)
            for (unsigned i = 0; i < SAMPLES; i++) {
                const unsigned bits = bits_of(large[box]);
                const uint16_t edge = (uint16_t)(1u << bits), cube[3] = {edge, edge, edge};
                uint16_t p[3], q[3];
                uint64_t box_p, box_q, cube_p, cube_q;
                sample_position(p, large[box], &seed);
                sample_position(q, large[box], &seed);
                assert_int_equal(qv_order_index(&box_p, orders[o], large[box], p), QV_OK);
                assert_int_equal(qv_order_index(&box_q, orders[o], large[box], q), QV_OK);
                assert_int_equal(qv_order_index(&cube_p, orders[o], cube, p), QV_OK);
                assert_int_equal(qv_order_index(&cube_q, orders[o], cube, q), QV_OK);
                assert_int_equal(box_p < box_q, cube_p < cube_q);
                assert_true(box_p <= cube_p);
            }
}

/* ---- What the curves are for -------------------------------------------------------- */

static unsigned distance(const uint16_t a[3], const uint16_t b[3])
{
    unsigned sum = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        sum += a[axis] > b[axis] ? (unsigned)(a[axis] - b[axis]) : (unsigned)(b[axis] - a[axis]);
    return sum;
}

/* From corner to corner along z, from face to face. */
static void hilbert_neighbours_share_a_face(void **state)
{
    (void)state;
    for (uint16_t edge = 1; edge <= 32; edge = (uint16_t)(2 * edge)) {
        const uint16_t size[3] = {edge, edge, edge};
        const uint16_t begin[3] = {0, 0, 0}, end[3] = {0, 0, (uint16_t)(edge - 1)};
        uint16_t before[3], at[3];
        assert_int_equal(qv_order_position(before, &qv_order_hilbert, size, 0), QV_OK);
        assert_true(same(before, begin));
        for (uint64_t index = 1; index < qv_box_voxels(size); index++) {
            assert_int_equal(qv_order_position(at, &qv_order_hilbert, size, index), QV_OK);
            assert_int_equal(distance(at, before), 1);
            memcpy(before, at, sizeof at);
        }
        assert_true(same(before, end));
    }
}

/* Each cube of 2^k voxels that lies in the box and begins at a multiple of 2^k is a run. */
static void curves_fill_cube_after_cube(void **state)
{
    static const uint16_t size[3] = {50, 37, 64};
    (void)state;
    for (unsigned o = MORTON; o < ORDERS; o++)
        for (uint16_t edge = 2; edge <= 32; edge = (uint16_t)(2 * edge)) {
            uint64_t least = UINT64_MAX, greatest = 0, index;
            uint16_t at[3];
            for (at[2] = edge; at[2] < 2 * edge; at[2]++)
                for (at[1] = 0; at[1] < edge; at[1]++)
                    for (at[0] = 0; at[0] < edge; at[0]++) {
                        assert_int_equal(qv_order_index(&index, orders[o], size, at), QV_OK);
                        least = index < least ? index : least;
                        greatest = index > greatest ? index : greatest;
                    }
            assert_int_equal(greatest - least + 1, edge * edge * edge);
        }
}

enum { PAGE = 512, PAGES = 100 * 60 * 37 / PAGE + 1 };

/* Pages of PAGE voxels that a cube of 8^3 reads, its first voxel at `first`. */
static unsigned pages_read(const qv_order *order, const uint16_t size[3], const uint16_t first[3])
{
    uint8_t read[PAGES];
    uint16_t at[3];
    unsigned count = 0;
    memset(read, 0, sizeof read);
    for (at[2] = first[2]; at[2] < first[2] + 8; at[2]++)
        for (at[1] = first[1]; at[1] < first[1] + 8; at[1]++)
            for (at[0] = first[0]; at[0] < first[0] + 8; at[0]++) {
                uint64_t index;
                assert_int_equal(qv_order_index(&index, order, size, at), QV_OK);
                count += !read[index / PAGE];
                read[index / PAGE] = 1;
            }
    return count;
}

/* A file that is read by pages is read less where its order keeps neighbours together. */
static void hilbert_reads_the_fewest_pages(void **state)
{
    static const uint16_t size[3] = {100, 60, 37}, places[3] = {93, 53, 30};
    unsigned read[ORDERS] = {0, 0, 0};
    uint32_t seed = 4;
    (void)state;
    for (unsigned i = 0; i < 500; i++) {
        uint16_t first[3];
        sample_position(first, places, &seed);
        for (unsigned o = 0; o < ORDERS; o++)
            read[o] += pages_read(orders[o], size, first);
    }
    printf("# 500 cubes of 8^3 voxels read pages of 512: linear %u, Morton %u, Hilbert %u\n",
           read[LINEAR], read[MORTON], read[HILBERT]);
    assert_true(read[HILBERT] < read[MORTON]);
    assert_true(2 * read[MORTON] < read[LINEAR]);
}

/* ---- Refusals -------------------------------------------------------------------------- */

static void refuse_index(const uint16_t size[3], const uint16_t position[3], qv_status status)
{
    for (unsigned o = 0; o < ORDERS; o++) {
        uint64_t index = 77;
        assert_int_equal(qv_order_index(&index, orders[o], size, position), status);
        assert_int_equal(index, 77);
    }
}

static void refuse_position(const uint16_t size[3], uint64_t index, qv_status status)
{
    for (unsigned o = 0; o < ORDERS; o++) {
        uint16_t position[3] = {7, 8, 9};
        assert_int_equal(qv_order_position(position, orders[o], size, index), status);
        assert_true(position[0] == 7 && position[1] == 8 && position[2] == 9);
    }
}

static void what_is_refused(void **state)
{
    static const uint16_t size[3] = {5, 4, 3}, most[3] = {4096, 4096, 4096}, none[3] = {0, 0, 0};
    uint16_t position[3] = {0, 0, 0};
    uint64_t index;
    (void)state;
    assert_int_equal(qv_order_index(NULL, &qv_order_linear, size, none), QV_ERROR_NULL);
    assert_int_equal(qv_order_index(&index, NULL, size, none), QV_ERROR_NULL);
    assert_int_equal(qv_order_position(NULL, &qv_order_linear, size, 0), QV_ERROR_NULL);
    assert_int_equal(qv_order_position(position, NULL, size, 0), QV_ERROR_NULL);
    refuse_index(NULL, none, QV_ERROR_NULL);
    refuse_index(size, NULL, QV_ERROR_NULL);
    refuse_position(NULL, 0, QV_ERROR_NULL);
    for (unsigned axis = 0; axis < 3; axis++) {
        uint16_t wrong[3] = {5, 4, 3}, outside[3] = {4, 3, 2};
        wrong[axis] = 0;
        refuse_index(wrong, none, QV_ERROR_SIZE);
        refuse_position(wrong, 0, QV_ERROR_SIZE);
        wrong[axis] = QV_AXIS_MAX + 1;
        refuse_index(wrong, none, QV_ERROR_SIZE);
        refuse_position(wrong, 0, QV_ERROR_SIZE);
        outside[axis]++;
        refuse_index(size, outside, QV_ERROR_SIZE);
    }
    refuse_position(size, 60, QV_ERROR_SIZE);
    refuse_position(most, (uint64_t)1 << 36, QV_ERROR_SIZE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_in_small_boxes),
        cmocka_unit_test(morton_in_small_boxes),
        cmocka_unit_test(hilbert_in_small_boxes),
        cmocka_unit_test(there_and_back_in_large_boxes),
        cmocka_unit_test(curves_of_the_largest_cube),
        cmocka_unit_test(boxes_keep_the_order_of_the_cube),
        cmocka_unit_test(hilbert_neighbours_share_a_face),
        cmocka_unit_test(curves_fill_cube_after_cube),
        cmocka_unit_test(hilbert_reads_the_fewest_pages),
        cmocka_unit_test(what_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
