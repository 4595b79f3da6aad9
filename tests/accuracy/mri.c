/*
 * The library against the double-precision reference on a real scan: the head
 * ch2.nii.gz of Debian's mricron-data, classified with a table.
 */
#include "check.h"
#include "scan.h"
#include "tally.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EDGE 128 /* pixels of the square frame */

static const double pi = 3.14159265358979323846;
static const double least_equal = 0.99;

typedef struct angles {
    const char *name;
    qv_angle azimuth, elevation, roll, field_of_view;
    double step;
} angles;

static const angles views[] = {
    {"front", 0, 0, 0, 0, 1},
    {"oblique", 0x15555555u, 0x0e38e38eu, 0, 0, 1},
    {"perspective", 0xe0000001u, 0x08000000u, 0x03000000u, 0x1c71c71cu, 0.7},
};

typedef struct storage_kind {
    const char *name;
    qv_storage storage;
    size_t voxel_bytes;
    const qv_sampling *sampling;
} storage_kind;

static const storage_kind storages[] = {
    {"rgba8", QV_STORAGE_RGBA8, 4, &qv_weighted_rgba8},
    {"rgba16", QV_STORAGE_RGBA16, 8, &qv_weighted_rgba16},
    {"indexed8", QV_STORAGE_INDEXED8, 1, &qv_weighted_indexed8},
    {"indexed8_16", QV_STORAGE_INDEXED8_16, 1, &qv_weighted_indexed8_16},
};

/* ---- The scan and its classification --------------------------------------- */

/* The table with 8 bits a channel, each cut. */
static void narrow(uint8_t palette8[QV_PALETTE_ENTRIES][4],
                   uint16_t palette16[QV_PALETTE_ENTRIES][4])
{
    for (int value = 0; value < QV_PALETTE_ENTRIES; value++) {
        for (int channel = 0; channel < 4; channel++) {
            palette8[value][channel] = (uint8_t)(palette16[value][channel] / 257);
        }
    }
}

/* The scan as the storage keeps it, in memory of the caller's own; null without memory. */
static unsigned char *classify(const unsigned char *scan, const storage_kind *kind,
                               const unsigned char *palette)
{
    unsigned char *voxels = malloc(REF_SCAN_VOXELS * kind->voxel_bytes);
    if (voxels == NULL || kind->voxel_bytes == 1) {
        return voxels == NULL ? NULL : memcpy(voxels, scan, REF_SCAN_VOXELS);
    }
    for (size_t i = 0; i < REF_SCAN_VOXELS; i++) {
        memcpy(voxels + i * kind->voxel_bytes, palette + scan[i] * kind->voxel_bytes,
               kind->voxel_bytes);
    }
    return voxels;
}

static void describe(qv_volume *volume, const storage_kind *kind, const unsigned char *voxels,
                     const unsigned char *palette)
{
    const int32_t stride = (int32_t)kind->voxel_bytes;
    const bool indexed = kind->voxel_bytes == 1;
    volume->voxels = voxels;
    volume->voxels_bytes = REF_SCAN_VOXELS * kind->voxel_bytes;
    volume->palette = indexed ? palette : NULL;
    if (indexed) {
        volume->palette_bytes =
            kind->storage == QV_STORAGE_INDEXED8 ? QV_PALETTE8_BYTES : QV_PALETTE16_BYTES;
    }
    volume->size[0] = REF_SCAN_X;
    volume->size[1] = REF_SCAN_Y;
    volume->size[2] = REF_SCAN_Z;
    volume->stride[0] = stride;
    volume->stride[1] = stride * REF_SCAN_X;
    volume->stride[2] = stride * REF_SCAN_X * REF_SCAN_Y;
    volume->storage = (uint8_t)kind->storage;
}

/* ---- Views ----------------------------------------------------------------- */

