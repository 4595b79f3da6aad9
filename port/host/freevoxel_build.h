/*
 * freevoxel_build.h - fills the memory of a FreeVoxel file.
 */
#ifndef QVOL_HOST_FREEVOXEL_BUILD_H
#define QVOL_HOST_FREEVOXEL_BUILD_H

#include "freevoxel_file.h"
#include "levels.h"

/* bytes: header->total_bytes, zeroed. levels: read where the header has some. Directions are
   built side by side, on the settings' threads. They are built in linear order: for another one,
   in memory of as many bytes. */
void freevoxel_build(uint8_t *bytes, const struct freevoxel_header *header, const qv_volume *volume,
                     const struct levels *levels, const struct model *model,
                     const struct settings *settings);

#endif
