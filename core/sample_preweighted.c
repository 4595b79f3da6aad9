#include "cell.h"
#include "march.h"
#include "preweighted.h"

/* Cells of one zone are clamped alike: on each axis a digit of 2 bits, 0 between the outermost
   voxel centres, 1 above them, 2 below. Place holds QV_CENTRED, as in qv_cell_locate_axis. */
#define INSIDE 0u

static unsigned zone_of(const qv_coord place[3], const qv_volume *volume)
{
    unsigned zone = INSIDE;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t index = (uint32_t)((uint64_t)place[axis] >> 32);
        zone <<= 2;
        if (index >= volume->size[axis] - 1u)
            zone += index > QV_AXIS_MAX ? 2u : 1u;
    }
    return zone;
}

/* Moves a ray on to its first sample in another zone; returns how many it leaves behind. */
static uint32_t leave_zone(qv_ray *ray, const qv_volume *volume, unsigned zone)
{
    uint32_t count = 0;
    do {
        qv_advance(ray);
        count++;
    } while (count != ray->samples && zone_of(ray->place, volume) == zone);
    return count;
}

/* The same from inside. Most samples are, and few follow: the last one inside is looked for from
   the end. */
static uint32_t leave_inside(qv_ray *ray, const qv_volume *volume)
{
    uint32_t count = ray->samples;
    for (unsigned axis = 0; axis < 3; axis++)
        ray->place[axis] += fx_multiply(ray->advance[axis], (int32_t)(count - 1u));
    for (; zone_of(ray->place, volume) != INSIDE; count--)
        for (unsigned axis = 0; axis < 3; axis++)
            ray->place[axis] -= ray->advance[axis];
    qv_advance(ray);
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

/* Finds the ray's next passage, and moves the ray on behind it. */
static void begin(qv_passage *passage, qv_ray *ray, const qv_volume *volume)
{
    qv_cell cell;
    unsigned zone = zone_of(ray->place, volume);
    qv_cell_locate(&cell, volume, ray);
    passage->base = cell.base;
    for (unsigned axis = 0; axis < 3; axis++) {
        passage->place[axis] = (uint32_t)ray->place[axis];
        passage->next[axis] = cell.next[axis];
    }
    passage->samples = zone == INSIDE ? leave_inside(ray, volume) : leave_zone(ray, volume, zone);
    passage->step = step_of(passage, ray);
    ray->samples -= passage->samples;
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
    qv_ray_clip(ray, context);
    set_out(&passage, ray, context->scene.termination);
    while (ray->samples != 0 && passage.transmittance > passage.enough) {
        begin(&passage, ray, &context->scene.volume);
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
    qv_reverse(ray);
    set_out(&passage, ray, 0);
    while (ray->samples != 0) {
        begin(&passage, ray, &context->scene.volume);
        qv_passage_over(&passage);
    }
    arrive(light, &passage);
}

QV_DESCRIPTOR qv_sampling qv_preweighted_associated8 = {
    qv_prepare_steps, march, QV_READ_OUT_ASSOCIATED, QV_STORAGE_ASSOCIATED8, 0};
QV_DESCRIPTOR qv_sampling qv_preweighted_associated8_back_to_front = {
    qv_prepare_steps, march_back, QV_READ_OUT_ASSOCIATED, QV_STORAGE_ASSOCIATED8, 0};
