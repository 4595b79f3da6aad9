/*
 * firmware_size.c - one storage, one sampling mode, one pixel format: the program
 * whose flash, RAM and stack `make size` reports.
 *
 * Each call into the library is one region of the counting plugin.
 */
#include "firmware_size.h"
#include "measure.h"
#include "console.h"

enum { EDGE = 8, VOXELS = EDGE * EDGE * EDGE, WIDTH = 16, HEIGHT = 16 };

static uint8_t voxels[VOXELS];
static uint8_t palette[QV_PALETTE_ENTRIES][4];
static uint8_t pixels[HEIGHT][WIDTH * 2];

/* A volume with empty, thin and opaque voxels, so that a ray takes every path. */
static void make_volume(void)
{
    for (uint32_t i = 0; i < VOXELS; i++)
        voxels[i] = (uint8_t)(i * 97 >> 3);
    for (uint32_t i = 0; i < QV_PALETTE_ENTRIES; i++) {
        palette[i][0] = (uint8_t)i;
        palette[i][1] = (uint8_t)(255 - i);
        palette[i][2] = 128;
        palette[i][3] = (uint8_t)(i < 64 ? 0 : i);
    }
}

static void make_scene(qv_scene *scene, qv_view *view)
{
    *scene = (qv_scene){
        .volume = {.voxels = voxels,
                   .palette = palette[0],
                   .voxels_bytes = VOXELS,
                   .palette_bytes = QV_PALETTE8_BYTES,
                   .stride = {1, EDGE, EDGE * EDGE},
                   .size = {EDGE, EDGE, EDGE},
                   .storage = QV_STORAGE_INDEXED8},
        .sampling = &qv_weighted_indexed8,
        .termination = QV_TERMINATION_DEFAULT,
        .background = {32, 64, 96, 255},
    };
    *view = (qv_view){.pitch = QV_ONE_Q16, .step = QV_ONE_Q16, .width = WIDTH, .height = HEIGHT};
}

/* Returns the first error. */
static qv_status draw(void)
{
    static qv_context context;
    qv_scene scene;
    qv_view view;
    const qv_image image = {pixels, sizeof pixels, sizeof pixels[0], &qv_format_rgb565_le};
    const qv_rect frame = {0, 0, WIDTH, HEIGHT};
    make_scene(&scene, &view);

    measure_begin();
    qv_rotation(view.rotation, 0x15000000u, 0x0A000000u, 0);
    measure_end();
    measure_begin();
    qv_status status = size_camera(&scene.camera, &scene.volume, &view);
    measure_end();
    if (status != QV_OK)
        return status;
    measure_begin();
    status = qv_init(&context, &scene);
    measure_end();
    if (status != QV_OK)
        return status;
    measure_begin();
    status = qv_render(&image, &context, &frame);
    measure_end();
    return status;
}

int main(void)
{
    make_volume();
    console_text("context ");
    console_decimal(sizeof(qv_context));
    console_text("\n");
    return -(int)draw();
}
