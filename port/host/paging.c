/*
 * paging.c - a cache of pages over voxels in memory, which stand for a raw file.
 */
#include "paging.h"
#include "error.h"
#include "voxel_storage.h"

#include <stdlib.h>
#include <string.h>

/* Voxels that follow each other in the file, from wherever strides have them. */
static int read_file(void *user, void *to, uint64_t offset, uint32_t bytes)
{
    const qv_volume *source = user;
    unsigned voxel_bytes = storage_voxel_bytes((qv_storage)source->storage);
    uint64_t voxel = offset / voxel_bytes;
    for (uint32_t done = 0; done < bytes; done += voxel_bytes, voxel++) {
        uint64_t row = voxel / source->size[0];
        ptrdiff_t x = (ptrdiff_t)(voxel % source->size[0]) * source->stride[0];
        ptrdiff_t y = (ptrdiff_t)(row % source->size[1]) * source->stride[1];
        ptrdiff_t z = (ptrdiff_t)(row / source->size[1]) * source->stride[2];
        memcpy((uint8_t *)to + done, source->voxels + x + y + z, voxel_bytes);
    }
    return 0;
}

/* The settings were checked: widths are powers of 2. */
static uint8_t shift_of(uint32_t width)
{
    uint8_t shift = 0;
    while (width >> shift != 1) {
        shift++;
    }
    return shift;
}

/* Refuses what qv_pages_init does not number in 32 bits: bytes of a page, and bricks. */
static void check_page(const qv_pages *pages, const qv_volume *volume)
{
    uint64_t bytes = qv_page_bytes(pages->shift, volume->size, volume->storage), bricks = 1;
    for (unsigned a = 0; a < 3; a++) {
        bricks *= ((volume->size[a] - 1u) >> pages->shift[a]) + 1u; /* at most 2^36 in all */
    }
    if (bytes > UINT32_MAX) {
        usage_error("--page", "a page of %llu bytes is larger than %lu", (unsigned long long)bytes,
                    (unsigned long)UINT32_MAX);
    }
    if (bricks >= UINT32_MAX) {
        usage_error("--page", "%llu bricks are more than %lu", (unsigned long long)bricks,
                    (unsigned long)UINT32_MAX - 1);
    }
}

static void set_memory(qv_pages *pages, const qv_volume *volume, uint32_t count)
{
    uint64_t bytes = qv_page_bytes(pages->shift, volume->size, volume->storage) * count;
    pages->count = (uint16_t)count;
    pages->bytes = (size_t)bytes;
    pages->memory = allocate(bytes, "--cache", "pages");
    pages->table = allocate(count * sizeof *pages->table, "--cache", "pages");
}

void paging_create(struct paging *paging, qv_volume *volume, const struct settings *settings)
{
    qv_pages *pages = &paging->pages;
    memset(paging, 0, sizeof *paging);
    paging->source = *volume;
    paging->file.read = read_file;
    paging->file.user = &paging->source;
    paging->file.storage = volume->storage;
    pages->read = qv_linear_read;
    pages->user = &paging->file;
    for (unsigned a = 0; a < 3; a++) {
        paging->file.size[a] = volume->size[a];
        pages->shift[a] = shift_of(settings->cache.page[a]);
    }
    check_page(pages, volume);
    set_memory(pages, volume, settings->cache.pages);
    volume->pages = pages;
    qv_status status = qv_pages_init(pages, volume);
    if (status != QV_OK) {
        usage_error("--cache", "%s", qv_status_text(status));
    }
}

void paging_free(struct paging *paging)
{
    free(paging->pages.memory);
    free(paging->pages.table);
}

void report_pages(struct json *json, const struct paging *paging)
{
    const qv_pages *pages = &paging->pages;
    json_object(json, "pages");
    json_integer(json, "count", pages->count);
    json_triple(json, "page", INT64_C(1) << pages->shift[0], INT64_C(1) << pages->shift[1],
                INT64_C(1) << pages->shift[2]);
    json_unsigned(json, "page_bytes", pages->page_bytes);
    json_unsigned(json, "bytes", pages->bytes);
    json_unsigned(json, "searches", pages->searches);
    json_unsigned(json, "reads", pages->reads);
    json_unsigned(json, "file_reads", paging->file.reads);
    json_unsigned(json, "file_bytes", paging->file.bytes);
    json_close(json);
}
