/*
 * export.h - classified voxels to a file: raw, or C source for a device's flash. With
 * the palette beside them, coarser levels behind them, and a report.
 */
#ifndef QVOL_HOST_EXPORT_H
#define QVOL_HOST_EXPORT_H

#include "flash_array.h"
#include "levels.h"

struct export
{
    const struct settings *settings;
    const struct model *model;
    const qv_volume *volume;
    const struct levels *levels; /* null: none */
    output out;
    bool is_array;
    bool swap; /* 16-bit channels, to the byte order asked for */
    struct flash_array array;
};

/* What can be refused before anything is read. */
void export_check_settings(const struct settings *settings);

/* What the input decides, before long work. */
void export_check_model(const struct model *model, const struct settings *settings);

/* All arguments stay in use; levels may be null, voxels of the volume need not be there. */
void export_begin(struct export *export, const struct model *model, const qv_volume *volume,
                  const struct levels *levels, const struct settings *settings);

/* Voxels of the volume as they follow each other, in as many parts as one likes. */
void export_voxels(struct export *export, const void *voxels, size_t bytes);

/* Levels, palette and report; then the files get their names. */
void export_end(struct export *export);

#endif
