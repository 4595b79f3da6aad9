#include "camera.h"
#include "fx_wide.h"

/* Vectors are compared as integers below 2^15, which have lost less than a part
   in 2^14; a determinant below 2^-14 of the possible 2^45 counts as none. */
#define MOST_SCALED       ((uint64_t)1 << 15)
#define LEAST_DETERMINANT ((int64_t)1 << 31)

static uint64_t magnitude(qv_coord v)
{
    return v < 0 ? 0u - (uint64_t)v : (uint64_t)v;
}

static uint64_t largest(const qv_coord v[3])
{
    uint64_t most = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        if (magnitude(v[axis]) > most)
            most = magnitude(v[axis]);
    return most;
}

static int within(const qv_coord v[3], uint32_t voxels)
{
    return largest(v) <= (uint64_t)voxels << 32;
}

/* Halves v until its largest component is below 2^15. */
static void scale(int32_t scaled[3], const qv_coord v[3])
{
    for (unsigned axis = 0; axis < 3; axis++) {
        uint64_t most = largest(v), size = magnitude(v[axis]);
        for (; most >= MOST_SCALED; most >>= 1)
            size >>= 1;
        scaled[axis] = v[axis] < 0 ? -(int32_t)size : (int32_t)size;
    }
}

/* a . (b x c), each component below 2^15: each product of two
   below 2^30, |result| < 6 * 2^45. */
static int64_t determinant(const int32_t a[3], const int32_t b[3], const int32_t c[3])
{
    int64_t sum = 0;
    for (unsigned i = 0; i < 3; i++) {
        unsigned j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
        sum += fx_multiply((int64_t)(b[j] * c[k]) - b[k] * c[j], a[i]);
    }
    return sum;
}

static int independent(const qv_camera *camera)
{
    int32_t a[3], b[3], c[3];
    scale(a, camera->across);
    scale(b, camera->down);
    scale(c, camera->along);
    int64_t d = determinant(a, b, c);
    return d <= -LEAST_DETERMINANT || d >= LEAST_DETERMINANT;
}

/*
 * Orthographic cameras have no pace: there along leads from sample to sample. In
 * perspective the eye lies at most 2^20 paces off on each axis; the volume is at
 * most 2^20 of them long, so k stays below sqrt(3) * 2^21 < QV_GRID_LIMIT.
 */
static int paced(const qv_camera *camera)
{
    const qv_coord *pace = camera->pace;
    if (largest(pace) == 0)
        return largest(camera->along) >= QV_LEAST_PACE && within(camera->along, QV_MOST_PACE);
    for (unsigned axis = 0; axis < 3; axis++)
        if (pace[axis] < (qv_coord)QV_LEAST_PACE ||
            magnitude(camera->origin[axis]) > (uint64_t)pace[axis] << 20)
            return 0;
    return within(pace, QV_MOST_PACE);
}

qv_status qv_camera_check(const qv_camera *camera)
{
    if (!camera->ray)
        return QV_ERROR_NULL;
    int in_range = within(camera->origin, QV_MOST_ORIGIN) &&
                   within(camera->across, QV_MOST_PITCH) && within(camera->down, QV_MOST_PITCH) &&
                   within(camera->along, QV_MOST_ALONG);
    return in_range && paced(camera) && independent(camera) ? QV_OK : QV_ERROR_CAMERA;
}
