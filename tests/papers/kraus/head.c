/*
 * head.c - the head of Debian's mricron-data, classified and shaded by the
 * library: an opaque skin, a few voxels thick, before a blue inside. Where a coarser
 * level loses the skin, blue shines through.
 */
#include "subject.h"

#include <stdlib.h>
#include <string.h>

enum { nx = PAPER_HEAD_X, ny = PAPER_HEAD_Y, nz = PAPER_HEAD_Z, edge = 256 /* pixels */ };

static const qv_control_point points[] = {
    {8, {65535, 46000, 34000, 0}},      {14, {65535, 48000, 36000, 60000}},
    {46, {65535, 44000, 32000, 60000}}, {60, {65535, 44000, 32000, 0}},
    {64, {0, 26000, 65535, 0}},         {80, {0, 26000, 65535, 30000}},
};

/* Light from the viewer's upper left. The scan's x runs to the left of the head, its y to
   the nose; the viewer stands before the face, to its right. */
static const qv_shading shading = {
    .light = {60, 40, 70},
    .viewer = {50, 80, 25},
    .ambient = 90,
    .diffuse = 200,
    .specular = 24,
    .gloss = 5,
    .least_gradient = 1,
};

static qv_scalars describe(const uint8_t *scan)
{
    qv_scalars scalars;
    memset(&scalars, 0, sizeof scalars);
    scalars.values = scan;
    scalars.values_bytes = (uint64_t)nx * ny * nz;
    scalars.type = QV_SCALAR_U8;
    scalars.size[0] = nx;
    scalars.size[1] = ny;
    scalars.size[2] = nz;
    scalars.stride[0] = 1;
    scalars.stride[1] = nx;
    scalars.stride[2] = nx * ny;
    return scalars;
}

void make_head(subject *made)
{
    uint8_t *scan = paper_head();
    qv_transfer table;
    const qv_classifier classifier = {describe(scan), 0, 255, &table, &shading};
    const qv_block all = {{0, 0, 0}, {nx, ny, nz}};
    made->name = "head";
    made->kept = 0;
    made->levels = 5;
    made->view = (paper_view){148, 12, 262.0 / edge, 1, edge, edge};
    paper_volume_make(&made->made, nx, ny, nz);
    paper_require(qv_transfer_build(&table, points, sizeof points / sizeof points[0]) == QV_OK &&
                      qv_classify(made->made.voxels, (size_t)made->made.volume.voxels_bytes,
                                  QV_STORAGE_RGBA16, &classifier, &all) == QV_OK,
                  "cannot classify the head");
    free(scan);
}
