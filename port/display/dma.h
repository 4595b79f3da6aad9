/*
 * dma.h - two strips, one being rendered while the other is on its way to the panel.
 */
#ifndef QVOL_DMA_H
#define QVOL_DMA_H

#include "qvol.h"

/* The board's: starts sending rows and returns at once; waits until all is sent. */
typedef struct qvol_dma {
    void (*start)(void *user, const void *rows, size_t bytes, int32_t top);
    void (*wait)(void *user);
    void *user;
} qvol_dma;

/* Shows height rows of width pixels of 16 bits. memory holds both strips, each of `rows` rows. */
qv_status qvol_dma_show(const qvol_dma *dma, const qv_context *context, uint16_t *memory,
                        int32_t rows, int32_t width, int32_t height);

#endif /* QVOL_DMA_H */
