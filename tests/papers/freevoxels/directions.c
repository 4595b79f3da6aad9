/*
 * directions.c - section 3.1: 26 directions for light from anywhere. A step of equation 5 is as
 * opaque along a diagonal as along an axis, though it is longer; equation 11 is another product;
 * and the nearest of the directions may be far from the one wanted.
 */
#include "freevoxels.h"

#include "bearing.h"
#include "reference/attenuation.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* ---- A way of 32 voxels ------------------------------------------------------------- */

enum { size = 34, way = 32 /* voxels long */ };

static const double opacity = 0.05;

static void fill_fog(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    (void)at;
    rgba[3] = *(const uint16_t *)from;
}

/* The light left after a way of that length along a direction of so many axes, by the library:
   between the two voxels next to its end, in the logarithm. */
static double light_after_way(const qv_volume *volume, int axes)
{
    const uint8_t direction = qv_direction(-1, axes > 1 ? -1 : 0, axes > 2 ? -1 : 0);
    const double steps = way / sqrt(axes), before = floor(steps);
    const unsigned last = (unsigned)before;
    attenuated light;
    attenuated_make(&light, volume, ONLY(direction), 0);
    const double at = attenuated_byte(&light, last, last, last) / 255.;
    const double next = attenuated_byte(&light, last + 1, last + 1, last + 1) / 255.;
    attenuated_free(&light);
    return at * pow(next / at, steps - before);
}

static void ways_of_one_length(FILE *table)
{
    static const char *const names[] = {"an axis", "a diagonal of a face",
                                        "a diagonal of the cube"};
    const uint16_t alpha = paper_channel(opacity);
    char what[96];
    paper_volume fog;
    paper_volume_make(&fog, size, size, size);
    paper_volume_fill(&fog, fill_fog, &alpha);
    for (int axes = 1; axes <= 3; axes++) {
        fog.volume.unit_distance = 0;
        (void)snprintf(what, sizeof what, "as published, along %s", names[axes - 1]);
        const paper_row published = {what, "-", pow(1 - opacity, way / sqrt(axes)),
                                     light_after_way(&fog.volume, axes), 0.003};
        paper_table_add(table, &published);
        fog.volume.unit_distance = QV_ONE_Q16;
        (void)snprintf(what, sizeof what, "by the length of a step, along %s", names[axes - 1]);
        const paper_row corrected = {what, "-", pow(1 - opacity, way),
                                     light_after_way(&fog.volume, axes), 0.003};
        paper_table_add(table, &corrected);
    }
    paper_volume_free(&fog);
}

/* ---- The nearest direction ---------------------------------------------------------------- */

/* The direction that the library takes for the nearest, of all. */
static int nearest(const qv_volume *volume, const double v[3])
{
    const double largest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    uint8_t numbers[QV_DIRECTIONS]; /* bytes that tell whose they are */
    int32_t scaled[3];
    qv_compass compass;
    qv_bearing bearing;
    uint32_t length;
    for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++) {
        numbers[direction] = direction;
    }
    for (int axis = 0; axis < 3; axis++) {
        scaled[axis] = (int32_t)lround(v[axis] / largest * INT32_MAX);
    }
    qv_compass_of(&compass, volume, QV_DIRECTIONS_ALL, QV_NEAREST);
    paper_require(qv_bearing_of(&bearing, &length, &compass, scaled) == QV_OK, "no bearing");
    return (int)lround(255 * ldexp(qv_bearing_transmittance(&bearing, numbers, NULL), -32));
}

static double degrees_between(const double v[3], int direction)
{
    double dot = 0, step_square = 0, v_square = 0;
    int step[3];
    ref_direction_step(step, direction);
    for (int axis = 0; axis < 3; axis++) {
        dot += step[axis] * v[axis];
        step_square += step[axis] * step[axis];
        v_square += v[axis] * v[axis];
    }
    return acos(fmin(1, dot / sqrt(step_square * v_square))) * 180 / pi;
}

/* The farthest from the nearest direction: as far from an axis as from the diagonals. */
static void farthest_direction(FILE *table)
{
    const double v[3] = {1, sqrt(2) - 1, sqrt(3) - sqrt(2)};
    const double exact = acos(1 / sqrt(1 + v[1] * v[1] + v[2] * v[2])) * 180 / pi;
    paper_volume voxel;
    paper_volume_make(&voxel, 1, 1, 1);
    const paper_row row = {"nearest direction, at most so many degrees away", "-", exact,
                           degrees_between(v, nearest(&voxel.volume, v)), 0.001};
    paper_table_add(table, &row);
    paper_volume_free(&voxel);
}

/* Ten layers of which a pixel takes a quarter: equation 11 in place of 5. */
static void equation11(FILE *table)
{
    const double alpha = 0.1;
    enum { layers = 10 };
    paper_volume fog;
    attenuated light;
    const uint16_t stored = paper_channel(alpha);
    paper_volume_make(&fog, layers + 1, 1, 1);
    paper_volume_fill(&fog, fill_fog, &stored);
    attenuated_make(&light, &fog.volume, ONLY(qv_direction(-1, 0, 0)), 0);
    pairs_add(table, "light after 10 voxels of opacity 0.1: equation 11, weights of 1/4",
              pow(1 - alpha / 4, layers), attenuated_byte(&light, layers, 0, 0) / 255.);
    attenuated_free(&light);
    paper_volume_free(&fog);
}

void directions(FILE *table)
{
    paper_table_begin(table, "\n## Equation 5 and 26 directions: light after a way of 32 voxels, "
                             "opacity 0.05");
    ways_of_one_length(table);
    farthest_direction(table);
    pairs_begin(table, "\n### Equation 11 is not equation 5", "that way", "ours");
    equation11(table);
}
