/*
 * model.c - from settings and a file to a classified volume.
 */
#include "model.h"
#include "error.h"
#include "parallel.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_TRANSFER "grey"
/* Length of the light's vector, in a component of 16 bits. */
#define LIGHT_LENGTH 16384
#define Q30          1073741824.0
#define RADIANS      (3.14159265358979323846 / 180)

unsigned storage_voxel_bytes(qv_storage storage)
{
    if (storage == QV_STORAGE_RGBA8) {
        return 4;
    }
    return storage == QV_STORAGE_RGBA16 ? 8 : 1;
}

const char *storage_name(qv_storage storage)
{
    return choice_name(storage_names,
                       storage == QV_STORAGE_INDEXED8_16 ? QV_STORAGE_INDEXED8 : (int)storage);
}

void check_status(qv_status status, const struct model *model, const char *field)
{
    if (status < 0) {
        data_error(model->scan.file, field, "%s", qv_status_text(status));
    }
}

/* Degrees to a binary angle, to nearest; whole turns vanish in the cast. */
static qv_angle binary_angle(double degrees)
{
    return (qv_angle)(int64_t)llround(fmod(degrees, 360) / 360 * 4294967296.0);
}

void settings_rotation(int32_t rotation[3][3], const struct settings *settings)
{
    qv_rotation(rotation, binary_angle(settings->angles[0]), binary_angle(settings->angles[1]),
                binary_angle(settings->angles[2]));
}

/* The light stands `right` and `up` degrees from the viewer and turns with him. */
static void set_directions(qv_shading *shading, const struct settings *settings)
{
    int32_t rotation[3][3];
    double right = sin(settings->light[0] * RADIANS) * cos(settings->light[1] * RADIANS);
    double up = sin(settings->light[1] * RADIANS);
    double back = cos(settings->light[0] * RADIANS) * cos(settings->light[1] * RADIANS);
    settings_rotation(rotation, settings);
    for (unsigned w = 0; w < 3; w++) {
        double light = right * rotation[0][w] - up * rotation[1][w] - back * rotation[2][w];
        shading->light[w] = (int16_t)lround(light / Q30 * LIGHT_LENGTH);
        shading->viewer[w] = (int16_t)lround(-rotation[2][w] / Q30 * LIGHT_LENGTH);
    }
}

static void make_palette(struct model *model)
{
    if (model->storage == QV_STORAGE_INDEXED8) {
        model->palette_bytes = QV_PALETTE8_BYTES;
        model->palette = allocate(QV_PALETTE8_BYTES, model->scan.file, "palette");
        qv_transfer_to_palette8(model->palette, model->table);
    } else if (model->storage == QV_STORAGE_INDEXED8_16) {
        model->palette_bytes = QV_PALETTE16_BYTES;
        model->palette = model->table;
    }
}

static void set_classifier(struct model *model)
{
    qv_classifier *classifier = &model->classifier;
    classifier->scalars = model->view.scalars;
    classifier->low = model->view.low;
    classifier->high = model->view.high;
    classifier->transfer = (const qv_transfer *)&model->table;
    classifier->shading = model->shaded ? &model->shading : NULL;
}

static void read_scalars(struct model *model, const struct settings *settings,
                         qv_storage default_storage)
{
    model->storage = settings_storage(settings, default_storage);
    if (settings->palette != NULL) {
        usage_error("--palette", "only data of --type indexed8 take a palette");
    }
    if (settings->shade && storage_voxel_bytes(model->storage) == 1) {
        usage_error("--shade", "shaded colours need --storage rgba8 or rgba16");
    }
    transfer_read(&model->transfer,
                  settings->transfer != NULL ? settings->transfer : DEFAULT_TRANSFER);
    check_status(qv_transfer_build(model->table, model->transfer.points, model->transfer.count),
                 model, "transfer function");
    scalar_view_create(&model->view, &model->scan, settings);
    model->world_unit = model->view.world_unit;
    model->shaded = settings->shade;
    model->shading = model->transfer.shading;
    set_directions(&model->shading, settings);
    set_classifier(model);
    make_palette(model);
}

static void refuse_classification(const struct settings *settings)
{
    const char *option = settings->transfer != NULL    ? "--tf"
                         : settings->window_given      ? "--window"
                         : settings->shade             ? "--shade"
                         : settings->storage != 0      ? "--storage"
                         : settings->palette_bits != 0 ? "--palette-bits"
                                                       : NULL;
    if (option != NULL) {
        usage_error(option, "the input is classified already");
    }
}

