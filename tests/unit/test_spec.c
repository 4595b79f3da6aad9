/*
 * The worked examples S8 .. S24 of tests/SPEC.md: from voxels to light. The same inputs and
 * results as there, written out.
 */
#include "check.h"
#include "camera.h"
#include "march.h"
#include "pixels.h"

#include <string.h>

#define VOXEL INT64_C(0x100000000)

#define expect_vector(v, x, y, z)                                                                  \
    do {                                                                                           \
        assert_int_equal((v)[0], x);                                                               \
        assert_int_equal((v)[1], y);                                                               \
        assert_int_equal((v)[2], z);                                                               \
    } while (0)

/* ---- Volume, camera, ray ---------------------------------------------------- */

/* Stands for the voxels where only their addresses are looked at. */
static const uint8_t memory[2048];

static qv_volume any_volume(void)
{
    const qv_volume volume = {.voxels = memory,
                              .voxels_bytes = sizeof memory,
                              .spacing = {65536, 98304, 43691},
                              .stride = {1, 3, 12},
                              .size = {3, 4, 5},
                              .storage = QV_STORAGE_INDEXED8};
    return volume;
}

static qv_view any_view(void)
{
    qv_view view = {.pitch = 32768, .step = 49152, .width = 6, .height = 5};
    qv_rotation(view.rotation, 0x15555555, 0x15555555, 0xF0000000);
    return view;
}

/* A context for a camera; unchecked, since rays read no voxels. */
static qv_context any_context(const qv_camera *camera)
{
    const qv_context context = {
        .scene = {.phase = 0x5555, .volume = any_volume(), .camera = *camera}};
    return context;
}

static void S8_address(void **state)
{
    qv_volume volume = any_volume();
    qv_cell cell;
    const qv_ray ray = {.place = {3 * VOXEL, 2 * VOXEL, 1 * VOXEL}, .advance = {0, 0, 0}};
    (void)state;
    for (unsigned axis = 0; axis < 3; axis++)
        volume.size[axis] = 8;
    volume.voxels = memory + 512;
    volume.stride[0] = 8;
    volume.stride[1] = -64;
    volume.stride[2] = 1024;
    qv_cell_locate(&cell, &volume, &ray);
    assert_int_equal(cell.base - volume.voxels, 920);
}

static void S9_spacing(void **state)
{
    static const uint32_t spacing[] = {65536, 98304, 4096, 43691};
    static const qv_coord voxels[] = {4294967296, 2863311531, 68719476736, 6442401792};
    qv_volume volume = any_volume();
    (void)state;
    for (unsigned i = 0; i < 4; i++) {
        volume.spacing[0] = spacing[i];
        assert_int_equal(qv_voxels(65536, &volume, 0), voxels[i]);
    }
}

static void S10_rotation(void **state)
{
    const qv_view view = any_view();
    (void)state;
    expect_vector(view.rotation[0], 756378408, 673930355, 355852616);
    expect_vector(view.rotation[1], 603854640, -224100503, -859104210);
    expect_vector(view.rotation[2], -464943849, 805306369, -536870912);
}

static qv_camera orthographic(void)
{
    const qv_volume volume = any_volume();
    const qv_view view = any_view();
    qv_camera camera;
    assert_int_equal(qv_orthographic(&camera, &volume, &view), QV_OK);
    return camera;
}

static qv_camera perspective(void)
{
    const qv_volume volume = any_volume();
    const qv_view view = any_view();
    qv_camera camera;
    assert_int_equal(qv_perspective(&camera, &volume, &view, 0x1C71C71C), QV_OK);
    return camera;
}

static void S11_orthographic_camera(void **state)
{
    const qv_camera camera = orthographic();
    (void)state;
    expect_vector(camera.origin, 245140344, 6941101419, 13223129916);
    expect_vector(camera.across, 1512756816, 898573806, 1067549703);
    expect_vector(camera.down, 1207709280, -298800671, -2577292967);
    expect_vector(camera.along, -1394831547, 1610612738, -2415900672);
    expect_vector(camera.pace, 0, 0, 0);
}

static void S12_perspective_camera(void **state)
{
    const qv_camera camera = perspective();
    (void)state;
    expect_vector(camera.origin, 12829564588, 1214731031, 21800139166);
    expect_vector(camera.across, 1512756816, 1347860710, 711705232);
    expect_vector(camera.down, 1207709280, -448201006, -1718208420);
    expect_vector(camera.along, -12584424244, 8589555579, -5718049792);
    expect_vector(camera.pace, 3221225472, 2147483648, 4831801344);
}

