/*
 * firmware_pages.c - a volume larger than the memory that is left for it: the ball's voxels, read
 * byte by byte from program memory as if that were an SD card or a serial flash, through a cache.
 * The same program for every board.
 *
 * Measured is a frame of each: of the voxels where they are; through one page that holds them all
 * already; through as few bricks, and as few slices, as a sample may need. Prints its checksum,
 * which is the same for all, its samples, and what was searched and read.
 */
#include "access.h"
#include "ball.h"
#include "console.h"
#include "crc32.h"
#include "measure.h"

enum { WIDTH = 32, HEIGHT = 32, PAGES_MOST = 8, CACHE_BYTES = 2304 };

#define AZIMUTH   0x15555555u /* 30 degrees */
#define ELEVATION 0x0E38E38Eu /* 20 degrees */

static uint8_t memory[CACHE_BYTES];
static qv_page table[PAGES_MOST];
static uint8_t row[WIDTH * 2];
static qv_context context;

typedef struct cache {
    const char *name;
    uint16_t pages; /* 0: none */
    uint8_t shift[3];
    uint8_t filled; /* by a frame before the one that is measured */
} cache;

/* What stands for a device: the ball's voxels, from the first one on. */
static int read_voxels(void *user, void *to, uint64_t offset, uint32_t bytes)
{
    const qv_volume *volume = user;
    qv_address from = qv_at(volume->voxels, (qv_offset)offset);
    uint8_t *byte = to;
    for (; bytes != 0; bytes--) {
        *byte++ = qv_read8(from);
        from = qv_at(from, 1);
    }
    return 0;
}

/* The frame row by row, and its checksum. */
static qv_status draw(uint32_t *checksum, uint32_t *samples)
{
    const qv_image image = {row, sizeof row, sizeof row, &qv_format_rgb565_le};
    qv_status status = QV_OK;
    *checksum = 0;
    *samples = 0;
    for (int32_t y = 0; y < HEIGHT && status == QV_OK; y++) {
        const qv_rect line = {0, y, WIDTH, y + 1};
        qv_progress progress = {0};
        status = qv_render_some(&image, &progress, &context, &line, WIDTH);
        *checksum = crc32_update(*checksum, row, sizeof row);
        *samples += progress.samples;
    }
    return status;
}

static qv_status look(qv_scene *scene)
{
    qv_view view = {.pitch = QV_ONE_Q16 / 2, .step = QV_ONE_Q16, .width = WIDTH, .height = HEIGHT};
    qv_rotation(view.rotation, AZIMUTH, ELEVATION, 0);
    qv_status status = qv_orthographic(&scene->camera, &scene->volume, &view);
    return status == QV_OK ? qv_init(&context, scene) : status;
}

static void print(const char *name, uint32_t number)
{
    console_text(name);
    console_decimal(number);
}

static qv_status measure(const char *name)
{
    uint32_t checksum, samples;
    measure_begin();
    qv_status status = draw(&checksum, &samples);
    measure_end();
    console_text(name);
    if (status != QV_OK) {
        console_text(" failed\n");
        return status;
    }
    print(" ", checksum);
    print(" samples ", samples);
    return QV_OK;
}

static qv_status in_place(void)
{
    qv_scene scene = {.sampling = &qv_weighted_indexed8};
    ball_volume(&scene.volume);
    qv_status status = look(&scene);
    if (status == QV_OK)
        status = measure("memory");
    console_text("\n");
    return status;
}

static qv_status through(const cache *of)
{
    qv_volume ball;
    qv_scene scene = {.sampling = &qv_weighted_indexed8_paged};
    qv_linear linear = {.read = read_voxels,
                        .user = &ball,
                        .size = {BALL_SIZE, BALL_SIZE, BALL_SIZE},
                        .storage = QV_STORAGE_INDEXED8};
    qv_pages pages = {.read = qv_linear_read,
                      .user = &linear,
                      .memory = memory,
                      .bytes = sizeof memory,
                      .table = table,
                      .count = of->pages,
                      .shift = {of->shift[0], of->shift[1], of->shift[2]}};
    uint32_t checksum, samples;
    ball_volume(&ball);
    scene.volume = ball;
    scene.volume.voxels = 0;
    scene.volume.pages = &pages;
    qv_status status = qv_pages_init(&pages, &scene.volume);
    if (status == QV_OK)
        status = look(&scene);
    if (status == QV_OK && of->filled)
        status = draw(&checksum, &samples);
    pages.searches = 0;
    pages.reads = 0;
    linear.bytes = 0;
    if (status == QV_OK)
        status = measure(of->name);
    print(" pages ", of->pages);
    print(" searches ", pages.searches);
    print(" reads ", pages.reads);
    print(" bytes ", (uint32_t)linear.bytes);
    console_text("\n");
    return status;
}

int main(void)
{
    static const cache caches[] = {
        {"whole", 1, {12, 12, 12}, 1}, {"bricks", 8, {2, 2, 2}, 0}, {"slices", 2, {12, 12, 0}, 0}};
    qv_status status = in_place();
    for (unsigned i = 0; i < sizeof caches / sizeof *caches && status == QV_OK; i++)
        status = through(&caches[i]);
    return status != QV_OK;
}
