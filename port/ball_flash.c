/*
 * ball_flash.c - the ball in flash, which is included as a file.
 */
#include "ball.h"

__asm__(".section .rodata.ball,\"a\"\n"
        "ball:\n"
        ".incbin \"ball.volume\"\n" /* see tests/device/ball_write.c */
        ".previous\n");

extern const uint8_t ball[];

qv_address ball_data(void)
{
    return ball;
}
