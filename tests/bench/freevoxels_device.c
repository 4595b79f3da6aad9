/*
 * freevoxels_device.c - instructions of FreeVoxels: one measured region (port/measure.h) for
 * each subject, over the ball of port/ball.h; the first is empty. Prints a line for each:
 * name, what its instructions are divided by, pixels that it changed, and a checksum of the results,
 * which is the same on every machine; a bar between them.
 */
#include "ball.h"
#include "console.h"
#include "crc32.h"
#include "measure.h"

/* Frames of splats: of an even number of pixels, the volume's centre is the corner of four. */
enum { FRAME = 8, WIDE = 16, SUMS = WIDE * WIDE * QV_SUM_CHANNELS };

enum { CALLS = 4 }; /* of a splat in its region */

enum { SLICES = 2, LIT_BYTES = SLICES * BALL_SIZE * BALL_SIZE * 4 };

enum { LEVEL_SIZE = (BALL_SIZE + 1) / 2, BLOCKS = LEVEL_SIZE * LEVEL_SIZE * LEVEL_SIZE };

static union {
    uint32_t sums[SUMS];
    uint8_t bytes[BALL_VOXELS > LIT_BYTES ? BALL_VOXELS : LIT_BYTES];
} memory;

static uint32_t blocks[BLOCKS];
static qv_volume volume;
static qv_attenuation attenuation;
static qv_splats splats;

static void report(const char *name, qv_status status, uint32_t divisor, uint32_t pixels,
                   uint32_t checksum)
{
    console_text(name);
    console_text("|");
    console_decimal(divisor);
    console_text("|");
    console_decimal(pixels);
    console_text("|");
    if (status == QV_OK)
        console_decimal(checksum);
    else
        console_text(qv_status_text(status));
    console_text("\n");
}

/* The bytes of a number, the lowest first, whatever the machine. */
static uint32_t checksum_of(const uint32_t *numbers, uint32_t count)
{
    uint32_t checksum = 0;
    for (uint32_t i = 0; i < count; i++) {
        const uint8_t bytes[4] = {(uint8_t)numbers[i], (uint8_t)(numbers[i] >> 8),
                                  (uint8_t)(numbers[i] >> 16), (uint8_t)(numbers[i] >> 24)};
        checksum = crc32_update(checksum, bytes, sizeof bytes);
    }
    return checksum;
}

static void measure_nothing(void)
{
    measure_begin();
    measure_end();
    report("nothing", QV_OK, 1, 0, 0);
}

/* ---- Attenuation ------------------------------------------------------------ */

/* One direction of all voxels. */
static void measure_attenuation(const char *name, const qv_volume *of, const qv_order *order,
                                uint8_t direction, uint32_t *sums)
{
    const qv_attenuation one = {.order = order,
                                .directions = (uint32_t)1 << direction,
                                .size = {BALL_SIZE, BALL_SIZE, BALL_SIZE}};
    measure_begin();
    qv_status status =
        qv_attenuate(memory.bytes, BALL_VOXELS, sums, &one, of, &qv_domain_extinction, direction);
    measure_end();
    report(name, status, BALL_VOXELS, 0, crc32_update(0, memory.bytes, BALL_VOXELS));
}

/* A level from the blocks that the last direction left. */
static void measure_level(const char *name, uint8_t direction)
{
    const qv_attenuation one = {.directions = (uint32_t)1 << direction,
                                .size = {LEVEL_SIZE, LEVEL_SIZE, LEVEL_SIZE}};
    measure_begin();
    qv_status status =
        qv_attenuate_level(memory.bytes, BLOCKS, &one, blocks, volume.size, 1, direction);
    measure_end();
    report(name, status, BLOCKS, 0, crc32_update(0, memory.bytes, BLOCKS));
}

