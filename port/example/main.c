/* main.c - prints the picture of a ball. */
#include "ball.h"
#include <stdio.h>

static void show(const char *line)
{
    puts(line);
}

int main(void)
{
    return ball_draw(show);
}
