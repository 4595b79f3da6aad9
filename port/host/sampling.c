/*
 * sampling.c - a table of the library's sampling modes.
 */
#include "sampling.h"
#include "error.h"
#include "voxel_storage.h"

#include <stddef.h>

/* Of storage that holds opacity, or of storage that holds extinction. */
#define STORAGES 4

enum way { FRONT_TO_BACK, BACK_TO_FRONT, PAGED, PAGED_BACK_TO_FRONT, THROUGH_LEVELS, WAYS };

struct family {
    const qv_sampling *by_step[WAYS][STORAGES]; /* opacities as they are */
    const qv_sampling *opacity[WAYS][STORAGES]; /* by length */
    const qv_sampling *extinction[WAYS][STORAGES];
};

#define OF_OPACITY(mode, way)                                                                      \
    {                                                                                              \
        &qv_##mode##_rgba8##way, &qv_##mode##_rgba16##way, &qv_##mode##_indexed8##way,             \
            &qv_##mode##_indexed8_16##way                                                          \
    }
#define OF_EXTINCTION(mode, way)                                                                   \
    {                                                                                              \
        &qv_##mode##_rgbt8##way, &qv_##mode##_rgbt16##way, &qv_##mode##_indexed8_t8##way,          \
            &qv_##mode##_indexed8_t16##way                                                         \
    }
#define BOTH_ORDERS(list, mode)                                                                    \
    list(mode, ), list(mode, _back_to_front), list(mode, _paged), list(mode, _paged_back_to_front)
#define ALL_WAYS(list, mode) BOTH_ORDERS(list, mode), list(mode, _levels)

static const struct family families[SAMPLING_MODES] = {
    [SAMPLING_NEAREST] = {.by_step = {BOTH_ORDERS(OF_OPACITY, nearest)}},
    [SAMPLING_SEPARATE] = {.by_step = {BOTH_ORDERS(OF_OPACITY, separate)}},
    [SAMPLING_PREWEIGHTED] = {.by_step = {{&qv_preweighted_associated8},
                                          {&qv_preweighted_associated8_back_to_front}}},
    [SAMPLING_WEIGHTED] = {.by_step = {BOTH_ORDERS(OF_OPACITY, weighted)},
                           .opacity = {ALL_WAYS(OF_OPACITY, corrected)}},
    [SAMPLING_EXTINCTION] = {.opacity = {ALL_WAYS(OF_OPACITY, extinction)},
                             .extinction = {ALL_WAYS(OF_EXTINCTION, extinction)}},
    [SAMPLING_BSPLINE_WEIGHTED] = {.opacity = {ALL_WAYS(OF_OPACITY, bspline_weighted)}},
    [SAMPLING_BSPLINE_EXTINCTION] = {.opacity = {ALL_WAYS(OF_OPACITY, bspline_extinction)},
                                     .extinction = {ALL_WAYS(OF_EXTINCTION, bspline_extinction)}},
};

int sampling_mode(const struct settings *settings, qv_storage storage)
{
    if (settings->sampling != SAMPLING_BY_STORAGE) {
        return settings->sampling;
    }
    if (storage_is_associated(storage)) {
        return SAMPLING_PREWEIGHTED;
    }
    return storage_holds_extinction(storage) ? SAMPLING_EXTINCTION : SAMPLING_WEIGHTED;
}

static enum way way_of(const struct settings *settings)
{
    if (settings->level_given) {
        return THROUGH_LEVELS;
    }
    if (settings->cache.pages != 0) {
        return settings_back_to_front(settings) ? PAGED_BACK_TO_FRONT : PAGED;
    }
    return settings_back_to_front(settings) ? BACK_TO_FRONT : FRONT_TO_BACK;
}

/* Where nothing asks for lengths, weighted samples stand for one step each. A number of slices
   does: their opacities hold for a length. */
bool sampling_by_length(const struct settings *settings, qv_storage storage)
{
    const struct family *family = &families[sampling_mode(settings, storage)];
    bool asked =
        settings->unit_distance > 0 || settings->level_given || settings->slices.count != 0;
    return family->by_step[FRONT_TO_BACK][0] == NULL ||
           (asked && family->opacity[FRONT_TO_BACK][0] != NULL);
}

const qv_sampling *sampling_choose(const struct settings *settings, qv_storage storage)
{
    int mode = sampling_mode(settings, storage);
    enum way way = way_of(settings);
    const struct family *family = &families[mode];
    const qv_sampling *sampling;
    if (storage_is_associated(storage) != (mode == SAMPLING_PREWEIGHTED)) {
        usage_error("--sampling", "preweighted and storage associated8 need each other");
    }
    if (storage_is_associated(storage)) {
        sampling = family->by_step[way][0];
    } else if (storage_holds_extinction(storage)) {
        sampling = family->extinction[way][storage - QV_STORAGE_RGBT8];
    } else if (sampling_by_length(settings, storage)) {
        sampling = family->opacity[way][storage - QV_STORAGE_RGBA8];
    } else {
        sampling = family->by_step[way][storage - QV_STORAGE_RGBA8];
    }
    if (sampling == NULL && storage_is_associated(storage)) {
        usage_error("--cache", "there is no preweighted sampling through pages");
    }
    if (sampling == NULL) {
        usage_error("--sampling", "%s takes opacities; storage that holds extinction needs %s",
                    choice_name(sampling_names, mode), "extinction or bspline-extinction");
    }
    return sampling;
}
