/*
 * freevoxels.c - FreeVoxels: the bytes of one direction and of a coarser level are made, and the
 * volume, whose bytes lie in program memory, is drawn as splats, lit by a lamp.
 */
#include "size.h"

#define FIELD_OF_VIEW 0x1C71C71Cu /* 40 degrees */

enum { SUMS = SIZE_WIDTH * SIZE_HEIGHT * QV_SUM_CHANNELS };

/* The direction that is made: (1, 1, 1); of level 1, one direction of all voxels. */
enum { CORNER = QV_DIRECTIONS - 1, LEVEL_SIZE = VOLUME_EDGE / 2 + 1 };
enum { BLOCKS = LEVEL_SIZE * LEVEL_SIZE * LEVEL_SIZE };

/* What each step needs alone. */
static union {
    uint32_t sums[SUMS];
    uint32_t blocks[BLOCKS];
} memory;

static qv_status make_attenuation(const qv_volume *volume)
{
    const qv_attenuation fine = {.directions = (uint32_t)1 << CORNER,
                                 .size = {VOLUME_EDGE, VOLUME_EDGE, VOLUME_EDGE}};
    const qv_attenuation coarse = {.directions = (uint32_t)1 << CORNER,
                                   .size = {LEVEL_SIZE, LEVEL_SIZE, LEVEL_SIZE}};
    qv_status status = QV_OK;
    SIZE_CALL(status, qv_attenuate(size_memory, VOLUME_VOXELS, memory.blocks, &fine, volume,
                                   &qv_domain_extinction, CORNER));
    SIZE_CALL(status, qv_attenuate_level(size_memory, BLOCKS, &coarse, memory.blocks, volume->size,
                                         1, CORNER));
    return status;
}

static void describe(qv_splat_scene *scene, const qv_volume *volume)
{
    *scene = (qv_splat_scene){
        .splatting = &qv_splatting_added,
        .kernel = &qv_kernel_quadratic,
        .domain = &qv_domain_extinction,
        .directions = QV_DIRECTIONS_ALL,
        .field_of_view = FIELD_OF_VIEW,
        .background = {10, 12, 20, 255},
        .lighting = {.lamps = {{{-4, -3, 5}, {65535, 65535, 65535}}},
                     .count = 1,
                     .ambient = {16384, 16384, 16384}},
        .view = {.pitch = QV_ONE_Q16 / 2, .width = SIZE_WIDTH, .height = SIZE_HEIGHT},
        .volume = *volume};
    qv_rotation(scene->view.rotation, 0x15555555u, 0x0E38E38Eu, 0);
}

static qv_status draw(const qv_splats *splats, const qv_volume *volume)
{
    static const qv_block whole = {{0, 0, 0}, {VOLUME_EDGE, VOLUME_EDGE, VOLUME_EDGE}};
    const qv_sums sums = {memory.sums, SUMS, {0, 0, SIZE_WIDTH, SIZE_HEIGHT}};
    const qv_image image = {size_memory, SIZE_MEMORY, SIZE_WIDTH * 2, &qv_format_rgb565_le};
    qv_attenuation attenuation;
    qv_status status = QV_OK;
    volume_attenuation(&attenuation);
    SIZE_CALL(status, qv_sums_clear(&sums, splats));
    SIZE_CALL(status, qv_splat_block(&sums, splats, volume, &attenuation, 0, &whole));
    SIZE_CALL(status, qv_sums_read_out(&image, &sums, splats));
    return status;
}

qv_status use_freevoxels(void)
{
    static qv_splats splats;
    static qv_splat_scene scene;
    qv_volume volume;
    volume_describe(&volume);
    size_context_bytes(sizeof splats);
    size_scratch_bytes(sizeof memory);
    describe(&scene, &volume);
    qv_status status = make_attenuation(&volume);
    SIZE_CALL(status, qv_splat_init(&splats, &scene));
    return status == QV_OK ? draw(&splats, &volume) : status;
}
