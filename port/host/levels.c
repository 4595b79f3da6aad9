/*
 * levels.c - downsamples slices on several threads.
 */
#include "levels.h"
#include "error.h"
#include "parallel.h"
#include "sampling.h"

#include <stdlib.h>
#include <string.h>

static int chosen_filter(const struct model *model, const struct settings *settings)
{
    int mode = sampling_mode(settings, model->storage);
    if (settings->filter != FILTER_BY_SAMPLING) {
        return settings->filter;
    }
    return mode == SAMPLING_BSPLINE_WEIGHTED || mode == SAMPLING_BSPLINE_EXTINCTION ? FILTER_QUAD4
                                                                                    : FILTER_BOX4;
}

static const qv_filter *library_filter(int filter)
{
    switch (filter) {
    case FILTER_BOX2:
        return &qv_filter_box2;
    case FILTER_BOX4:
        return &qv_filter_box4;
    default:
        return &qv_filter_quad4;
    }
}

static int chosen_domain(const struct model *model, const struct settings *settings)
{
    if (settings->domain != DOMAIN_OPACITY) {
        return DOMAIN_EXTINCTION;
    }
    if (storage_holds_extinction(model->storage)) {
        usage_error("--domain", "the volume holds extinction, no opacity");
    }
    return DOMAIN_OPACITY;
}

struct slices {
    const struct model *model;
    const qv_volume *finer;
    const qv_filter *filter;
    const qv_domain *domain;
    uint8_t *voxels;
    size_t slice_bytes;
};

/* Slices share nothing that is written. */
static void downsample_slice(void *context, uint32_t z)
{
    const struct slices *s = context;
    check_status(qv_downsample(s->voxels + z * s->slice_bytes, s->slice_bytes, s->finer, s->filter,
                               s->domain, (uint16_t)z, (uint16_t)(z + 1)),
                 s->model, "levels");
}

/* Level by level, each from the one before. */
static void downsample(struct levels *levels, struct slices *slices, const qv_volume *volume,
                       const struct settings *settings)
{
    qv_volume finer = *volume, level;
    for (uint8_t number = 1; number <= levels->pyramid.levels; number++) {
        struct parallel work = {downsample_slice, slices, 0, settings->threads,
                                progress_label(settings->quiet, "downsampling")};
        check_status(qv_pyramid_level(&level, volume, &levels->pyramid, number), slices->model,
                     "levels");
        slices->finer = &finer;
        slices->slice_bytes = (size_t)level.stride[2];
        slices->voxels = (uint8_t *)levels->voxels + (level.voxels - levels->pyramid.voxels);
        work.pieces = level.size[2];
        parallel_run(&work);
        finer = level;
    }
}

void levels_build(struct levels *levels, const qv_volume *volume, const struct model *model,
                  const struct settings *settings)
{
    int filter = chosen_filter(model, settings);
    int domain = chosen_domain(model, settings);
    bool stored = domain == DOMAIN_OPACITY || storage_holds_extinction(model->storage);
    struct slices slices = {.model = model,
                            .filter = library_filter(filter),
                            .domain = stored ? &qv_domain_stored : &qv_domain_extinction};
    qv_pyramid *pyramid = &levels->pyramid;
    memset(levels, 0, sizeof *levels);
    pyramid->levels = qv_pyramid_levels(volume->size);
    if (pyramid->levels == 0) {
        data_error(model->scan.file, "levels", "a single voxel has none");
    }
    pyramid->bytes = qv_pyramid_bytes(volume->size, volume->storage, pyramid->levels);
    levels->voxels = allocate(pyramid->bytes, model->scan.file, "levels");
    levels->filter = choice_name(filter_names, filter);
    levels->domain = choice_name(domain_names, domain);
    pyramid->voxels = levels->voxels;
    downsample(levels, &slices, volume, settings);
}

/* Nothing is left to choose about levels that are there. */
static void take_levels(struct levels *levels, const struct model *model,
                        const struct settings *settings)
{
    if (settings->filter != FILTER_BY_SAMPLING) {
        usage_error("--filter", "the input has its levels already");
    }
    if (settings->domain != DOMAIN_BY_DEFAULT) {
        usage_error("--domain", "the input has its levels already");
    }
    memset(levels, 0, sizeof *levels);
    levels->pyramid.voxels = model->scan.levels;
    levels->pyramid.bytes = model->scan.level_bytes;
    levels->pyramid.levels = scan_levels(&model->scan, storage_of_entries(model->storage));
}

void levels_create(struct levels *levels, const qv_volume *volume, const struct model *model,
                   const struct settings *settings)
{
    if (model->scan.levels != NULL) {
        take_levels(levels, model, settings);
    } else {
        levels_build(levels, volume, model, settings);
    }
}

void levels_free(struct levels *levels)
{
    free(levels->voxels);
}
