/*
 * adapters.c - each adapter of port/display/ leaves on a panel in memory what qv_render makes of
 * the whole frame. Prints TAP.
 */
#include "adapters.h"
#include "dma.h"
#include <lvgl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <u8g2.h>
#include <zephyr/drivers/display.h>

qv_status qvol_lvgl_draw(lv_draw_buf_t *buffer, const qv_context *context);
qv_status qvol_lvgl_area(uint8_t *pixels, const lv_area_t *area, const qv_context *context);
int qvol_zephyr_show(const struct device *display, const qv_context *context, void *strip,
                     size_t strip_bytes, uint16_t width, uint16_t height);
qv_status qvol_u8g2_show(u8g2_t *u8g2, const qv_context *context);

enum {
    EDGE = 8,
    STRIP_ROWS = 5,
    STRIP_BYTES = 2 * WIDTH * STRIP_ROWS,
    FRAME_BYTES = 4 * WIDTH * HEIGHT
};

static uint8_t voxels[EDGE * EDGE * EDGE][4];
static qv_context context;
static uint8_t expected[FRAME_BYTES], panel[FRAME_BYTES];
static uint16_t strip[2][WIDTH * STRIP_ROWS];

/* ---- Panels ---- */

struct device {
    uint8_t *pixels;
};

int display_write(const struct device *dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf)
{
    const uint8_t *from = buf;
    if (desc->buf_size < 2u * desc->pitch * desc->height || desc->frame_incomplete)
        return -1;
    for (unsigned row = 0; row < desc->height; row++)
        memcpy(dev->pixels + 2 * ((y + row) * WIDTH + x), from + 2 * row * desc->pitch,
               2u * desc->width);
    return 0;
}

void u8g2_FirstPage(u8g2_t *u8g2)
{
    u8g2->tile_curr_row = 0;
}

static size_t page_bytes(const u8g2_t *u8g2)
{
    return 8u * u8g2->tile_width * u8g2->tile_buf_height;
}

uint8_t u8g2_NextPage(u8g2_t *u8g2)
{
    memcpy(u8g2->panel + 8 * u8g2->tile_width * u8g2->tile_curr_row, u8g2->tile_buf_ptr,
           page_bytes(u8g2));
    u8g2->tile_curr_row = (uint8_t)(u8g2->tile_curr_row + u8g2->tile_buf_height);
    return u8g2->tile_curr_row < u8g2->tile_height;
}

/* A transfer that is under way: its bytes are read when it is waited for. */
typedef struct transfer {
    const void *rows;
    size_t bytes;
    int32_t top;
} transfer;

static void start_transfer(void *user, const void *rows, size_t bytes, int32_t top)
{
    *(transfer *)user = (transfer){rows, bytes, top};
}

static void wait_for_transfer(void *user)
{
    transfer *t = user;
    if (t->bytes > 0)
        memcpy(panel + 2 * WIDTH * t->top, t->rows, t->bytes);
    t->bytes = 0;
}

/* ---- Pictures ---- */

static qv_status make_context(void)
{
    for (unsigned i = 0; i < EDGE * EDGE * EDGE; i++)
        for (unsigned c = 0; c < 4; c++)
            voxels[i][c] = (uint8_t)((i * 37 + c * 101) ^ (i >> 3));
    qv_scene scene = {.sampling = &qv_weighted_rgba8,
                      .volume = {.voxels = voxels[0],
                                 .voxels_bytes = sizeof voxels,
                                 .size = {EDGE, EDGE, EDGE},
                                 .storage = QV_STORAGE_RGBA8,
                                 .stride = {4, 4 * EDGE, 4 * EDGE * EDGE}}};
    qv_view view = {.pitch = QV_ONE_Q16 / 4, .step = QV_ONE_Q16, .width = WIDTH, .height = HEIGHT};
    qv_rotation(view.rotation, 0x0C000000u, 0x08000000u, 0);
    qv_status status = qv_orthographic(&scene.camera, &scene.volume, &view);
    return status == QV_OK ? qv_init(&context, &scene) : status;
}

/* Renders the whole frame, and clears the panel. */
static bool expect(const qv_format *format)
{
    static const qv_rect frame = {0, 0, WIDTH, HEIGHT};
    const ptrdiff_t stride = (ptrdiff_t)qv_row_bytes(format, WIDTH);
    const qv_image image = {expected, sizeof expected, stride, format};
    memset(expected, 0, sizeof expected);
    memset(panel, 0, sizeof panel);
    return qv_render(&image, &context, &frame) == QV_OK;
}

