/*
 * ball_make.h - makes the data of ball.h on a machine whose memory holds it.
 */
#ifndef BALL_MAKE_H
#define BALL_MAKE_H

#include "ball.h"

/* An error is one of qv_attenuate. */
qv_status ball_make(uint8_t data[BALL_BYTES]);

#endif /* BALL_MAKE_H */
