/*
 * Two bricks of one colour and opacity, combined by replay: as all slices in one buffer.
 */
#include "check.h"
#include "qvol.h"
#include "random.h"

#include <string.h>

/* ---- One pixel, slice by slice --------------------------------------------- */

static uint32_t divided(uint32_t x)
{
    return (2 * x + 255) / 510;
}

/* A slice of hardware, section 2.1: colours weighted by the opacity, rounded. */
static void blend_slices(uint8_t pixel[4], const uint8_t rgba[4], uint32_t count)
{
    while (count-- > 0)
        for (unsigned c = 0; c < 4; c++) {
            const uint32_t colour = c < 3 ? rgba[c] : 255;
            pixel[c] = (uint8_t)(divided(colour * rgba[3]) + divided((255u - rgba[3]) * pixel[c]));
        }
}

static void expect_replayed(uint8_t behind[4], uint8_t front[4], const uint8_t rgba[4],
                            const uint8_t expected[4])
{
    const qv_rect rect = {5, -3, 6, -2};
    const qv_buffer far = {behind, NULL, 4, 0, 4, 0, &qv_hardware_rgba8888};
    const qv_buffer near = {front, NULL, 4, 0, 4, 0, &qv_hardware_rgba8888};
    uint8_t before[4];
    memcpy(before, front, 4);
    assert_int_equal(qv_replay(&far, &near, rgba, &rect), QV_OK);
    assert_memory_equal(behind, expected, 4);
    assert_memory_equal(front, before, 4);
}

static void random_pixel(uint8_t pixel[4], uint32_t *seed)
{
    for (unsigned c = 0; c < 4; c++)
        pixel[c] = (uint8_t)random_next(seed);
}

/* Any opacity, colours and background; at least one slice behind. */
static void as_all_slices_in_one(void **state)
{
    uint32_t seed = 1;
    (void)state;
    for (uint32_t i = 0; i < 40000; i++) {
        uint8_t rgba[4], behind[4], front[4] = {0}, all[4];
        random_pixel(rgba, &seed);
        rgba[3] = (uint8_t)(i % 3 == 0 ? i % 16 : rgba[3]);
        random_pixel(behind, &seed);
        blend_slices(behind, rgba, 1 + random_below(&seed, 200));
        memcpy(all, behind, 4);
        const uint32_t count = random_below(&seed, 260);
        blend_slices(front, rgba, count);
        blend_slices(all, rgba, count);
        expect_replayed(behind, front, rgba, all);
    }
}

/* All numbers of slices of the fogs of the paper: in every way of sharing them. */
static void uniform_fogs(void **state)
{
    static const uint8_t opacities[] = {1, 2, 3, 5, 10};
    (void)state;
    for (unsigned i = 0; i < sizeof opacities; i++) {
        const uint8_t rgba[4] = {255, 128, 0, opacities[i]};
        for (uint32_t total = 1; total <= 200; total++) {
            uint8_t all[4] = {0};
            blend_slices(all, rgba, total);
            for (uint32_t count = 0; count <= total; count++) {
                uint8_t behind[4] = {0}, front[4] = {0};
                blend_slices(behind, rgba, total - count);
                blend_slices(front, rgba, count);
                expect_replayed(behind, front, rgba, all);
            }
        }
    }
}

/* What such slices never make is put in front: equation 8; colours up to the opacity. */
static void other_pixels_are_put_in_front(void **state)
{
    const uint8_t rgba[4] = {255, 100, 0, 7}, clear[4] = {9, 9, 9, 0};
    static const uint8_t fronts[][4] = {
        {6, 3, 0, 7}, {100, 0, 0, 100}, {200, 50, 1, 100}, {1, 1, 1, 255}, {0, 0, 0, 1}};
    (void)state;
    for (unsigned i = 0; i < sizeof fronts / sizeof *fronts; i++) {
        uint8_t behind[4] = {10, 200, 77, 200}, front[4], expected[4];
        memcpy(front, fronts[i], 4);
        for (unsigned c = 0; c < 4; c++) {
            const uint32_t colour = front[c] < front[3] ? front[c] : front[3];
            expected[c] = (uint8_t)(colour + divided((255u - front[3]) * behind[c]));
        }
        expect_replayed(behind, front, rgba, expected);
    }
    uint8_t behind[4] = {1, 2, 3, 4}, front[4] = {0}, same[4] = {1, 2, 3, 4};
    expect_replayed(behind, front, rgba, same);
    expect_replayed(behind, front, clear, same);
}