static void measure_attenuations(void)
{
    const uint8_t face = qv_direction(0, 0, 1), along = qv_direction(1, 0, 0);
    const uint8_t edge = qv_direction(0, 1, 1), corner = qv_direction(1, 1, 1);
    qv_volume clear = volume;
    clear.palette += BALL_CLEAR_AT - BALL_PALETTE_AT;
    measure_attenuation("direction along z", &volume, &qv_order_linear, face, NULL);
    measure_attenuation("direction along x", &volume, &qv_order_linear, along, NULL);
    measure_attenuation("direction along an edge", &volume, &qv_order_linear, edge, NULL);
    measure_attenuation("direction along a corner", &volume, &qv_order_linear, corner, NULL);
    measure_attenuation("direction along z, clear voxels", &clear, &qv_order_linear, face, NULL);
    measure_attenuation("direction along z, Morton order", &volume, &qv_order_morton, face, NULL);
    measure_attenuation("direction along z, Hilbert order", &volume, &qv_order_hilbert, face, NULL);
    measure_attenuation("direction along z, with blocks", &volume, &qv_order_linear, face, blocks);
    measure_level("voxel of level 1 from blocks", face);
}

/* ---- Splats ----------------------------------------------------------------- */

/* What tells one splat from another. */
typedef struct subject {
    const char *name;
    const qv_splatting *splatting;
    const qv_kernel *kernel;
    qv_angle field_of_view, azimuth, elevation;
    uint32_t pitch;
    uint8_t frame; /* pixels across and down */
    uint8_t interpolation, lamps;
    uint8_t place; /* of the voxel on each axis */
} subject;

#define NARROW    0x04000000u /* 6 degrees: so far away that a voxel is as wide as without an eye */
#define AZIMUTH   0x15555555u /* 30 degrees */
#define ELEVATION 0x0E38E38Eu /* 20 degrees */

enum { MIDDLE = BALL_SIZE / 2 };

static qv_status start(const subject *s)
{
    qv_splat_scene scene = {
        .splatting = s->splatting,
        .kernel = s->kernel,
        .domain = &qv_domain_extinction,
        .directions = QV_DIRECTIONS_ALL,
        .field_of_view = s->field_of_view,
        .interpolation = s->interpolation,
        .lighting = {.lamps = {{{-4, -3, 5}, {65535, 65535, 65535}}}, .count = s->lamps},
        .view = {.pitch = s->pitch, .width = s->frame, .height = s->frame},
        .volume = volume};
    qv_rotation(scene.view.rotation, s->azimuth, s->elevation, 0);
    return qv_splat_init(&splats, &scene);
}

static uint32_t count_changed(uint32_t pixels)
{
    uint32_t changed = 0;
    for (uint32_t i = 0; i < pixels; i++)
        changed += memory.sums[i * QV_SUM_CHANNELS + 3] != 0 ? 1 : 0;
    return changed;
}

static void measure_splat(const subject *s)
{
    const uint16_t pixels = (uint16_t)(s->frame * s->frame);
    const qv_sums sums = {memory.sums, SUMS, {0, 0, s->frame, s->frame}};
    qv_freevoxel voxel = {.position = {s->place, s->place, s->place}};
    uint16_t index = (uint16_t)(s->place * (1 + BALL_SIZE + BALL_SIZE * BALL_SIZE));
    voxel.voxel = volume.voxels + index;
    voxel.attenuation = qv_attenuation_at(&attenuation, voxel.position);
    qv_status status = start(s);
    if (status == QV_OK)
        status = qv_sums_clear(&sums, &splats);
    measure_begin();
    for (unsigned i = 0; i < CALLS && status == QV_OK; i++)
        status = qv_splat(&sums, &splats, &voxel);
    measure_end();
    report(s->name, status, CALLS, count_changed(pixels),
           checksum_of(memory.sums, QV_SUM_CHANNELS * pixels));
}

