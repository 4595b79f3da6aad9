/*
 * fx_angle.h - sine and cosine of binary angles.
 */
#ifndef FX_ANGLE_H
#define FX_ANGLE_H

#include <stdint.h>

typedef uint32_t fx_angle; /* 2^32 is a full turn */

#define FX_QUARTER_TURN 0x40000000u
#define FX_ONE_Q30      0x40000000 /* 1 in Q2.30 */

/*
 * Sine and cosine in Q2.30, for every angle. Error at most 2^-28; exact at the
 * multiples of 90 degrees. sin(-a) = -sin(a), and sin(90 degrees - a) = cos(a),
 * bit for bit. Source: Taylor's series on an eighth of a turn.
 */
void fx_sine_cosine(int32_t *sine, int32_t *cosine, fx_angle angle);

#endif /* FX_ANGLE_H */
