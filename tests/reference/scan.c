#include "scan.h"

#include <stdio.h>
#include <stdlib.h>

#define SCAN_FILE   "/usr/share/mricron/templates/ch2.nii.gz"
#define SCAN_HEADER 352 /* bytes before the voxels of a NIfTI-1 file */

bool ref_scan_read(uint8_t *scan)
{
    unsigned char header[SCAN_HEADER];
    bool whole = false;
    FILE *pipe = popen("gzip -dc " SCAN_FILE, "r");
    if (pipe == NULL) {
        return false;
    }
    if (fread(header, 1, sizeof header, pipe) == sizeof header) {
        whole = fread(scan, 1, REF_SCAN_VOXELS, pipe) == REF_SCAN_VOXELS;
    }
    (void)pclose(pipe);
    return whole;
}

/* To nearest. */
static uint8_t mean_of_cube(const uint8_t *corner, unsigned factor)
{
    const size_t row = REF_SCAN_X, slice = (size_t)REF_SCAN_X * REF_SCAN_Y;
    const unsigned count = factor * factor * factor;
    unsigned sum = count / 2;
    for (unsigned i = 0; i < count; i++) {
        const unsigned x = i % factor, y = i / factor % factor, z = i / factor / factor;
        sum += corner[x + y * row + z * slice];
    }
    return (uint8_t)(sum / count);
}

static void reduce(uint8_t *reduced, const uint16_t size[3], const uint8_t *scan, unsigned factor)
{
    for (unsigned z = 0; z < size[2]; z++) {
        for (unsigned y = 0; y < size[1]; y++) {
            for (unsigned x = 0; x < size[0]; x++) {
                const size_t line = y * factor + (size_t)REF_SCAN_Y * z * factor;
                *reduced++ = mean_of_cube(scan + x * factor + REF_SCAN_X * line, factor);
            }
        }
    }
}

uint8_t *ref_scan_reduced(uint16_t size[3], unsigned factor)
{
    size[0] = (uint16_t)(REF_SCAN_X / factor);
    size[1] = (uint16_t)(REF_SCAN_Y / factor);
    size[2] = (uint16_t)(REF_SCAN_Z / factor);
    uint8_t *scan = malloc(REF_SCAN_VOXELS);
    uint8_t *reduced = malloc((size_t)size[0] * size[1] * size[2]);
    if (scan == NULL || reduced == NULL || !ref_scan_read(scan)) {
        free(scan);
        free(reduced);
        return NULL;
    }
    reduce(reduced, size, scan, factor);
    free(scan);
    return reduced;
}

void ref_scan_palette(uint16_t palette[QV_PALETTE_ENTRIES][4])
{
    const uint32_t air = 24, highest = QV_PALETTE_ENTRIES - 1;
    for (uint32_t value = 0; value <= highest; value++) {
        const uint32_t above = value < air ? 0 : value - air;
        palette[value][0] = (uint16_t)(0xffff - 40 * value);
        palette[value][1] = (uint16_t)(257 * value);
        palette[value][2] = (uint16_t)(0xffff * value * value / (highest * highest));
        palette[value][3] = (uint16_t)(above * above * above / 260);
    }
}
