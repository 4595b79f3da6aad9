/*
 * model_extinction.c - transfer tables of extinction, and of opacity for another length.
 *
 * Classification copies the table's fourth channel as it is, so voxels hold extinction
 * where the table does.
 */
#include "model.h"

/* What full opacity becomes for its unit distance where 8 bits hold it: half a level of
   255 shines through, and as many values as can be are left for the rest. */
#define OPAQUE_DEPTH_OF_8_BITS 9

static void table_entries(qv_entries *entries, const struct model *model, uint32_t unit_distance)
{
    *entries = (qv_entries){.entries = (qv_address)&model->table,
                            .count = QV_PALETTE_ENTRIES,
                            .unit_distance = unit_distance,
                            .storage = QV_STORAGE_RGBA16};
}

/* The library's own depth of full opacity, 64, is for 16 bits. */
static uint32_t extinction_of_opaque(qv_storage storage, uint32_t unit_distance)
{
    return storage_channel_bytes(storage) == 2
               ? 0
               : to_q16((double)OPAQUE_DEPTH_OF_8_BITS * QV_ONE_Q16 / unit_distance);
}

static uint32_t least_extinction(const struct model *model, uint32_t unit_distance)
{
    uint32_t extinction;
    qv_entries entries;
    table_entries(&entries, model, unit_distance);
    check_status(qv_extinction_of(&extinction, &entries,
                                  extinction_of_opaque(model->storage, unit_distance)),
                 model, "extinction");
    return extinction;
}

/* Of 8 bits, from the table; that of 16 bits is the table. */
static void renew_palette(struct model *model)
{
    if (model->palette_bytes == QV_PALETTE8_BYTES) {
        qv_transfer_to_palette8(model->palette, &model->table);
    }
}

/* In place. */
static void convert_table(struct model *model, uint32_t extinction, uint32_t unit_distance)
{
    qv_entries entries;
    table_entries(&entries, model, unit_distance);
    check_status(qv_opacity_to_extinction(&model->table, sizeof model->table, QV_STORAGE_RGBT16,
                                          extinction, &entries),
                 model, "extinction");
    renew_palette(model);
    model->unit_distance = unit_distance;
    model->extinction = extinction;
}

void model_hold_extinction(struct model *model, const struct settings *settings)
{
    uint32_t unit = model->unit_distance != 0 ? model->unit_distance : to_q16(settings->step);
    uint32_t extinction = 0;
    if (model->classified_before || !storage_holds_extinction(model->storage)) {
        return;
    }
    if (settings->extinction > 0) {
        extinction = to_q16(settings->extinction);
    } else {
        extinction = least_extinction(model, unit);
        if (model->mask != NULL) {
            uint32_t masked = least_extinction(model->mask, unit);
            extinction = masked > extinction ? masked : extinction;
        }
    }
    convert_table(model, extinction, unit);
    if (model->mask != NULL) {
        convert_table(model->mask, extinction, unit);
    }
}

void model_hold_steps(struct model *model, uint32_t step)
{
    qv_entries entries;
    table_entries(&entries, model, model->unit_distance);
    check_status(qv_opacity_to_opacity(&model->table, sizeof model->table, QV_STORAGE_RGBA16, step,
                                       &entries),
                 model, "opacity");
    renew_palette(model);
    model->unit_distance = 0;
    if (model->mask != NULL) {
        model_hold_steps(model->mask, step);
    }
}
