/*
 * firmware_ball.c - a picture of FreeVoxels on a device: voxels and their bytes of attenuation
 * stay in program memory, sums of a few rows of pixels in RAM. A lamp casts the ball's shadow
 * into the fog. The same program for every board.
 *
 * Three regions are measured: the frame in strips, by blocks of voxels; the same from a stream of
 * voxels along a Hilbert curve, which makes the same picture; and the attenuation of one direction.
 * Prints what each leaves, by checksum.
 */
#include "ball.h"
#include "console.h"
#include "crc32.h"
#include "measure.h"

enum { WIDTH = 32, HEIGHT = 32, STRIP = 8, STRIP_SUMS = STRIP * WIDTH * QV_SUM_CHANNELS };

#define FIELD_OF_VIEW 0x1C71C71Cu /* 40 degrees */
#define AZIMUTH       0x15555555u /* 30 degrees */
#define ELEVATION     0x0E38E38Eu /* 20 degrees */

/* The direction that is built: (1, 1, 1). */
enum { CORNER = QV_DIRECTIONS - 1 };

static union {
    uint32_t sums[STRIP_SUMS];
    uint8_t bytes[BALL_VOXELS];
} memory;

static uint8_t strip[STRIP][WIDTH][3];
static qv_volume volume;
static qv_attenuation attenuation;
static qv_splats splats;

static qv_status start(void)
{
    qv_splat_scene scene = {.splatting = &qv_splatting_added,
                            .kernel = &qv_kernel_quadratic,
                            .domain = &qv_domain_extinction,
                            .directions = QV_DIRECTIONS_ALL,
                            .field_of_view = FIELD_OF_VIEW,
                            .background = {10, 12, 20, 255},
                            .lighting = {.lamps = {{{-4, -3, 5}, {65535, 65535, 65535}}},
                                         .count = 1,
                                         .ambient = {16384, 16384, 16384}},
                            .view = {.pitch = QV_ONE_Q16 / 2, .width = WIDTH, .height = HEIGHT}};
    ball_volume(&volume);
    ball_attenuation(&attenuation);
    scene.volume = volume;
    qv_rotation(scene.view.rotation, AZIMUTH, ELEVATION, 0);
    return qv_splat_init(&splats, &scene);
}

static qv_status add_block(const qv_sums *sums)
{
    static const qv_block whole = {{0, 0, 0}, {BALL_SIZE, BALL_SIZE, BALL_SIZE}};
    return qv_splat_block(sums, &splats, &volume, &attenuation, 0, &whole);
}

/* The voxel with the next index on the curve. */
static int next_voxel(void *user, qv_freevoxel *voxel)
{
    uint16_t *index = user;
    if (*index == BALL_VOXELS)
        return 0;
    if (qv_order_position(voxel->position, &qv_order_hilbert, volume.size, (*index)++) != QV_OK)
        return QV_ERROR_SIZE;
    uint16_t place = (uint16_t)(voxel->position[0] + BALL_SIZE * voxel->position[1] +
                                BALL_SIZE * BALL_SIZE * voxel->position[2]);
    voxel->voxel = volume.voxels + place;
    voxel->attenuation = qv_attenuation_at(&attenuation, voxel->position);
    voxel->level = 0;
    return 1;
}

static qv_status add_stream(const qv_sums *sums)
{
    uint16_t index = 0;
    return qv_splat_stream(sums, &splats, next_voxel, &index);
}

/* A strip from the first row on, and into the checksum. */
static qv_status draw_strip(uint32_t *checksum, int32_t top, qv_status (*add)(const qv_sums *))
{
    const qv_sums sums = {memory.sums, STRIP_SUMS, {0, top, WIDTH, top + STRIP}};
    const qv_image image = {strip, sizeof strip, sizeof strip[0], &qv_format_rgb888};
    qv_status status = qv_sums_clear(&sums, &splats);
    if (status == QV_OK)
        status = add(&sums);
    if (status == QV_OK)
        status = qv_sums_read_out(&image, &sums, &splats);
    *checksum = crc32_update(*checksum, strip, sizeof strip);
    return status;
}

static qv_status draw(uint32_t *checksum, qv_status (*add)(const qv_sums *))
{
    qv_status status = QV_OK;
    for (int32_t top = 0; top < HEIGHT && status == QV_OK; top += STRIP)
        status = draw_strip(checksum, top, add);
    return status;
}

static qv_status draw_block(uint32_t *checksum)
{
    return draw(checksum, add_block);
}

static qv_status draw_stream(uint32_t *checksum)
{
    return draw(checksum, add_stream);
}

/* The bytes of one direction, from the voxels in program memory into RAM. */
static qv_status attenuate(uint32_t *checksum)
{
    const qv_attenuation one = {.directions = (uint32_t)1 << CORNER,
                                .size = {BALL_SIZE, BALL_SIZE, BALL_SIZE}};
    qv_status status = qv_attenuate(memory.bytes, sizeof memory.bytes, NULL, &one, &volume,
                                    &qv_domain_extinction, CORNER);
    *checksum = crc32_update(0, memory.bytes, sizeof memory.bytes);
    return status;
}

static qv_status measure(const char *what, qv_status (*run)(uint32_t *checksum))
{
    uint32_t checksum = 0;
    measure_begin();
    qv_status status = run(&checksum);
    measure_end();
    console_text(what);
    if (status != QV_OK)
        console_text("failed");
    else
        console_decimal(checksum);
    console_text("\n");
    return status;
}

int main(void)
{
    qv_status status = start();
    if (status == QV_OK)
        status = measure("block ", draw_block);
    if (status == QV_OK)
        status = measure("stream ", draw_stream);
    if (status == QV_OK)
        status = measure("attenuation ", attenuate);
    return status != QV_OK;
}
