#include "reference.h"

#include <math.h>

/* 2 pi / 2^32: radians of one unit of a binary angle. */
static const double radians_per_unit = 1.46291807926715968e-9;

double ref_sine(qv_angle angle)
{
    const uint32_t quarter = angle >> 30;
    const double rest = (double)(angle & 0x3fffffffu) * radians_per_unit;
    /* sin(0) and cos(0) are exact, which makes the multiples of 90 degrees exact. */
    const double magnitude = quarter & 1u ? cos(rest) : sin(rest);
    return quarter & 2u ? -magnitude : magnitude;
}

double ref_cosine(qv_angle angle)
{
    return ref_sine(angle + 0x40000000u);
}

/* Turns two orthogonal directions in their plane: the first towards the second. */
static void turn(double first[3], double second[3], qv_angle angle)
{
    const double s = ref_sine(angle), c = ref_cosine(angle);
    for (int axis = 0; axis < 3; axis++) {
        const double a = first[axis], b = second[axis];
        first[axis] = c * a + s * b;
        second[axis] = c * b - s * a;
    }
}

/*
 * The viewer starts at -y with z up. A camera that goes round by the azimuth
 * pans to the left, for the viewer moves to the right and keeps looking at the
 * centre; one that is lifted tilts down; roll turns right towards down.
 */
void ref_rotation(double rotation[3][3], qv_angle azimuth, qv_angle elevation, qv_angle roll)
{
    static const double start[3][3] = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    for (int row = 0; row < 3; row++) {
        for (int axis = 0; axis < 3; axis++) {
            rotation[row][axis] = start[row][axis];
        }
    }
    turn(rotation[0], rotation[2], azimuth);
    turn(rotation[2], rotation[1], elevation);
    turn(rotation[0], rotation[1], roll);
}
