/*
 * classification.c - scalars to indices, and control points to the palette that they index.
 */
#include "size.h"

/* Far more than two control points are as large: the code is the same. */
static const qv_control_point points[] = {{0, {0, 0, 0, 0}}, {255, {65535, 50000, 40000, 30000}}};

/* The palette and the indices of a slice share the memory. */
enum { SLICE = VOLUME_EDGE * VOLUME_EDGE, INDICES_AT = QV_PALETTE8_BYTES };

qv_status use_classification(void)
{
    static qv_transfer transfer;
    static const qv_block block = {{0, 0, 0}, {VOLUME_EDGE, VOLUME_EDGE, 1}};
    qv_classifier classifier = {.low = 10, .high = 240};
    qv_volume volume;
    qv_status status = QV_OK;
    size_scratch_bytes(sizeof transfer);
    volume_describe(&volume);
    classifier.scalars = (qv_scalars){.values = volume.voxels,
                                      .values_bytes = VOLUME_VOXELS,
                                      .stride = {1, VOLUME_EDGE, SLICE},
                                      .size = {VOLUME_EDGE, VOLUME_EDGE, VOLUME_EDGE},
                                      .type = QV_SCALAR_U8};
    SIZE_CALL(status, qv_transfer_build(&transfer, points, sizeof points / sizeof *points));
    if (status == QV_OK) {
        measure_begin();
        qv_transfer_to_palette8((uint8_t(*)[4])size_memory, &transfer);
        measure_end();
    }
    SIZE_CALL(status, qv_classify(size_memory + INDICES_AT, SLICE, QV_STORAGE_INDEXED8, &classifier,
                                  &block));
    return status;
}
