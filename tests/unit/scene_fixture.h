/*
 * scene_fixture.h - a small random scene in one structure: volumes of every
 * storage, a view that sees all of them, and a frame to render into.
 *
 * The same seed fills the same bytes, so scenes can be compared and copied; the
 * scene points into its fixture, which must stay where it is.
 */
#ifndef SCENE_FIXTURE_H
#define SCENE_FIXTURE_H

#include "check.h"
#include "qvol.h"
#include "random.h"
#include "ray.h"

#include <string.h>

enum {
    FIXTURE_NX = 6,
    FIXTURE_NY = 5,
    FIXTURE_NZ = 4,
    FIXTURE_VOXELS = FIXTURE_NX * FIXTURE_NY * FIXTURE_NZ,
    FIXTURE_COARSER = 3 * 3 * 2 + 2 * 2 * 1 + 1, /* voxels of all coarser levels */
    FIXTURE_WIDTH = 17,
    FIXTURE_HEIGHT = 13,
    FIXTURE_POISON = 0xA5
};

#define QUARTER_TURN 0x40000000u
#define VOXEL        ((qv_coord)1 << 32)

typedef struct fixture {
    qv_scene scene;
    qv_transfer palette16;
    uint8_t palette8[QV_PALETTE_ENTRIES][4];
    uint16_t voxels[FIXTURE_VOXELS * 4]; /* bytes for 8-bit storage */
    qv_pyramid pyramid;
    uint16_t coarser[FIXTURE_COARSER * 4];
} fixture;

static const qv_rect fixture_frame = {0, 0, FIXTURE_WIDTH, FIXTURE_HEIGHT};

/* ---- Outputs that must stay untouched ----------------------------------- */

static inline void fixture_poison(void *memory, size_t bytes)
{
    memset(memory, FIXTURE_POISON, bytes);
}

static inline int fixture_untouched(const void *memory, size_t bytes)
{
    const uint8_t *byte = (const uint8_t *)memory;
    while (bytes > 0 && byte[bytes - 1] == FIXTURE_POISON)
        bytes--;
    return bytes == 0;
}

/* ---- Rays ---- */

/* Clips a ray to a box of this size. */
static inline void fixture_clip(qv_ray *ray, const uint16_t size[3], int32_t first)
{
    qv_context context;
    memcpy(context.scene.volume.size, size, sizeof context.scene.volume.size);
    ray->first = first;
    qv_ray_clip(ray, &context);
}

/* ---- Volumes ------------------------------------------------------------ */

/* The storage with opacity for extinction, which looks the same in memory. */
static inline uint8_t fixture_with_opacity(uint8_t storage)
{
    return storage < QV_STORAGE_RGBT8 ? storage : (uint8_t)(storage - QV_STORAGE_INDEXED8_16);
}

static inline int32_t fixture_voxel_bytes(uint8_t storage)
{
    const uint8_t with_opacity = fixture_with_opacity(storage);
    if (with_opacity == QV_STORAGE_RGBA16)
        return 8;
    return with_opacity == QV_STORAGE_RGBA8 ? 4 : 1;
}

/* A third of the opacities 0, the others at most a quarter. */
static inline void fixture_random(fixture *f, uint32_t seed)
{
    uint8_t *bytes = (uint8_t *)f->voxels;
    const uint8_t storage = fixture_with_opacity(f->scene.volume.storage);
    for (unsigned i = 0; i < QV_PALETTE_ENTRIES * 4; i++) {
        uint32_t level = random_next(&seed) >> 16;
        if (i % 4 == 3)
            level = level < 0x5555 ? 0 : level / 4;
        f->palette16.rgba[i / 4][i % 4] = (uint16_t)level;
        f->palette8[i / 4][i % 4] = (uint8_t)(level >> 8);
    }
    for (unsigned i = 0; i < FIXTURE_VOXELS; i++) {
        const uint32_t entry = random_below(&seed, QV_PALETTE_ENTRIES);
        if (storage == QV_STORAGE_RGBA8)
            memcpy(&bytes[4 * i], f->palette8[entry], 4);
        else if (storage == QV_STORAGE_RGBA16)
            memcpy(&f->voxels[4 * i], f->palette16.rgba[entry], 8);
        else
            bytes[i] = (uint8_t)entry;
    }
}