static void measure_splats(void)
{
    static const qv_splatting *const added = &qv_splatting_added, *const over = &qv_splatting_over;
    static const qv_kernel *const linear = &qv_kernel_linear, *const smooth = &qv_kernel_quadratic;
    const uint32_t one = QV_ONE_Q16;
    enum { LIGHT = QV_BETWEEN_LIGHT, DEPTHS = QV_BETWEEN_DEPTHS, NEAREST = QV_NEAREST };
    const subject subjects[] = {
        {"between", added, linear, 0, AZIMUTH, ELEVATION, 4 * one, FRAME - 1, LIGHT, 0, MIDDLE},
        {"between", added, linear, 0, AZIMUTH, ELEVATION, one, FRAME, LIGHT, 0, MIDDLE},
        {"between", added, linear, 0, AZIMUTH, ELEVATION, one / 2, FRAME, LIGHT, 0, MIDDLE},
        {"between depths", added, linear, 0, AZIMUTH, ELEVATION, one, FRAME, DEPTHS, 0, MIDDLE},
        {"nearest", added, linear, 0, AZIMUTH, ELEVATION, 4 * one, FRAME - 1, NEAREST, 0, MIDDLE},
        {"nearest", added, linear, 0, AZIMUTH, ELEVATION, one, FRAME, NEAREST, 0, MIDDLE},
        {"nearest", added, linear, 0, AZIMUTH, ELEVATION, one / 2, FRAME, NEAREST, 0, MIDDLE},
        {"between, quadratic", added, smooth, 0, AZIMUTH, ELEVATION, one, FRAME - 1, LIGHT, 0,
         MIDDLE},
        {"between, a lamp", added, linear, 0, AZIMUTH, ELEVATION, one, FRAME, LIGHT, 1, MIDDLE},
        {"over", over, linear, 0, AZIMUTH, ELEVATION, one, FRAME, LIGHT, 0, MIDDLE},
        {"between, eye", added, linear, NARROW, AZIMUTH, ELEVATION, one, FRAME, LIGHT, 0, MIDDLE},
        {"nearest, eye", added, linear, NARROW, AZIMUTH, ELEVATION, one, FRAME, NEAREST, 0, MIDDLE},
        {"beside the frame", added, linear, 0, AZIMUTH, ELEVATION, one / 8, FRAME, LIGHT, 0, 3},
        {"empty", added, linear, 0, AZIMUTH, ELEVATION, one, FRAME, LIGHT, 0, 0},
    };
    for (unsigned i = 0; i < sizeof subjects / sizeof *subjects; i++)
        measure_splat(&subjects[i]);
}

/* The whole ball at once, a voxel a pixel wide. */
static void measure_block(const char *name, qv_angle field_of_view)
{
    static const qv_block whole = {{0, 0, 0}, {BALL_SIZE, BALL_SIZE, BALL_SIZE}};
    const subject s = {name,
                       &qv_splatting_added,
                       &qv_kernel_linear,
                       field_of_view,
                       AZIMUTH,
                       ELEVATION,
                       QV_ONE_Q16,
                       WIDE,
                       0,
                       0,
                       MIDDLE};
    const qv_sums sums = {memory.sums, SUMS, {0, 0, WIDE, WIDE}};
    qv_status status = start(&s);
    if (status == QV_OK)
        status = qv_sums_clear(&sums, &splats);
    measure_begin();
    if (status == QV_OK)
        status = qv_splat_block(&sums, &splats, &volume, &attenuation, 0, &whole);
    measure_end();
    report(name, status, BALL_VOXELS, count_changed(WIDE * WIDE), checksum_of(memory.sums, SUMS));
}

/* ---- Light -------------------------------------------------------------------- */

static void measure_light(const char *name, uint8_t interpolation)
{
    static const qv_block slices = {{0, 0, MIDDLE}, {BALL_SIZE, BALL_SIZE, MIDDLE + SLICES}};
    const qv_lighting lighting = {.lamps = {{{-4, -3, 5}, {65535, 65535, 65535}}}, .count = 1};
    measure_begin();
    qv_status status = qv_illuminate(memory.bytes, LIT_BYTES, &volume, &attenuation, &lighting,
                                     interpolation, &slices);
    measure_end();
    report(name, status, LIT_BYTES / 4, 0, crc32_update(0, memory.bytes, LIT_BYTES));
}

int main(void)
{
    ball_volume(&volume);
    ball_attenuation(&attenuation);
    measure_nothing();
    measure_attenuations();
    measure_splats();
    measure_block("block", 0);
    measure_block("block, eye", NARROW);
    measure_light("voxel lit, between", QV_BETWEEN_LIGHT);
    measure_light("voxel lit, between depths", QV_BETWEEN_DEPTHS);
    measure_light("voxel lit, nearest", QV_NEAREST);
    console_text("context ");
    console_decimal(sizeof splats);
    console_text("\n");
    return 0;
}
