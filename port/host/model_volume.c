/*
 * model_volume.c - reduces and classifies what was read.
 */
#include "model.h"
#include "error.h"
#include "parallel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The smallest spacing stays 1. */
static void normalise_spacing(struct model *model, qv_scalars *scalars)
{
    uint32_t *spacing = scalars->spacing;
    double unit = fmin(spacing[0], fmin(spacing[1], spacing[2]));
    for (unsigned a = 0; a < 3; a++) {
        double ratio = spacing[a] / unit;
        if (ratio > SPACING_RATIO_MOST) {
            data_error(model->scan.file, "reduction",
                       "one axis would have %g times the spacing "
                       "of another",
                       ratio);
        }
        spacing[a] = (uint32_t)lround(ratio * QV_ONE_Q16);
    }
    model->world_unit *= unit / QV_ONE_Q16;
    if (model->unit_distance != 0) {
        model->unit_distance = to_q16(model->unit_distance / unit);
    }
}

void model_reduce(struct model *model, const uint8_t factor[3])
{
    qv_scalars *scalars = &model->classifier.scalars;
    int32_t bytes = scalars->type == QV_SCALAR_U8 ? 1 : 2;
    qv_scalars reduced = *scalars;
    uint64_t total = (uint64_t)bytes;
    void *values;
    for (unsigned a = 0; a < 3; a++) {
        reduced.size[a] = (uint16_t)((scalars->size[a] + factor[a] - 1) / factor[a]);
        reduced.spacing[a] = scalars->spacing[a] * factor[a]; /* at most 2^20 * 2^6 */
        reduced.stride[a] = (int32_t)total;                   /* at most 2 * 2^24 */
        total *= reduced.size[a];
    }
    values = allocate(total, model->scan.file, "data");
    check_status(qv_reduce(values, (size_t)total, scalars, factor, 0, reduced.size[2]), model,
                 "reduction");
    normalise_spacing(model, &reduced);
    memcpy(model->reduction, factor, sizeof model->reduction);
    free(model->scan.values);
    model->scan.values = values;
    reduced.values = values;
    reduced.values_bytes = total;
    *scalars = reduced;
    if (model->mask != NULL) {
        model_reduce(model->mask, factor);
    }
}

/* Whether the scalar is above 0; voxels count x first, then y, then z. */
static bool is_inside(const qv_scalars *scalars, uint64_t voxel)
{
    uint64_t row = voxel / scalars->size[0];
    int64_t x = (int64_t)(voxel % scalars->size[0]);
    int64_t y = (int64_t)(row % scalars->size[1]);
    int64_t z = (int64_t)(row / scalars->size[1]);
    const void *value =
        scalars->values + x * scalars->stride[0] + y * scalars->stride[1] + z * scalars->stride[2];
    if (scalars->type == QV_SCALAR_U8) {
        return *(const uint8_t *)value > 0;
    }
    return scalars->type == QV_SCALAR_U16 ? *(const uint16_t *)value > 0
                                          : *(const int16_t *)value > 0;
}

/* Voxels of the mask replace those outside it. */
static void apply_mask(uint8_t *voxels, size_t bytes, const struct model *mask, uint32_t first,
                       uint32_t end)
{
    const qv_scalars *scalars = &mask->classifier.scalars;
    unsigned voxel_bytes = storage_voxel_bytes(mask->storage);
    uint64_t before = (uint64_t)scalars->size[0] * scalars->size[1] * first;
    uint8_t *own = allocate(bytes, mask->scan.file, "voxels");
    model_classify(own, bytes, mask, first, end);
    for (size_t place = 0; place < bytes; place += voxel_bytes) {
        if (is_inside(scalars, before + place / voxel_bytes)) {
            memcpy(voxels + place, own + place, voxel_bytes);
        }
    }
    free(own);
}

