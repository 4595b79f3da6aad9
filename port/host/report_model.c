/*
 * report_model.c - where voxels come from, as JSON.
 */
#include "report_model.h"

void report_input(struct json *json, const struct scan *scan)
{
    char orientation[4];
    scan_orientation_text(scan, orientation);
    json_object(json, "input");
    json_text(json, "file", scan->file);
    json_text(json, "format", scan->format);
    json_triple(json, "size", scan->size[0], scan->size[1], scan->size[2]);
    json_text(json, "type", choice_name(element_names, (int)scan->type));
    json_unsigned(json, "bytes", scan->bytes);
    json_unsigned(json, "level_bytes", scan->level_bytes);
    json_decimals(json, "spacing", scan->spacing, 3);
    json_text(json, "orientation", scan->oriented ? orientation : "unknown");
    json_decimal(json, "slope", scan->slope);
    json_decimal(json, "offset", scan->offset);
    json_close(json);
}

static const char *scalar_type_name(uint8_t type)
{
    static const char *const names[] = {"", "u8", "u16", "s16"};
    return names[type];
}

/* How stored values became the scalars, in world order, that are classified. */
static void report_scalars(struct json *json, const struct model *model)
{
    const struct scalar_view *view = &model->view;
    const qv_scalars *scalars = &view->scalars;
    const uint8_t *axis = model->scan.turn.axis;
    const bool *reversed = model->scan.turn.reversed;
    json_object(json, "scalars");
    json_text(json, "type", scalar_type_name(scalars->type));
    json_triple(json, "size", scalars->size[0], scalars->size[1], scalars->size[2]);
    json_triple(json, "stored_axis", axis[0], axis[1], axis[2]);
    json_triple(json, "reversed", reversed[0], reversed[1], reversed[2]);
    json_decimals(json, "window", view->window, 2);
    json_integer(json, "low", view->low);
    json_integer(json, "high", view->high);
    json_text(json, "conversion",
              view->converted ? "round(65535 * (slope * stored + offset - window[0]) / "
                                "(window[1] - window[0])), clamped to 0 .. 65535"
                              : "none");
    json_triple(json, "reduction", model->reduction[0], model->reduction[1], model->reduction[2]);
    json_text(json, "index", "round(255 * (scalar - low) / (high - low)), clamped to 0 .. 255");
    json_close(json);
}

static void report_shading(struct json *json, const struct model *model)
{
    const qv_shading *shading = &model->shading;
    if (!model->shaded) {
        json_null(json, "shading");
        return;
    }
    json_object(json, "shading");
    json_triple(json, "light", shading->light[0], shading->light[1], shading->light[2]);
    json_triple(json, "viewer", shading->viewer[0], shading->viewer[1], shading->viewer[2]);
    json_integer(json, "ambient", shading->ambient);
    json_integer(json, "diffuse", shading->diffuse);
    json_integer(json, "specular", shading->specular);
    json_integer(json, "gloss", shading->gloss);
    json_integer(json, "least_gradient", shading->least_gradient);
    json_close(json);
}

/* One line for each of the 256 entries. */
static void report_table(struct json *json, const uint16_t *words, const uint8_t *bytes)
{
    json_array(json, "table");
    for (unsigned i = 0; i < QV_PALETTE_ENTRIES; i++) {
        int64_t entry[4];
        for (unsigned c = 0; c < 4; c++) {
            entry[c] = words != NULL ? words[4 * i + c] : bytes[4 * i + c];
        }
        json_integers(json, NULL, entry, 4);
    }
    json_close(json);
}

static void report_transfer(struct json *json, const struct model *model)
{
    bool wide = model->palette_bytes != QV_PALETTE8_BYTES;
    json_object(json, "transfer");
    if (!model->classified_before) {
        json_text(json, "name", model->transfer.name);
    } else if (model->palette != NULL) {
        json_text(json, "name", "palette");
    } else {
        json_null(json, "name");
    }
    json_text(json, "channels", storage_holds_extinction(model->storage) ? "rgbt" : "rgba");
    if (model->palette != NULL) { /* what the samples read */
        json_integer(json, "bits", wide ? 16 : 8);
        report_table(json, wide ? model->palette : NULL, wide ? NULL : model->palette);
    } else if (!model->classified_before) {
        json_integer(json, "bits", 16);
        report_table(json, &model->table.rgba[0][0], NULL);
    }
    json_close(json);
}

