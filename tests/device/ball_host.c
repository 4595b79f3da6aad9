/*
 * ball_host.c - the ball in this machine's memory.
 */
#include "ball_make.h"

#include <stdlib.h>

static uint8_t data[BALL_BYTES];

/* ball_make asks for the address too. */
qv_address ball_data(void)
{
    static int made;
    if (!made) {
        made = 1;
        if (ball_make(data) != QV_OK)
            abort();
    }
    return data;
}