/* ---- Rectangles and errors -------------------------------------------------- */

#define WIDTH  7
#define HEIGHT 5

/* Rows of either direction, padded; only the rectangle's pixels are written. */
static void rows_and_strides(void **state)
{
    static uint8_t far[HEIGHT * 40], near[HEIGHT * 36], before[sizeof far];
    const uint8_t rgba[4] = {200, 90, 5, 3};
    const qv_rect rect = {0, 0, WIDTH, HEIGHT};
    const qv_buffer behind = {far, NULL, sizeof far, 0, 40, 0, &qv_hardware_rgba8888};
    const qv_buffer front = {near + 4 * 36, NULL, 4 * 36 + 28, 0, -36, 0, &qv_hardware_rgba8888};
    uint32_t seed = 3;
    (void)state;
    for (unsigned i = 0; i < sizeof far; i++)
        before[i] = far[i] = (uint8_t)random_next(&seed);
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            blend_slices(&near[36 * (4 - y) + 4 * x], rgba, WIDTH * y + x);
            blend_slices(&before[40 * y + 4 * x], rgba, WIDTH * y + x);
        }
    assert_int_equal(qv_replay(&behind, &front, rgba, &rect), QV_OK);
    assert_memory_equal(far, before, sizeof far);
}

static void bad_calls_are_refused(void **state)
{
    uint8_t far[16] = {1, 2, 3, 4}, near[16] = {0}, before[16];
    const uint8_t rgba[4] = {255, 255, 255, 1};
    const qv_rect rect = {0, 0, 2, 2}, empty = {0, 0, 0, 2};
    const qv_buffer behind = {far, NULL, 16, 0, 8, 0, &qv_hardware_rgba8888};
    const qv_buffer front = {near, NULL, 16, 0, 8, 0, &qv_hardware_rgba8888};
    qv_buffer of_three = behind, by_dither = behind, small = front;
    (void)state;
    memcpy(before, far, sizeof far);
    of_three.blend = &qv_hardware_rgb888;
    by_dither.blend = &qv_over_rgba8888;
    small.bytes--;
    assert_int_equal(qv_replay(NULL, &front, rgba, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_replay(&behind, NULL, rgba, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_replay(&behind, &front, NULL, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_replay(&behind, &front, rgba, NULL), QV_ERROR_NULL);
    assert_int_equal(qv_replay(&behind, &front, rgba, &empty), QV_ERROR_RECT);
    assert_int_equal(qv_replay(&of_three, &front, rgba, &rect), QV_ERROR_BUFFER);
    assert_int_equal(qv_replay(&behind, &of_three, rgba, &rect), QV_ERROR_BUFFER);
    assert_int_equal(qv_replay(&by_dither, &front, rgba, &rect), QV_ERROR_BUFFER);
    assert_int_equal(qv_replay(&behind, &small, rgba, &rect), QV_ERROR_BUFFER);
    assert_int_equal(qv_replay(&small, &front, rgba, &rect), QV_ERROR_BUFFER);
    assert_memory_equal(far, before, sizeof far);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_all_slices_in_one),          cmocka_unit_test(uniform_fogs),
        cmocka_unit_test(other_pixels_are_put_in_front), cmocka_unit_test(rows_and_strides),
        cmocka_unit_test(bad_calls_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
