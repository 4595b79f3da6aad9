/*
 * firmware_picture.c - the ball of ball.h on the board's panel, by rays, in strips: all that a
 * firmware needs to show a volume in its flash.
 */
#include PANEL_HEADER
#include "ball.h"
#include "console.h"
#include "machine.h"
#include "panel_show.h"

#define AZIMUTH   0x15555555u /* 30 degrees */
#define ELEVATION 0x0E38E38Eu /* 20 degrees */

static qv_context context;

static qv_status start(void)
{
    /* The ball's diameter and its fog fill the height. */
    qv_view view = {.pitch = QV_ONE_Q16 * BALL_SIZE / PANEL_HEIGHT,
                    .step = QV_ONE_Q16 / 2,
                    .width = PANEL_WIDTH,
                    .height = PANEL_HEIGHT};
    qv_scene scene = {.sampling = &qv_bspline_weighted_indexed8,
                      .termination = QV_TERMINATION_DEFAULT,
                      .background = {10, 12, 20, 255}};
    ball_volume(&scene.volume);
    qv_rotation(view.rotation, AZIMUTH, ELEVATION, 0);
    qv_status status = qv_orthographic(&scene.camera, &scene.volume, &view);
    return status == QV_OK ? qv_init(&context, &scene) : status;
}

int main(void)
{
    uint32_t checksum;
    panel_start();
    qv_status status = start();
    if (status == QV_OK)
        status = panel_show(&checksum, &context);
    if (status != QV_OK) {
        console_text(qv_status_text(status));
        return 1;
    }
    console_text("checksum ");
    console_hexadecimal(checksum);
    console_text("\nREADY\n");
    for (;;)
        machine_wait();
}
