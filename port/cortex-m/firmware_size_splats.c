/*
 * firmware_size_splats.c - the smallest useful firmware of splats, reported beside those of
 * firmware_size.c: one storage, one kernel, one pixel format; orthographic, between directions.
 *
 * Voxels and their bytes of attenuation count as made elsewhere. Each call into the library is
 * one region of the counting plugin.
 */
#include "measure.h"
#include "console.h"
#include "qvol.h"

enum { EDGE = 8, VOXELS = EDGE * EDGE * EDGE, WIDTH = 16, HEIGHT = 8 };

/* The directions between which light comes to the view below: (0, -1, 0), (1, -1, 0), (1, -1, 1). */
enum { DIRECTIONS = 3 };

#define DIRECTION_SET ((uint32_t)1 << 10 | (uint32_t)1 << 11 | (uint32_t)1 << 19)
#define AZIMUTH       0x15000000u
#define ELEVATION     0x0A000000u

static uint8_t voxels[VOXELS];
static uint8_t palette[QV_PALETTE_ENTRIES][4];
static uint8_t attenuation_bytes[VOXELS][DIRECTIONS];
static uint32_t sums[HEIGHT * WIDTH * QV_SUM_CHANNELS];
static uint8_t pixels[HEIGHT][WIDTH * 2];

/* Empty, thin and opaque voxels, in the light and in the shade. */
static void make_volume(void)
{
    for (uint32_t i = 0; i < VOXELS; i++) {
        voxels[i] = (uint8_t)(i * 97 >> 3);
        for (uint32_t d = 0; d < DIRECTIONS; d++)
            attenuation_bytes[i][d] = (uint8_t)(255 - (i * 31 >> 4) % 256);
    }
    for (uint32_t i = 0; i < QV_PALETTE_ENTRIES; i++) {
        palette[i][0] = (uint8_t)i;
        palette[i][1] = (uint8_t)(255 - i);
        palette[i][2] = 128;
        palette[i][3] = (uint8_t)(i < 64 ? 0 : i);
    }
}

static void describe(qv_splat_scene *scene)
{
    *scene = (qv_splat_scene){
        .splatting = &qv_splatting_added,
        .kernel = &qv_kernel_quadratic,
        .domain = &qv_domain_extinction,
        .directions = DIRECTION_SET,
        .background = {32, 64, 96, 255},
        .view = {.pitch = QV_ONE_Q16, .width = WIDTH, .height = HEIGHT},
        .volume = {.voxels = voxels,
                   .palette = palette[0],
                   .voxels_bytes = VOXELS,
                   .palette_bytes = QV_PALETTE8_BYTES,
                   .stride = {1, EDGE, EDGE * EDGE},
                   .size = {EDGE, EDGE, EDGE},
                   .storage = QV_STORAGE_INDEXED8},
    };
    qv_rotation(scene->view.rotation, AZIMUTH, ELEVATION, 0);
}

/* Returns the first error. */
static qv_status draw(void)
{
    static qv_splats splats;
    static qv_splat_scene scene;
    const qv_attenuation attenuation = {.records = attenuation_bytes[0],
                                        .bytes = sizeof attenuation_bytes,
                                        .directions = DIRECTION_SET,
                                        .size = {EDGE, EDGE, EDGE}};
    const qv_sums frame = {sums, sizeof sums / sizeof *sums, {0, 0, WIDTH, HEIGHT}};
    const qv_block whole = {{0, 0, 0}, {EDGE, EDGE, EDGE}};
    const qv_image image = {pixels, sizeof pixels, sizeof pixels[0], &qv_format_rgb565_le};
    describe(&scene);

    measure_begin();
    qv_status status = qv_splat_init(&splats, &scene);
    measure_end();
    if (status == QV_OK)
        status = qv_sums_clear(&frame, &splats);
    if (status != QV_OK)
        return status;
    measure_begin();
    status = qv_splat_block(&frame, &splats, &scene.volume, &attenuation, 0, &whole);
    measure_end();
    if (status != QV_OK)
        return status;
    measure_begin();
    status = qv_sums_read_out(&image, &frame, &splats);
    measure_end();
    return status;
}

int main(void)
{
    make_volume();
    console_text("context ");
    console_decimal(sizeof(qv_splats));
    console_text("\n");
    return -(int)draw();
}
