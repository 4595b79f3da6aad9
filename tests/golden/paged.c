#include "paged.h"
#include "set.h"

#include <string.h>

/* ---- Modes ---------------------------------------------------------------- */

typedef struct pair {
    const qv_sampling *in_memory, *paged;
} pair;

#define BOTH(name, order)                                                                          \
    {                                                                                              \
        &name##order, &name##_paged##order                                                         \
    }
#define PAIR(name) BOTH(name, ), BOTH(name, _back_to_front)
#define OPACITY_PAIRS(mode)                                                                        \
    PAIR(mode##_rgba8), PAIR(mode##_rgba16), PAIR(mode##_indexed8), PAIR(mode##_indexed8_16)
#define EXTINCTION_PAIRS(mode)                                                                     \
    PAIR(mode##_rgbt8), PAIR(mode##_rgbt16), PAIR(mode##_indexed8_t8), PAIR(mode##_indexed8_t16)

static const pair pairs[] = {
    OPACITY_PAIRS(qv_nearest),
    OPACITY_PAIRS(qv_separate),
    OPACITY_PAIRS(qv_weighted),
    OPACITY_PAIRS(qv_corrected),
    OPACITY_PAIRS(qv_bspline_weighted),
    OPACITY_PAIRS(qv_extinction),
    EXTINCTION_PAIRS(qv_extinction),
    OPACITY_PAIRS(qv_bspline_extinction),
    EXTINCTION_PAIRS(qv_bspline_extinction),
};

/* Null: there is none. */
static const qv_sampling *paged_of(const qv_sampling *sampling)
{
    for (unsigned i = 0; i < COUNT(pairs); i++)
        if (pairs[i].in_memory == sampling)
            return pairs[i].paged;
    return NULL;
}

bool golden_is_paged(const golden_mode *mode)
{
    return paged_of(mode->sampling) != NULL;
}

/* ---- Caches --------------------------------------------------------------- */

/* Pages for trilinear modes, and for B-splines. */
static const struct cache {
    uint8_t shift[3];
    uint16_t count, count_of_bspline;
} caches[GOLDEN_CACHES] = {
    {{1, 1, 1}, 8, 8},    {{2, 1, 3}, 8, 8},   {{3, 3, 3}, 9, 9},
    {{12, 12, 0}, 2, 3},  {{0, 12, 12}, 2, 3}, {{12, 2, 12}, 2, 2},
    {{12, 12, 12}, 1, 1}, {{1, 2, 0}, 50, 50}, {{2, 2, 2}, 16, 16},
};

enum { MOST_PAGES = 64 };

qv_pages golden_pages;

static qv_volume source; /* where the pages' voxels come from */
static qv_page table[MOST_PAGES];
static uint16_t pages[MOST_PAGES * GOLDEN_VOXEL_BYTES / 2];
static const struct cache *chosen;
static uint16_t count;

void golden_choose_cache(unsigned number, const golden_mode *mode)
{
    bool bspline =
        mode->family == GOLDEN_BSPLINE_WEIGHTED || mode->family == GOLDEN_BSPLINE_EXTINCTION;
    chosen = &caches[number];
    count = bspline ? chosen->count_of_bspline : chosen->count;
}

/* From whatever layout, voxel by voxel. */
static int read_brick(void *user, void *page, const qv_brick *brick)
{
    const qv_volume *volume = user;
    const uint16_t *first = brick->block.first, *end = brick->block.end;
    const size_t bytes = golden_pages.stride[0];
    for (unsigned z = first[2]; z < end[2]; z++)
        for (unsigned y = first[1]; y < end[1]; y++)
            for (unsigned x = first[0]; x < end[0]; x++) {
                qv_offset from = (qv_offset)x * volume->stride[0] +
                                 (qv_offset)y * volume->stride[1] +
                                 (qv_offset)z * volume->stride[2];
                memcpy((uint8_t *)page + (x - first[0]) * bytes + (y - first[1]) * brick->row +
                           (z - first[2]) * brick->slice,
                       volume->voxels + from, bytes);
            }
    return 0;
}

qv_status golden_page(qv_scene *scene, golden_memory *memory)
{
    (void)memory;
    source = scene->volume;
    scene->sampling = paged_of(scene->sampling);
    scene->volume.voxels = NULL;
    scene->volume.voxels_bytes = 0;
    memset(scene->volume.stride, 0, sizeof scene->volume.stride);
    scene->volume.pages = &golden_pages;
    golden_pages = (qv_pages){.read = read_brick,
                              .user = &source,
                              .memory = pages,
                              .bytes = sizeof pages,
                              .table = table,
                              .count = count};
    memcpy(golden_pages.shift, chosen->shift, sizeof golden_pages.shift);
    memset(pages, 0xEE, sizeof pages); /* what no brick overwrites may not be seen */
    return qv_pages_init(&golden_pages, &scene->volume);
}
