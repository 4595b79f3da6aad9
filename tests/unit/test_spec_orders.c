/*
 * The worked examples S97 .. S99 of tests/SPEC.md: orders of voxels. The same inputs and results as
 * there, written out.
 */
#include "check.h"
#include "qvol.h"

#include <string.h>

enum { ORDERS = 3, BOXES = 3 };

static const qv_order *const orders[ORDERS] = {&qv_order_linear, &qv_order_morton,
                                               &qv_order_hilbert};

static const uint16_t boxes[BOXES][3] = {{4096, 4096, 4096}, {256, 256, 124}, {2049, 17, 4096}};

static void S97_voxels_in_order(void **state)
{
    static const uint16_t size[3] = {3, 2, 3};
    static const char *const voxels[ORDERS] = {
        "000 100 200 010 110 210 001 101 201 011 111 211 002 102 202 012 112 212",
        "000 100 010 110 001 101 011 111 200 210 201 211 002 102 012 112 202 212",
        "000 010 011 001 101 111 110 100 200 201 211 210 212 202 112 102 002 012"};
    (void)state;
    for (unsigned o = 0; o < ORDERS; o++)
        for (unsigned i = 0; i < 18; i++) {
            uint16_t position[3];
            assert_int_equal(qv_order_position(position, orders[o], size, i), QV_OK);
            for (unsigned axis = 0; axis < 3; axis++)
                assert_int_equal(position[axis], voxels[o][4 * i + axis] - '0');
        }
}

static void S98_indices(void **state)
{
    static const uint16_t voxels[BOXES][3] = {{1000, 2000, 3000}, {100, 200, 99}, {2048, 16, 4095}};
    static const uint64_t indices[BOXES][ORDERS] = {{50339841000, 37579844096, 66221976998},
                                                    {6539364, 6009956, 8079231},
                                                    {142675967, 142675967, 71372259}};
    (void)state;
    for (unsigned box = 0; box < BOXES; box++)
        for (unsigned o = 0; o < ORDERS; o++) {
            uint64_t index;
            assert_int_equal(qv_order_index(&index, orders[o], boxes[box], voxels[box]), QV_OK);
            assert_true(index == indices[box][o]);
        }
}

static void S99_voxels(void **state)
{
    static const uint64_t indices[BOXES] = {123456789, 1000000, 7654321};
    static const uint16_t voxels[BOXES][ORDERS][3] = {
        {{3349, 1468, 7}, {289, 490, 381}, {188, 157, 256}},
        {{64, 66, 15}, {76, 96, 48}, {47, 40, 115}},
        {{1306, 12, 219}, {737, 14, 446}, {453, 6, 930}}};
    (void)state;
    for (unsigned box = 0; box < BOXES; box++)
        for (unsigned o = 0; o < ORDERS; o++) {
            uint16_t position[3];
            assert_int_equal(qv_order_position(position, orders[o], boxes[box], indices[box]),
                             QV_OK);
            assert_memory_equal(position, voxels[box][o], sizeof position);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S97_voxels_in_order),
        cmocka_unit_test(S98_indices),
        cmocka_unit_test(S99_voxels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
