/*
 * freevoxel_reorder.c - finds the index of each voxel once, whatever the number of directions.
 */
#include "freevoxel_reorder.h"
#include "parallel.h"

#include <string.h>

struct reorder {
    uint8_t *to; /* first records of the level */
    const uint8_t *from;
    const struct freevoxel_level *level;
    const qv_order *order;
};

/* Slices share no record. */
static void reorder_slice(void *context, uint32_t z)
{
    const struct reorder *r = context;
    const uint16_t *size = r->level->size;
    size_t record = r->level->record;
    const uint8_t *from = r->from + (uint64_t)z * size[0] * size[1] * record;
    uint16_t position[3] = {0, 0, (uint16_t)z};
    for (; position[1] < size[1]; position[1]++) {
        for (position[0] = 0; position[0] < size[0]; position[0]++) {
            memcpy(r->to + r->order->index(size, position) * record, from, record);
            from += record;
        }
    }
}

void freevoxel_reorder(uint8_t *bytes, const struct freevoxel_header *header, const uint8_t *linear,
                       const struct settings *settings)
{
    for (unsigned l = 0; l <= header->coarser; l++) {
        const struct freevoxel_level *level = &header->levels[l];
        struct reorder reorder = {bytes + level->offset, linear + level->offset, level,
                                  freevoxel_order(header)};
        struct parallel work = {reorder_slice, &reorder, level->size[2], settings->threads,
                                progress_label(settings->quiet, "ordering")};
        parallel_run(&work);
    }
}
