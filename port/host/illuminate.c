/*
 * illuminate.c - attenuates towards the lamps, then lights slice by slice.
 */
#include "illuminate.h"
#include "error.h"
#include "lighting.h"
#include "parallel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Shares of directions are found to 2^-20; components this near to each other may be taken for
   equal there, or for either order. */
#define NEAR 1e-4

struct light {
    const struct model *model;
    qv_volume volume; /* as it is attenuated */
    qv_lighting lighting;
    qv_attenuation attenuation;
    uint8_t *records;
    uint8_t *voxels; /* lit */
    size_t slice_bytes;
};

/* ---- Directions ----------------------------------------------------------------- */

/* The direction along the axes whose magnitude is at least so much, and along `own`. */
static uint32_t direction_along(const double v[3], double least, unsigned own)
{
    int step[3];
    for (unsigned a = 0; a < 3; a++) {
        bool moves = a == own || fabs(v[a]) >= least;
        step[a] = moves ? (v[a] > 0) - (v[a] < 0) : 0;
    }
    return step[0] == 0 && step[1] == 0 && step[2] == 0
               ? 0
               : (uint32_t)1 << qv_direction(step[0], step[1], step[2]);
}

/* Those that a lamp shines between: along its longest axis, its longest two and all three. Of
   axes that are nearly the same, both. */
static uint32_t directions_of(const qv_lamp *lamp, const uint32_t spacing[3])
{
    double v[3]; /* in voxels */
    uint32_t set = 0;
    for (unsigned a = 0; a < 3; a++) {
        v[a] = (double)lamp->direction[a] / spacing[a];
    }
    for (unsigned a = 0; a < 3; a++) {
        set |= direction_along(v, fabs(v[a]) * (1 - NEAR), a);
        set |= direction_along(v, fabs(v[a]) * (1 + NEAR), a);
    }
    return set;
}

/* ---- Attenuation ---------------------------------------------------------------- */

static void attenuate_direction(void *context, uint32_t direction)
{
    const struct light *light = context;
    bool stored = storage_holds_extinction((qv_storage)light->volume.storage);
    if ((light->attenuation.directions >> direction & 1u) == 0) {
        return;
    }
    check_status(qv_attenuate(light->records, (size_t)light->attenuation.bytes, NULL,
                              &light->attenuation, &light->volume,
                              stored ? &qv_domain_stored : &qv_domain_extinction,
                              (uint8_t)direction),
                 light->model, "attenuation");
}

static void attenuate(struct light *light, const struct settings *settings)
{
    qv_attenuation *attenuation = &light->attenuation;
    struct parallel work = {attenuate_direction, light, QV_DIRECTIONS, settings->threads,
                            progress_label(settings->quiet, "attenuating")};
    for (unsigned i = 0; i < light->lighting.count; i++) {
        attenuation->directions |= directions_of(&light->lighting.lamps[i], light->volume.spacing);
    }
    memcpy(attenuation->size, light->volume.size, sizeof attenuation->size);
    attenuation->bytes = qv_attenuation_bytes(attenuation);
    light->records = allocate(attenuation->bytes, light->model->scan.file, "attenuation");
    attenuation->records = light->records;
    parallel_run(&work);
}

/* ---- Voxels --------------------------------------------------------------------- */

static void light_slice(void *context, uint32_t z)
{
    const struct light *light = context;
    const uint16_t *size = light->volume.size;
    qv_block slice = {{0, 0, (uint16_t)z}, {size[0], size[1], (uint16_t)(z + 1)}};
    check_status(qv_illuminate(light->voxels + z * light->slice_bytes, light->slice_bytes,
                               &light->volume, &light->attenuation, &light->lighting, 0, &slice),
                 light->model, "light");
}

/* Entries, tightly packed; what was looked up in the palette is in the voxels now. */
static void take_lit(qv_volume *volume, struct model *model, uint8_t *voxels)
{
    model->storage = storage_of_entries(model->storage);
    free(model->voxels);
    model->voxels = voxels;
    volume->storage = (uint8_t)model->storage;
    volume->voxels = voxels;
    volume->palette = NULL;
    volume->palette_bytes = 0;
    volume->stride[0] = (int32_t)storage_voxel_bytes(model->storage);
    volume->stride[1] = volume->stride[0] * volume->size[0]; /* at most 2^15 */
    volume->stride[2] = volume->stride[1] * volume->size[1]; /* at most 2^27 */
    volume->voxels_bytes = (uint64_t)volume->stride[2] * volume->size[2];
}

void illuminate(qv_volume *volume, struct model *model, uint32_t step,
                const struct settings *settings)
{
    struct light light = {.model = model, .volume = *volume};
    struct parallel work = {light_slice, &light, volume->size[2], settings->threads,
                            progress_label(settings->quiet, "lighting")};
    if (settings->level_given && model->scan.levels != NULL) {
        usage_error("--light", "the input has its levels already, which stay unlit");
    }
    if (light.volume.unit_distance == 0 && !storage_holds_extinction(model->storage)) {
        light.volume.unit_distance = step;
    }
    lighting_create(&light.lighting, settings);
    attenuate(&light, settings);
    light.slice_bytes = (size_t)storage_voxel_bytes(storage_of_entries(model->storage)) *
                        volume->size[0] * volume->size[1];
    light.voxels =
        allocate((uint64_t)light.slice_bytes * volume->size[2], model->scan.file, "voxels");
    parallel_run(&work);
    free(light.records);
    take_lit(volume, model, light.voxels);
}
