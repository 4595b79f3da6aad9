/*
 * command_classify.c - voxels for later or for a device's flash.
 */
#include "commands.h"
#include "error.h"
#include "export.h"

#include <math.h>
#include <stdlib.h>

/* Voxels are classified and written slice by slice, in about so many bytes. */
#define STRIP_BYTES (4u << 20)

/* Bytes of voxels and palette after a reduction: at most 2^36 * 8 + 2^11. */
static uint64_t bytes_after(const struct model *model, const uint8_t factor[3])
{
    uint64_t bytes = storage_voxel_bytes(model->storage);
    for (unsigned a = 0; a < 3; a++) {
        bytes *= (model->classifier.scalars.size[a] + factor[a] - 1u) / factor[a];
    }
    return bytes + model->palette_bytes;
}

/* Factors that make voxels of about that edge, in the smallest spacing. */
static void factors_of_edge(uint8_t factor[3], const struct model *model, unsigned edge)
{
    for (unsigned a = 0; a < 3; a++) {
        double spacing = model->classifier.scalars.spacing[a] / (double)QV_ONE_Q16;
        factor[a] = (uint8_t)fmax(1, round(edge / spacing));
    }
}

/* The first, hence smallest, factors with which everything fits. */
static void fit(uint8_t factor[3], const struct model *model, uint64_t most)
{
    for (unsigned edge = 1; edge <= FACTOR_MOST; edge++) {
        factors_of_edge(factor, model, edge);
        if (bytes_after(model, factor) <= most) {
            return;
        }
    }
    data_error(model->scan.file, "--fit", "not even factors of %d fit %llu bytes", FACTOR_MOST,
               (unsigned long long)most);
}

/* By --fit or --reduce; without either nothing changes. */
static void reduce(struct model *model, const struct settings *settings)
{
    uint8_t factor[3];
    if (settings->fit != 0) {
        fit(factor, model, settings->fit);
    } else {
        for (unsigned a = 0; a < 3; a++) {
            factor[a] = (uint8_t)(settings->reduce[a] != 0 ? settings->reduce[a] : 1);
        }
    }
    if (factor[0] > 1 || factor[1] > 1 || factor[2] > 1) {
        model_reduce(model, factor);
    }
}

/* Only one strip of classified voxels is in memory at a time. */
static void write_voxels(struct export *export, const struct model *model)
{
    const qv_scalars *scalars = &model->classifier.scalars;
    size_t slice =
        (size_t)storage_voxel_bytes(model->storage) * scalars->size[0] * scalars->size[1];
    uint32_t slices = slice < STRIP_BYTES ? (uint32_t)(STRIP_BYTES / slice) : 1;
    uint8_t *strip = allocate((uint64_t)slice * slices, model->scan.file, "voxels");
    for (uint32_t z = 0; z < scalars->size[2]; z += slices) {
        uint32_t end = z + slices < scalars->size[2] ? z + slices : scalars->size[2];
        size_t bytes = slice * (end - z);
        model_classify(strip, bytes, model, z, end);
        export_voxels(export, strip, bytes);
    }
    free(strip);
}

/* What can be refused before anything is read. */
static void check_settings(const struct settings *settings)
{
    export_check_settings(settings);
    if (settings->fit != 0 && settings->reduce[0] != 0) {
        usage_error("--fit", "chooses the factors that --reduce gives");
    }
}

int command_classify(const struct settings *settings)
{
    struct model model;
    struct export export;
    qv_volume volume;
    check_settings(settings);
    model_read(&model, settings, settings->operands[0], QV_STORAGE_INDEXED8);
    if (model.classified_before) {
        data_error(model.scan.file, "type", "is classified already");
    }
    export_check_model(&model, settings);
    reduce(&model, settings);
    model_hold_extinction(&model, settings);
    model_describe(&volume, &model);
    export_begin(&export, &model, &volume, NULL, settings);
    write_voxels(&export, &model);
    export_end(&export);
    model_free(&model);
    return EXIT_SUCCESS;
}
