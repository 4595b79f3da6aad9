#include "dma.h"

qv_status qvol_dma_show(const qvol_dma *dma, const qv_context *context, uint16_t *memory,
                        int32_t rows, int32_t width, int32_t height)
{
    const size_t bytes = sizeof *memory * (size_t)width * (size_t)rows;
    uint16_t *strip[2] = {memory, memory + width * rows};
    qv_status status = QV_OK;
    for (int32_t top = 0, turn = 0; top < height && status == QV_OK; top += rows, turn ^= 1) {
        const qv_rect rect = {0, top, width, top + rows < height ? top + rows : height};
        const qv_image image = {strip[turn], bytes, 2 * (ptrdiff_t)width, &qv_format_rgb565_be};
        status = qv_render(&image, context, &rect); /* while the strip before is sent */
        dma->wait(dma->user);
        if (status == QV_OK)
            dma->start(dma->user, strip[turn], 2 * (size_t)(width * (rect.bottom - top)), top);
    }
    dma->wait(dma->user);
    return status;
}
