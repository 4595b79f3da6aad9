/*
 * Low opacities survive: uniform volumes of faint voxels against the exact
 * 1 - (1 - a)^n, for 64 sub-voxel phases of the sample grid.
 */
#include "check.h"
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define DEEPEST 512
#define PHASES  64
#define ACROSS  2 /* voxels on x and on y */
#define VOXELS  (ACROSS * ACROSS * DEEPEST)

static const qv_coord one = (qv_coord)1 << 32;

/* Half a level is the read-out's own rounding. */
static const double most_off = 0.51;

static const double opacities[] = {0.00005, 0.0005, 0.001, 0.002, 0.004, 0.01};
static const uint16_t depths[] = {128, 256, DEEPEST};

/* Colours in steps of 1/65535: 1, 128, 255 and the maximum, of 16 bits and of 8. */
static const uint16_t colours[][3] = {{1, 128, 255}, {0xffff, 0x0101, 0x8080}};

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

typedef union memory {
    uint16_t rgba16[VOXELS][4];
    unsigned char index8[VOXELS];
} memory;

typedef struct setting {
    uint16_t entry[4]; /* what every voxel holds */
    uint16_t depth;
    double worst_opacity, worst_colour;
} setting;

/* Equal voxels two by two along z, seen along z with one sample in each of their depths. */
static void uniform_scene(qv_scene *scene, memory *voxels, uint16_t (*palette)[4],
                          qv_storage storage, const setting *of)
{
    const bool indexed = storage == QV_STORAGE_INDEXED8_16;
    const int32_t bytes = indexed ? 1 : 8;
    memset(scene, 0, sizeof *scene);
    for (int i = 0; i < ACROSS * ACROSS * of->depth; i++) {
        if (indexed) {
            voxels->index8[i] = 7;
        } else {
            memcpy(voxels->rgba16[i], of->entry, sizeof of->entry);
        }
    }
    memcpy(palette[7], of->entry, sizeof of->entry);
    scene->volume.voxels = (const unsigned char *)voxels;
    scene->volume.palette = indexed ? (const unsigned char *)palette : NULL;
    scene->volume.palette_bytes = indexed ? QV_PALETTE16_BYTES : 0;
    scene->volume.storage = (uint8_t)storage;
    scene->volume.stride[0] = bytes;
    scene->volume.stride[1] = bytes * ACROSS;
    scene->volume.stride[2] = bytes * ACROSS * ACROSS;
    scene->volume.voxels_bytes = (uint64_t)(bytes * ACROSS * ACROSS) * of->depth;
    scene->volume.size[0] = ACROSS;
    scene->volume.size[1] = ACROSS;
    scene->volume.size[2] = of->depth;
    scene->camera.across[0] = one;
    scene->camera.down[1] = one;
    scene->camera.along[2] = one;
    scene->camera.step = QV_ONE_Q16;
    scene->camera.projection = &qv_projection_orthographic;
    scene->sampling = indexed ? &qv_weighted_indexed8_16 : &qv_weighted_rgba16;
}

/* One pixel of the scene against n samples of the stored opacity. */
static void compare_pixel(setting *of, const qv_scene *scene)
{
    const double a = of->entry[3] / 65535.0;
    const double alpha = -expm1(of->depth * log1p(-a));
    const qv_rect rect = {0, 0, 1, 1};
    uint8_t pixel[4];
    const qv_image image = {pixel, sizeof pixel, sizeof pixel, &qv_format_rgba8888};
    qv_context context;
    assert_int_equal(qv_init(&context, scene), QV_OK);
    assert_int_equal(qv_render(&image, &context, &rect), QV_OK);
    of->worst_opacity = fmax(of->worst_opacity, fabs(pixel[3] - 255 * alpha));
    for (int channel = 0; channel < 3; channel++) {
        const double colour = of->entry[channel] / 65535.0 * alpha;
        of->worst_colour = fmax(of->worst_colour, fabs(pixel[channel] - 255 * colour));
    }
}

/* Phases along the ray and between the voxels' centres at once. */
static void all_phases(setting *of, qv_storage storage)
{
    static memory voxels;
    static uint16_t palette[QV_PALETTE_ENTRIES][4];
    qv_scene scene;
    uniform_scene(&scene, &voxels, palette, storage, of);
    for (uint32_t phase = 0; phase < PHASES; phase++) {
        scene.phase = (uint16_t)(phase * (65536 / PHASES));
        scene.camera.origin[0] = one / 2 + one * phase / PHASES;
        scene.camera.origin[1] = one / 2 + one * (PHASES - 1 - phase) / PHASES;
        compare_pixel(of, &scene);
    }
}

static void all_depths(qv_storage storage, double opacity, double *worst)
{
    for (size_t depth = 0; depth < COUNT(depths); depth++) {
        setting of = {{0, 0, 0, 0}, depths[depth], 0, 0};
        of.entry[3] = (uint16_t)(opacity * 65535 + 0.5);
        for (size_t set = 0; set < COUNT(colours); set++) {
            memcpy(of.entry, colours[set], sizeof colours[set]);
            all_phases(&of, storage);
        }
        printf("# opacity %.5f stored as %u, %u samples: opacity %.4f, colour %.4f levels off\n",
               opacity, of.entry[3], of.depth, of.worst_opacity, of.worst_colour);
        *worst = fmax(*worst, fmax(of.worst_opacity, of.worst_colour));
    }
}

static void test_storage(qv_storage storage)
{
    double worst = 0;
    for (size_t i = 0; i < COUNT(opacities); i++) {
        all_depths(storage, opacities[i], &worst);
    }
    printf("# worst: %.4f levels off\n", worst);
    assert_true(worst <= most_off);
}

static void test_rgba16(void **state)
{
    (void)state;
    test_storage(QV_STORAGE_RGBA16);
}

static void test_palette16(void **state)
{
    (void)state;
    test_storage(QV_STORAGE_INDEXED8_16);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rgba16),
        cmocka_unit_test(test_palette16),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
