/*
 * settings_check.c - options that make sense only together.
 */
#include "settings.h"
#include "error.h"
#include "picture.h"
#include "settings_advise.h"
#include "settings_freevoxel.h"
#include "settings_slices.h"
#include "voxel_storage.h"

bool settings_want_array(const struct settings *settings)
{
    const char *name = settings->output;
    return name != NULL && (has_ending(name, ".c") || has_ending(name, ".h"));
}

/* A file of voxels that hold opacity has no place for the length it holds for. */
static bool export_keeps_unit(const struct settings *settings)
{
    return settings_want_array(settings) || settings->json != NULL || settings->extinction_given ||
           settings->storage == QV_STORAGE_RGBT8 || settings->storage == QV_STORAGE_RGBT16;
}

/* nearest, separate and preweighted know no lengths. */
static bool sampling_may_weigh(const struct settings *settings)
{
    return settings->sampling != SAMPLING_NEAREST && settings->sampling != SAMPLING_SEPARATE &&
           settings->sampling != SAMPLING_PREWEIGHTED &&
           settings->storage != QV_STORAGE_ASSOCIATED8;
}

bool settings_back_to_front(const struct settings *settings)
{
    return settings->order == ORDER_BY_COMPOSITING ? settings->slices.wanted
                                                   : settings->order == ORDER_BACK_TO_FRONT;
}

void settings_refuse(const struct option_need *needs, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        if (needs[i].given && !needs[i].met) {
            usage_error(needs[i].option, "needs %s", needs[i].need);
        }
    }
}

void settings_check_needs(const struct settings *settings, int groups)
{
    bool exports = (groups & GROUP_EXPORT) != 0;
    bool levels = exports || settings->level_given || settings_make_levels(settings, groups);
    bool array = settings_want_array(settings);
    bool unit = settings->unit_distance > 0;
    bool back_to_front = settings_back_to_front(settings);
    const struct option_need needs[] = {
        {"--mask", settings->mask != NULL, settings->mask_transfer != NULL, "--mask-tf"},
        {"--mask-tf", settings->mask_transfer != NULL, settings->mask != NULL, "--mask"},
        {"--light", settings->light_given, settings->shade, "--shade"},
        {"--termination", settings->termination >= 0, !back_to_front,
         "--order front-to-back: from the back nothing ends early"},
        {"--unit-distance", unit && exports, export_keeps_unit(settings),
         "--storage rgbt8 or rgbt16, --extinction, --json or an output that ends in .c or .h"},
        {"--unit-distance", unit, sampling_may_weigh(settings),
         "another --sampling: nearest, separate and preweighted take opacities as they are"},
        {"--level", settings->level_given, sampling_may_weigh(settings),
         "another --sampling: nearest, separate and preweighted have no levels"},
        {"--level", settings->level_given, !back_to_front || settings->slices.wanted,
         "--order front-to-back"},
        {"--filter", settings->filter != FILTER_BY_SAMPLING, levels, "--level"},
        {"--domain", settings->domain != DOMAIN_BY_DEFAULT, levels, "--level"},
        {"--page", settings->cache.page_given, settings->cache.pages != 0, "--cache"},
        {"--cache", settings->cache.pages != 0,
         settings->sampling != SAMPLING_PREWEIGHTED && !settings->level_given &&
             settings->slices.bricks[0] == 0,
         "voxels of one volume, without --level, --bricks and --sampling preweighted"},
        {"--gain", settings->gain_given, settings->output != NULL, "--output"},
        {"--name", settings->name != NULL, array, "an output that ends in .c or .h"},
        {"--endian", settings->endian_given && exports, !array,
         "raw output: C arrays are in the compiler's byte order"},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
    if ((groups & GROUP_ADVISE) != 0) {
        settings_check_advise(settings);
        return;
    }
    settings_check_slices(settings, groups);
    settings_check_freevoxel(settings, groups);
}

qv_storage settings_storage(const struct settings *settings, qv_storage by_default)
{
    bool associated = settings->sampling == SAMPLING_PREWEIGHTED;
    qv_storage storage = settings->storage != 0 ? (qv_storage)settings->storage
                         : associated           ? QV_STORAGE_ASSOCIATED8
                                                : by_default;
    if (settings->palette_bits != 0 && !storage_is_indexed(storage)) {
        usage_error("--palette-bits", "only indexed8 has a palette");
    }
    if (settings->palette_bits == 16) {
        storage = QV_STORAGE_INDEXED8_16;
    }
    if (settings->extinction_given && storage_is_indexed(storage)) {
        storage = storage_with_extinction(storage);
    }
    if (settings->extinction_given && !storage_holds_extinction(storage)) {
        usage_error("--extinction", "needs --storage rgbt8, rgbt16 or indexed8");
    }
    return storage;
}
