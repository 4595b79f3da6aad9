/*
 * firmware_head.c - a turning head on the board's panel: volume and palette stay in flash.
 *
 * The volume is written by `qvol classify`, the view by toolchain/view_header; both by the rules
 * of toolchain/shared/head.mk. The head turns for ever; told a number, the program shows that frame of
 * the turn and waits, told "exit" it ends after one turn.
 */
#include <stdbool.h>
#include PANEL_HEADER
#include "console.h"
#include "head_view.h"
#include "machine.h"
#include "panel_show.h"
#include "semihosting.h"
#include "stack.h"

enum { FOREVER = -1, ONE_TURN = -2 };

extern const qv_volume head_volume;

static qv_context context;

static qv_status make_context(uint32_t frame)
{
    static const qv_angle from[3] = HEAD_ANGLES;
    const qv_angle turned = frame * (qv_angle)(0x100000000u / HEAD_FRAMES);
    qv_view view = HEAD_VIEW;
    qv_scene scene = {
        .volume = head_volume,
        .sampling = &HEAD_SAMPLING,
        .phase = HEAD_PHASE,
        .termination = HEAD_TERMINATION,
        .background = HEAD_BACKGROUND,
    };
    qv_rotation(view.rotation, from[0] + turned, from[1], from[2]);
    qv_status status = qv_orthographic(&scene.camera, &scene.volume, &view);
    return status == QV_OK ? qv_init(&context, &scene) : status;
}

static qv_status show(uint32_t frame)
{
    uint32_t checksum;
    qv_status status = make_context(frame);
    if (status == QV_OK)
        status = panel_show(&checksum, &context);
    if (status != QV_OK) {
        console_text(qv_status_text(status));
    } else {
        console_text("frame ");
        console_decimal(frame);
        console_text(" checksum ");
        console_hexadecimal(checksum);
        console_text(" stack ");
        console_decimal(stack_high_water());
    }
    console_text("\n");
    return status;
}

/* What the last word of the command line says: a frame, ONE_TURN or FOREVER. */
static int32_t told(void)
{
    char line[80];
    size_t length = 0, word = 0;
    if (!semihosting_command_line(line, sizeof line))
        return FOREVER;
    for (; line[length] != '\0'; length++)
        if (line[length] == ' ')
            word = length + 1;
    if (word == 0)
        return FOREVER;
    return line[word] >= '0' && line[word] <= '9' ? line[word] - '0' : ONE_TURN;
}

int main(void)
{
    const int32_t order = told();
    uint32_t frame = order < 0 ? 0 : (uint32_t)order % HEAD_FRAMES;
    panel_start();
    for (;;) {
        if (show(frame) != QV_OK)
            return 1;
        if (order >= 0)
            break;
        frame = (frame + 1) % HEAD_FRAMES;
        if (order == ONE_TURN && frame == 0)
            return 0;
    }
    console_text("READY\n");
    for (;;)
        machine_wait();
}