static bool same(void)
{
    return memcmp(panel, expected, sizeof panel) == 0;
}

static bool lvgl_draws(lv_color_format_t format, unsigned pixel_bytes)
{
    lv_draw_buf_t buffer = {.header = {.cf = format, .w = WIDTH, .h = HEIGHT},
                            .data_size = pixel_bytes * WIDTH * HEIGHT,
                            .data = panel};
    buffer.header.stride = pixel_bytes * WIDTH & 0xFFFFu;
    return qvol_lvgl_draw(&buffer, &context) == QV_OK && same();
}

static bool lvgl_draws_rgb565(void)
{
    return expect(&qv_format_rgb565_le) && lvgl_draws(LV_COLOR_FORMAT_RGB565, 2);
}

static bool lvgl_draws_xrgb8888(void)
{
    return expect(&qv_format_bgra8888) && lvgl_draws(LV_COLOR_FORMAT_XRGB8888, 4);
}

static bool lvgl_flushes_areas(void)
{
    bool good = expect(&qv_format_rgb565_le);
    for (int32_t top = 0; top < HEIGHT; top += STRIP_ROWS) {
        const int32_t last = top + STRIP_ROWS < HEIGHT ? top + STRIP_ROWS - 1 : HEIGHT - 1;
        const lv_area_t area = {0, top, WIDTH - 1, last};
        good = good && qvol_lvgl_area(panel + 2 * WIDTH * top, &area, &context) == QV_OK;
    }
    return good && same();
}

static bool zephyr_shows(void)
{
    const struct device device = {panel};
    return expect(&qv_format_rgb565_le) &&
           qvol_zephyr_show(&device, &context, strip[0], STRIP_BYTES, WIDTH, HEIGHT) == 0 && same();
}

static bool zephyr_needs_a_row(void)
{
    const struct device device = {panel};
    return qvol_zephyr_show(&device, &context, strip[0], 2 * WIDTH - 1, WIDTH, HEIGHT) != 0;
}

static bool u8g2_shows(void)
{
    static uint8_t page[WIDTH];
    u8g2_t u8g2 = {.tile_buf_ptr = page,
                   .tile_buf_height = 1,
                   .tile_width = WIDTH / 8,
                   .tile_height = HEIGHT / 8,
                   .panel = panel};
    return expect(&qv_format_mono_vertical) && qvol_u8g2_show(&u8g2, &context) == QV_OK && same();
}

/* Its colours are numbers: on a little-endian machine the low byte comes first. */
static bool gfx_shows(void)
{
    static uint16_t pixels[WIDTH * HEIGHT];
    bool good = expect(&qv_format_rgb565_le) &&
                show_by_gfx(pixels, &context, strip[0], STRIP_ROWS) == QV_OK;
    memcpy(panel, pixels, sizeof pixels);
    return good && same();
}

static bool dma_shows(void)
{
    transfer under_way = {0};
    const qvol_dma dma = {start_transfer, wait_for_transfer, &under_way};
    return expect(&qv_format_rgb565_be) &&
           qvol_dma_show(&dma, &context, strip[0], STRIP_ROWS, WIDTH, HEIGHT) == QV_OK && same();
}

static const struct {
    const char *name;
    bool (*passes)(void);
} tests[] = {{"LVGL, a draw buffer of RGB565", lvgl_draws_rgb565},
             {"LVGL, a draw buffer of XRGB8888", lvgl_draws_xrgb8888},
             {"LVGL, areas of partial buffers", lvgl_flushes_areas},
             {"Zephyr, strips by display_write", zephyr_shows},
             {"Zephyr, a strip shorter than a row is refused", zephyr_needs_a_row},
             {"u8g2, pages of 8 rows", u8g2_shows},
             {"Adafruit GFX, strips of 16-bit colours", gfx_shows},
             {"DMA, two strips", dma_shows}};

int main(void)
{
    int failures = make_context() != QV_OK;
    for (size_t i = 0; i < sizeof tests / sizeof *tests; i++) {
        bool good = tests[i].passes();
        failures += !good;
        (void)printf("%sok %zu - %s\n", good ? "" : "not ", i + 1, tests[i].name);
    }
    (void)printf("1..%zu\n", sizeof tests / sizeof *tests);
    return failures != 0;
}
