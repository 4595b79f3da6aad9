/*
 * freevoxel_build.c - copies voxels into records, and attenuates them direction by direction.
 */
#include "freevoxel_build.h"
#include "error.h"
#include "freevoxel_reorder.h"
#include "parallel.h"

#include <stdlib.h>
#include <string.h>

struct build {
    uint8_t *bytes;             /* to be written */
    struct freevoxel_file file; /* the same, as a reader sees it */
    const qv_volume *volume;
    const struct levels *levels;
    const struct model *model;
    const qv_domain *domain;
    uint8_t level; /* whose voxels are copied */
    qv_volume level_volume;
};

/* A level as a volume of its own. */
static void describe(qv_volume *level, const struct build *build, uint8_t number)
{
    check_status(qv_pyramid_level(level, build->volume, &build->levels->pyramid, number),
                 build->model, "levels");
}

/* ---- Voxels ------------------------------------------------------------------- */

/* Slices share no record. */
static void copy_slice(void *context, uint32_t z)
{
    const struct build *build = context;
    const struct freevoxel_level *level = &build->file.header.levels[build->level];
    const qv_volume *volume = &build->level_volume;
    uint64_t before = (uint64_t)z * level->size[0] * level->size[1];
    uint8_t *record = build->bytes + level->offset + before * level->record;
    uint16_t position[3] = {0, 0, (uint16_t)z};
    for (; position[1] < level->size[1]; position[1]++) {
        for (position[0] = 0; position[0] < level->size[0]; position[0]++) {
            int64_t place = 0; /* within the volume's memory */
            for (unsigned a = 0; a < 3; a++) {
                place += (int64_t)volume->stride[a] * position[a];
            }
            freevoxel_put_voxel(record, level, volume->voxels + place);
            record += level->record;
        }
    }
}

static void copy_voxels(struct build *build, const struct settings *settings)
{
    for (uint8_t number = 0; number <= build->file.header.coarser; number++) {
        struct parallel work = {copy_slice, build, 0, settings->threads,
                                progress_label(settings->quiet, "copying")};
        build->level = number;
        describe(&build->level_volume, build, number);
        work.pieces = build->level_volume.size[2];
        parallel_run(&work);
    }
}

/* ---- Attenuation ---------------------------------------------------------------- */

/* What the library refuses comes from options that say what opacity means. */
static void check_attenuated(qv_status status, const struct model *model)
{
    if (status == QV_ERROR_UNIT ||
        (status == QV_ERROR_EXTINCTION && !storage_holds_extinction(model->storage))) {
        usage_error("--unit-distance", "%s", qv_status_text(status));
    }
    if (status == QV_ERROR_EXTINCTION) {
        usage_error("--extinction", "%s", qv_status_text(status));
    }
    check_status(status, model, "attenuation");
}

/* Attenuation is a matter of proportions: lengths that a deep level has, and the library does not
   take, are all halved, unit distances rounded up to stay above 0. An extinction of 2^31 or more
   would be too much for lengths above 256 anyway. */
static void shrink(qv_volume *volume)
{
    while (volume->spacing[0] > FREEVOXEL_SPACING_MOST ||
           volume->spacing[1] > FREEVOXEL_SPACING_MOST ||
           volume->spacing[2] > FREEVOXEL_SPACING_MOST) {
        for (unsigned a = 0; a < 3; a++) {
            volume->spacing[a] /= 2;
        }
        volume->unit_distance -= volume->unit_distance / 2;
        volume->extinction *= 2;
    }
}

/* Of a level by its own voxels. blocks: null, or the sums for coarser ones. */
static void attenuate(const struct build *build, uint8_t number, uint8_t direction,
                      uint32_t *blocks)
{
    const struct freevoxel_level *level = &build->file.header.levels[number];
    qv_attenuation attenuation;
    qv_volume volume;
    describe(&volume, build, number);
    shrink(&volume);
    freevoxel_file_attenuation(&attenuation, &build->file, number);
    check_attenuated(qv_attenuate(build->bytes + level->offset + level->voxel_bytes,
                                  (size_t)attenuation.bytes, blocks, &attenuation, &volume,
                                  build->domain, direction),
                     build->model);
}

/* Of a level by means over the voxels of level 0. */
static void average(const struct build *build, uint8_t number, uint8_t direction,
                    const uint32_t *blocks)
{
    const struct freevoxel_level *level = &build->file.header.levels[number];
    qv_attenuation attenuation;
    freevoxel_file_attenuation(&attenuation, &build->file, number);
    check_attenuated(qv_attenuate_level(build->bytes + level->offset + level->voxel_bytes,
                                        (size_t)attenuation.bytes, &attenuation, blocks,
                                        build->volume->size, number, direction),
                     build->model);
}

static uint32_t *allocate_blocks(const struct build *build)
{
    return allocate(qv_blocks_bytes(build->volume->size), build->model->scan.file, "levels");
}

/* The set's direction of that rank. */
static uint8_t nth_direction(uint32_t directions, uint32_t rank)
{
    uint8_t direction = 0;
    for (;; direction++) {
        bool is_in = (directions >> direction & 1u) != 0;
        if (is_in && rank-- == 0) {
            return direction;
        }
    }
}

/* Directions share no byte. */
static void build_direction(void *context, uint32_t rank)
{
    const struct build *build = context;
    const struct freevoxel_header *header = &build->file.header;
    uint8_t direction = nth_direction(header->directions, rank);
    uint32_t *blocks = header->hierarchy == FREEVOXEL_GEOMETRIC ? allocate_blocks(build) : NULL;
    attenuate(build, 0, direction, blocks);
    for (uint8_t number = 1; number <= header->coarser; number++) {
        if (blocks != NULL) {
            average(build, number, direction, blocks);
        } else {
            attenuate(build, number, direction, NULL);
        }
    }
    free(blocks);
}

/* The levels in linear order. */
static void build_linear(uint8_t *bytes, const struct freevoxel_header *header,
                         const qv_volume *volume, const struct levels *levels,
                         const struct model *model, const struct settings *settings)
{
    bool stored = storage_holds_extinction((qv_storage)volume->storage);
    struct build build = {.bytes = bytes,
                          .file = {.name = settings->output, .bytes = bytes, .header = *header},
                          .volume = volume,
                          .levels = levels,
                          .model = model,
                          .domain = stored ? &qv_domain_stored : &qv_domain_extinction};
    struct parallel work = {build_direction, &build, qv_directions_count(header->directions),
                            settings->threads, progress_label(settings->quiet, "attenuating")};
    build.file.header.order = FREEVOXEL_LINEAR;
    copy_voxels(&build, settings);
    parallel_run(&work);
}

void freevoxel_build(uint8_t *bytes, const struct freevoxel_header *header, const qv_volume *volume,
                     const struct levels *levels, const struct model *model,
                     const struct settings *settings)
{
    freevoxel_header_write(bytes, header);
    if (header->order == FREEVOXEL_LINEAR) {
        build_linear(bytes, header, volume, levels, model, settings);
    } else {
        uint8_t *linear = allocate(header->total_bytes, model->scan.file, "order");
        build_linear(linear, header, volume, levels, model, settings);
        freevoxel_reorder(bytes, header, linear, settings);
        free(linear);
    }
}
