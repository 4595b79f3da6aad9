#include "pages.h"

#include "fx_wide.h"
#include "layout.h"
#include "palette.h"

/* Ways of a set, but for bricks that are 1 voxel wide: as many as a sample can lie in. */
#define LEAST_WAYS 8u

/* Voxels on an axis that the widest reconstruction reads. */
#define MOST_TAPS 3u

/* Spreads neighbouring bricks over the sets: 2^32 / golden ratio, odd. */
#define SPREAD 0x9E3779B1u

/* ---- Shapes ------------------------------------------------------------------- */

/* Voxels of a brick on an axis. */
static uint32_t width_of(const uint8_t shift[3], const uint16_t size[3], unsigned axis)
{
    uint32_t width = (uint32_t)1 << shift[axis];
    return width < size[axis] ? width : size[axis];
}

/* Bricks on an axis: 1 .. QV_AXIS_MAX. */
static uint32_t bricks_of(const uint8_t shift[3], const uint16_t size[3], unsigned axis)
{
    return ((size[axis] - 1u) >> shift[axis]) + 1u;
}

static int size_valid(const uint16_t size[3])
{
    for (unsigned axis = 0; axis < 3; axis++)
        if (size[axis] == 0 || size[axis] > QV_AXIS_MAX)
            return 0;
    return 1;
}

static int shift_valid(const uint8_t shift[3])
{
    return shift[0] <= QV_PAGE_SHIFT_MAX && shift[1] <= QV_PAGE_SHIFT_MAX &&
           shift[2] <= QV_PAGE_SHIFT_MAX;
}

uint64_t qv_page_bytes(const uint8_t shift[3], const uint16_t size[3], uint8_t storage)
{
    if (!shift_valid(shift) || !size_valid(size))
        return 0;
    uint32_t row = width_of(shift, size, 0) * qv_voxel_bytes(storage); /* <= 2^15 */
    return fx_wide_product(row * width_of(shift, size, 1), width_of(shift, size, 2));
}

/* At most 2^36. */
static uint64_t brick_count(const uint8_t shift[3], const uint16_t size[3])
{
    return fx_wide_product(bricks_of(shift, size, 0) * bricks_of(shift, size, 1),
                           bricks_of(shift, size, 2));
}

/* ---- Checks ------------------------------------------------------------------- */

/* Everything but where voxels lie. */
static qv_status check_volume(const qv_volume *volume)
{
    if (!qv_storage_known(volume->storage))
        return QV_ERROR_STORAGE;
    if (!size_valid(volume->size))
        return QV_ERROR_SIZE;
    qv_status status = qv_palette_check(volume, qv_channel_bytes(volume->storage),
                                        qv_storage_indexed(volume->storage));
    return status == QV_OK ? qv_spacing_check(volume->spacing) : status;
}

/* Whether pages of so many bytes fit their memory, and all bricks have numbers. */
static int pages_valid(const qv_pages *pages, const qv_volume *volume)
{
    uint64_t bytes = qv_page_bytes(pages->shift, volume->size, volume->storage);
    uintptr_t odd = (uintptr_t)pages->memory & (qv_voxel_alignment(volume->storage) - 1u);
    return pages->count != 0 && odd == 0 && bytes != 0 && bytes <= pages->bytes / pages->count &&
           bytes >> 32 == 0 && brick_count(pages->shift, volume->size) < QV_NO_BRICK;
}

/* Most bricks that taps x taps x taps voxels lie in: 1 .. 27. */
static unsigned bricks_needed(const qv_pages *pages, const qv_volume *volume, unsigned taps)
{
    unsigned needed = 1;
    for (unsigned axis = 0; axis < 3; axis++) {
        unsigned bricks = (unsigned)bricks_of(pages->shift, volume->size, axis);
        unsigned most = pages->shift[axis] == 0 ? taps : 2u;
        needed *= bricks < most ? bricks : most;
    }
    return needed;
}

