/*
 * firmware_head.c - a head on the OLED: volume and palette stay in flash, the
 * picture never exists as a whole in RAM.
 *
 * The volume is written by `qvol classify`, the view by toolchain/view_header;
 * both by the rules of toolchain/shared/device.mk. With the argument "exit" the program
 * ends after the picture, otherwise it waits so that the panel can be seen.
 */
#include <stdbool.h>
#include "crc32.h"
#include "head_view.h"
#include "measure.h"
#include "oled.h"
#include "qvol.h"
#include "console.h"
#include "semihosting.h"
#include "stack.h"
#include "systick.h"

enum { STRIP_ROWS = 8 };

extern const qv_volume head_volume;

static const qv_view view = HEAD_VIEW;
static qv_context context;
static uint8_t strip[STRIP_ROWS][OLED_ROW_BYTES];

static qv_status make_context(void)
{
    qv_scene scene = {
        .volume = head_volume,
        .sampling = &qv_weighted_indexed8,
        .phase = HEAD_PHASE,
        .termination = HEAD_TERMINATION,
        .background = HEAD_BACKGROUND,
    };
    qv_status status = qv_orthographic(&scene.camera, &scene.volume, &view);
    return status == QV_OK ? qv_init(&context, &scene) : status;
}

/* Renders strip after strip; each goes to the panel and into the checksum. */
static qv_status draw(uint32_t *checksum, uint64_t *ticks)
{
    const qv_image image = {strip, sizeof strip, sizeof strip[0], &qv_format_grey4};
    *checksum = 0;
    *ticks = 0;
    for (int32_t top = 0; top < OLED_HEIGHT; top += STRIP_ROWS) {
        const qv_rect rect = {0, top, OLED_WIDTH, top + STRIP_ROWS};
        uint64_t start = systick_ticks();
        measure_begin();
        qv_status status = qv_render(&image, &context, &rect);
        measure_end();
        *ticks += systick_ticks() - start;
        if (status != QV_OK)
            return status;
        oled_rows((uint32_t)top, strip[0], STRIP_ROWS);
        *checksum = crc32_update(*checksum, strip, sizeof strip);
    }
    return QV_OK;
}

static void report(uint32_t checksum, uint64_t ticks)
{
    console_text("checksum ");
    console_hexadecimal(checksum);
    console_text("\ninstructions ");
    console_decimal(systick_instructions(ticks));
    console_text("\nstack ");
    console_decimal(stack_high_water());
    console_text("\nREADY\n");
}

/* Whether the command line ends in " exit". */
static bool told_to_exit(void)
{
    static const char word[] = " exit";
    char line[80];
    size_t length = 0;
    if (!semihosting_command_line(line, sizeof line))
        return false;
    while (line[length] != '\0')
        length++;
    if (length < sizeof word - 1)
        return false;
    for (size_t i = 0; i < sizeof word - 1; i++) {
        if (line[length - (sizeof word - 1) + i] != word[i])
            return false;
    }
    return true;
}

int main(void)
{
    uint32_t checksum;
    uint64_t ticks;
    oled_start();
    systick_start();
    qv_status status = make_context();
    if (status == QV_OK)
        status = draw(&checksum, &ticks);
    if (status != QV_OK) {
        console_text(qv_status_text(status));
        console_text("\n");
        return 1;
    }
    report(checksum, ticks);
    while (!told_to_exit())
        __asm__ volatile("wfi");
    return 0;
}
