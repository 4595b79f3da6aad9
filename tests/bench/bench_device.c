/*
 * bench_device.c - one picture for each storage and sampling mode, each a region
 * of the counting plugin; prints what was in it, one line a region:
 *     STORAGE MODE SCENE SAMPLES SKIPPED
 * In the scene "full" no sample can be skipped, in "sparse" most are.
 */
#include <stdbool.h>
#include "measure.h"
#include "qvol.h"
#include "console.h"

/* The largest cube of 8-byte voxels that leaves room on 16 KB of RAM. */
enum { EDGE = 10, VOXELS = EDGE * EDGE * EDGE, WIDTH = 16, HEIGHT = 16 };

/* Opacities of 16 bits. Thin, so that no ray ends early. */
enum { THIN = 0x0300, CLEAR = 0 };

typedef struct mode {
    const char *storage;
    const char *name;
    const qv_sampling *sampling;
} mode;

static const mode modes[] = {
    {"rgba8", "nearest", &qv_nearest_rgba8},
    {"rgba8", "separate", &qv_separate_rgba8},
    {"rgba8", "weighted", &qv_weighted_rgba8},
    {"rgba8", "corrected", &qv_corrected_rgba8},
    {"rgba8", "extinction", &qv_extinction_rgba8},
    {"rgba8", "bspline_weighted", &qv_bspline_weighted_rgba8},
    {"rgba8", "bspline_extinction", &qv_bspline_extinction_rgba8},
    {"rgba16", "nearest", &qv_nearest_rgba16},
    {"rgba16", "separate", &qv_separate_rgba16},
    {"rgba16", "weighted", &qv_weighted_rgba16},
    {"rgba16", "corrected", &qv_corrected_rgba16},
    {"rgba16", "extinction", &qv_extinction_rgba16},
    {"rgba16", "bspline_weighted", &qv_bspline_weighted_rgba16},
    {"rgba16", "bspline_extinction", &qv_bspline_extinction_rgba16},
    {"indexed8", "nearest", &qv_nearest_indexed8},
    {"indexed8", "separate", &qv_separate_indexed8},
    {"indexed8", "weighted", &qv_weighted_indexed8},
    {"indexed8", "corrected", &qv_corrected_indexed8},
    {"indexed8", "extinction", &qv_extinction_indexed8},
    {"indexed8", "bspline_weighted", &qv_bspline_weighted_indexed8},
    {"indexed8", "bspline_extinction", &qv_bspline_extinction_indexed8},
    {"indexed8_16", "nearest", &qv_nearest_indexed8_16},
    {"indexed8_16", "separate", &qv_separate_indexed8_16},
    {"indexed8_16", "weighted", &qv_weighted_indexed8_16},
    {"indexed8_16", "corrected", &qv_corrected_indexed8_16},
    {"indexed8_16", "extinction", &qv_extinction_indexed8_16},
    {"indexed8_16", "bspline_weighted", &qv_bspline_weighted_indexed8_16},
    {"indexed8_16", "bspline_extinction", &qv_bspline_extinction_indexed8_16},
    {"rgbt8", "extinction", &qv_extinction_rgbt8},
    {"rgbt8", "bspline_extinction", &qv_bspline_extinction_rgbt8},
    {"rgbt16", "extinction", &qv_extinction_rgbt16},
    {"rgbt16", "bspline_extinction", &qv_bspline_extinction_rgbt16},
    {"indexed8_t8", "extinction", &qv_extinction_indexed8_t8},
    {"indexed8_t8", "bspline_extinction", &qv_bspline_extinction_indexed8_t8},
    {"indexed8_t16", "extinction", &qv_extinction_indexed8_t16},
    {"indexed8_t16", "bspline_extinction", &qv_bspline_extinction_indexed8_t16},
};

static uint16_t voxels[VOXELS * 4];
static union {
    uint8_t rgba8[QV_PALETTE_ENTRIES][4];
    uint16_t rgba16[QV_PALETTE_ENTRIES][4];
} palette;
static uint8_t pixels[HEIGHT][WIDTH * 2];

/* In the sparse scene only the lowest slice can be seen. */
static uint16_t opacity(uint32_t voxel, bool sparse)
{
    return sparse && voxel >= EDGE * EDGE ? CLEAR : THIN;
}

static bool has_16_bits(qv_storage storage)
{
    return storage % 2 == 0;
}

