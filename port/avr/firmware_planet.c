/*
 * firmware_planet.c - a planet in fog: 34 KB of volume stay in program memory, the frame buffer
 * of 8 bits a channel takes three quarters of the RAM. Half of the fog has less than 1/255 of
 * opacity for a slice, which a blend of 8 bits keeps by its dither alone.
 *
 * Two regions are measured: some rows ray by ray, then the whole frame slice by slice. Prints
 * what each leaves in the frame buffer, by checksum.
 */
#include "planet.h"
#include "console.h"
#include "crc32.h"
#include "measure.h"

/* Rows that are rendered by rays: through the middle of the planet. */
enum { RAYS_TOP = 28, RAYS_BOTTOM = 36 };

uint8_t planet_frame[PLANET_HEIGHT][PLANET_WIDTH][3];

static qv_context context;

static const qv_rect all = {0, 0, PLANET_WIDTH, PLANET_HEIGHT};

static void describe(qv_volume *volume)
{
    volume->voxels = planet_voxels();
    volume->voxels_bytes = PLANET_VOXELS;
    volume->palette = planet_palette();
    volume->palette_bytes = QV_PALETTE16_BYTES;
    volume->storage = QV_STORAGE_INDEXED8_16;
    int32_t stride = 1;
    for (unsigned axis = 0; axis < 3; axis++) {
        volume->size[axis] = PLANET_SIZE;
        volume->stride[axis] = stride;
        stride *= PLANET_SIZE;
    }
}

static qv_status make_context(void)
{
    qv_scene scene = {.sampling = &qv_weighted_indexed8_16};
    qv_view view = {.pitch = QV_ONE_Q16 / 2,
                    .step = QV_ONE_Q16,
                    .width = PLANET_WIDTH,
                    .height = PLANET_HEIGHT};
    describe(&scene.volume);
    qv_rotation(view.rotation, 0, 0x08888889 /* 12 degrees */, 0);
    qv_status status = qv_orthographic(&scene.camera, &scene.volume, &view);
    return status == QV_OK ? qv_init(&context, &scene) : status;
}

static qv_status render_rays(void)
{
    const qv_image image = {planet_frame[RAYS_TOP],
                            sizeof planet_frame[0] * (RAYS_BOTTOM - RAYS_TOP),
                            sizeof planet_frame[0], &qv_format_rgb888};
    const qv_rect rows = {0, RAYS_TOP, PLANET_WIDTH, RAYS_BOTTOM};
    return qv_render(&image, &context, &rows);
}

static qv_status render_slices(void)
{
    const qv_buffer buffer = {.pixels = planet_frame,
                              .bytes = sizeof planet_frame,
                              .stride = sizeof planet_frame[0],
                              .blend = &qv_over_rgb888};
    const qv_dither dither = {.sequence = qv_sequence_blocks};
    int32_t first, end;
    qv_status status = qv_slice_range(&first, &end, &context, &all);
    if (status == QV_OK)
        status = qv_clear(&buffer, &context, &all);
    for (int32_t slice = end; status == QV_OK && slice-- > first;)
        status = qv_slice(&buffer, &dither, &context, &all, slice);
    return status;
}

static void report(const char *what, qv_status status)
{
    console_text(what);
    if (status != QV_OK)
        console_text(" failed");
    else
        console_hexadecimal(crc32_update(0, planet_frame, sizeof planet_frame));
    console_text("\n");
}

static qv_status measure(const char *what, qv_status (*render)(void))
{
    measure_begin();
    qv_status status = render();
    measure_end();
    report(what, status);
    return status;
}

int main(void)
{
    qv_status status = make_context();
    if (status == QV_OK)
        status = measure("rays ", render_rays);
    if (status == QV_OK)
        status = measure("slices ", render_slices);
    return status != QV_OK;
}
