#include "cell.h"
#include "march.h"
#include "preweighted.h"

/*
 * Cells of one zone are clamped alike: on each axis their indices are those between the outermost
 * voxel centres, or the one above them, or the one below, -1. Zones are convex: where two samples
 * of a ray are in one, so are those between them.
 */
typedef struct zone {
    uint32_t first[3], count[3];
    int inside; /* on all axes between the outermost centres */
} zone;

/* Of a place, of which QV_CENTRED is part. */
static uint32_t index_of(qv_coord place)
{
    return (uint32_t)((uint64_t)place >> 32);
}

static void find_zone(zone *here, const qv_ray *ray, const qv_volume *volume)
{
    here->inside = 1;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t index = index_of(ray->place[axis]), last = volume->size[axis] - 1u;
        here->inside &= index < last;
        here->first[axis] = index < last ? 0 : index;
        here->count[axis] = index < last ? last : 1;
    }
}

static int is_in(const qv_coord place[3], const zone *of)
{
    return index_of(place[0]) - of->first[0] < of->count[0] &&
           index_of(place[1]) - of->first[1] < of->count[1] &&
           index_of(place[2]) - of->first[2] < of->count[2];
}

static void move(qv_coord place[3], const qv_coord by[3])
{
    place[0] += by[0];
    place[1] += by[1];
    place[2] += by[2];
}

/* Moves a ray on to its first sample in another zone; returns how many it leaves behind. */
static uint32_t leave_zone(qv_ray *ray, const zone *here)
{
    uint32_t count = 0;
    do {
        move(ray->place, ray->advance);
        count++;
    } while (is_in(ray->place, here));
    return count;
}

/* The same from inside. Most samples are, and few follow: the last one inside is looked for from
   the end. */
static uint32_t leave_inside(qv_ray *ray, const qv_coord end[3], const zone *here)
{
    const qv_coord back[3] = {-ray->advance[0], -ray->advance[1], -ray->advance[2]};
    uint32_t count = ray->samples;
    memcpy(ray->place, end, sizeof ray->place);
    for (; !is_in(ray->place, here); count--)
        move(ray->place, back);
    move(ray->place, ray->advance);
    return count;
}

/* Bytes from sample to sample of a passage, without the carries of fractions. It fits where
   there are two of them, as on each axis they are so many voxels apart, or one more. */
static qv_offset step_of(const qv_passage *passage, const qv_ray *ray)
{
    qv_offset step = 0;
    if (passage->samples == 1)
        return step;
    for (unsigned axis = 0; axis < 3; axis++)
        step += (qv_offset)fx_shift_floor(ray->advance[axis], 32) * passage->next[axis];
    return step;
}

/* Finds the ray's next passage, and moves the ray on behind it. Its last sample is at `end`. */
static void begin(qv_passage *passage, qv_ray *ray, const qv_coord end[3], const qv_volume *volume)
{
    qv_cell cell;
    zone here;
    find_zone(&here, ray, volume);
    qv_cell_locate(&cell, volume, ray);
    passage->base = cell.base;
    for (unsigned axis = 0; axis < 3; axis++) {
        passage->place[axis] = (uint32_t)ray->place[axis];
        passage->next[axis] = cell.next[axis];
    }
    if (is_in(end, &here))
        passage->samples = ray->samples;
    else if (here.inside)
        passage->samples = leave_inside(ray, end, &here);
    else
        passage->samples = leave_zone(ray, &here);
    passage->step = step_of(passage, ray);
    ray->samples -= passage->samples;
}

/* Where a ray's last sample lies; for a ray that has none, anywhere. */
static void find_end(qv_coord end[3], const qv_ray *ray)
{
    int32_t last = (int32_t)(ray->samples - 1u);
    for (unsigned axis = 0; axis < 3; axis++)
        end[axis] = ray->place[axis] + fx_multiply(ray->advance[axis], last);
}

/* Sets out along a ray that has been clipped. */
static void set_out(qv_passage *passage, const qv_ray *ray, uint16_t termination)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        passage->advance[axis] = (uint32_t)ray->advance[axis];
        passage->light[axis] = 0;
    }
    passage->transmittance = QV_UNDIMMED;
    passage->enough = QV_NOTHING + (QV_WHOLE >> 16) * termination; /* <= QV_WHOLE + 256 */
    passage->skipped = 0;
}

/* transmittance * 2^31 / QV_WHOLE, to nearest: the factor is 2^39 / 255. */
#define Q31_OF_WHOLE 0x80808081u

static void arrive(qv_light *light, const qv_passage *passage)
{
    uint32_t rest = passage->transmittance;
    for (unsigned c = 0; c < 3; c++)
        light->colour[c] = (passage->light[c] >> 1) + (passage->light[c] & 1u);
    light->transmittance =
        rest <= QV_NOTHING ? 0u : fx_high_product(rest - QV_NOTHING, Q31_OF_WHOLE);
    light->skipped = passage->skipped;
}

static void march(qv_light *light, qv_ray *ray, const qv_context *context)
{
    qv_passage passage;
    qv_coord end[3];
    qv_ray_clip(ray, context);
    find_end(end, ray);
    set_out(&passage, ray, context->scene.termination);
    while (ray->samples != 0 && passage.transmittance > passage.enough) {
        begin(&passage, ray, end, &context->scene.volume);
        qv_passage_under(&passage);
        ray->samples += passage.samples;
    }
    light->terminated = ray->samples != 0;
    arrive(light, &passage);
}

static void march_back(qv_light *light, qv_ray *ray, const qv_context *context)
{
    qv_passage passage;
    qv_ray_clip(ray, context);
    const qv_coord end[3] = {ray->place[0], ray->place[1], ray->place[2]};
    qv_reverse(ray);
    set_out(&passage, ray, 0);
    while (ray->samples != 0) {
        begin(&passage, ray, end, &context->scene.volume);
        qv_passage_over(&passage);
    }
    arrive(light, &passage);
}

QV_DESCRIPTOR qv_sampling qv_preweighted_associated8 = {
    qv_prepare_steps, march, QV_READ_OUT_ASSOCIATED, QV_STORAGE_ASSOCIATED8, 0};
QV_DESCRIPTOR qv_sampling qv_preweighted_associated8_back_to_front = {
    qv_prepare_steps, march_back, QV_READ_OUT_ASSOCIATED, QV_STORAGE_ASSOCIATED8, 0};
