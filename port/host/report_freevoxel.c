/*
 * report_freevoxel.c - what a FreeVoxel file holds and takes.
 */
#include "report_freevoxel.h"
#include "direction_text.h"
#include "freevoxel_header.h"
#include "settings_freevoxel.h"

#include <inttypes.h>
#include <stdio.h>

static const char *hierarchy_name(const struct freevoxel_header *header)
{
    return header->coarser == 0 ? "none" : choice_name(hierarchy_names, header->hierarchy);
}

static void report_level(struct json *json, const struct freevoxel_level *level)
{
    json_object(json, NULL);
    json_triple(json, "size", level->size[0], level->size[1], level->size[2]);
    json_text(json, "storage", storage_name((qv_storage)level->storage));
    json_unsigned(json, "voxels", level->voxels);
    json_integer(json, "record_bytes", level->record);
    json_unsigned(json, "offset", level->offset);
    json_unsigned(json, "bytes", level->voxels * level->record);
    json_close(json);
}

void report_freevoxels(struct json *json, const struct freevoxel_header *header)
{
    json_object(json, "freevoxels");
    json_text(json, "order", choice_name(voxel_order_names, header->order));
    json_text(json, "hierarchy", hierarchy_name(header));
    json_array(json, "directions");
    for (unsigned d = 0; d < QV_DIRECTIONS; d++) {
        char name[DIRECTION_BYTES];
        direction_name(name, d);
        if ((header->directions >> d & 1u) != 0) {
            json_text(json, NULL, name);
        }
    }
    json_close(json);
    json_array(json, "levels");
    for (unsigned l = 0; l <= header->coarser; l++) {
        report_level(json, &header->levels[l]);
    }
    json_close(json);
    json_unsigned(json, "bytes", header->total_bytes);
    json_close(json);
}

void report_freevoxel_file(struct json *json, const struct freevoxel_file *file)
{
    const qv_volume *volume = &file->header.volume;
    const uint32_t *spacing = volume->spacing;
    json_text(json, "program", "qvol");
    json_text(json, "version", qv_version());
    json_integer(json, "specification", QV_SPECIFICATION);
    json_object(json, "input");
    json_text(json, "file", file->name);
    json_text(json, "format", "FreeVoxel");
    json_triple(json, "size", volume->size[0], volume->size[1], volume->size[2]);
    json_triple(json, "spacing_q16", spacing[0], spacing[1], spacing[2]);
    json_text(json, "storage", storage_name((qv_storage)volume->storage));
    json_integer(json, "palette_bytes", volume->palette_bytes);
    json_integer(json, "unit_distance_q16", volume->unit_distance);
    json_integer(json, "extinction_q16", volume->extinction);
    json_close(json);
    report_freevoxels(json, &file->header);
}

static void print_directions(uint32_t directions)
{
    printf("directions   %u:", qv_directions_count(directions));
    for (unsigned d = 0; d < QV_DIRECTIONS; d++) {
        char name[DIRECTION_BYTES];
        direction_name(name, d);
        if ((directions >> d & 1u) != 0) {
            printf(" %s", name);
        }
    }
    printf("\n");
}

/* For what a stored fourth channel holds. */
static void print_opacity(const qv_volume *volume)
{
    if (volume->extinction != 0) {
        printf("extinction   %g of the full value\n", volume->extinction / (double)QV_ONE_Q16);
    } else if (volume->unit_distance != 0) {
        printf("opacities    for a length of %g\n", volume->unit_distance / (double)QV_ONE_Q16);
    } else {
        printf("opacities    for a step of any direction\n");
    }
}

void print_freevoxel_file(const struct freevoxel_file *file)
{
    const struct freevoxel_header *header = &file->header;
    const qv_volume *volume = &header->volume;
    printf("file         %s\n", file->name);
    printf("format       FreeVoxel %d\n", FREEVOXEL_VERSION);
    printf("size         %u x %u x %u\n", volume->size[0], volume->size[1], volume->size[2]);
    printf("type         %s\n", storage_name((qv_storage)volume->storage));
    printf("spacing      %g x %g x %g\n", volume->spacing[0] / (double)QV_ONE_Q16,
           volume->spacing[1] / (double)QV_ONE_Q16, volume->spacing[2] / (double)QV_ONE_Q16);
    print_opacity(volume);
    print_directions(header->directions);
    printf("order        %s\n", choice_name(voxel_order_names, header->order));
    printf("hierarchy    %s\n", hierarchy_name(header));
    for (unsigned l = 0; l <= header->coarser; l++) {
        const struct freevoxel_level *level = &header->levels[l];
        printf("level %-2u     %u x %u x %u, %" PRIu64 " voxels of %u bytes at %" PRIu64 "\n", l,
               level->size[0], level->size[1], level->size[2], level->voxels, level->record,
               level->offset);
    }
    printf("bytes        %" PRIu64 ", %.2f a voxel\n", header->total_bytes,
           (double)header->total_bytes / (double)header->levels[0].voxels);
}
