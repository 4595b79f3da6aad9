#include "camera.h"
#include "fx_wide.h"

/* Vectors are compared as integers below 2^15, which have lost less than a part
   in 2^14; a determinant below 2^-14 of the possible 2^45 counts as none. */
#define MOST_SCALED       ((uint64_t)1 << 15)
#define LEAST_DETERMINANT ((uint64_t)1 << 31)

static uint64_t magnitude(qv_coord v)
{
    return v < 0 ? 0u - (uint64_t)v : (uint64_t)v;
}

uint64_t qv_largest(const qv_coord v[3])
{
    uint64_t most = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        if (magnitude(v[axis]) > most)
            most = magnitude(v[axis]);
    return most;
}

int qv_within(const qv_coord v[3], uint32_t voxels)
{
    return qv_largest(v) <= (uint64_t)voxels << 32;
}

/* Halves v until its largest component is below 2^15. */
static void scale(int32_t scaled[3], const qv_coord v[3])
{
    unsigned shift = 0;
    for (uint64_t most = qv_largest(v); most >= MOST_SCALED; most >>= 1)
        shift++;
    for (unsigned axis = 0; axis < 3; axis++) {
        int32_t size = (int32_t)(magnitude(v[axis]) >> shift);
        scaled[axis] = v[axis] < 0 ? -size : size;
    }
}

/* Whether |a . (b x c)| reaches the least determinant. Components are below 2^15,
   so those of the vector product below 2^31, and |sum| < 6 * 2^45. */
static int independent(const qv_camera *camera)
{
    int32_t a[3], b[3], c[3];
    int64_t sum = 0;
    scale(a, camera->across);
    scale(b, camera->down);
    scale(c, camera->along);
    for (unsigned i = 0, j = 1, k = 2; i < 3; j = k, k = i++)
        sum += fx_multiply(b[j] * c[k] - b[k] * c[j], a[i]);
    return magnitude(sum) >= LEAST_DETERMINANT;
}

qv_status qv_camera_check(const qv_camera *camera)
{
    if (!camera->projection)
        return QV_ERROR_NULL;
    int in_range =
        qv_within(camera->origin, QV_MOST_ORIGIN) && qv_within(camera->across, QV_MOST_PITCH) &&
        qv_within(camera->down, QV_MOST_PITCH) && QV_FIELD(camera->projection, in_range)(camera);
    return in_range && independent(camera) ? QV_OK : QV_ERROR_CAMERA;
}
