/*
 * ball.c - descriptors of the ball.
 */
#include "ball.h"
#include "access.h"

void ball_volume(qv_volume *volume)
{
    const qv_volume described = {.voxels = qv_at(ball_data(), BALL_VOXELS_AT),
                                 .voxels_bytes = BALL_VOXELS,
                                 .palette = qv_at(ball_data(), BALL_PALETTE_AT),
                                 .palette_bytes = QV_PALETTE8_BYTES,
                                 .storage = QV_STORAGE_INDEXED8,
                                 .unit_distance = QV_ONE_Q16,
                                 .size = {BALL_SIZE, BALL_SIZE, BALL_SIZE},
                                 .stride = {1, BALL_SIZE, BALL_SIZE * BALL_SIZE}};
    *volume = described;
}

void ball_attenuation(qv_attenuation *attenuation)
{
    const qv_attenuation described = {.records = qv_at(ball_data(), BALL_ATTENUATION_AT),
                                      .bytes = BALL_ATTENUATION,
                                      .directions = QV_DIRECTIONS_ALL,
                                      .size = {BALL_SIZE, BALL_SIZE, BALL_SIZE}};
    *attenuation = described;
}
