/*
 * bench_device.c - pictures of each storage and sampling mode, each a region of the
 * emulator's count; prints what was in it, one line a region:
 *     STORAGE MODE SCENE RAYS SAMPLES SKIPPED
 * In the scene "full" no sample can be skipped, in "sparse" most are; "fine" is "full" with
 * twice the samples on the same rays. So the difference of the two is what samples cost
 * inside a ray, and what "full" costs beyond its samples belongs to rays.
 */
#include <stdbool.h>
#include "bench_modes.h"
#include "measure.h"
#include "console.h"
#include "access.h"

/* Rays through the middle of a cube, so that few samples lie in its outermost half voxel, where
   cells are clamped. */
enum { EDGE = 10, VOXELS = EDGE * EDGE * EDGE, WIDTH = 8, HEIGHT = 8 };

/* Four times two entries of 8 bits or one of 16, the same in either byte order: of thin opacity,
   so that no ray ends early, and without a byte, hence an index, of 0. */
#define VOXEL     0x035A5A03, 0x03030303
#define FIVE(...) __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__, __VA_ARGS__
#define TEN(...)  FIVE(__VA_ARGS__), FIVE(__VA_ARGS__)

#ifndef FLASH_VOLUME /* where flash is read as RAM is */
#define FLASH_VOLUME
#define FLASH_ADDRESS(object) ((qv_address) & (object))
#endif

static const uint32_t full[2 * VOXELS] FLASH_VOLUME = {TEN(TEN(TEN(VOXEL)))};
/* Clear above the lowest slice; and indices that are. */
static const uint32_t sparse[2 * VOXELS] FLASH_VOLUME = {TEN(TEN(VOXEL))};
static const uint32_t sparse_indices[VOXELS / 4] FLASH_VOLUME = {FIVE(FIVE(0x5A5A5A5A))};
/* Clear for index 0, thin for those that voxels hold. */
static const uint32_t palette[2 * QV_PALETTE_ENTRIES] FLASH_VOLUME = {0, 0, TEN(TEN(VOXEL))};

static uint8_t pixels[HEIGHT][WIDTH * 2];

typedef struct picture {
    const char *name;
    bool sparse;
    uint32_t step;
} picture;

/* Rays of about 40 samples, and of 80. */
static const picture pictures[] = {
    {"full", false, QV_ONE_Q16 / 4},
    {"sparse", true, QV_ONE_Q16 / 4},
    {"fine", false, QV_ONE_Q16 / 8},
};

static qv_address voxels_of(bool indexed, bool is_sparse)
{
    if (!is_sparse)
        return FLASH_ADDRESS(full);
    return indexed ? FLASH_ADDRESS(sparse_indices) : FLASH_ADDRESS(sparse);
}

static void make_volume(qv_volume *volume, qv_storage storage, bool is_sparse)
{
    bool indexed = storage == QV_STORAGE_INDEXED8 || storage == QV_STORAGE_INDEXED8_16 ||
                   storage == QV_STORAGE_INDEXED8_T8 || storage == QV_STORAGE_INDEXED8_T16;
    bool wide = storage % 2 == 0;
    int32_t bytes = indexed ? 1 : wide ? 8 : 4;
    *volume = (qv_volume){
        .voxels = voxels_of(indexed, is_sparse),
        .voxels_bytes = (uint32_t)VOXELS * (uint32_t)bytes,
        .stride = {bytes, bytes * EDGE, bytes * EDGE * EDGE},
        .size = {EDGE, EDGE, EDGE},
        .storage = (uint8_t)storage,
    };
    if (indexed) {
        volume->palette = FLASH_ADDRESS(palette);
        volume->palette_bytes = wide ? QV_PALETTE16_BYTES : QV_PALETTE8_BYTES;
    }
}

static qv_status make_context(qv_context *context, const bench_mode *m, const picture *of)
{
    qv_scene scene = {.sampling = m->sampling};
    qv_view view = {.pitch = QV_ONE_Q16 / 2, .step = of->step, .width = WIDTH, .height = HEIGHT};
    make_volume(&scene.volume, (qv_storage)QV_FIELD(m->sampling, storage), of->sparse);
    if (QV_FIELD(m->sampling, by_length)) {
        scene.volume.unit_distance = QV_ONE_Q16;
        scene.volume.extinction = QV_ONE_Q16;
    }
    qv_rotation(view.rotation, 0x0C000000u, 0x08000000u, 0);
    qv_status status = qv_orthographic(&scene.camera, &scene.volume, &view);
    return status == QV_OK ? qv_init(context, &scene) : status;
}

static void print_number(uint32_t number)
{
    console_text(" ");
    console_decimal(number);
}

static void print_line(const bench_mode *m, const picture *of, const qv_progress *progress)
{
    console_text(m->storage);
    console_text(" ");
    console_text(m->name);
    console_text(" ");
    console_text(of->name);
    print_number(WIDTH * HEIGHT);
    print_number((uint32_t)progress->samples);
    print_number((uint32_t)progress->skipped);
    console_text("\n");
}

static qv_status measure(const bench_mode *m, const picture *of)
{
    static qv_context context;
    static const qv_rect frame = {0, 0, WIDTH, HEIGHT};
    const qv_image image = {pixels, sizeof pixels, sizeof pixels[0], &qv_format_rgb565_le};
    qv_progress progress = {0};
    qv_status status = make_context(&context, m, of);
    if (status != QV_OK)
        return status;
    measure_begin();
    status = qv_render_some(&image, &progress, &context, &frame, WIDTH * HEIGHT);
    measure_end();
    print_line(m, of, &progress);
    return status;
}

int main(void)
{
    qv_status status = QV_OK;
    for (uint32_t i = 0; i < bench_mode_count; i++)
        for (uint32_t p = 0; p < sizeof pictures / sizeof *pictures && status == QV_OK; p++)
            status = measure(&bench_modes[i], &pictures[p]);
    if (status != QV_OK) {
        console_text(qv_status_text(status));
        console_text("\n");
    }
    return status != QV_OK;
}
