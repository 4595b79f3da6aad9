/*
 * planet_write.c - writes the volume for port/avr/planet_flash.c: voxels, then the palette's
 * words, low byte first, as an AVR has them.
 *
 *     planet_write FILE
 */
#include "planet_make.h"

#include <stdio.h>

static uint8_t voxels[PLANET_SIZE][PLANET_SIZE][PLANET_SIZE];
static uint16_t palette[QV_PALETTE_ENTRIES][4];

static int write_volume(FILE *file)
{
    if (fwrite(voxels, 1, sizeof voxels, file) != sizeof voxels)
        return 0;
    for (unsigned i = 0; i < QV_PALETTE_ENTRIES; i++)
        for (unsigned c = 0; c < 4; c++)
            if (putc(palette[i][c] & 0xFF, file) == EOF || putc(palette[i][c] >> 8, file) == EOF)
                return 0;
    return 1;
}

int main(int count, char **arguments)
{
    if (count != 2) {
        fprintf(stderr, "usage: planet_write FILE\n");
        return 2;
    }
    planet_make_voxels(voxels);
    planet_make_palette(palette);
    FILE *file = fopen(arguments[1], "wb");
    int written = file != NULL && write_volume(file);
    if (file == NULL || fclose(file) != 0 || !written) {
        perror(arguments[1]);
        return 1;
    }
    return 0;
}
