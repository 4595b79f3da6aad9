/*
 * columns.c - a pixel before columns of white voxels.
 */
#include "columns.h"

#include "attenuated.h"

#include <math.h>
#include <string.h>

static void fill_white(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    (void)at;
    rgba[0] = rgba[1] = rgba[2] = PAPER_FULL;
    rgba[3] = paper_channel(*(const double *)from);
}

/* One pixel, which sees along y what lies in the middle of the columns. */
static void look(qv_splat_scene *scene, const qv_volume *columns, const qv_splatting *splatting)
{
    const paper_view view = {0, 0, 1, 1, 1, 1};
    splat_scene_make(scene, columns, &view);
    scene->kernel = &qv_kernel_linear;
    scene->splatting = splatting;
}

/* Each layer that is added lies behind the others, which for equal voxels blends as one more
   before them. */
static double worst_of_layers(const qv_splat_scene *scene, const qv_attenuation *light,
                              double opacity, double share)
{
    const uint16_t *size = scene->volume.size;
    uint32_t sum[QV_SUM_CHANNELS];
    const qv_sums sums = {sum, QV_SUM_CHANNELS, {0, 0, 1, 1}};
    double worst = 0, passes = 1;
    qv_splats splats;
    paper_require(qv_splat_init(&splats, scene) == QV_OK && qv_sums_clear(&sums, &splats) == QV_OK,
                  "no columns of voxels");
    for (uint16_t layer = 0; layer < size[1]; layer++) {
        const qv_block block = {{0, layer, 0}, {size[0], (uint16_t)(layer + 1), size[2]}};
        paper_require(qv_splat_block(&sums, &splats, &scene->volume, light, 0, &block) == QV_OK,
                      "cannot splat a layer");
        passes *= 1 - opacity;
        worst = fmax(worst, fabs(sum[3] / 65536.0 - 255 * share * (1 - passes)));
    }
    return worst;
}

double columns_off(const qv_splatting *splatting, double opacity, const uint16_t size[3],
                   double share)
{
    const double stored = paper_channel(opacity) / (double)PAPER_FULL;
    paper_volume columns;
    attenuated light;
    qv_splat_scene scene;
    paper_volume_make(&columns, size[0], size[1], size[2]);
    paper_volume_fill(&columns, fill_white, &opacity);
    columns.volume.unit_distance = QV_ONE_Q16;
    look(&scene, &columns.volume, splatting);
    attenuated_make(&light, &columns.volume, scene.directions, 0);
    const double worst = worst_of_layers(&scene, light.level, stored, share);
    attenuated_free(&light);
    paper_volume_free(&columns);
    return worst;
}
