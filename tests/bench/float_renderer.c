#include "float_renderer.h"

#include <math.h>

typedef struct {
    float colour[3], transmittance;
} light;

static float coordinate(qv_coord v)
{
    return (float)((double)v / 4294967296.0);
}

static int clamp(int i, int size)
{
    return i < 0 ? 0 : i >= size ? size - 1 : i;
}

/* Adds one voxel's share to a sample. */
static void gather(float sample[4], const uint8_t *voxel, float weight)
{
    float share = weight * (float)voxel[3] * (1.0f / 255.0f);
    for (int c = 0; c < 3; c++)
        sample[c] += share * (float)voxel[c] * (1.0f / 255.0f);
    sample[3] += share;
}

static void sample_at(float sample[4], const qv_volume *volume, const float point[3])
{
    qv_address corner[2][3];
    float fraction[2][3];
    for (int axis = 0; axis < 3; axis++) {
        float place = point[axis] - 0.5f, below = floorf(place);
        for (int side = 0; side < 2; side++) {
            int index = clamp((int)below + side, volume->size[axis]);
            corner[side][axis] = volume->voxels + (ptrdiff_t)index * volume->stride[axis];
        }
        fraction[1][axis] = place - below;
        fraction[0][axis] = 1.0f - fraction[1][axis];
    }
    sample[0] = sample[1] = sample[2] = sample[3] = 0.0f;
    for (unsigned i = 0; i < 8; i++) {
        unsigned x = i & 1u, y = i >> 1 & 1u, z = i >> 2;
        const uint8_t *voxel =
            corner[x][0] + (corner[y][1] - volume->voxels) + (corner[z][2] - volume->voxels);
        gather(sample, voxel, fraction[x][0] * fraction[y][1] * fraction[z][2]);
    }
}

/* Narrows the samples first .. last to those inside one pair of faces. */
static void clip(float *first, float *last, float origin, float along, float size)
{
    if (fabsf(along) < 1e-6f) {
        if (origin < 0.0f || origin >= size)
            *last = *first - 1.0f;
        return;
    }
    float enter = -origin / along, leave = (size - origin) / along;
    *first = fmaxf(*first, ceilf(fminf(enter, leave)));
    *last = fminf(*last, floorf(fmaxf(enter, leave)));
}

static unsigned long trace(light *l, const qv_scene *scene, const float origin[3],
                           const float along[3])
{
    float first = -1e6f, last = 1e6f, threshold = (float)scene->termination / 65535.0f;
    unsigned long taken = 0;
    for (int axis = 0; axis < 3; axis++)
        clip(&first, &last, origin[axis], along[axis], scene->volume.size[axis]);
    for (float k = first; k <= last && l->transmittance > threshold; k += 1.0f) {
        float sample[4], point[3];
        for (int axis = 0; axis < 3; axis++)
            point[axis] = origin[axis] + k * along[axis];
        sample_at(sample, &scene->volume, point);
        for (int c = 0; c < 3; c++)
            l->colour[c] += l->transmittance * sample[c];
        l->transmittance *= 1.0f - sample[3];
        taken++;
    }
    return taken;
}

unsigned long float_render(uint8_t *rgba, const qv_scene *scene, int width, int height)
{
    const qv_camera *camera = &scene->camera;
    unsigned long taken = 0;
    for (int i = 0; i < width * height; i++) {
        light l = {{0.0f, 0.0f, 0.0f}, 1.0f};
        float origin[3], along[3];
        int x = i % width, y = i / width;
        for (int axis = 0; axis < 3; axis++) {
            along[axis] = coordinate(camera->along[axis]);
            origin[axis] = coordinate(camera->origin[axis] + x * camera->across[axis] +
                                      y * camera->down[axis]);
        }
        taken += trace(&l, scene, origin, along);
        for (int c = 0; c < 3; c++)
            rgba[4 * i + c] = (uint8_t)lrintf(255.0f * fminf(l.colour[c], 1.0f));
        rgba[4 * i + 3] = (uint8_t)lrintf(255.0f * (1.0f - l.transmittance));
    }
    return taken;
}
