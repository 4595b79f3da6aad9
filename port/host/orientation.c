/*
 * orientation.c - stored axes to the world's: right, anterior, superior.
 */
#include "scan.h"

#include <math.h>
#include <string.h>

static const uint8_t permutations[6][3] = {
    {0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0},
};

/* Six volumes of the box of unit directions: below this they lie in a plane. */
#define LEAST_DETERMINANT 1e-6

/* By the first row. */
static double determinant(double m[3][3])
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/* Lengths of the columns become the spacing, the columns unit vectors. */
static bool normalise(double direction[3][3], double spacing[3])
{
    for (unsigned a = 0; a < 3; a++) {
        double length = sqrt(direction[0][a] * direction[0][a] + direction[1][a] * direction[1][a] +
                             direction[2][a] * direction[2][a]);
        if (!isfinite(length) || length <= 0) {
            return false;
        }
        spacing[a] = length;
        for (unsigned w = 0; w < 3; w++) {
            direction[w][a] /= length;
        }
    }
    return true;
}

/* The permutation whose axes lie closest to the world's: largest sum of cosines. */
static const uint8_t *nearest_permutation(double direction[3][3])
{
    const uint8_t *best = permutations[0];
    double best_sum = -1;
    for (unsigned p = 0; p < 6; p++) {
        const uint8_t *axis = permutations[p];
        double sum =
            fabs(direction[0][axis[0]]) + fabs(direction[1][axis[1]]) + fabs(direction[2][axis[2]]);
        if (sum > best_sum) {
            best_sum = sum;
            best = axis;
        }
    }
    return best;
}

bool scan_orient(struct scan *scan, double direction[3][3])
{
    const uint8_t *axis;
    if (!normalise(direction, scan->spacing) ||
        !(fabs(determinant(direction)) >= LEAST_DETERMINANT)) {
        return false;
    }
    axis = nearest_permutation(direction);
    for (unsigned w = 0; w < 3; w++) {
        scan->turn.axis[w] = axis[w];
        scan->turn.reversed[w] = direction[w][axis[w]] < 0;
    }
    scan->oriented = true;
    return true;
}

void scan_orientation_text(const struct scan *scan, char text[4])
{
    static const char towards[3] = {'R', 'A', 'S'};
    static const char away[3] = {'L', 'P', 'I'};
    for (unsigned w = 0; w < 3; w++) {
        text[scan->turn.axis[w]] = scan->turn.reversed[w] ? away[w] : towards[w];
    }
    text[3] = '\0';
}
