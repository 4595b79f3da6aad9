/*
 * float_device.c - the arithmetic of opacity-weighted RGBA8 samples inside a ray, in float, as
 * one writes it where no integers are at hand: fetch of eight voxels, weights, weighting by
 * opacity, interpolation, composition and step. What a sample costs in the compiler's software
 * floats is the difference between its two regions, which prints as
 *     float SAMPLES SAMPLES
 */
#include <stdbool.h>
#include "console.h"
#include "measure.h"

enum { EDGE = 8, ROW = EDGE * 4, SLICE = EDGE * ROW, SAMPLES = 16 };

/* Thin, so that no ray ends early. */
enum { OPACITY = 3 };

static uint8_t voxels[EDGE * SLICE];

typedef struct ray {
    float point[3], step[3]; /* between voxel centres, which have whole coordinates */
} ray;

typedef struct light {
    float colour[3], transmittance;
} light;

static void fill(void)
{
    for (unsigned i = 0; i < sizeof voxels; i++)
        voxels[i] = i % 4 == 3 ? OPACITY : (uint8_t)(i * 29);
}

/* Adds one voxel's share of the sample: its colour counts by its opacity. */
static void gather(float sample[4], const uint8_t *voxel, float weight)
{
    float share = weight * (float)voxel[3];
    sample[0] += share * (float)voxel[0];
    sample[1] += share * (float)voxel[1];
    sample[2] += share * (float)voxel[2];
    sample[3] += share;
}

static void take_sample(float sample[4], const float point[3])
{
    const int x = (int)point[0], y = (int)point[1], z = (int)point[2];
    const float fx = point[0] - (float)x, fy = point[1] - (float)y, fz = point[2] - (float)z;
    const float near_near = (1.0f - fy) * (1.0f - fz), far_near = fy * (1.0f - fz);
    const float near_far = (1.0f - fy) * fz, far_far = fy * fz;
    const uint8_t *cell = &voxels[x * 4 + y * ROW + z * SLICE];
    sample[0] = sample[1] = sample[2] = sample[3] = 0.0f;
    gather(sample, cell, (1.0f - fx) * near_near);
    gather(sample, cell + 4, fx * near_near);
    gather(sample, cell + ROW, (1.0f - fx) * far_near);
    gather(sample, cell + ROW + 4, fx * far_near);
    gather(sample, cell + SLICE, (1.0f - fx) * near_far);
    gather(sample, cell + SLICE + 4, fx * near_far);
    gather(sample, cell + SLICE + ROW, (1.0f - fx) * far_far);
    gather(sample, cell + SLICE + ROW + 4, fx * far_far);
}

/* Front to back, while anything behind can be seen. */
static void march(light *l, ray *r, unsigned samples)
{
    for (; samples > 0 && l->transmittance > 1.0f / 1024.0f; samples--) {
        float sample[4];
        take_sample(sample, r->point);
        float share = l->transmittance * (1.0f / (255.0f * 255.0f));
        for (unsigned c = 0; c < 3; c++)
            l->colour[c] += share * sample[c];
        l->transmittance -= l->transmittance * sample[3] * (1.0f / 255.0f);
        for (unsigned axis = 0; axis < 3; axis++)
            r->point[axis] += r->step[axis];
    }
}

/* Whether light came out. */
static bool measure(unsigned samples)
{
    light l = {{0.0f, 0.0f, 0.0f}, 1.0f};
    ray r = {{0.6f, 1.1f, 0.4f}, {0.19f, 0.11f, 0.17f}}; /* 32 steps stay inside */
    measure_begin();
    march(&l, &r, samples);
    measure_end();
    return l.colour[0] > 0.0f && l.transmittance > 0.5f;
}

int main(void)
{
    fill();
    bool lit = measure(SAMPLES) && measure(2 * SAMPLES);
    console_text("float ");
    console_decimal(SAMPLES);
    console_text(" ");
    console_decimal(2 * SAMPLES);
    console_text("\n");
    return lit ? 0 : 1;
}