/* A packed volume, x fastest; of stored extinction, up to a depth of 2 a voxel. */
static inline void fixture_volume(fixture *f, uint8_t storage, uint32_t seed)
{
    const int32_t bytes = fixture_voxel_bytes(storage);
    const uint8_t with_opacity = fixture_with_opacity(storage);
    qv_volume *volume = &f->scene.volume;
    memset(volume, 0, sizeof *volume);
    volume->voxels = (qv_address)f->voxels;
    volume->voxels_bytes = (uint64_t)FIXTURE_VOXELS * (uint64_t)bytes;
    volume->stride[0] = bytes;
    volume->stride[1] = bytes * FIXTURE_NX;
    volume->stride[2] = bytes * FIXTURE_NX * FIXTURE_NY;
    volume->size[0] = FIXTURE_NX;
    volume->size[1] = FIXTURE_NY;
    volume->size[2] = FIXTURE_NZ;
    volume->storage = storage;
    volume->extinction = 8 * QV_ONE_Q16;
    if (with_opacity == QV_STORAGE_INDEXED8 || with_opacity == QV_STORAGE_INDEXED8_16) {
        const int wide = with_opacity == QV_STORAGE_INDEXED8_16;
        volume->palette = wide ? (qv_address)&f->palette16 : (qv_address)f->palette8;
        volume->palette_bytes = wide ? QV_PALETTE16_BYTES : QV_PALETTE8_BYTES;
    }
    fixture_random(f, seed);
}

/* All coarser levels of the volume, for as long as the fixture stays where it is. */
static inline void fixture_add_pyramid(fixture *f)
{
    const uint8_t levels = qv_pyramid_levels(f->scene.volume.size);
    f->pyramid.voxels = (qv_address)f->coarser;
    f->pyramid.bytes = sizeof f->coarser;
    f->pyramid.levels = levels;
    f->scene.pyramid = &f->pyramid;
    for (unsigned number = 1; number <= levels; number++) {
        qv_volume finer, level;
        assert_int_equal(
            qv_pyramid_level(&finer, &f->scene.volume, &f->pyramid, (uint8_t)(number - 1)), QV_OK);
        assert_int_equal(qv_pyramid_level(&level, &f->scene.volume, &f->pyramid, (uint8_t)number),
                         QV_OK);
        uint8_t *to = (uint8_t *)f->coarser + (level.voxels - f->pyramid.voxels);
        assert_int_equal(qv_downsample(to, (size_t)level.voxels_bytes, &finer, &qv_filter_box4,
                                       &qv_domain_stored, 0, level.size[2]),
                         QV_OK);
    }
}

/* ---- Views -------------------------------------------------------------- */

/* Two thirds of a voxel from pixel to pixel, half a voxel from sample to sample. */
static inline qv_view fixture_view(qv_angle azimuth, qv_angle elevation, qv_angle roll)
{
    qv_view view;
    memset(&view, 0, sizeof view);
    qv_rotation(view.rotation, azimuth, elevation, roll);
    view.pitch = QV_ONE_Q16 * 2 / 3;
    view.step = QV_ONE_Q16 / 2;
    view.width = FIXTURE_WIDTH;
    view.height = FIXTURE_HEIGHT;
    return view;
}

/* Looks at the volume from in front, at the right and above. */
static inline void fixture_aim(fixture *f, qv_angle field_of_view)
{
    const qv_view view = fixture_view(QUARTER_TURN / 3, QUARTER_TURN / 4, 0u - QUARTER_TURN / 9);
    const qv_status status =
        field_of_view == 0
            ? qv_orthographic(&f->scene.camera, &f->scene.volume, &view)
            : qv_perspective(&f->scene.camera, &f->scene.volume, &view, field_of_view);
    assert_int_equal(status, QV_OK);
}

/* ---- Scenes ------------------------------------------------------------- */

/* An orthographic scene without early termination or background. */
static inline void fixture_make(fixture *f, const qv_sampling *sampling, uint32_t seed)
{
    memset(f, 0, sizeof *f);
    f->scene.sampling = sampling;
    fixture_volume(f, sampling->storage, seed);
    fixture_aim(f, 0);
}

static inline qv_context fixture_context(const fixture *f)
{
    qv_context context;
    assert_int_equal(qv_init(&context, &f->scene), QV_OK);
    return context;
}

/* The whole frame as RGBA8888. */
typedef uint8_t fixture_pixels[FIXTURE_HEIGHT][FIXTURE_WIDTH][4];

static inline void fixture_render(fixture_pixels pixels, const fixture *f)
{
    const qv_context context = fixture_context(f);
    const qv_image image = {pixels, sizeof(fixture_pixels), FIXTURE_WIDTH * 4, &qv_format_rgba8888};
    assert_int_equal(qv_render(&image, &context, &fixture_frame), QV_OK);
}

/* The greatest difference between two scenes' pictures, which must show much of the
   volume. */
static inline int fixture_difference(const fixture *a, const fixture *b)
{
    fixture_pixels pixels_a, pixels_b;
    const uint8_t *p = &pixels_a[0][0][0], *q = &pixels_b[0][0][0];
    uint32_t covered = 0;
    int worst = 0;
    fixture_render(pixels_a, a);
    fixture_render(pixels_b, b);
    for (unsigned i = 0; i < sizeof pixels_a; i++) {
        const int apart = p[i] > q[i] ? p[i] - q[i] : q[i] - p[i];
        covered += i % 4 == 3 && p[i] > 0;
        worst = apart > worst ? apart : worst;
    }
    assert_true(covered >= 40);
    return worst;
}

#endif /* SCENE_FIXTURE_H */
