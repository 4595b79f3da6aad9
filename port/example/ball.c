/*
 * ball.c - a volume of characters in program memory, drawn into a line of text at a time.
 *
 * A ball of two halves in a translucent skin. A voxel's index is its character.
 */
#include "ball.h"
#include "qvol.h"

/* An AVR reads program memory by instructions of its own: see qv_address. */
#ifdef __AVR__
#include <avr/pgmspace.h>
#define IN_PROGRAM_MEMORY PROGMEM
#define ADDRESS(object)   pgm_get_far_address(object)
#else
#define IN_PROGRAM_MEMORY
#define ADDRESS(object) ((qv_address)(object))
#endif

enum { EDGE = 8, VOXELS = EDGE * EDGE * EDGE };

/* Pixels. A character is twice as high as wide, so every second row is shown. */
enum { WIDTH = 48, HEIGHT = 48, ROWS_A_LINE = 2 };

/* clang-format off */
static const char voxels[VOXELS + 1] IN_PROGRAM_MEMORY =
    "........" "........" "........" "...++..." "...++..." "........" "........" "........"
    "........" "...++..." "..++++.." ".++@@++." ".++@@++." "..++++.." "...++..." "........"
    "........" "..++++.." ".+@@@@+." ".+@@@@+." ".+@@@@+." ".+@@@@+." "..++++.." "........"
    "...++..." ".++@@++." ".+@@@@+." "+@@@@@@+" "+@@@@@@+" ".+@@@@+." ".++@@++." "...++..."
    "...++..." ".++oo++." ".+oooo+." "+oooooo+" "+oooooo+" ".+oooo+." ".++oo++." "...++..."
    "........" "..++++.." ".+oooo+." ".+oooo+." ".+oooo+." ".+oooo+." "..++++.." "........"
    "........" "...++..." "..++++.." ".++oo++." ".++oo++." "..++++.." "...++..." "........"
    "........" "........" "........" "...++..." "...++..." "........" "........" "........";
/* clang-format on */

/* R, G, B, opacity; what is not named is clear. */
static const uint8_t palette[QV_PALETTE_ENTRIES][4] IN_PROGRAM_MEMORY = {
    ['+'] = {160, 160, 160, 24},
    ['o'] = {110, 110, 110, 200},
    ['@'] = {255, 255, 255, 200},
};

static qv_status start(qv_context *context)
{
    qv_view view = {.pitch = QV_ONE_Q16 / 5, .step = QV_ONE_Q16, .width = WIDTH, .height = HEIGHT};
    qv_scene scene = {
        .sampling = &qv_weighted_indexed8,
        .volume = {.voxels = ADDRESS(voxels),
                   .voxels_bytes = VOXELS,
                   .palette = ADDRESS(palette),
                   .palette_bytes = QV_PALETTE8_BYTES,
                   .storage = QV_STORAGE_INDEXED8,
                   .size = {EDGE, EDGE, EDGE},
                   .stride = {1, EDGE, EDGE * EDGE}},
    };
    qv_rotation(view.rotation, 0x18000000 /* 34 degrees */, 0x10000000 /* 22 degrees */, 0);
    qv_status status = qv_orthographic(&scene.camera, &scene.volume, &view);
    return status == QV_OK ? qv_init(context, &scene) : status;
}

/* Grey levels as characters: from 0, which is empty, to 255. */
static void to_text(char line[WIDTH + 1], const uint8_t *grey)
{
    static const char shades[] = {' ', '.', ':', '-', '=', '+', '*', '#', '%', '@'};
    for (unsigned x = 0; x < WIDTH; x++)
        line[x] = shades[grey[x] * sizeof shades / 256];
    line[WIDTH] = '\0';
}

int ball_draw(void (*show)(const char *line))
{
    static qv_context context;
    uint8_t grey[WIDTH];
    char line[WIDTH + 1];
    const qv_image image = {grey, sizeof grey, WIDTH, &qv_format_l8};
    qv_status status = start(&context);
    for (int32_t y = 0; y < HEIGHT && status == QV_OK; y += ROWS_A_LINE) {
        const qv_rect row = {0, y, WIDTH, y + 1};
        status = qv_render(&image, &context, &row);
        if (status != QV_OK)
            break;
        to_text(line, grey);
        show(line);
    }
    return status;
}
