/*
 * configuration.c - which configurations reach what is wanted, the cheapest first.
 */
#include "configuration.h"
#include "voxel_storage.h"

#include "advise_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MODES  (sizeof table_modes / sizeof table_modes[0])
#define BLENDS (sizeof table_blends / sizeof table_blends[0])

/* Errors are kept in 1/100 of a level. */
#define LEVEL 100.0

const char *configuration_unit(int target)
{
    return strcmp(choice_name(configuration_targets, target), "avr") == 0 ? "cycles"
                                                                          : "instructions";
}

/* Negative, 0 or positive, as qsort wants it. */
static int order(double a, double b)
{
    return (a > b) - (a < b);
}

/* ---- Rays ------------------------------------------------------------------------ */

bool ray_by_length(const struct ray_configuration *of)
{
    return of->of->sampling->by_length != 0;
}

static struct ray_configuration ray_of(const struct mode_figures *mode, unsigned step,
                                       const struct ray_wish *wish)
{
    const struct error_figures *errors =
        wish->samples ? &mode->errors[step].samples : &mode->errors[step].medium;
    uint32_t cost = mode->cost[wish->target - 1];
    return (struct ray_configuration){
        .of = mode,
        .voxel_bytes = storage_voxel_bytes((qv_storage)mode->sampling->storage),
        .step = table_steps[step],
        .worst = errors->worst / LEVEL,
        .rms = errors->rms / LEVEL,
        .sample = cost,
        .length = cost / table_steps[step],
    };
}

/* Where samples are given, so is their step: one stands for all. */
static bool is_possible(const struct ray_configuration *of, const struct ray_wish *wish)
{
    return (!wish->samples || of->step == 1) &&
           (wish->voxel_bytes == 0 || of->voxel_bytes <= wish->voxel_bytes);
}

static bool is_within(const struct ray_configuration *of, const struct ray_wish *wish)
{
    return (wish->worst <= 0 || of->worst <= wish->worst) &&
           (wish->rms <= 0 || of->rms <= wish->rms);
}

/* Of two that cost the same, the one of fewer bytes, then the more exact. */
static int compare_rays(const void *a, const void *b)
{
    const struct ray_configuration *first = a, *second = b;
    int by = order(first->length, second->length);
    by = by != 0 ? by : order(first->voxel_bytes, second->voxel_bytes);
    return by != 0 ? by : order(first->worst, second->worst);
}

unsigned rays_within(struct ray_configuration found[CONFIGURATION_MOST],
                     const struct ray_wish *wish)
{
    unsigned count = 0;
    for (unsigned mode = 0; mode < MODES; mode++) {
        for (unsigned step = 0; step < CONFIGURATION_STEPS; step++) {
            struct ray_configuration of = ray_of(&table_modes[mode], step, wish);
            if (is_possible(&of, wish) && is_within(&of, wish)) {
                found[count++] = of;
            }
        }
    }
    qsort(found, count, sizeof *found, compare_rays);
    return count;
}

/* There is always one: an index takes one byte. */
void rays_best(struct ray_configuration *best, const struct ray_wish *wish)
{
    struct ray_configuration all[CONFIGURATION_MOST];
    struct ray_wish any = *wish;
    any.worst = any.rms = 0;
    unsigned count = rays_within(all, &any);
    *best = all[0];
    for (unsigned i = 1; i < count; i++) {
        bool better = wish->worst > 0 ? all[i].worst < best->worst : all[i].rms < best->rms;
        if (better) {
            *best = all[i];
        }
    }
}

/* ---- Frame buffers ----------------------------------------------------------------- */

static bool is_wanted(const struct blend_figures *blend, const struct buffer_wish *wish)
{
    return (wish->bits == 0 || blend->bits == wish->bits) &&
           (wish->residual < 0 || blend->residual == wish->residual);
}

/* At most what so many blends are off, levels of 255. Each rounds by less than 1 of the state's last
   unit, by dither; a plain one by 1/2, its colour and its opacity by 1/2 each, too. It multiplies
   what is off before by 1 at most. Beside them what lies behind is rounded where it has fewer than
   8 bits, and where it has more, the level that is read. */
static double most_of_slices(const struct blend_figures *blend, unsigned slices)
{
    const unsigned whole = blend->bits < 8 ? blend->bits : 8;
    const unsigned fraction = blend->residual + (blend->bits - whole);
    const double unit = 255.0 / (double)((1UL << whole) - 1) / (double)(1UL << fraction);
    const double each = blend->advice == QV_ADVICE_PLAIN ? 1.5 : 1;
    const double beside = (whole < 8 ? unit / 2 : 0) + (fraction > 0 ? 0.5 : 0);
    return ceil(LEVEL * (slices * each * unit + beside)) / LEVEL;
}

/* Whether the library would take this blend for its bits. Its table begins at 64 slices. */
static bool is_recommended(struct buffer_configuration *made, const struct blend_figures *blend,
                           const struct buffer_wish *wish)
{
    qv_recommendation recommendation;
    qv_status status =
        qv_recommend(&recommendation, blend->bits, blend->residual, wish->slices, wish->opacity);
    if (status != QV_OK || recommendation.advice != blend->advice) {
        return false;
    }
    const double most = most_of_slices(blend, wish->slices);
    *made = (struct buffer_configuration){blend, fmin(recommendation.worst / LEVEL, most),
                                          fmin(recommendation.worst_fog / LEVEL, most),
                                          blend->cost[wish->target - 1]};
    return true;
}

static double error_of(const struct buffer_configuration *of, const struct buffer_wish *wish)
{
    return wish->fog ? of->worst_fog : of->worst;
}

static int compare_buffers(const void *a, const void *b)
{
    const struct buffer_configuration *first = a, *second = b;
    int by = order(first->pixel, second->pixel);
    return by != 0 ? by : order(first->worst, second->worst);
}

unsigned buffers_within(struct buffer_configuration found[CONFIGURATION_MOST],
                        const struct buffer_wish *wish)
{
    unsigned count = 0;
    for (unsigned blend = 0; blend < BLENDS; blend++) {
        struct buffer_configuration of;
        if (is_wanted(&table_blends[blend], wish) &&
            is_recommended(&of, &table_blends[blend], wish) &&
            (wish->worst <= 0 || error_of(&of, wish) <= wish->worst)) {
            found[count++] = of;
        }
    }
    qsort(found, count, sizeof *found, compare_buffers);
    return count;
}

/* There is always one: all bits have a blend for what is recommended. */
void buffers_best(struct buffer_configuration *best, const struct buffer_wish *wish)
{
    struct buffer_configuration all[CONFIGURATION_MOST];
    struct buffer_wish any = *wish;
    any.worst = 0;
    unsigned count = buffers_within(all, &any);
    *best = all[0];
    for (unsigned i = 1; i < count; i++) {
        if (error_of(&all[i], wish) < error_of(best, wish)) {
            *best = all[i];
        }
    }
}
