/*
 * head.c - the head, classified without shading: its light is that of lamps.
 */
#include "head.h"

#include "scan.h"

#include <stdlib.h>
#include <string.h>

static const qv_control_point skin[] = {
    {10, {65535, 50000, 40000, 0}},
    {34, {65535, 50000, 40000, 9000}},
    {60, {65535, 54000, 45000, 14000}},
    {255, {65535, 60000, 52000, 14000}},
};

static const qv_control_point glass[] = {
    {8, {65535, 49000, 38500, 0}},      {22, {65535, 50400, 40000, 1570}},
    {42, {64000, 42400, 30800, 520}},   {60, {51400, 15400, 12800, 20}},
    {78, {51400, 18000, 15400, 520}},   {92, {61700, 38500, 32100, 2360}},
    {104, {65535, 60600, 56000, 5570}}, {114, {65535, 64200, 61700, 6880}},
    {121, {65535, 64200, 61700, 4900}}, {128, {65535, 57800, 48800, 260}},
    {255, {64250, 52700, 43700, 13}},
};

void skin_transfer(qv_transfer *made)
{
    paper_require(qv_transfer_build(made, skin, sizeof skin / sizeof skin[0]) == QV_OK,
                  "no transfer function");
}

void glass_transfer(qv_transfer *made)
{
    paper_require(qv_transfer_build(made, glass, sizeof glass / sizeof glass[0]) == QV_OK,
                  "no transfer function");
}

void head_make(paper_volume *made, const qv_transfer *transfer, unsigned factor)
{
    uint16_t size[3];
    uint8_t *scan = ref_scan_reduced(size, factor);
    paper_require(scan != NULL, "cannot read the head (Debian's mricron-data)");
    paper_volume_make(made, size[0], size[1], size[2]);
    for (size_t i = 0; i < (size_t)size[0] * size[1] * size[2]; i++) {
        memcpy(made->voxels[i], transfer->rgba[scan[i]], sizeof made->voxels[i]);
    }
    made->volume.unit_distance = QV_ONE_Q16;
    for (int axis = 0; axis < 3; axis++) {
        made->volume.spacing[axis] = QV_ONE_Q16 * factor;
    }
    free(scan);
}
