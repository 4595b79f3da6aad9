#include "kernel.h"

/*
 * Integrals of the kernels from the middle on, 65536 being 1: entry i is that up to i / 64 of
 * half the width. With t in voxels, t - t^2 / 2 for the linear kernel 1 - |t|; and for the
 * quadratic B-spline 3 t / 4 - t^3 / 3 up to 1/2, and 1/2 - (3/2 - t)^3 / 6 from there, as it goes
 * on beyond the end. To nearest; tests/unit/test_footprint.c computes them again.
 */

/* clang-format off */

FX_TABLE uint16_t linear[QV_KERNEL_PARTS + 2] = {
    0, 1016, 2016, 3000, 3968, 4920, 5856, 6776, 7680, 8568, 9440, 10296,
    11136, 11960, 12768, 13560, 14336, 15096, 15840, 16568, 17280, 17976, 18656, 19320,
    19968, 20600, 21216, 21816, 22400, 22968, 23520, 24056, 24576, 25080, 25568, 26040,
    26496, 26936, 27360, 27768, 28160, 28536, 28896, 29240, 29568, 29880, 30176, 30456,
    30720, 30968, 31200, 31416, 31616, 31800, 31968, 32120, 32256, 32376, 32480, 32568,
    32640, 32696, 32736, 32760, 32768, 32760,
};

FX_TABLE uint16_t quadratic[QV_KERNEL_PARTS + 2] = {
    0, 1152, 2302, 3448, 4590, 5725, 6851, 7968, 9072, 10163, 11239, 12298,
    13338, 14358, 15356, 16331, 17280, 18202, 19096, 19959, 20790, 21587, 22349, 23076,
    23768, 24426, 25052, 25645, 26207, 26739, 27241, 27714, 28160, 28579, 28971, 29338,
    29681, 30000, 30296, 30571, 30824, 31057, 31271, 31466, 31643, 31803, 31948, 32077,
    32192, 32293, 32382, 32459, 32525, 32581, 32627, 32665, 32696, 32720, 32738, 32750,
    32759, 32764, 32767, 32768, 32768, 32768,
};

/* clang-format on */

QV_DESCRIPTOR qv_kernel qv_kernel_linear = {linear, 2};
QV_DESCRIPTOR qv_kernel qv_kernel_quadratic = {quadratic, 3};