static void S13_orthographic_ray(void **state)
{
    const qv_camera camera = orthographic();
    const qv_context context = any_context(&camera);
    qv_ray ray;
    (void)state;
    qv_ray_orthographic(&ray, &context, 2, 2);
    expect_vector(ray.place, 5221135781, 8677510410, 9398355452);
    expect_vector(ray.advance, -1394831547, 1610612738, -2415900672);
}

static void S14_perspective_ray(void **state)
{
    const qv_camera camera = perspective();
    const qv_context context = any_context(&camera);
    qv_ray ray;
    (void)state;
    qv_ray_perspective(&ray, &context, 4, -1);
    expect_vector(ray.place, 12323212785, 1843947829, 21687010078);
    expect_vector(ray.advance, -1519078587, 1887679198, -339392442);
}

/* The shortest direction that makes a ray, and one too short. */
static void S14_short_directions(void **state)
{
    const qv_camera camera = {.origin = {VOXEL, VOXEL, VOXEL},
                              .pace = {VOXEL / 2, VOXEL / 2, VOXEL / 2}};
    qv_context context = any_context(&camera);
    qv_ray ray;
    (void)state;
    context.scene.phase = 0;
    context.scene.camera.along[0] = 65535;
    context.scene.camera.along[1] = -65535;
    assert_int_equal(qv_ray_perspective(&ray, &context, 0, 0), 0);
    context.scene.camera.along[0] = 65536;
    context.scene.camera.along[1] = 0;
    assert_int_equal(qv_ray_perspective(&ray, &context, 0, 0), 1);
    qv_ray_clip(&ray, &context);
    assert_int_equal(ray.samples, 4);
    expect_vector(ray.advance, 2147483648, 0, 0);
}

/* Clips a ray and compares its first and last sample number. */
static void expect_clip(qv_ray ray, int32_t least, int32_t first, int32_t last)
{
    const qv_volume volume = any_volume();
    const qv_coord start = ray.place[0];
    const qv_context context = {.scene.volume = volume};
    ray.first = least;
    qv_ray_clip(&ray, &context);
    assert_int_equal(ray.samples, last - first + 1);
    assert_int_equal(ray.place[0], start + first * ray.advance[0] - VOXEL / 2 + VOXEL / 512);
}

static void S15_clip(void **state)
{
    const qv_ray perspective_ray = {.place = {12323212785, 1843947829, 21687010078},
                                    .advance = {-1519078587, 1887679198, -339392442}};
    const qv_ray orthographic_ray = {.place = {5221135781, 8677510410, 9398355452},
                                     .advance = {-1394831547, 1610612738, -2415900672}};
    const qv_ray upwards = {.place = {0, VOXEL, VOXEL}, .advance = {VOXEL / 2, 0, 0}};
    const qv_ray downwards = {.place = {0, VOXEL, VOXEL}, .advance = {-VOXEL / 2, 0, 0}};
    (void)state;
    expect_clip(perspective_ray, 0, 1, 8);
    expect_clip(orthographic_ray, -QV_GRID_LIMIT, -4, 3);
    expect_clip(upwards, -QV_GRID_LIMIT, 0, 5);
    expect_clip(downwards, -QV_GRID_LIMIT, -5, 0);
}

/* Compares the voxels i0 and i1 of the cell at a place, both as bytes from voxel
   (0, 0, 0), and its fractions. */
static void expect_cell(const qv_ray *ray, ptrdiff_t low, ptrdiff_t high, uint32_t x, uint32_t y,
                        uint32_t z)
{
    const qv_volume volume = any_volume();
    qv_cell cell;
    qv_cell_locate(&cell, &volume, ray);
    assert_int_equal(cell.base - memory, low);
    assert_int_equal(cell.base + cell.next[0] + cell.next[1] + cell.next[2] - memory, high);
    assert_int_equal(fx_fraction_bits(cell.fraction[0]), x);
    assert_int_equal(fx_fraction_bits(cell.fraction[1]), y);
    assert_int_equal(fx_fraction_bits(cell.fraction[2]), z);
}

static void S16_cell(void **state)
{
    const qv_ray inner = {.place = {5626881984, 5367890383, 18529737712}, .advance = {0, 0, 0}};
    const qv_coord centred = VOXEL / 512 - VOXEL / 2;
    const qv_ray clamped = {
        .place = {VOXEL / 4 + centred, 7 * VOXEL / 2 + centred, 2 * VOXEL - VOXEL / 512 + centred},
        .advance = {0, 0, 0}};
    (void)state;
    expect_cell(&inner, 1 * 1 + 1 * 3 + 4 * 12, 2 * 1 + 2 * 3 + 4 * 12, 79, 63, 80);
    expect_cell(&clamped, 0 * 1 + 3 * 3 + 1 * 12, 0 * 1 + 3 * 3 + 2 * 12, 192, 0, 128);
}

