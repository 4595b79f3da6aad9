/*
 * freevoxel_reorder.h - records of linear order, in that of a file.
 */
#ifndef QVOL_HOST_FREEVOXEL_REORDER_H
#define QVOL_HOST_FREEVOXEL_REORDER_H

#include "freevoxel_file.h"
#include "settings.h"

/* Writes the levels of a file to `bytes` from one of the same header in linear order. */
void freevoxel_reorder(uint8_t *bytes, const struct freevoxel_header *header, const uint8_t *linear,
                       const struct settings *settings);

#endif
