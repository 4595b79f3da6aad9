/*
 * splat_fixture.h - a small volume with its attenuation, and a scene of it.
 */
#ifndef QV_SPLAT_FIXTURE_H
#define QV_SPLAT_FIXTURE_H

#include "check.h"
#include "qvol.h"
#include "random.h"

#include <string.h>

#define SIDE   6u
#define VOXELS (SIDE * SIDE * SIDE)
#define FRAME  48

typedef struct splat_fixture {
    uint8_t voxels[VOXELS * 4];
    uint8_t bytes[VOXELS * QV_DIRECTIONS];
    uint32_t sums[FRAME * FRAME * QV_SUM_CHANNELS];
    uint8_t pixels[FRAME * FRAME * 4];
    qv_volume volume;
    qv_attenuation attenuation;
    qv_splat_scene scene;
    qv_sums target;
    qv_image image;
} splat_fixture;

static const qv_block splat_all = {{0, 0, 0}, {SIDE, SIDE, SIDE}};

static inline qv_angle splat_degrees(double angle)
{
    return (qv_angle)(int64_t)(angle / 360 * 4294967296.);
}

static inline void splat_attenuate(splat_fixture *f)
{
    for (uint8_t d = 0; d < QV_DIRECTIONS; d++)
        assert_int_equal(qv_attenuate(f->bytes, sizeof f->bytes, NULL, &f->attenuation, &f->volume,
                                      &qv_domain_extinction, d),
                         QV_OK);
}

/* Voxels of random colours; every third is empty. */
static inline void splat_begin(splat_fixture *f, uint32_t seed, uint32_t most_opacity)
{
    memset(f, 0, sizeof *f);
    for (unsigned i = 0; i < VOXELS; i++) {
        for (unsigned c = 0; c < 3; c++)
            f->voxels[4 * i + c] = (uint8_t)(random_next(&seed) >> 7);
        f->voxels[4 * i + 3] = (uint8_t)(i % 3 == 0 ? 0 : random_below(&seed, most_opacity + 1u));
    }
    const qv_volume volume = {.voxels = f->voxels,
                              .voxels_bytes = sizeof f->voxels,
                              .size = {SIDE, SIDE, SIDE},
                              .storage = QV_STORAGE_RGBA8,
                              .unit_distance = QV_ONE_Q16,
                              .stride = {4, 4 * SIDE, 4 * SIDE * SIDE}};
    const qv_attenuation attenuation = {.records = f->bytes,
                                        .bytes = sizeof f->bytes,
                                        .directions = QV_DIRECTIONS_ALL,
                                        .size = {SIDE, SIDE, SIDE}};
    f->volume = volume;
    f->attenuation = attenuation;
    splat_attenuate(f);
    f->scene.splatting = &qv_splatting_added;
    f->scene.kernel = &qv_kernel_quadratic;
    f->scene.domain = &qv_domain_extinction;
    f->scene.directions = QV_DIRECTIONS_ALL;
    f->scene.volume = volume;
    f->scene.view.pitch = QV_ONE_Q16 / 4;
    f->scene.view.width = f->scene.view.height = FRAME;
    qv_rotation(f->scene.view.rotation, splat_degrees(25), splat_degrees(15), 0);
    const qv_sums target = {f->sums, sizeof f->sums / sizeof *f->sums, {0, 0, FRAME, FRAME}};
    const qv_image image = {f->pixels, sizeof f->pixels, 4 * FRAME, &qv_format_rgba8888};
    f->target = target;
    f->image = image;
}

static inline void splat_init(qv_splats *splats, const splat_fixture *f)
{
    assert_int_equal(qv_splat_init(splats, &f->scene), QV_OK);
}

/* All voxels, from memory. */
static inline void splat_draw(splat_fixture *f, const qv_splats *splats)
{
    assert_int_equal(qv_sums_clear(&f->target, splats), QV_OK);
    assert_int_equal(qv_splat_block(&f->target, splats, &f->volume, &f->attenuation, 0, &splat_all),
                     QV_OK);
}

/* A voxel by itself. */
static inline qv_freevoxel splat_voxel(const splat_fixture *f, unsigned index)
{
    const qv_freevoxel voxel = {f->voxels + 4 * index,
                                f->bytes + QV_DIRECTIONS * index,
                                {(uint16_t)(index % SIDE), (uint16_t)(index / SIDE % SIDE),
                                 (uint16_t)(index / SIDE / SIDE)},
                                0};
    return voxel;
}

#endif /* QV_SPLAT_FIXTURE_H */
