/*
 * model.c - reads a volume and all that its classification needs.
 */
#include "model.h"
#include "error.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_TRANSFER "grey"
/* Length of the light's vector, in a component of 16 bits. */
#define LIGHT_LENGTH 16384
#define Q30          1073741824.0
#define RADIANS      (3.14159265358979323846 / 180)

uint32_t to_q16(double number)
{
    return (uint32_t)fmax(1, round(number * QV_ONE_Q16));
}

void check_status(qv_status status, const struct model *model, const char *field)
{
    if (status < 0) {
        data_error(model->scan.file, field, "%s", qv_status_text(status));
    }
}

/* Degrees to a binary angle, to nearest; whole turns vanish in the cast. */
qv_angle binary_angle(double degrees)
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

/* Indexed voxels are looked up while they are sampled. */
static void make_palette(struct model *model)
{
    if (!storage_is_indexed(model->storage)) {
        return;
    }
    if (storage_channel_bytes(model->storage) == 2) {
        model->palette_bytes = QV_PALETTE16_BYTES;
        model->palette = &model->table;
    } else {
        model->palette_bytes = QV_PALETTE8_BYTES;
        model->palette = allocate(QV_PALETTE8_BYTES, model->scan.file, "palette");
        qv_transfer_to_palette8(model->palette, &model->table);
    }
}

/* The descriptor that qv_classify and qv_reduce work on. */
static void set_classifier(struct model *model)
{
    qv_classifier *classifier = &model->classifier;
    classifier->scalars = model->view.scalars;
    classifier->low = model->view.low;
    classifier->high = model->view.high;
    classifier->transfer = &model->table;
    classifier->shading = model->shaded ? &model->shading : NULL;
}

/* Usage errors first: reading may take a while, they should not. */
static void read_scalars(struct model *model, const struct settings *settings,
                         qv_storage default_storage)
{
    model->storage = settings_storage(settings, default_storage);
    if (settings->palette != NULL) {
        usage_error("--palette", "only data of --type indexed8 take a palette");
    }
    if (settings->shade && storage_is_indexed(model->storage)) {
        usage_error("--shade", "shaded colours need --storage rgba8 or rgba16, rgbt8 or rgbt16");
    }
    transfer_read(&model->transfer,
                  settings->transfer != NULL ? settings->transfer : DEFAULT_TRANSFER);
    check_status(qv_transfer_build(&model->table, model->transfer.points, model->transfer.count),
                 model, "transfer function");
    scalar_view_create(&model->view, &model->scan, settings);
    model->world_unit = model->view.world_unit;
    memset(model->reduction, 1, sizeof model->reduction);
    model->shaded = settings->shade;
    model->shading = model->transfer.shading;
    set_directions(&model->shading, settings);
    set_classifier(model);
    make_palette(model);
}

/* Within a percent: files round their lengths. */
static bool same_spacing(const struct model *a, const struct model *b)
{
    bool same = true;
    for (unsigned w = 0; w < 3; w++) {
        double length = a->view.scalars.spacing[w] * a->world_unit;
        double other = b->view.scalars.spacing[w] * b->world_unit;
        same = same && fabs(length - other) <= length / 100;
    }
    return same;
}

/* The mask is classified by itself, its gradients too: at the edge of an organ
   that stands alone they are the organ's surface. */
static void read_mask(struct model *model, const struct settings *settings)
{
    struct settings own = *settings;
    struct model *mask = allocate(sizeof *mask, settings->mask, NULL);
    model->mask = mask;
    own.mask = NULL;
    own.mask_transfer = NULL;
    own.transfer = settings->mask_transfer;
    if (storage_is_indexed(model->storage)) {
        usage_error("--mask",
                    "two transfer functions need --storage rgba8 or rgba16, rgbt8 or rgbt16");
    }
    model_read(mask, &own, settings->mask, model->storage);
    if (mask->classified_before || mask->view.converted) {
        data_error(settings->mask, "type", "a mask has whole numbers of 8 or 16 bits");
    }
    if (memcmp(mask->view.scalars.size, model->view.scalars.size,
               sizeof model->view.scalars.size) != 0) {
        data_error(settings->mask, "size", "differs from that of %s", model->scan.file);
    }
    if (!same_spacing(mask, model)) {
        data_error(settings->mask, "spacing", "differs from that of %s", model->scan.file);
    }
}

static void refuse_classification(const struct settings *settings)
{
    const struct {
        const char *option;
        bool given;
    } refused[] = {
        {"--tf", settings->transfer != NULL},  {"--mask", settings->mask != NULL},
        {"--window", settings->window_given},  {"--shade", settings->shade},
        {"--storage", settings->storage != 0}, {"--palette-bits", settings->palette_bits != 0},
    };
    for (unsigned i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        if (refused[i].given) {
            usage_error(refused[i].option, "the input is classified already");
        }
    }
}

