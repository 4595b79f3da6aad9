/*
 * Footprints of splats: the kernels' tables, and the weights of pixels against integrals in
 * doubles.
 */
#include "check.h"
#include "kernel.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>

#define MOST_PIXELS 1024

static double worst;

/* The integral of a kernel from minus infinity to t voxels from its middle. */
static double integral(const qv_kernel *kernel, double t)
{
    const double size = fabs(t);
    double half;
    if (2 * size >= kernel->halves)
        half = .5;
    else if (kernel == &qv_kernel_linear)
        half = size - size * size / 2;
    else if (size <= .5)
        half = .75 * size - size * size * size / 3;
    else
        half = .5 - pow(1.5 - size, 3) / 6;
    return t < 0 ? .5 - half : .5 + half;
}

static void tables(void **state)
{
    static const qv_kernel *const kernels[] = {&qv_kernel_linear, &qv_kernel_quadratic};
    (void)state;
    for (unsigned k = 0; k < 2; k++)
        for (unsigned i = 0; i <= QV_KERNEL_PARTS; i++) {
            const double t = kernels[k]->halves / 2. * i / QV_KERNEL_PARTS;
            const double exact = floor((integral(kernels[k], t) - .5) * 65536 + .5);
            assert_true(fx_table16(kernels[k]->integral + i) == exact);
        }
}

/* Weights over the whole of a footprint: each near the mean of the kernel over the pixel, and all
   of them the voxel's size. */
static void check_footprint(const qv_kernel *kernel, int64_t centre, uint32_t size)
{
    static uint16_t weights[MOST_PIXELS];
    qv_footprint footprint;
    int32_t first, end;
    uint32_t sum = 0;
    const double voxel = size / 65536., middle = (double)centre / 65536.;
    qv_footprint_of(&footprint, kernel, centre, size);
    qv_footprint_range(&first, &end, &footprint, -30000, 30000);
    assert_true(end > first && end - first <= MOST_PIXELS);
    qv_footprint_weights(weights, &footprint, first, (unsigned)(end - first));
    for (int32_t pixel = first; pixel < end; pixel++) {
        const double left = (pixel - .5 - middle) / voxel, right = (pixel + .5 - middle) / voxel;
        const double exact = voxel * (integral(kernel, right) - integral(kernel, left));
        const double weight = weights[pixel - first] / 32768.;
        worst = fmax(worst, fabs(weight - exact));
        assert_true(fabs(weight - exact) <= (voxel <= 1 ? ldexp(1, -12) : ldexp(1, -9)));
        assert_true(weights[pixel - first] <= 32769);
        assert_int_equal(qv_footprint_weight(&footprint, pixel), weights[pixel - first]);
        sum += weights[pixel - first];
    }
    assert_true(abs((int)sum - (int)(size / 2)) <= 2);
    assert_int_equal(qv_footprint_weight(&footprint, first - 1), 0);
    assert_int_equal(qv_footprint_weight(&footprint, end), 0);
}

static void weights_of_footprints(void **state)
{
    uint32_t random = 41;
    (void)state;
    for (unsigned i = 0; i < 20000; i++) {
        const double scale = exp2((double)random_below(&random, 1400) / 100 - 6);
        const int64_t centre = (int64_t)random_below(&random, 1u << 26) - (1 << 25);
        check_footprint(i % 2 == 0 ? &qv_kernel_linear : &qv_kernel_quadratic, centre,
                        (uint32_t)(scale * 65536));
    }
    check_footprint(&qv_kernel_linear, 0, QV_LEAST_WIDTH);
    check_footprint(&qv_kernel_quadratic, 32768, QV_LEAST_WIDTH);
}

/* Between two centres of voxels, the linear kernel gives each a half; on a centre, three quarters
   and an eighth: means over a pixel as wide as a voxel. */
static void known_weights(void **state)
{
    qv_footprint footprint;
    (void)state;
    qv_footprint_of(&footprint, &qv_kernel_linear, 32768, 65536);
    assert_int_equal(qv_footprint_weight(&footprint, 0), 16384);
    assert_int_equal(qv_footprint_weight(&footprint, 1), 16384);
    qv_footprint_of(&footprint, &qv_kernel_linear, 65536, 65536);
    assert_int_equal(qv_footprint_weight(&footprint, 0), 4096);
    assert_int_equal(qv_footprint_weight(&footprint, 1), 24576);
    assert_int_equal(qv_footprint_weight(&footprint, 2), 4096);
}

static void largest_footprints_are_cut(void **state)
{
    qv_footprint footprint;
    int32_t first, end;
    uint32_t sum = 0;
    (void)state;
    qv_footprint_of(&footprint, &qv_kernel_quadratic, (int64_t)100 << 16, QV_MOST_WIDTH);
    qv_footprint_range(&first, &end, &footprint, -7000, 9000);
    assert_true(first >= 100 - 6145 && end <= 100 + 6146);
    for (int32_t pixel = first; pixel < end; pixel++)
        sum += qv_footprint_weight(&footprint, pixel);
    assert_true(abs((int)(sum / 32768) - 4096) <= 1);
    qv_footprint_range(&first, &end, &footprint, 20, 30);
    assert_true(first == 20 && end == 30);
    qv_footprint_range(&first, &end, &footprint, 8000, 8100);
    assert_true(first == end);
    qv_footprint_of(&footprint, &qv_kernel_linear, (int64_t)1 << 42, 65536);
    qv_footprint_range(&first, &end, &footprint, 0, 100);
    assert_true(first == end);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables),
        cmocka_unit_test(weights_of_footprints),
        cmocka_unit_test(known_weights),
        cmocka_unit_test(largest_footprints_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
