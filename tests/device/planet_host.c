/*
 * planet_host.c - what port/avr/firmware_planet.c needs of a machine, for this one. With
 * PLANET_PICTURE in the environment, that file gets the frame of the last region as PAM.
 */
#include "planet_make.h"
#include "console.h"
#include "measure.h"

#include <stdio.h>
#include <stdlib.h>

static uint8_t voxels[PLANET_SIZE][PLANET_SIZE][PLANET_SIZE];
static uint16_t palette[QV_PALETTE_ENTRIES][4];

qv_address planet_voxels(void)
{
    planet_make_voxels(voxels);
    return voxels[0][0];
}

qv_address planet_palette(void)
{
    planet_make_palette(palette);
    return (qv_address)palette;
}

void measure_begin(void)
{
}

void measure_end(void)
{
    const char *name = getenv("PLANET_PICTURE");
    FILE *file = name != NULL ? fopen(name, "wb") : NULL;
    if (file == NULL)
        return;
    fprintf(file, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 3\nMAXVAL 255\nTUPLTYPE RGB\nENDHDR\n",
            PLANET_WIDTH, PLANET_HEIGHT);
    fwrite(planet_frame, 1, sizeof planet_frame, file);
    fclose(file);
}

void console_text(const char *text)
{
    fputs(text, stdout);
}