/* Whether the pages were made ready for volumes like this one. */
static int pages_ready(const qv_pages *pages, const qv_volume *volume)
{
    for (unsigned axis = 0; axis < 3; axis++)
        if (pages->size[axis] != volume->size[axis])
            return 0;
    return pages->stride[0] == qv_voxel_bytes(volume->storage);
}

qv_status qv_pages_check(const qv_volume *volume, unsigned taps)
{
    const qv_pages *pages = volume->pages;
    if (!pages)
        return QV_ERROR_NULL;
    qv_status status = check_volume(volume);
    if (status != QV_OK)
        return status;
    if (!pages_ready(pages, volume) || bricks_needed(pages, volume, taps) > pages->ways)
        return QV_ERROR_PAGES;
    return QV_OK;
}

/* ---- Making ready ------------------------------------------------------------- */

/* Into sets, each of which holds the bricks of any sample. */
static void divide(qv_pages *pages, const qv_volume *volume)
{
    unsigned needed = bricks_needed(pages, volume, MOST_TAPS);
    unsigned least = needed < LEAST_WAYS ? LEAST_WAYS : needed;
    unsigned sets = pages->count / least;
    pages->sets = (uint16_t)(sets != 0 ? sets : 1u);
    pages->ways = (uint16_t)(pages->count / pages->sets);
}

static void forget(qv_pages *pages)
{
    for (uint16_t i = 0; i < pages->count; i++) {
        pages->table[i].brick = QV_NO_BRICK;
        pages->table[i].page = i;
    }
    for (unsigned axis = 0; axis < 3; axis++)
        pages->cells[axis] = 0;
}

qv_status qv_pages_init(qv_pages *pages, const qv_volume *volume)
{
    if (!pages || !volume || !pages->read || !pages->memory || !pages->table)
        return QV_ERROR_NULL;
    qv_status status = check_volume(volume);
    if (status != QV_OK)
        return status;
    if (!pages_valid(pages, volume))
        return QV_ERROR_PAGES;
    for (unsigned axis = 0; axis < 3; axis++)
        pages->size[axis] = volume->size[axis];
    pages->stride[0] = qv_voxel_bytes(volume->storage);
    pages->stride[1] = pages->stride[0] * width_of(pages->shift, volume->size, 0);
    pages->stride[2] = pages->stride[1] * width_of(pages->shift, volume->size, 1);
    pages->page_bytes = pages->stride[2] * width_of(pages->shift, volume->size, 2);
    divide(pages, volume);
    pages->status = QV_OK;
    pages->error = 0;
    pages->searches = 0;
    pages->reads = 0;
    pages->failures = 0;
    forget(pages);
    return QV_OK;
}

/* ---- The cache ---------------------------------------------------------------- */

/* What is to be read: the brick whose first voxel stands in pages->wanted already. */
static void describe(qv_pages *pages, uint32_t number)
{
    qv_brick *brick = &pages->wanted;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t end = brick->block.first[axis] + width_of(pages->shift, pages->size, axis);
        brick->block.end[axis] = (uint16_t)(end < pages->size[axis] ? end : pages->size[axis]);
    }
    brick->number = number;
    brick->row = pages->stride[1];
    brick->slice = pages->stride[2];
    brick->bytes = pages->page_bytes;
}

/* A page that cannot be read is all 0. */
static void read_page(uint8_t *page, qv_pages *pages, uint32_t number)
{
    describe(pages, number);
    pages->reads++;
    int status = pages->read(pages->user, page, &pages->wanted);
    if (status >= 0)
        return;
    memset(page, 0, (size_t)pages->page_bytes);
    pages->failures++;
    if (pages->status == QV_OK)
        pages->error = status;
    pages->status = QV_ERROR_READ;
}

/*
 * The page of a brick. A set is kept in the order of use, so that the brick wanted most often
 * stands first, and the one not wanted for longest makes room.
 */
