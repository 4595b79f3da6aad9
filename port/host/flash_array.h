/*
 * flash_array.h - a classified volume as C source for a device's flash.
 */
#ifndef QVOL_HOST_FLASH_ARRAY_H
#define QVOL_HOST_FLASH_ARRAY_H

#include "levels.h"
#include "output.h"

#define FLASH_NAME_BYTES 64

struct flash_array {
    output *out;
    const struct model *model;
    const qv_volume *volume;
    const struct levels *levels; /* null: none */
    const struct settings *settings;
    char name[FLASH_NAME_BYTES];
    bool header_file;    /* .h: static constants; .c: with external linkage */
    unsigned word_bytes; /* 1 or 2: so the array is aligned as the storage needs */
    unsigned column;
};

/* Comment, #include, start of the voxels. The name comes from the file's if
   settings give none. Levels may be null; all arguments stay in use. */
void flash_array_begin(struct flash_array *array, output *out, const struct model *model,
                       const qv_volume *volume, const struct levels *levels,
                       const struct settings *settings);

/* Voxels in the machine's byte order, as they follow each other. */
void flash_array_voxels(struct flash_array *array, const void *voxels, size_t bytes);

/* Palette, levels and descriptors. */
void flash_array_end(struct flash_array *array);

#endif