static void read_palette(struct model *model, const struct settings *settings)
{
    struct source source;
    FILE *file;
    if (settings->palette == NULL) {
        usage_error("--palette", "data of --type indexed8 need one");
    }
    source_open(&source, settings->palette, QV_PALETTE16_BYTES);
    if (source.bytes != QV_PALETTE8_BYTES && source.bytes != QV_PALETTE16_BYTES) {
        data_error(source.name, "palette", "%llu bytes, 256 entries take %d or %d",
                   (unsigned long long)source.bytes, QV_PALETTE8_BYTES, QV_PALETTE16_BYTES);
    }
    model->palette_bytes = (uint32_t)source.bytes;
    model->palette = allocate(source.bytes, source.name, "palette");
    file = fopen(source.path, "rb");
    if (file == NULL || fread(model->palette, 1, source.bytes, file) != source.bytes) {
        system_error(source.name, "palette");
    }
    fclose(file);
    model->storage = QV_STORAGE_INDEXED8;
    if (source.bytes == QV_PALETTE16_BYTES) {
        model->storage = QV_STORAGE_INDEXED8_16;
        if (settings->big_endian != machine_is_big_endian()) {
            swap_words(model->palette, source.bytes, 2);
        }
    }
}

static void read_classified(struct model *model, const struct settings *settings)
{
    refuse_classification(settings);
    model->classified_before = true;
    if (model->scan.type == ELEMENT_INDEXED8) {
        read_palette(model, settings);
    } else {
        model->storage = model->scan.type == ELEMENT_RGBA8 ? QV_STORAGE_RGBA8 : QV_STORAGE_RGBA16;
    }
}

void model_read(struct model *model, const struct settings *settings, const char *name,
                qv_storage default_storage)
{
    memset(model, 0, sizeof *model);
    input_read(&model->scan, name, &settings->raw);
    if (element_is_classified(model->scan.type)) {
        read_classified(model, settings);
    } else {
        read_scalars(model, settings, default_storage);
    }
}

void model_reduce(struct model *model, const uint8_t factor[3])
{
    qv_scalars *scalars = &model->classifier.scalars;
    int32_t bytes = scalars->type == QV_SCALAR_U8 ? 1 : 2;
    qv_scalars reduced = *scalars;
    uint64_t total = (uint64_t)bytes;
    double unit;
    void *values;
    for (unsigned a = 0; a < 3; a++) {
        reduced.size[a] = (uint16_t)((scalars->size[a] + factor[a] - 1) / factor[a]);
        reduced.spacing[a] = scalars->spacing[a] * factor[a]; /* at most 2^20 * 2^6 */
        reduced.stride[a] = (int32_t)total;                   /* at most 2 * 2^24 */
        total *= reduced.size[a];
    }
    values = allocate(total, model->scan.file, "data");
    check_status(qv_reduce(values, total, scalars, factor, 0, reduced.size[2]), model, "reduction");
    unit = fmin(reduced.spacing[0], fmin(reduced.spacing[1], reduced.spacing[2]));
    for (unsigned a = 0; a < 3; a++) {
        reduced.spacing[a] = (uint32_t)lround(reduced.spacing[a] / unit * QV_ONE_Q16);
    }
    model->world_unit *= unit / QV_ONE_Q16;
    reduced.values = values;
    reduced.values_bytes = total;
    *scalars = reduced;
}

void model_classify(void *voxels, size_t bytes, const struct model *model, uint32_t first,
                    uint32_t end)
{
    const qv_scalars *scalars = &model->classifier.scalars;
    qv_block block = {{0, 0, (uint16_t)first}, {scalars->size[0], scalars->size[1], (uint16_t)end}};
    check_status(qv_classify(voxels, bytes, model->storage, &model->classifier, &block), model,
                 "classification");
}

struct slices {
    const struct model *model;
    uint8_t *voxels;
    size_t slice_bytes;
};

static void classify_slice(void *context, uint32_t z)
{
    const struct slices *slices = context;
    model_classify(slices->voxels + z * slices->slice_bytes, slices->slice_bytes, slices->model, z,
                   z + 1);
}

static void classify_volume(qv_volume *volume, const struct model *model,
                            const struct settings *settings)
{
    const qv_scalars *scalars = &model->classifier.scalars;
    unsigned bytes = storage_voxel_bytes(model->storage);
    struct slices slices = {model, NULL, (size_t)bytes * scalars->size[0] * scalars->size[1]};
    struct parallel work = {classify_slice, &slices, scalars->size[2], settings->threads,
                            progress_label(settings->quiet, "classifying")};
    volume->voxels_bytes = (uint64_t)slices.slice_bytes * scalars->size[2];
    slices.voxels = allocate(volume->voxels_bytes, model->scan.file, "voxels");
    parallel_run(&work);
    volume->voxels = slices.voxels;
    memcpy(volume->size, scalars->size, sizeof volume->size);
    memcpy(volume->spacing, scalars->spacing, sizeof volume->spacing);
    volume->stride[0] = (int32_t)bytes;
    volume->stride[1] = volume->stride[0] * scalars->size[0]; /* at most 2^15 */
    volume->stride[2] = volume->stride[1] * scalars->size[1]; /* at most 2^27 */
}

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
    memset(volume, 0, sizeof *volume);
    volume->storage = (uint8_t)model->storage;
    volume->palette = model->palette;
    volume->palette_bytes = model->palette_bytes;
    if (model->classified_before) {
        take_volume(volume, model);
    } else {
        classify_volume(volume, model, settings);
        free(model->scan.values);
        model->scan.values = NULL;
    }
    check_status(qv_volume_check(volume), model, "volume");
}
