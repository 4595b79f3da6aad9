/*
 * ball_flash.c - the ball in program memory. It is included as a file, see planet_flash.c.
 */
#include "ball.h"

__asm__(".section .volume,\"a\"\n"
        "ball:\n"
        ".incbin \"ball.volume\"\n" /* see tests/device/ball_write.c */
        ".previous\n");

extern const uint8_t ball[];

qv_address ball_data(void)
{
    return FLASH_ADDRESS(ball);
}