/* ---- Sample ------------------------------------------------------------------- */

static void expect_weights(const uint8_t f[3], const uint32_t expected[8])
{
    const fx_fraction fraction[3] = {fx_fraction_of(f[0]), fx_fraction_of(f[1]),
                                     fx_fraction_of(f[2])};
    fx_weight weight[8];
    qv_weights(weight, fraction);
    for (unsigned i = 0; i < 8; i++)
        assert_int_equal(fx_weight_bits(weight[i]), expected[i]);
}

static void S17_weights(void **state)
{
    static const uint8_t f[2][3] = {{85, 170, 3}, {255, 255, 255}};
    static const uint32_t w[2][8] = {{14534, 7224, 28729, 14281, 172, 86, 341, 169},
                                     {0, 1, 1, 254, 1, 254, 254, 64771}};
    (void)state;
    for (unsigned i = 0; i < 2; i++)
        expect_weights(f[i], w[i]);
}

/* The sample of S18 to S21 in one mode: eight entries side by side are the corners. */
static qv_sample sample_corners(qv_mode *mode, unsigned storage, const uint8_t f[3])
{
    uint8_t narrow[8][4];
    uint16_t wide[8][4];
    for (unsigned q = 0; q < 8; q++) {
        const unsigned rgba[4] = {10 * q + 1, 255 - 30 * q, 7 * q * q % 256, (37 * q + 5) % 256};
        for (unsigned c = 0; c < 4; c++) {
            narrow[q][c] = (uint8_t)rgba[c];
            wide[q][c] = (uint16_t)(257 * rgba[c] + q);
        }
    }
    const int32_t entry = (int32_t)qv_entry_bytes(storage);
    const qv_volume volume = {.voxels = storage == QV_STORAGE_RGBA8 ? narrow[0] : (qv_address)wide,
                              .size = {2, 2, 2},
                              .stride = {entry, 2 * entry, 4 * entry},
                              .storage = (uint8_t)storage};
    const qv_ray ray = {
        .place = {f[0] * (VOXEL / 256), f[1] * (VOXEL / 256), f[2] * (VOXEL / 256)}};
    qv_sample sample;
    assert_true(mode(&sample, &ray, &volume, storage));
    return sample;
}

static void expect_sample(const qv_sample *sample, uint32_t opacity, uint32_t red, uint32_t green,
                          uint32_t blue)
{
    assert_int_equal(fx_share_bits(sample->opacity), opacity);
    assert_int_equal(fx_sum_bits(sample->light[0]), red);
    assert_int_equal(fx_sum_bits(sample->light[1]), green);
    assert_int_equal(fx_sum_bits(sample->light[2]), blue);
}

static const uint8_t inside[3] = {85, 170, 3};

static void S18_weighted_8_bits(void **state)
{
    const qv_sample sample = sample_corners(qv_sample_weighted, QV_STORAGE_RGBA8, inside);
    (void)state;
    expect_sample(&sample, 4423680, 109156160, 813840960, 195469032);
}

static void S19_weighted_16_bits(void **state)
{
    const qv_sample sample = sample_corners(qv_sample_weighted, QV_STORAGE_RGBA16, inside);
    (void)state;
    expect_sample(&sample, 1136997632, 110062946, 820331968, 197060302);
}

static void S20_separate(void **state)
{
    const qv_sample narrow = sample_corners(qv_sample_separate, QV_STORAGE_RGBA8, inside);
    const qv_sample wide = sample_corners(qv_sample_separate, QV_STORAGE_RGBA16, inside);
    (void)state;
    expect_sample(&narrow, 4423680, 79937280, 901497600, 127550160);
    expect_sample(&wide, 1136997632, 80600553, 908673325, 128590857);
}

static void S21_nearest(void **state)
{
    static const uint8_t halfway[3] = {128, 127, 255};
    const qv_sample narrow = sample_corners(qv_sample_nearest, QV_STORAGE_RGBA8, inside);
    const qv_sample wide = sample_corners(qv_sample_nearest, QV_STORAGE_RGBA16, inside);
    const qv_sample tie = sample_corners(qv_sample_nearest, QV_STORAGE_RGBA8, halfway);
    (void)state;
    expect_sample(&narrow, 5177344, 108724224, 1009582080, 144965632);
    expect_sample(&wide, 1330708480, 109626695, 1017625685, 146155390);
    expect_sample(&tie, 12451840, 635043840, 1307443200, 2179072000);
}