/* The size tells the width of the entries; no other is one. */
static void check_palette_size(const struct source *source)
{
    if (!source_holds(source, QV_PALETTE8_BYTES) && !source_holds(source, QV_PALETTE16_BYTES)) {
        data_error(source->name, "palette", "%s%llu bytes, 256 entries take %d or %d",
                   source->more ? "more than " : "", (unsigned long long)source->bytes,
                   QV_PALETTE8_BYTES, QV_PALETTE16_BYTES);
    }
}

/* Of indexed8 data, whose levels are as wide as the palette. */
static void swap_levels(struct scan *scan)
{
    if (scan->levels != NULL) {
        swap_words(scan->levels, scan->level_bytes, 2);
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
    check_palette_size(&source);
    model->palette_bytes = (uint32_t)source.bytes;
    model->palette = allocate(model->palette_bytes, source.name, "palette");
    file = fopen(source.path, "rb");
    if (file == NULL || fread(model->palette, model->palette_bytes, 1, file) != 1) {
        system_error(source.name, "palette");
    }
    fclose(file);
    model->storage = QV_STORAGE_INDEXED8;
    if (model->palette_bytes == QV_PALETTE16_BYTES) {
        model->storage = QV_STORAGE_INDEXED8_16;
        if (settings->big_endian != machine_is_big_endian()) {
            swap_words(model->palette, model->palette_bytes, 2);
            swap_levels(&model->scan);
        }
    }
    if (settings->extinction_given) {
        model->storage = storage_with_extinction(model->storage);
    }
}

static qv_storage storage_of_element(element type)
{
    switch (type) {
    case ELEMENT_RGBA8:
        return QV_STORAGE_RGBA8;
    case ELEMENT_RGBA16:
        return QV_STORAGE_RGBA16;
    case ELEMENT_RGBT8:
        return QV_STORAGE_RGBT8;
    case ELEMENT_ASSOCIATED8:
        return QV_STORAGE_ASSOCIATED8;
    default:
        return QV_STORAGE_RGBT16;
    }
}

/* The data do not tell what their full value means. */
static void read_extinction(struct model *model, const struct settings *settings)
{
    const char *type = choice_name(element_names, (int)model->scan.type);
    if (!storage_holds_extinction(model->storage)) {
        if (settings->extinction_given) {
            usage_error("--extinction", "data of type %s hold opacity", type);
        }
        return;
    }
    if (!(settings->extinction > 0)) {
        usage_error("--extinction", "data of type %s need the depth of their full value", type);
    }
    if (settings->unit_distance > 0) {
        usage_error("--unit-distance", "the input holds extinction, which needs none");
    }
    model->extinction = to_q16(settings->extinction);
}

/* What follows the voxels was compared with the widths that indexed8 data may have. */
static void check_levels(const struct model *model)
{
    if (model->scan.levels != NULL &&
        scan_levels(&model->scan, storage_of_entries(model->storage)) == 0) {
        data_error(model->scan.file, "levels", "%llu bytes are none of a palette of %u bytes",
                   (unsigned long long)model->scan.level_bytes, model->palette_bytes);
    }
}

/* Voxels that stand in the file as the renderer wants them. */
static void read_classified(struct model *model, const struct settings *settings)
{
    refuse_classification(settings);
    model->classified_before = true;
    if (model->scan.type == ELEMENT_INDEXED8) {
        read_palette(model, settings);
    } else {
        model->storage = storage_of_element(model->scan.type);
    }
    read_extinction(model, settings);
    check_levels(model);
}

void model_read(struct model *model, const struct settings *settings, const char *name,
                qv_storage default_storage)
{
    memset(model, 0, sizeof *model);
    model->unit_distance = settings->slices.count != 0 ? QV_ONE_Q16 : 0;
    if (settings->unit_distance > 0) {
        model->unit_distance = to_q16(settings->unit_distance);
    }
    input_read(&model->scan, name, &settings->raw);
    if (element_is_classified(model->scan.type)) {
        read_classified(model, settings);
    } else {
        read_scalars(model, settings, default_storage);
        if (settings->mask != NULL) {
            read_mask(model, settings);
        }
    }
}

void model_free(struct model *model)
{
    if (model->mask != NULL) {
        model_free(model->mask);
        free(model->mask);
    }
    if (model->palette != &model->table) {
        free(model->palette);
    }
    free(model->voxels);
    scan_free(&model->scan);
}
