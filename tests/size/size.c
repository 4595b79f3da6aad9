/*
 * size.c - the frame of all programs of size.h: runs what they use, and prints the bytes of
 * the state that the library wants of its caller.
 */
#include "size.h"
#include "console.h"

uint8_t size_memory[SIZE_MEMORY];
qv_context size_context;
const qv_rect size_frame = {0, 0, SIZE_WIDTH, SIZE_HEIGHT};

static uint32_t context_bytes, scratch_bytes;

void size_context_bytes(size_t bytes)
{
    context_bytes += (uint32_t)bytes;
}

void size_scratch_bytes(size_t bytes)
{
    scratch_bytes = bytes > scratch_bytes ? (uint32_t)bytes : scratch_bytes;
}

static void print_figure(const char *name, uint32_t bytes)
{
    console_text(name);
    console_decimal(bytes);
    console_text("\n");
}

void size_scene(qv_scene *scene, qv_view *view, const qv_sampling *sampling)
{
    *scene = (qv_scene){.sampling = sampling,
                        .termination = QV_TERMINATION_DEFAULT,
                        .background = {32, 64, 96, 255}};
    *view = (qv_view){
        .pitch = QV_ONE_Q16 / 2, .step = QV_ONE_Q16, .width = SIZE_WIDTH, .height = SIZE_HEIGHT};
    volume_describe(&scene->volume);
    measure_begin();
    qv_rotation(view->rotation, 0x15000000u, 0x0A000000u, 0);
    measure_end();
}

qv_status size_render(const qv_scene *scene)
{
    const qv_image image = {size_memory, SIZE_MEMORY, SIZE_WIDTH * 2, &qv_format_rgb565_le};
    qv_status status = QV_OK;
    SIZE_CALL(status, qv_init(&size_context, scene));
    SIZE_CALL(status, qv_render(&image, &size_context, &size_frame));
    return status;
}

int main(void)
{
    qv_status status = QV_OK;
    size_context_bytes(sizeof size_context); /* which all that cast rays share */
    for (size_use *const *use = size_uses; *use != NULL && status == QV_OK; use++)
        status = (*use)();
    print_figure("context ", context_bytes);
    print_figure("scratch ", scratch_bytes);
    return -(int)status;
}