static void S22_opacity(void **state)
{
    (void)state;
    assert_int_equal(qv_opacity_q32(fx_share_of(16711680), QV_STORAGE_RGBA8), 0xFFFFFFFFu);
    assert_int_equal(qv_opacity_q32(fx_share_of(65536), QV_STORAGE_RGBA8), 16843009);
    assert_int_equal(qv_opacity_q32(fx_share_of(4423680), QV_STORAGE_RGBA8), 1136903107);
    assert_int_equal(qv_opacity_q32(fx_share_of(4294901760u), QV_STORAGE_RGBA16), 0xFFFFFFFFu);
    assert_int_equal(qv_opacity_q32(fx_share_of(65536), QV_STORAGE_RGBA16), 65537);
    assert_int_equal(qv_opacity_q32(fx_share_of(1136997632), QV_STORAGE_RGBA16), 1137014981);
}

/* ---- Compositing -------------------------------------------------------------- */

typedef void compositing(qv_light *light, const uint32_t sample[3], uint32_t opacity);

static void under(qv_light *light, const uint32_t sample[3], uint32_t opacity)
{
    qv_under(light, sample, opacity);
}

static void over(qv_light *light, const uint32_t sample[3], uint32_t opacity)
{
    qv_over(light, sample, opacity);
}

/* Composites the first `count` of the weighted, the separate and the nearest sample. */
static qv_light gather(compositing *composite, unsigned storage, unsigned count)
{
    qv_mode *const modes[3] = {qv_sample_weighted, qv_sample_separate, qv_sample_nearest};
    qv_light light = {.transmittance = QV_CLEAR};
    for (unsigned i = 0; i < count; i++) {
        const qv_sample sample = sample_corners(modes[i], storage, inside);
        const uint32_t colour[3] = {fx_sum_bits(sample.light[0]), fx_sum_bits(sample.light[1]),
                                    fx_sum_bits(sample.light[2])};
        composite(&light, colour, qv_opacity_q32(sample.opacity, storage));
    }
    return light;
}

static void expect_light(const qv_light *light, const uint32_t expected[4])
{
    expect_vector(light->colour, expected[0], expected[1], expected[2]);
    assert_int_equal(light->transmittance, expected[3]);
}

static void S23_under(void **state)
{
    static const uint32_t one[4] = {54578080, 406920480, 97734516, 1579032094};
    static const uint32_t three[4] = {113358066, 1011272452, 183816331, 801354235};
    static const uint32_t wide[4] = {114296125, 1019299184, 185311727, 801262030};
    const qv_light light[3] = {gather(under, QV_STORAGE_RGBA8, 1),
                               gather(under, QV_STORAGE_RGBA8, 3),
                               gather(under, QV_STORAGE_RGBA16, 3)};
    (void)state;
    expect_light(&light[0], one);
    expect_light(&light[1], three);
    expect_light(&light[2], wide);
}

static void S24_over(void **state)
{
    static const uint32_t one[4] = {54578080, 406920480, 97734516, 1579032094};
    static const uint32_t three[4] = {109646529, 1022407064, 166100111, 801354235};
    static const uint32_t wide[4] = {110553301, 1030521837, 167451971, 801262030};
    const qv_light light[3] = {gather(over, QV_STORAGE_RGBA8, 1), gather(over, QV_STORAGE_RGBA8, 3),
                               gather(over, QV_STORAGE_RGBA16, 3)};
    (void)state;
    expect_light(&light[0], one);
    expect_light(&light[1], three);
    expect_light(&light[2], wide);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S8_address),
        cmocka_unit_test(S9_spacing),
        cmocka_unit_test(S10_rotation),
        cmocka_unit_test(S11_orthographic_camera),
        cmocka_unit_test(S12_perspective_camera),
        cmocka_unit_test(S13_orthographic_ray),
        cmocka_unit_test(S14_perspective_ray),
        cmocka_unit_test(S14_short_directions),
        cmocka_unit_test(S15_clip),
        cmocka_unit_test(S16_cell),
        cmocka_unit_test(S17_weights),
        cmocka_unit_test(S18_weighted_8_bits),
        cmocka_unit_test(S19_weighted_16_bits),
        cmocka_unit_test(S20_separate),
        cmocka_unit_test(S21_nearest),
        cmocka_unit_test(S22_opacity),
        cmocka_unit_test(S23_under),
        cmocka_unit_test(S24_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
