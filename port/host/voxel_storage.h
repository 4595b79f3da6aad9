/*
 * voxel_storage.h - what each qv_storage is called and holds.
 */
#ifndef QVOL_HOST_VOXEL_STORAGE_H
#define QVOL_HOST_VOXEL_STORAGE_H

#include "qvol.h"

#include <stdbool.h>

unsigned storage_voxel_bytes(qv_storage storage);

/* Of the words of an entry, in the volume or its palette: 1 or 2. */
unsigned storage_channel_bytes(qv_storage storage);

bool storage_is_indexed(qv_storage storage);
bool storage_holds_extinction(qv_storage storage);

/* Whether colours are weighted by opacity, once the voxels have been classified. */
bool storage_is_associated(qv_storage storage);

/* The same with the other kind of fourth channel; of opacity, colours are not weighted. */
qv_storage storage_with_extinction(qv_storage storage);
qv_storage storage_with_opacity(qv_storage storage);

/* Of the palette's entries; other storage is its own. Coarser levels have it. */
qv_storage storage_of_entries(qv_storage storage);

/* "rgba8", "indexed8", ... ; what a palette holds is told elsewhere. */
const char *storage_name(qv_storage storage);

/* "QV_STORAGE_RGBA8", ... */
const char *storage_constant(qv_storage storage);

#endif