static uint8_t *find_page(qv_pages *pages, uint32_t number)
{
    uint32_t set = ((number * SPREAD >> 16) * pages->sets) >> 16; /* sets <= 2^13 */
    qv_page *ways = pages->table + (size_t)set * pages->ways;
    unsigned way = 0, last = pages->ways - 1u;
    pages->searches++;
    while (way < last && ways[way].brick != number)
        way++;
    qv_page found = ways[way];
    int present = found.brick == number;
    for (; way > 0; way--)
        ways[way] = ways[way - 1u];
    found.brick = number;
    ways[0] = found;
    uint8_t *page = (uint8_t *)pages->memory + (size_t)found.page * (size_t)pages->page_bytes;
    if (!present)
        read_page(page, pages, number);
    return page;
}

static const uint8_t *find_voxel(qv_pages *pages, const uint16_t position[3])
{
    const uint8_t *shift = pages->shift;
    uint32_t number = 0, offset = 0; /* offset < page_bytes */
    for (unsigned axis = 3; axis-- > 0;) {
        uint32_t brick = (uint32_t)position[axis] >> shift[axis], first = brick << shift[axis];
        number = number * bricks_of(shift, pages->size, axis) + brick;
        offset += (position[axis] - first) * pages->stride[axis];
        pages->wanted.block.first[axis] = (uint16_t)first;
    }
    return find_page(pages, number) + (size_t)offset;
}

const uint8_t *qv_pages_voxel(qv_pages *pages, const uint16_t position[3])
{
    pages->cells[0] = 0; /* the box of cells may lose a page */
    return find_voxel(pages, position);
}

/* ---- The box of cells --------------------------------------------------------- */

/* The lowest voxel of the box on an axis, and how many bytes on its upper neighbour lies. */
typedef struct lowest {
    uint32_t rise[3];
    uint16_t voxel[3];
} lowest;

/*
 * Finds the box on an axis. Returns whether its cells, of which there is one, lie in two bricks.
 * An index below 0 is clamped; unsigned, it lies above every size.
 */
static unsigned find_span(lowest *low, qv_pages *pages, unsigned axis, uint32_t index)
{
    unsigned shift = pages->shift[axis];
    uint32_t last = pages->size[axis] - 1u, first = index >> shift << shift;
    uint32_t end = first + ((uint32_t)1 << shift) - 1u; /* the last voxel of the brick */
    pages->first[axis] = index;
    pages->cells[axis] = 1;
    low->rise[axis] = 0;
    low->voxel[axis] = (uint16_t)index;
    if (index >= last) {
        low->voxel[axis] = (uint16_t)(index > QV_AXIS_MAX ? 0 : last);
        return 0;
    }
    if (index == end)
        return 1;
    pages->first[axis] = first;
    pages->cells[axis] = (end < last ? end : last) - first;
    low->rise[axis] = pages->stride[axis];
    low->voxel[axis] = (uint16_t)first;
    return 0;
}

void qv_pages_seek(qv_pages *pages, const qv_coord place[3])
{
    lowest low;
    unsigned across = 0; /* bit 0 for x: the corners lie in two bricks */
    for (unsigned axis = 0; axis < 3; axis++)
        across |= find_span(&low, pages, axis, (uint32_t)((uint64_t)place[axis] >> 32)) << axis;
    for (unsigned corner = 0; corner < 8; corner++) {
        unsigned inside = corner & ~across, bit = inside & (0u - inside);
        if (inside != 0) { /* bits 1, 2, 4 are axes 0, 1, 2 */
            pages->corner[corner] = pages->corner[corner ^ bit] + (size_t)low.rise[bit >> 1];
            continue;
        }
        const uint16_t position[3] = {(uint16_t)(low.voxel[0] + (corner & 1u)),
                                      (uint16_t)(low.voxel[1] + (corner >> 1 & 1u)),
                                      (uint16_t)(low.voxel[2] + (corner >> 2))};
        pages->corner[corner] = find_voxel(pages, position);
    }
}