/* From the file to classified voxels. */
static void report_classification(struct json *json, const struct model *model)
{
    report_input(json, &model->scan);
    if (!model->classified_before) {
        report_scalars(json, model);
        report_shading(json, model);
    }
    report_transfer(json, model);
}

static void report_mask(struct json *json, const struct model *mask)
{
    json_object(json, "mask");
    json_text(json, "rule", "where its scalar is above 0, its voxel replaces the input's");
    report_classification(json, mask);
    json_close(json);
}

void report_model(struct json *json, const struct model *model)
{
    json_text(json, "program", "qvol");
    json_text(json, "version", qv_version());
    json_integer(json, "specification", QV_SPECIFICATION);
    report_classification(json, model);
    if (model->mask != NULL) {
        report_mask(json, model->mask);
    }
}

/* 0 stands for what there is not. */
static void number_or_null(struct json *json, const char *key, uint32_t number)
{
    if (number != 0) {
        json_integer(json, key, number);
    } else {
        json_null(json, key);
    }
}

/* What the fourth channel means. Extinction that the input brought has no unit distance. */
static void report_fourth(struct json *json, const struct model *model, uint32_t step)
{
    bool extinction = storage_holds_extinction(model->storage);
    uint32_t unit = model->unit_distance;
    if (unit == 0 && !extinction) {
        unit = step;
    }
    number_or_null(json, "unit_distance_q16", unit);
    number_or_null(json, "extinction_q16", model->extinction);
}

void report_volume(struct json *json, const qv_volume *volume, const struct model *model,
                   uint32_t step)
{
    json_object(json, "volume");
    json_text(json, "storage", storage_name(model->storage));
    json_integer(json, "palette_bytes", volume->palette_bytes);
    json_triple(json, "size", volume->size[0], volume->size[1], volume->size[2]);
    json_triple(json, "stride", volume->stride[0], volume->stride[1], volume->stride[2]);
    json_triple(json, "spacing_q16", volume->spacing[0], volume->spacing[1], volume->spacing[2]);
    report_fourth(json, model, step);
    json_decimal(json, "world_unit", model->world_unit);
    json_unsigned(json, "bytes", volume->voxels_bytes);
    json_close(json);
}

/* Spacings in the file's unit. */
static void report_level(struct json *json, const qv_volume *level, uint8_t number,
                         const struct model *model, uint64_t offset)
{
    double spacing[3];
    for (unsigned a = 0; a < 3; a++) {
        spacing[a] = level->spacing[a] * model->world_unit / QV_ONE_Q16;
    }
    json_object(json, NULL);
    json_integer(json, "level", number);
    json_text(json, "storage", storage_name((qv_storage)level->storage));
    json_triple(json, "size", level->size[0], level->size[1], level->size[2]);
    json_decimals(json, "spacing", spacing, 3);
    json_unsigned(json, "offset", offset);
    json_unsigned(json, "bytes", level->voxels_bytes);
    json_close(json);
}

/* "box4", "extinction", ..., or null: the input's own. */
static void text_or_null(struct json *json, const char *key, const char *text)
{
    if (text != NULL) {
        json_text(json, key, text);
    } else {
        json_null(json, key);
    }
}

void report_levels(struct json *json, const struct levels *levels, const qv_volume *volume,
                   const struct model *model, uint64_t first_offset)
{
    const qv_pyramid *pyramid = &levels->pyramid;
    json_object(json, "pyramid");
    text_or_null(json, "filter", levels->filter);
    text_or_null(json, "domain", levels->domain);
    json_array(json, "levels");
    for (uint8_t number = 1; number <= pyramid->levels; number++) {
        qv_volume level;
        check_status(qv_pyramid_level(&level, volume, pyramid, number), model, "levels");
        report_level(json, &level, number, model,
                     first_offset + (uint64_t)(level.voxels - pyramid->voxels));
    }
    json_close(json);
    json_close(json);
}
