#include "camera.h"

#define MOST_SCALED ((qv_coord)1 << 15)
#define DEPENDENT_SHIFT 12 /* vectors with a determinant below 2^-12 count as dependent */

static qv_coord magnitude(qv_coord v)
{
    return v < 0 ? -v : v;
}

static int within(const qv_coord v[3], qv_coord limit)
{
    for (unsigned axis = 0; axis < 3; axis++)
        if (v[axis] < -limit || v[axis] > limit)
            return 0;
    return 1;
}

static qv_coord largest(const qv_coord v[3])
{
    qv_coord most = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        if (magnitude(v[axis]) > most)
            most = magnitude(v[axis]);
    return most;
}

/*
 * Scales v to integers, the largest component to 2^14 .. 2^15 - 1, and returns
 * that one; 0 for a zero vector.
 */
static int32_t scale(int32_t scaled[3], const qv_coord v[3])
{
    qv_coord most = largest(v);
    unsigned down = 0, up = 0;
    for (; most >= MOST_SCALED; most >>= 1)
        down++;
    for (; most != 0 && most < MOST_SCALED / 2; most <<= 1)
        up++;
    for (unsigned axis = 0; axis < 3; axis++) {
        int32_t size = (int32_t)((magnitude(v[axis]) >> down) << up); /* <= most < 2^15 */
        scaled[axis] = v[axis] < 0 ? -size : size;
    }
    return (int32_t)most;
}

/* a . (b x c), each component below 2^15: |result| < 6 * 2^45. */
static int64_t determinant(const int32_t a[3], const int32_t b[3], const int32_t c[3])
{
    int64_t sum = 0;
    for (unsigned i = 0; i < 3; i++) {
        unsigned j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        sum += a[i] * ((int64_t)b[j] * c[k] - (int64_t)b[k] * c[j]);
    }
    return sum;
}

static int independent(const qv_camera *camera)
{
    int32_t a[3], b[3], c[3];
    int64_t volume = scale(a, camera->across);
    volume *= scale(b, camera->down);
    volume *= scale(c, camera->along);
    return volume != 0 && magnitude(determinant(a, b, c)) >= volume >> DEPENDENT_SHIFT;
}

/* Orthographic cameras have no pace: then along leads from sample to sample. */
static int paced(const qv_camera *camera)
{
    if (largest(camera->pace) == 0)
        return largest(camera->along) >= QV_LEAST_PACE;
    for (unsigned axis = 0; axis < 3; axis++)
        if (camera->pace[axis] < QV_LEAST_PACE || camera->pace[axis] > QV_MOST_PACE)
            return 0;
    return 1;
}

qv_status qv_camera_check(const qv_camera *camera)
{
    if (!camera->ray)
        return QV_ERROR_NULL;
    int in_range = within(camera->origin, QV_MOST_ORIGIN) && within(camera->across, QV_MOST_PITCH) &&
                   within(camera->down, QV_MOST_PITCH) && within(camera->along, QV_MOST_PACE);
    return in_range && paced(camera) && independent(camera) ? QV_OK : QV_ERROR_CAMERA;
}