static uint32_t fill_direct(qv_storage storage, bool sparse)
{
    uint8_t *bytes = (uint8_t *)voxels;
    for (uint32_t i = 0; i < VOXELS * 4; i++) {
        uint16_t value = i % 4 == 3 ? opacity(i / 4, sparse) : (uint16_t)(i * 977);
        if (has_16_bits(storage))
            voxels[i] = value;
        else
            bytes[i] = (uint8_t)(value >> 8);
    }
    return has_16_bits(storage) ? 8 : 4;
}

static uint32_t fill_indexed(qv_storage storage, bool sparse)
{
    uint8_t *bytes = (uint8_t *)voxels;
    for (uint32_t i = 0; i < VOXELS; i++)
        bytes[i] = opacity(i, sparse) == CLEAR ? 0 : (uint8_t)(1 + i % 255);
    for (uint32_t i = 0; i < QV_PALETTE_ENTRIES * 4; i++) {
        uint16_t value = i % 4 != 3 ? (uint16_t)(i * 977) : i < 4 ? CLEAR : THIN;
        if (has_16_bits(storage))
            palette.rgba16[i / 4][i % 4] = value;
        else
            palette.rgba8[i / 4][i % 4] = (uint8_t)(value >> 8);
    }
    return 1;
}

static void make_volume(qv_volume *volume, qv_storage storage, bool sparse)
{
    bool indexed = storage == QV_STORAGE_INDEXED8 || storage == QV_STORAGE_INDEXED8_16 ||
                   storage == QV_STORAGE_INDEXED8_T8 || storage == QV_STORAGE_INDEXED8_T16;
    uint32_t bytes = indexed ? fill_indexed(storage, sparse) : fill_direct(storage, sparse);
    *volume = (qv_volume){
        .voxels = (qv_address)voxels,
        .voxels_bytes = VOXELS * bytes,
        .stride = {(int32_t)bytes, (int32_t)bytes * EDGE, (int32_t)bytes * EDGE * EDGE},
        .size = {EDGE, EDGE, EDGE},
        .storage = (uint8_t)storage,
    };
    if (indexed) {
        volume->palette = (qv_address)&palette;
        volume->palette_bytes = has_16_bits(storage) ? QV_PALETTE16_BYTES : QV_PALETTE8_BYTES;
    }
}

/* Rays of about 40 samples through the whole frame. */
static qv_status make_context(qv_context *context, const mode *m, bool sparse)
{
    qv_scene scene = {.sampling = m->sampling};
    qv_view view = {
        .pitch = QV_ONE_Q16 / 2, .step = QV_ONE_Q16 / 4, .width = WIDTH, .height = HEIGHT};
    make_volume(&scene.volume, (qv_storage)m->sampling->storage, sparse);
    if (m->sampling->prepare != qv_nearest_rgba8.prepare) { /* a mode that weighs by length */
        scene.volume.unit_distance = QV_ONE_Q16;
        scene.volume.extinction = QV_ONE_Q16;
    }
    qv_rotation(view.rotation, 0x0C000000u, 0x08000000u, 0);
    qv_status status = qv_orthographic(&scene.camera, &scene.volume, &view);
    return status == QV_OK ? qv_init(context, &scene) : status;
}

static void print_line(const mode *m, bool sparse, const qv_progress *progress)
{
    console_text(m->storage);
    console_text(" ");
    console_text(m->name);
    console_text(sparse ? " sparse " : " full ");
    console_decimal((uint32_t)progress->samples);
    console_text(" ");
    console_decimal((uint32_t)progress->skipped);
    console_text("\n");
}

static qv_status measure(const mode *m, bool sparse)
{
    static qv_context context;
    static const qv_rect frame = {0, 0, WIDTH, HEIGHT};
    const qv_image image = {pixels, sizeof pixels, sizeof pixels[0], &qv_format_rgb565_le};
    qv_progress progress = {0};
    qv_status status = make_context(&context, m, sparse);
    if (status != QV_OK)
        return status;
    measure_begin();
    status = qv_render_some(&image, &progress, &context, &frame, WIDTH * HEIGHT);
    measure_end();
    print_line(m, sparse, &progress);
    return status;
}

int main(void)
{
    for (uint32_t i = 0; i < sizeof modes / sizeof *modes; i++) {
        qv_status status = measure(&modes[i], false);
        if (status == QV_OK)
            status = measure(&modes[i], true);
        if (status != QV_OK) {
            console_text(qv_status_text(status));
            console_text("\n");
            return 1;
        }
    }
    return 0;
}
