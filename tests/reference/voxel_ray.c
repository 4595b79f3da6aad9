#include "freevoxels.h"

#include <math.h>
#include <stdlib.h>

/* ---- The field ------------------------------------------------------------ */

static size_t voxel_count(const qv_volume *volume)
{
    return (size_t)volume->size[0] * volume->size[1] * volume->size[2];
}

bool ref_field_make(ref_field *made, const qv_volume *volume)
{
    size_t index = 0;
    int32_t at[3];
    double rgba[4];
    made->volume = volume;
    made->extinction = malloc(voxel_count(volume) * sizeof *made->extinction);
    if (made->extinction == NULL) {
        return false;
    }
    for (at[2] = 0; at[2] < volume->size[2]; at[2]++) {
        for (at[1] = 0; at[1] < volume->size[1]; at[1]++) {
            for (at[0] = 0; at[0] < volume->size[0]; at[0]++) {
                ref_voxel(rgba, volume, at);
                made->extinction[index++] = ref_extinction(rgba[3], volume);
            }
        }
    }
    return true;
}

void ref_field_free(ref_field *made)
{
    free(made->extinction);
    made->extinction = NULL;
}

/* ---- A ray through it ------------------------------------------------------- */

typedef struct path {
    double start[3], v[3];
    double end; /* where it leaves the box, in lengths of v */
} path;

/* The voxels on both sides of a point on one axis, and the share of the upper one. Beyond the
   outermost centres both are the same. */
static double neighbours(size_t pair[2], double point, int32_t size)
{
    const double low = fmin(fmax(point - 0.5, 0), size - 1), first = floor(low);
    pair[0] = (size_t)first;
    pair[1] = pair[0] + (pair[0] + 1 < (size_t)size);
    return low - first;
}

static double extinction_at(const ref_field *field, const path *along, double t)
{
    const uint16_t *size = field->volume->size;
    size_t x[2], y[2], z[2];
    double row[4];
    const double right = neighbours(x, along->start[0] + t * along->v[0], size[0]);
    const double down = neighbours(y, along->start[1] + t * along->v[1], size[1]);
    const double up = neighbours(z, along->start[2] + t * along->v[2], size[2]);
    for (int i = 0; i < 4; i++) {
        const double *line = field->extinction + size[0] * (y[i % 2] + size[1] * z[i / 2]);
        row[i] = line[x[0]] + right * (line[x[1]] - line[x[0]]);
    }
    const double near = row[0] + down * (row[1] - row[0]);
    const double far = row[2] + down * (row[3] - row[2]);
    return near + up * (far - near);
}

/* Where the path meets the next plane through centres on an axis, beyond t. */
static double next_plane(const path *along, int axis, double t)
{
    const double v = along->v[axis], point = along->start[axis] + t * v - 0.5;
    if (v == 0) {
        return HUGE_VAL;
    }
    /* a plane closer than this is the one on which the path stands */
    const double on_it = 1e-9;
    const double plane = v > 0 ? floor(point + on_it) + 1 : ceil(point - on_it) - 1;
    return t + (plane - point) / v;
}

/* Gauss's rule of two points is exact here: within a cell extinction is a cubic of t. */
static double integral(const ref_field *field, const path *along, double from, double to)
{
    const double middle = (from + to) / 2, aside = (to - from) / 2 / sqrt(3);
    return (to - from) / 2 *
           (extinction_at(field, along, middle - aside) +
            extinction_at(field, along, middle + aside));
}

static double leave(const path *along, const uint16_t size[3])
{
    double end = HUGE_VAL;
    for (int axis = 0; axis < 3; axis++) {
        if (along->v[axis] != 0) {
            const double face = along->v[axis] > 0 ? size[axis] : 0;
            end = fmin(end, (face - along->start[axis]) / along->v[axis]);
        }
    }
    return end;
}

/* In steps of v: half a step of the voxel's level before its centre. */
static void set_out(path *along, int level, const int32_t at[3], const double v[3])
{
    const double longest = fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
    for (int axis = 0; axis < 3; axis++) {
        along->v[axis] = v[axis] / longest;
        along->start[axis] = ldexp(at[axis] + 0.5 + 0.5 * along->v[axis], level);
    }
}

double ref_depth_of_ray(const void *in, int level, const int32_t at[3], const double v[3])
{
    const ref_field *field = in;
    path along;
    double depth = 0;
    set_out(&along, level, at, v);
    along.end = leave(&along, field->volume->size);
    for (double t = 0; t < along.end;) {
        double next = along.end;
        for (int axis = 0; axis < 3; axis++) {
            next = fmin(next, next_plane(&along, axis, t));
        }
        depth += integral(field, &along, t, next);
        t = next;
    }
    return depth * ref_step_length(field->volume, v);
}
