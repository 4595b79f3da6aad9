/*
 * helium.h - marches in assembly (QV_MARCH_HEADER) for cores with vectors of integers
 * (ARMv8.1-M with MVE, Helium): opacity-weighted samples of 8-bit entries. See march_helium.S.
 */
#ifndef HELIUM_H
#define HELIUM_H

#define HELIUM_LANES 4u

/* Of longer rays, so many samples at a time: see helium_axis. */
#define HELIUM_SAMPLES_MAX 0x4000u

/* 1 voxel, Q16.16 */
#define HELIUM_ONE 0x10000u

/*
 * Where four samples lie on one axis, Q31.32: place * 2^16 + rest, and what takes them to the
 * next four. Place is one voxel too high, so that it is not below 0. What its steps, rounded
 * downwards, leave adds up in rest: below 2^18 every time, less than 2^31 in all. Lanes beyond
 * a ray's last sample hold what nobody takes.
 */
typedef struct {
    uint32_t place_step, rest_step;
    uint32_t stride;    /* bytes from voxel to voxel; 0 where there is but one */
    uint32_t last_cell; /* index of the last voxel but one */
    uint32_t place[HELIUM_LANES], rest[HELIUM_LANES];
} helium_axis;

/* What is prepared of a sample. Voxels are numbered as by qv_corners. */
typedef struct {
    uint32_t weight[4]; /* of voxels 2i in lower, of voxels 2i + 1 in upper halves */
    uint32_t cell;      /* voxel 0, in bytes from the volume's */
} helium_record;

/* The state of a march. */
typedef struct {
    helium_axis axis[3];
    uint32_t records_at[HELIUM_LANES]; /* addresses of records */
    uint32_t left[4], right[4];        /* addresses of voxels 2i and 2i + 1 of the first cell */
    uint32_t light[4];                 /* colour; and transmittance, front to back its complement */
    uint32_t palette;                  /* address */
    uint32_t enough;                   /* transmittance at or below which a ray ends, Q1.31 */
    uint32_t skipped;                  /* samples in cells without opacity */
    uint32_t next;                     /* address of a record, the next to be taken */
    uint32_t prepared;                 /* samples left of the four */
    uint32_t unprepared;               /* samples beyond */
    helium_record record[HELIUM_LANES];
} helium_state;

/* As march_helium.S knows it. */
typedef char helium_layout[offsetof(helium_state, records_at) == 144 &&
                                   offsetof(helium_state, left) == 144 + 16 &&
                                   offsetof(helium_state, palette) == 144 + 64 &&
                                   offsetof(helium_state, record) == 144 + 88
                               ? 1
                               : -1];

/* Take samples until none is left, light is enough, or the one before `next` needs the C form. */
void helium_march_rgba8(uint32_t *records_at);
void helium_march_back_rgba8(uint32_t *records_at);
void helium_march_indexed8(uint32_t *records_at);
void helium_march_back_indexed8(uint32_t *records_at);

FX_INLINE void helium_run(helium_state *h, unsigned storage, int back)
{
    if (qv_storage_indexed(storage) && back)
        helium_march_back_indexed8(h->records_at);
    else if (qv_storage_indexed(storage))
        helium_march_indexed8(h->records_at);
    else if (back)
        helium_march_back_rgba8(h->records_at);
    else
        helium_march_rgba8(h->records_at);
}

/* Whether a volume's entries can be read as words. */
static inline int helium_reads(const qv_volume *volume, unsigned storage)
{
    uint32_t bits = (uint32_t)(uintptr_t)volume->palette;
    if (!qv_storage_indexed(storage))
        bits = (uint32_t)(uintptr_t)volume->voxels | (uint32_t)volume->stride[0] |
               (uint32_t)volume->stride[1] | (uint32_t)volume->stride[2];
    return (bits & 3u) == 0;
}

static inline void helium_begin_axis(helium_axis *axis, qv_coord place, qv_coord advance,
                                     uint32_t size, uint32_t stride)
{
    uint64_t at = (uint64_t)place + ((uint64_t)HELIUM_ONE << 16);
    uint32_t whole = (uint32_t)((uint64_t)advance >> 16), part = (uint16_t)advance;
    for (uint32_t lane = 0; lane < HELIUM_LANES; lane++) {
        axis->place[lane] = (uint32_t)(at >> 16) + lane * whole;
        axis->rest[lane] = (uint16_t)at + lane * part;
    }
    axis->place_step = HELIUM_LANES * whole;
    axis->rest_step = HELIUM_LANES * part;
    axis->stride = size == 1 ? 0 : stride;
    axis->last_cell = size == 1 ? 0 : size - 2u;
}