static qv_status look(qv_scene *scene, ref_view *real, const angles *from)
{
    qv_view view;
    view.width = EDGE;
    view.height = EDGE;
    view.pitch = 2 * QV_ONE_Q16;
    view.step = (uint32_t)(from->step * QV_ONE_Q16);
    qv_rotation(view.rotation, from->azimuth, from->elevation, from->roll);
    ref_rotation(real->rotation, from->azimuth, from->elevation, from->roll);
    real->pitch = 2;
    real->step = view.step / 65536.0;
    real->width = EDGE;
    real->height = EDGE;
    real->field_of_view = from->field_of_view / 4294967296.0 * 2 * pi;
    if (from->field_of_view == 0) {
        return qv_orthographic(&scene->camera, &scene->volume, &view);
    }
    return qv_perspective(&scene->camera, &scene->volume, &view, from->field_of_view);
}

typedef struct agreement {
    tally stored, ideal;
} agreement;

static void compare(agreement *found, const qv_scene *scene, const ref_view *view)
{
    static uint8_t pixels[EDGE][EDGE][4];
    const qv_rect rect = {0, 0, EDGE, EDGE};
    const qv_image image = {pixels, sizeof pixels, sizeof pixels[0], &qv_format_rgba8888};
    qv_context context;
    assert_int_equal(qv_init(&context, scene), QV_OK);
    assert_int_equal(qv_render(&image, &context, &rect), QV_OK);
    for (int32_t y = 0; y < EDGE; y++) {
        for (int32_t x = 0; x < EDGE; x++) {
            ref_pixel expected;
            ref_render(&expected, scene, REF_WEIGHTED, x, y);
            if (expected.opacity > 0) {
                tally_pixel(&found->stored, pixels[y][x], &expected);
            }
            ref_render_ideal(&expected, scene, view, REF_WEIGHTED, x, y);
            if (expected.opacity > 0) {
                tally_pixel(&found->ideal, pixels[y][x], &expected);
            }
        }
    }
}

static void test_view(const storage_kind *kind, const qv_volume *volume, const angles *from)
{
    qv_scene scene;
    ref_view real;
    agreement found = {{0}, {0}};
    char name[64];
    memset(&scene, 0, sizeof scene);
    scene.volume = *volume;
    scene.sampling = kind->sampling;
    assert_int_equal(look(&scene, &real, from), QV_OK);
    compare(&found, &scene, &real);
    (void)snprintf(name, sizeof name, "%s, %s", kind->name, from->name);
    tally_print(name, &found.stored);
    (void)snprintf(name, sizeof name, "%s, %s, ideal camera", kind->name, from->name);
    tally_print(name, &found.ideal);
    assert_true(found.stored.channels > EDGE * EDGE); /* a quarter of the frame is covered */
    assert_true(found.stored.worst <= 1);
    assert_true(tally_share(&found.stored) >= least_equal);
    assert_true(found.ideal.worst <= 1);
}

static void test_storage(const storage_kind *kind)
{
    static unsigned char scan[REF_SCAN_VOXELS];
    static uint16_t palette16[QV_PALETTE_ENTRIES][4];
    static uint8_t palette8[QV_PALETTE_ENTRIES][4];
    const bool wide = kind->storage == QV_STORAGE_RGBA16 || kind->storage == QV_STORAGE_INDEXED8_16;
    const unsigned char *palette = wide ? (const unsigned char *)palette16 : palette8[0];
    qv_volume volume;
    assert_true(ref_scan_read(scan));
    ref_scan_palette(palette16);
    narrow(palette8, palette16);
    unsigned char *voxels = classify(scan, kind, palette);
    assert_non_null(voxels);
    memset(&volume, 0, sizeof volume);
    describe(&volume, kind, voxels, palette);
    for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
        test_view(kind, &volume, &views[i]);
    }
    free(voxels);
}

static void test_rgba8(void **state)
{
    (void)state;
    test_storage(&storages[0]);
}

static void test_rgba16(void **state)
{
    (void)state;
    test_storage(&storages[1]);
}

static void test_indexed8(void **state)
{
    (void)state;
    test_storage(&storages[2]);
}

static void test_indexed8_16(void **state)
{
    (void)state;
    test_storage(&storages[3]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rgba8),
        cmocka_unit_test(test_rgba16),
        cmocka_unit_test(test_indexed8),
        cmocka_unit_test(test_indexed8_16),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
