/*
 * command_pyramid.c - a volume and its coarser levels, for later or for a device.
 */
#include "commands.h"
#include "error.h"
#include "export.h"

#include <stdlib.h>

int command_pyramid(const struct settings *settings)
{
    struct model model;
    struct levels levels;
    struct export export;
    qv_volume volume;
    export_check_settings(settings);
    model_read(&model, settings, settings->operands[0], QV_STORAGE_RGBA16);
    if (storage_is_associated(model.storage)) {
        usage_error("--storage", "associated8 has no levels");
    }
    export_check_model(&model, settings);
    model_volume(&volume, &model, settings);
    levels_build(&levels, &volume, &model, settings);
    export_begin(&export, &model, &volume, &levels, settings);
    export_voxels(&export, volume.voxels, (size_t)volume.voxels_bytes);
    export_end(&export);
    levels_free(&levels);
    model_free(&model);
    return EXIT_SUCCESS;
}
