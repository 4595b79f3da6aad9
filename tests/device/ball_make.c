/*
 * ball_make.c - the data of ball.h. Integers only, so that every machine makes the same.
 */
#include "ball_make.h"

/* Squares of distances from the centre, in half voxels. */
enum { BALL_SQUARE = 48, FOG_SQUARE = 180 };

/* The palette: clear, fog, ball. */
enum { FOG = 1, FOG_SHADES = 16, BALL = 32, STRIPES = 2 };

enum { FOG_OPACITY = 3, BALL_OPACITY = 200 }; /* of a shade of fog, of the ball; 255 is 1 */

static void make_palette(uint8_t entry[][4])
{
    static const uint8_t stripes[STRIPES][3] = {{255, 200, 90}, {220, 70, 60}};
    for (unsigned i = 0; i < FOG_SHADES; i++) {
        entry[FOG + i][0] = 120;
        entry[FOG + i][1] = 170;
        entry[FOG + i][2] = 255;
        entry[FOG + i][3] = (uint8_t)(FOG_OPACITY * (i + 1));
    }
    for (unsigned i = 0; i < STRIPES; i++) {
        for (unsigned c = 0; c < 3; c++)
            entry[BALL + i][c] = stripes[i][c];
        entry[BALL + i][3] = BALL_OPACITY;
    }
}

static uint8_t voxel(int32_t x, int32_t y, int32_t z)
{
    int32_t square = x * x + y * y + z * z;
    if (square <= BALL_SQUARE)
        return (uint8_t)(BALL + (z + BALL_SIZE) / 4 % STRIPES);
    if (square > FOG_SQUARE)
        return 0;
    return (uint8_t)(FOG + (FOG_SQUARE - square) * FOG_SHADES / (FOG_SQUARE + 1));
}

/* Half voxels from the centre to that of a voxel. */
static int32_t from_centre(int32_t index)
{
    return 2 * index + 1 - BALL_SIZE;
}

static void make_voxels(uint8_t *to)
{
    for (int32_t z = 0; z < BALL_SIZE; z++)
        for (int32_t y = 0; y < BALL_SIZE; y++)
            for (int32_t x = 0; x < BALL_SIZE; x++)
                *to++ = voxel(from_centre(x), from_centre(y), from_centre(z));
}

qv_status ball_make(uint8_t data[BALL_BYTES])
{
    qv_status status = QV_OK;
    qv_volume volume;
    qv_attenuation attenuation;
    for (uint32_t i = 0; i < BALL_VOXELS_AT; i++)
        data[i] = 0;
    make_palette((uint8_t(*)[4])(data + BALL_PALETTE_AT));
    make_voxels(data + BALL_VOXELS_AT);
    ball_volume(&volume);
    ball_attenuation(&attenuation);
    for (uint8_t direction = 0; direction < QV_DIRECTIONS && status == QV_OK; direction++)
        status = qv_attenuate(data + BALL_ATTENUATION_AT, BALL_ATTENUATION, NULL, &attenuation,
                              &volume, &qv_domain_extinction, direction);
    return status;
}