static inline void helium_load(helium_state *h, const qv_light *light, int back)
{
    for (unsigned c = 0; c < 3; c++)
        h->light[c] = light->colour[c];
    h->light[3] = back ? light->transmittance : ~light->transmittance;
    h->skipped = light->skipped;
}

static inline void helium_store(qv_light *light, const helium_state *h, int back)
{
    for (unsigned c = 0; c < 3; c++)
        light->colour[c] = h->light[c];
    light->transmittance = back ? h->light[3] : ~h->light[3];
    light->skipped = h->skipped;
}

/* From where a ray stands. */
static inline void helium_begin(helium_state *h, const qv_ray *ray, const qv_context *context,
                                uint32_t samples)
{
    const qv_volume *volume = &context->scene.volume;
    for (unsigned axis = 0; axis < 3; axis++)
        helium_begin_axis(&h->axis[axis], ray->place[axis], ray->advance[axis], volume->size[axis],
                          (uint32_t)volume->stride[axis]);
    for (unsigned i = 0; i < 4; i++) {
        h->left[i] = (uint32_t)(uintptr_t)volume->voxels + (i & 1u) * h->axis[1].stride +
                     (i >> 1) * h->axis[2].stride;
        h->right[i] = h->left[i] + h->axis[0].stride;
        h->records_at[i] = (uint32_t)(uintptr_t)&h->record[i];
    }
    h->palette = (uint32_t)(uintptr_t)volume->palette;
    h->enough = (uint32_t)context->scene.termination << 15; /* Q0.16 to Q1.31 */
    h->next = h->records_at[0];
    h->prepared = 0;
    h->unprepared = samples;
}

/* Takes sample `number` from where the ray stands, in the C form. Seldom called: by itself, for
   any storage and order, so that its stack and code are none of the march's. */
__attribute__((noinline, unused)) static void
helium_take_alone(qv_light *light, qv_ray *ray, int32_t number, const qv_volume *volume, int back)
{
    uint32_t colour[3], opacity;
    qv_ray_count_from(ray, number);
    if (!qv_take(colour, &opacity, ray, volume, volume->storage, qv_take_weighted))
        light->skipped++;
    else if (back)
        qv_over(light, colour, opacity);
    else
        qv_under(light, colour, opacity);
    qv_ray_count_from(ray, -1 - number); /* it has gone on */
}

/* Takes the next of a ray's samples, until light is enough. */
FX_INLINE void helium_march(qv_light *light, qv_ray *ray, const qv_context *context,
                            unsigned storage, int back)
{
    uint32_t some = ray->samples < HELIUM_SAMPLES_MAX ? ray->samples : HELIUM_SAMPLES_MAX;
    uint32_t left = some;
    helium_state h;
    helium_begin(&h, ray, context, some);
    while (left != 0 && (back || light->transmittance > h.enough)) {
        helium_load(&h, light, back);
        helium_run(&h, storage, back);
        helium_store(light, &h, back);
        left = h.prepared + h.unprepared;
        if (left == 0)
            break;
        if (back || light->transmittance > h.enough)
            helium_take_alone(light, ray, (int32_t)(some - left), &context->scene.volume, back);
        h.prepared--;
        left--;
    }
    ray->samples -= some - left;
    light->terminated = !back && light->transmittance <= h.enough && ray->samples != 0;
    if (some == HELIUM_SAMPLES_MAX)
        qv_ray_count_from(ray, (int32_t)some);
}

FX_INLINE int qv_march_twin(qv_light *light, qv_ray *ray, const qv_context *context,
                            unsigned storage, qv_taking *mode, int back)
{
    if (mode != qv_take_weighted || qv_channel_bytes(storage) != 1 ||
        !helium_reads(&context->scene.volume, storage))
        return 0;
    qv_ray_clip(ray, context);
    if (back)
        qv_reverse(ray);
    while (ray->samples != 0 && !light->terminated)
        helium_march(light, ray, context, storage, back);
    return 1;
}

#endif /* HELIUM_H */
