/* app_main.c - prints the picture of a ball. */
#include "ball.h"
#include <stdio.h>

void app_main(void);

static void show(const char *line)
{
    puts(line);
}

void app_main(void)
{
    if (ball_draw(show) != 0)
        puts("qvol failed");
}
