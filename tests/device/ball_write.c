/*
 * ball_write.c - writes the ball for the flash of devices:
 *
 *     ball_write FILE
 */
#include "ball_make.h"

#include <stdio.h>

int main(int count, char **arguments)
{
    if (count != 2) {
        fprintf(stderr, "usage: ball_write FILE\n");
        return 2;
    }
    FILE *file = fopen(arguments[1], "wb");
    int written = file != NULL && fwrite(ball_data(), BALL_BYTES, 1, file) == 1;
    if (file == NULL || fclose(file) != 0 || !written) {
        perror(arguments[1]);
        return 1;
    }
    return 0;
}
