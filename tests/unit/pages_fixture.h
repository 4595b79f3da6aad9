/*
 * pages_fixture.h - a fixture whose voxels are read through pages, from its own memory as if that
 * were a device. Pages lie in memory of just their size.
 */
#ifndef PAGES_FIXTURE_H
#define PAGES_FIXTURE_H

#include "scene_fixture.h"

#include <stdlib.h>

enum { PAGED_BRICKS = FIXTURE_VOXELS, PAGED_ERROR = -77 };

typedef struct paged {
    fixture in_memory, through_pages;
    qv_pages pages;
    qv_linear linear;
    uint32_t failing;              /* the brick that cannot be read; PAGED_BRICKS: none */
    uint32_t reads[PAGED_BRICKS];  /* of each brick */
    qv_block blocks[PAGED_BRICKS]; /* where they were asked for */
} paged;

/* Out of the fixture's voxels, which no offset leaves. */
static inline int paged_device(void *user, void *to, uint64_t offset, uint32_t bytes)
{
    const paged *p = (const paged *)user;
    const qv_volume *volume = &p->in_memory.scene.volume;
    assert_true(offset <= volume->voxels_bytes && bytes <= volume->voxels_bytes - offset);
    memcpy(to, volume->voxels + offset, bytes);
    return 1; /* any value but a negative one will do */
}

/* What a page held before is seen by nobody, also beside the volume and where a read fails. */
static inline int paged_read(void *user, void *page, const qv_brick *brick)
{
    paged *p = (paged *)user;
    assert_true(brick->number < PAGED_BRICKS);
    fixture_poison(page, brick->bytes);
    p->reads[brick->number]++;
    p->blocks[brick->number] = brick->block;
    return brick->number == p->failing ? PAGED_ERROR : qv_linear_read(&p->linear, page, brick);
}

/* The pages' own memory; `count` of them. Freed by paged_free. */
static inline void paged_pages(paged *p, const uint8_t shift[3], uint16_t count)
{
    const qv_volume *volume = &p->in_memory.scene.volume;
    memset(&p->pages, 0, sizeof p->pages);
    p->pages.bytes = count * (size_t)qv_page_bytes(shift, volume->size, volume->storage);
    p->pages.memory = malloc(p->pages.bytes);
    p->pages.table = malloc(count * sizeof(qv_page));
    p->pages.count = count;
    p->pages.read = paged_read;
    p->pages.user = p;
    memcpy(p->pages.shift, shift, 3);
    p->failing = PAGED_BRICKS;
    memset(p->reads, 0, sizeof p->reads);
}

/* The same scene twice; the second through pages that are ready. */
static inline void paged_make(paged *p, const qv_sampling *sampling, const qv_sampling *through,
                              const uint8_t shift[3], uint16_t count)
{
    qv_scene *scene = &p->through_pages.scene;
    fixture_make(&p->in_memory, sampling, 3);
    if (sampling->by_length)
        p->in_memory.scene.volume.unit_distance = QV_ONE_Q16;
    p->through_pages = p->in_memory;
    p->linear = (qv_linear){.read = paged_device, .user = p, .storage = sampling->storage};
    memcpy(p->linear.size, scene->volume.size, sizeof p->linear.size);
    paged_pages(p, shift, count);
    scene->sampling = through;
    scene->volume.voxels = NULL;
    scene->volume.voxels_bytes = 0;
    memset(scene->volume.stride, 0, sizeof scene->volume.stride);
    scene->volume.pages = &p->pages;
    assert_int_equal(qv_pages_init(&p->pages, &scene->volume), QV_OK);
}

static inline void paged_free(paged *p)
{
    free(p->pages.memory);
    free(p->pages.table);
}

static inline qv_status paged_render(fixture_pixels pixels, const fixture *f)
{
    const qv_context context = fixture_context(f);
    const qv_image image = {pixels, sizeof(fixture_pixels), FIXTURE_WIDTH * 4, &qv_format_rgba8888};
    return qv_render(&image, &context, &fixture_frame);
}

/* Whether both scenes look the same; the second ends with this status. */
static inline int paged_same(const paged *p, qv_status status)
{
    fixture_pixels expected, actual;
    fixture_render(expected, &p->in_memory);
    assert_int_equal(paged_render(actual, &p->through_pages), status);
    return memcmp(expected, actual, sizeof expected) == 0;
}

#endif /* PAGES_FIXTURE_H */
