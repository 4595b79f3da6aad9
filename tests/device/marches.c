/*
 * marches.c - a device's own marches (QV_MARCH_HEADER) beside those in C, which the library
 * does not hold then: random rays through random volumes, TAP on the console.
 *
 * Compared are light, samples taken, skipped and left, to the last bit.
 */
#include <stdbool.h>
#include "console.h"
#include "march.h"
#include "../golden/splitmix.h"

enum { EDGE_MAX = 9, PADDING_MAX = 2, WORDS = (EDGE_MAX + PADDING_MAX) * EDGE_MAX * EDGE_MAX };

/* Samples of each storage and order. */
enum { SAMPLES = 1000000 };

typedef struct form {
    const char *name;
    unsigned storage;
    int back;
} form;

static uint32_t random_state = 1;
static uint32_t voxels[WORDS];
static uint32_t palette[QV_PALETTE_ENTRIES];
static qv_context context;

static uint32_t below(uint32_t bound)
{
    return random_below(&random_state, bound);
}

static uint32_t random32(void)
{
    return (uint32_t)random16(&random_state) << 16 | random16(&random_state);
}

/* An entry, clear, opaque or anything. */
static uint32_t random_entry(uint32_t clear_of_16)
{
    uint32_t entry = random32(), opacity = 0xFFu << 24;
    if (below(16) < clear_of_16)
        return entry & ~opacity;
    return below(8) == 0 ? entry | opacity : entry;
}

/* Axes in any order and direction, rows with any padding. */
static void random_layout(qv_volume *volume, int32_t bytes)
{
    uint32_t first = below(3), second = (first + 1 + below(2)) % 3;
    uint32_t axis[3] = {first, second, 3 - first - second};
    const unsigned char *start = (const unsigned char *)voxels;
    int32_t stride = bytes;
    for (unsigned i = 0; i < 3; i++) {
        uint32_t size = below(6) == 0 ? 1 : 2 + below(EDGE_MAX - 1);
        volume->size[axis[i]] = (uint16_t)size;
        volume->stride[axis[i]] = stride;
        if (below(2) == 1) {
            start += stride * (int32_t)(size - 1);
            volume->stride[axis[i]] = -stride;
        }
        stride *= (int32_t)(size + (i == 0 ? below(PADDING_MAX + 1) : 0));
    }
    volume->voxels = start;
}

static void random_volume(unsigned storage)
{
    qv_volume *volume = &context.scene.volume;
    uint32_t clear = below(17), flat = below(4) == 0 ? random_entry(0) : 0;
    for (uint32_t i = 0; i < WORDS; i++)
        voxels[i] = storage == QV_STORAGE_INDEXED8 ? random32()
                    : flat != 0 && below(8) != 0   ? flat
                                                   : random_entry(clear);
    for (uint32_t i = 0; i < QV_PALETTE_ENTRIES; i++)
        palette[i] = random_entry(clear);
    volume->storage = (uint8_t)storage;
    volume->palette = (qv_address)palette;
    random_layout(volume, storage == QV_STORAGE_INDEXED8 ? 1 : 4);
    context.scene.termination = below(4) == 0 ? random16(&random_state) : 0;
}

/* Q31.32, 0 up to the limit; now and then a multiple of 1/2, where voxels are sampled exactly. */
static qv_coord random_coordinate(uint32_t limit)
{
    uint32_t kind = below(8), part = kind == 0 ? 0 : kind == 1 ? 0x80000000u : random32();
    return (qv_coord)below(limit) * ((qv_coord)1 << 32) + part;
}

/* Up to 2 voxels from sample to sample, or so little that there are tens of thousands. */
static qv_coord random_advance(uint32_t slow)
{
    qv_coord advance = random_coordinate(2) / ((qv_coord)1 << slow);
    return below(6) == 0 ? 0 : below(2) == 0 ? advance : -advance;
}

/* A ray through a point in the volume, or beside it, which is one of its first samples. */
static void random_ray(qv_ray *ray)
{
    uint32_t slow = below(512) == 0 ? 12 : below(6);
    for (unsigned axis = 0; axis < 3; axis++) {
        ray->place[axis] = random_coordinate(context.scene.volume.size[axis]);
        ray->advance[axis] = random_advance(slow);
    }
    ray->place[0] += below(16) == 0 ? (qv_coord)EDGE_MAX << 32 : 0;
    if (ray->advance[0] == 0 && ray->advance[1] == 0)
        ray->advance[2] = (qv_coord)1 << 30;
    ray->first = below(4) == 0 ? 0 : -QV_GRID_LIMIT;
    qv_ray_count_from(ray, -(int32_t)below(8));
}

