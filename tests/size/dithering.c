/*
 * dithering.c - slices into a frame buffer of 8 bits, dithered, and from there to the display.
 */
#include "size.h"

enum { BUFFER_BYTES = SIZE_WIDTH * SIZE_HEIGHT * 3 };

/* Draws what the context holds. */
static qv_status draw_slices(const qv_buffer *buffer)
{
    static const qv_dither dither = {.sequence = qv_sequence_blocks};
    int32_t first = 0, end = 0;
    qv_status status = QV_OK;
    SIZE_CALL(status, qv_slice_range(&first, &end, &size_context, &size_frame));
    SIZE_CALL(status, qv_clear(buffer, &size_context, &size_frame));
    while (status == QV_OK && end-- > first)
        SIZE_CALL(status, qv_slice(buffer, &dither, &size_context, &size_frame, end));
    return status;
}

/* The frame buffer lies behind the pixels that are read out of it. */
qv_status use_dithering(void)
{
    const qv_buffer buffer = {.pixels = size_memory + SIZE_MEMORY - BUFFER_BYTES,
                              .bytes = BUFFER_BYTES,
                              .stride = SIZE_WIDTH * 3,
                              .blend = &qv_over_rgb888};
    const qv_image image = {size_memory, SIZE_MEMORY - BUFFER_BYTES, SIZE_WIDTH * 2,
                            &qv_format_rgb565_le};
    size_scratch_bytes(BUFFER_BYTES);
    qv_status status = draw_slices(&buffer);
    SIZE_CALL(status, qv_read_out(&image, &buffer, &size_context, &size_frame));
    return status;
}
