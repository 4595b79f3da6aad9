/*
 * scan.h - a real scan: the head ch2.nii.gz of Debian's mricron-data, and a table to classify
 * it with.
 */
#ifndef REFERENCE_SCAN_H
#define REFERENCE_SCAN_H

#include "qvol.h"

#include <stdbool.h>

#define REF_SCAN_X      181
#define REF_SCAN_Y      217
#define REF_SCAN_Z      181
#define REF_SCAN_VOXELS ((size_t)REF_SCAN_X * REF_SCAN_Y * REF_SCAN_Z)

/* Reads all voxels, x fastest. False where the file is not there. */
bool ref_scan_read(uint8_t *scan);

/*
 * The same reduced: each voxel is the mean of a cube of factor^3, without what is left over at the
 * upper faces. Returns the voxels, which the caller frees, or null without the file or memory.
 */
uint8_t *ref_scan_reduced(uint16_t size[3], unsigned factor);

/* Skin faint and reddish, brain denser and pale: colours and opacities that change with value. */
void ref_scan_palette(uint16_t palette[QV_PALETTE_ENTRIES][4]);

#endif /* REFERENCE_SCAN_H */