static bool same_light(const qv_light *a, const qv_light *b)
{
    return a->colour[0] == b->colour[0] && a->colour[1] == b->colour[1] &&
           a->colour[2] == b->colour[2] && a->transmittance == b->transmittance &&
           a->skipped == b->skipped && a->terminated == b->terminated;
}

static void print_number(const char *name, uint32_t number)
{
    console_text(name);
    console_decimal(number);
}

static void print_light(const char *name, const qv_light *light, const qv_ray *ray)
{
    console_text(name);
    for (unsigned c = 0; c < 3; c++) {
        console_hexadecimal(light->colour[c]);
        console_text(" ");
    }
    console_hexadecimal(light->transmittance);
    print_number(" skipped ", light->skipped);
    print_number(" of ", ray->all);
    print_number(" left ", ray->samples);
    console_text("\n");
}

static void march_in_c(qv_light *light, qv_ray *ray, const form *f)
{
    if (f->storage == QV_STORAGE_RGBA8 && f->back)
        qv_march_back(light, ray, &context, QV_STORAGE_RGBA8, qv_take_weighted);
    else if (f->storage == QV_STORAGE_RGBA8)
        qv_march(light, ray, &context, QV_STORAGE_RGBA8, qv_take_weighted);
    else if (f->back)
        qv_march_back(light, ray, &context, QV_STORAGE_INDEXED8, qv_take_weighted);
    else
        qv_march(light, ray, &context, QV_STORAGE_INDEXED8, qv_take_weighted);
}

static int march_in_twin(qv_light *light, qv_ray *ray, const form *f)
{
    if (f->storage == QV_STORAGE_RGBA8 && f->back)
        return qv_march_twin(light, ray, &context, QV_STORAGE_RGBA8, qv_take_weighted, 1);
    if (f->storage == QV_STORAGE_RGBA8)
        return qv_march_twin(light, ray, &context, QV_STORAGE_RGBA8, qv_take_weighted, 0);
    if (f->back)
        return qv_march_twin(light, ray, &context, QV_STORAGE_INDEXED8, qv_take_weighted, 1);
    return qv_march_twin(light, ray, &context, QV_STORAGE_INDEXED8, qv_take_weighted, 0);
}

/* One ray both ways; returns its samples, or 0 where light or counts differ. */
static bool compare_ray(uint32_t *taken, const form *f)
{
    qv_light exact = {{0, 0, 0}, QV_CLEAR, 0, 0}, light = exact;
    qv_ray ray, other;
    random_ray(&ray);
    other = ray;
    march_in_c(&exact, &ray, f);
    bool same = march_in_twin(&light, &other, f) == 1 && same_light(&light, &exact) &&
                ray.all == other.all && ray.samples == other.samples;
    *taken += ray.all - ray.samples;
    if (same)
        return true;
    print_light("# C       ", &exact, &ray);
    print_light("# twin    ", &light, &other);
    return false;
}

/* Whether the target leaves a form to C altogether. */
static bool left_to_c(const form *f)
{
    qv_light light = {{0, 0, 0}, QV_CLEAR, 0, 0};
    qv_ray ray;
    random_volume(f->storage);
    random_ray(&ray);
    return march_in_twin(&light, &ray, f) == 0;
}

static bool compare(const form *f)
{
    uint32_t taken = 0, rays = 0;
    bool same = true;
    while (taken < SAMPLES && same) {
        if (rays++ % 16 == 0)
            random_volume(f->storage);
        same = compare_ray(&taken, f);
    }
    console_text(same ? "ok - " : "not ok - ");
    console_text(f->name);
    print_number(": ", taken);
    print_number(" samples of ", rays);
    console_text(" rays\n");
    return same;
}

int main(void)
{
    static const form forms[] = {
        {"rgba8, front to back", QV_STORAGE_RGBA8, 0},
        {"rgba8, back to front", QV_STORAGE_RGBA8, 1},
        {"indexed8, front to back", QV_STORAGE_INDEXED8, 0},
        {"indexed8, back to front", QV_STORAGE_INDEXED8, 1},
    };
    bool same = true;
    unsigned compared = 0;
    for (unsigned i = 0; i < sizeof forms / sizeof *forms; i++) {
        if (left_to_c(&forms[i]))
            continue;
        same = compare(&forms[i]) && same;
        compared++;
    }
    return compared == 0 || !same;
}