/* In place. */
static void associate(void *voxels, size_t bytes, const struct model *model)
{
    const qv_entries entries = {.entries = voxels,
                                .count = (uint32_t)(bytes / storage_voxel_bytes(model->storage)),
                                .storage = (uint8_t)storage_with_opacity(model->storage)};
    check_status(qv_opacity_to_associated(voxels, bytes, &entries), model, "colours");
}

void model_classify(void *voxels, size_t bytes, const struct model *model, uint32_t first,
                    uint32_t end)
{
    const qv_scalars *scalars = &model->classifier.scalars;
    qv_block block = {{0, 0, (uint16_t)first}, {scalars->size[0], scalars->size[1], (uint16_t)end}};
    uint8_t storage = (uint8_t)storage_with_opacity(model->storage);
    check_status(qv_classify(voxels, bytes, storage, &model->classifier, &block), model,
                 "classification");
    if (storage_is_associated(model->storage)) {
        associate(voxels, bytes, model);
    }
    if (model->mask != NULL) {
        apply_mask(voxels, bytes, model->mask, first, end);
    }
}

struct slices {
    const struct model *model;
    uint8_t *voxels;
    size_t slice_bytes;
};

/* A slice is a piece of work: slices share nothing that is written. */
static void classify_slice(void *context, uint32_t z)
{
    const struct slices *slices = context;
    model_classify(slices->voxels + z * slices->slice_bytes, slices->slice_bytes, slices->model, z,
                   z + 1);
}

static void classify_volume(qv_volume *volume, struct model *model, const struct settings *settings)
{
    struct slices slices = {model, NULL, (size_t)volume->stride[2]};
    struct parallel work = {classify_slice, &slices, volume->size[2], settings->threads,
                            progress_label(settings->quiet, "classifying")};
    slices.voxels = allocate(volume->voxels_bytes, model->scan.file, "voxels");
    parallel_run(&work);
    model->voxels = slices.voxels;
    volume->voxels = slices.voxels;
}

/* Tightly packed, x fastest. */
void model_describe(qv_volume *volume, const struct model *model)
{
    const qv_scalars *scalars = &model->classifier.scalars;
    bool opacity = !storage_holds_extinction(model->storage);
    memset(volume, 0, sizeof *volume);
    volume->storage = (uint8_t)model->storage;
    volume->palette = model->palette;
    volume->palette_bytes = model->palette_bytes;
    volume->unit_distance = opacity ? model->unit_distance : 0;
    volume->extinction = model->extinction;
    memcpy(volume->size, scalars->size, sizeof volume->size);
    memcpy(volume->spacing, scalars->spacing, sizeof volume->spacing);
    volume->stride[0] = (int32_t)storage_voxel_bytes(model->storage);
    volume->stride[1] = volume->stride[0] * scalars->size[0]; /* at most 2^15 */
    volume->stride[2] = volume->stride[1] * scalars->size[1]; /* at most 2^27 */
    volume->voxels_bytes = (uint64_t)volume->stride[2] * scalars->size[2];
}

/* Voxels stay where the file was read to; strides turn them. */
static void take_volume(qv_volume *volume, struct model *model)
{
    struct layout layout;
    scan_layout(&layout, &model->scan, storage_voxel_bytes(model->storage));
    volume->voxels = (const unsigned char *)model->scan.values + layout.first;
    volume->voxels_bytes = model->scan.bytes;
    memcpy(volume->size, layout.size, sizeof volume->size);
    memcpy(volume->spacing, layout.spacing, sizeof volume->spacing);
    memcpy(volume->stride, layout.stride, sizeof volume->stride);
    model->world_unit = layout.world_unit;
}

void model_volume(qv_volume *volume, struct model *model, const struct settings *settings)
{
    model_hold_extinction(model, settings);
    model_describe(volume, model);
    if (model->classified_before) {
        take_volume(volume, model);
    } else {
        classify_volume(volume, model, settings);
    }
    check_status(qv_volume_check(volume), model, "volume");
}
