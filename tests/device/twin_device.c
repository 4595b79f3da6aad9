/*
 * twin_device.c - the twin of a target (QV_TWIN_HEADER) beside the C that it stands for: random
 * rays through random volumes, both from the same state. Prints TAP.
 */
#include "march.h"
#include QV_TWIN_HEADER
#include "console.h"

/* Samples that are compared, of each storage. */
enum { ENOUGH = 1000000, LONGEST = 64, VOXEL_BYTES = 4096 };

static uint8_t voxels[VOXEL_BYTES];
static uint8_t palette[QV_PALETTE8_BYTES];

static uint32_t next_random(void)
{
    static uint32_t state = 2463534242u;
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

static uint32_t below(uint32_t limit)
{
    return (uint32_t)((uint64_t)next_random() * limit >> 32);
}

/* Bytes, of which some are 0 and some are 255; opacities, each fourth byte, are 0 rather often:
   at odds of 1 to `clear`. */
static void fill(uint8_t *bytes, uint32_t count, uint32_t clear)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t random = next_random();
        bytes[i] = (random & 0xF00u) == 0 ? (uint8_t)(0u - (random & 1u)) : (uint8_t)random;
        if (i % 4 == 3 && below(clear) == 0)
            bytes[i] = 0;
    }
}

/* Axes of 1 to 8 voxels in any order, each of either sign. */
static void make_volume(qv_volume *volume, unsigned storage)
{
    int32_t stride = (int32_t)qv_voxel_bytes(storage);
    uint32_t first = below(3);
    volume->voxels = voxels;
    volume->palette = palette;
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t axis = (first + i) % 3;
        volume->size[axis] = (uint16_t)(1 + below(8));
        int32_t last = volume->size[axis] - 1;
        volume->stride[axis] = stride;
        if (below(2) == 0) {
            volume->stride[axis] = -stride;
            volume->voxels += last * stride;
        }
        stride += last * stride;
    }
}

/* A ray towards the volume from near its middle, unclipped: Q31.32. */
static void make_ray(qv_ray *ray, const qv_volume *volume)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        ray->place[axis] = (qv_coord)below(volume->size[axis]) << 32 | next_random();
        ray->advance[axis] = (qv_coord)((uint64_t)next_random() << below(3));
        if (below(2) == 0)
            ray->advance[axis] = -ray->advance[axis];
        if (below(8) == 0)
            ray->advance[axis] = 0;
    }
    if (ray->advance[0] == 0 && ray->advance[1] == 0 && ray->advance[2] == 0)
        ray->advance[0] = (qv_coord)1 << (26 + below(6));
    ray->first = below(2) == 0 ? 0 : -LONGEST;
}

static void make_light(qv_light *light)
{
    for (unsigned c = 0; c < 3; c++)
        light->colour[c] = next_random() >> 2;
    light->transmittance = below(4) == 0 ? QV_CLEAR : below(QV_CLEAR);
    light->skipped = below(100);
    light->terminated = 0;
}

static int same(const qv_light *a, const qv_light *b, const qv_ray *c, const qv_ray *d)
{
    int light = a->colour[0] == b->colour[0] && a->colour[1] == b->colour[1] &&
                a->colour[2] == b->colour[2] && a->transmittance == b->transmittance;
    return light && a->skipped == b->skipped && a->terminated == b->terminated &&
           c->samples == d->samples;
}

/* Compares one ray; returns the samples that it took, or -1 where the two differ. */
static int32_t compare(unsigned storage)
{
    static qv_context context;
    qv_light light, other;
    qv_ray ray, twin;
    make_volume(&context.scene.volume, storage);
    context.scene.termination = (uint16_t)(below(2) == 0 ? 0 : below(65536));
    make_ray(&ray, &context.scene.volume);
    make_light(&light);
    other = light;
    twin = ray;
    qv_march(&light, &ray, &context, storage, qv_take_weighted);
    QV_MARCH_WEIGHTED8(&other, &twin, &context, storage, qv_take_weighted);
    return same(&light, &other, &ray, &twin) ? (int32_t)(ray.all - ray.samples) : -1;
}

static int compare_all(unsigned storage)
{
    uint32_t samples = 0, rays = 0;
    while (samples < ENOUGH) {
        if (rays++ % 64 == 0) {
            uint32_t clear = 1 + below(4);
            fill(voxels, sizeof voxels, clear);
            fill(palette, sizeof palette, clear);
        }
        int32_t taken = compare(storage);
        if (taken < 0)
            return 0;
        samples += (uint32_t)taken;
    }
    return 1;
}

static int report(unsigned number, unsigned storage, const char *name)
{
    int good = compare_all(storage);
    console_text(good ? "ok " : "not ok ");
    console_decimal(number);
    console_text(name);
    return good;
}

int main(void)
{
    int good = report(1, QV_STORAGE_RGBA8, " - a million samples of rgba8: C and twin agree\n");
    good &= report(2, QV_STORAGE_INDEXED8, " - a million samples of indexed8: C and twin agree\n");
    console_text("1..2\n");
    return !good;
}
