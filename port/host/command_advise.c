/*
 * command_advise.c - the cheapest configuration for a device that is as exact as is wanted.
 */
#include "commands.h"
#include "configuration.h"
#include "error.h"
#include "json.h"
#include "settings_advise.h"
#include "settings_slices.h"
#include "voxel_storage.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SLICES_DEFAULT 1000
#define NAME_BYTES     64
#define OPTION_BYTES   192

/* 1 as a Q0.32. */
#define OPAQUE UINT32_MAX

static const char *target_name(const struct settings *settings)
{
    return choice_name(configuration_targets, settings->advise.target);
}

/* ---- Rays ------------------------------------------------------------------------ */

static void sampling_name(char name[NAME_BYTES], const struct ray_configuration *of)
{
    snprintf(name, NAME_BYTES, "qv_%s_%s", of->of->mode, of->of->storage);
}

/* The options of qvol render that draw so. Corrected samples are what weighted ones become where
   opacities hold for a length. */
static void render_options(char options[OPTION_BYTES], const struct ray_configuration *of)
{
    qv_storage storage = (qv_storage)of->of->sampling->storage;
    bool indexed = storage_is_indexed(storage);
    char mode[NAME_BYTES];
    snprintf(mode, sizeof mode, "%s",
             strcmp(of->of->mode, "corrected") == 0 ? "weighted" : of->of->mode);
    for (char *c = mode; *c != '\0'; c++) {
        *c = *c == '_' ? '-' : *c;
    }
    snprintf(options, OPTION_BYTES, "--sampling %s --storage %s%s%s%s --step %g", mode,
             storage_name(storage),
             indexed && storage_channel_bytes(storage) == 2 ? " --palette-bits 16" : "",
             indexed && storage_holds_extinction(storage) ? " --extinction auto" : "",
             ray_by_length(of) ? " --unit-distance 1" : "", of->step);
}

static void print_ray(const struct ray_configuration *of, unsigned others,
                      const struct settings *settings)
{
    const char *unit = configuration_unit(settings->advise.target);
    char name[NAME_BYTES], options[OPTION_BYTES];
    sampling_name(name, of);
    render_options(options, of);
    printf("sampling  %s, a step of %g voxels; opacities hold for a %s\n", name, of->step,
           ray_by_length(of) ? "voxel" : "step");
    printf("error     at most %.2f of 255, RMS %.2f, from %s\n", of->worst, of->rms,
           settings->advise.samples ? "the same samples in double precision" : "the medium");
    printf("memory    %u byte%s a voxel\n", of->voxel_bytes, of->voxel_bytes == 1 ? "" : "s");
    printf("cost      %u %s a sample, %.0f a voxel of a ray, on %s\n", of->sample, unit, of->length,
           target_name(settings));
    printf("options   %s\n", options);
    printf("others    %u more reach it: --json lists them\n", others);
}

/* Errors in 1/100 of a level, as where slices are recommended. */
static void report_ray(struct json *json, const struct ray_configuration *of)
{
    char name[NAME_BYTES], options[OPTION_BYTES];
    sampling_name(name, of);
    render_options(options, of);
    json_object(json, NULL);
    json_text(json, "sampling", name);
    json_text(json, "options", options);
    json_decimal(json, "step", of->step);
    json_boolean(json, "by_length", ray_by_length(of));
    json_unsigned(json, "voxel_bytes", of->voxel_bytes);
    json_unsigned(json, "cost_of_sample", of->sample);
    json_decimal(json, "cost_of_voxel", of->length);
    json_integer(json, "worst_x100", lround(100 * of->worst));
    json_integer(json, "rms_x100", lround(100 * of->rms));
    json_close(json);
}

static void refuse_rays(const struct ray_wish *wish, const struct settings *settings)
    __attribute__((noreturn));
static void refuse_rays(const struct ray_wish *wish, const struct settings *settings)
{
    struct ray_configuration best;
    char name[NAME_BYTES];
    rays_best(&best, wish);
    bool worst = wish->worst > 0 && best.worst > wish->worst;
    sampling_name(name, &best);
    data_error(target_name(settings), worst ? "--error" : "--rms",
               "no configuration reaches all that is wanted; the best, %s with a step of %g, is "
               "off by at most %.2f, RMS %.2f",
               name, best.step, best.worst, best.rms);
}

/* ---- Frame buffers ----------------------------------------------------------------- */

static const char *advice_name(const struct buffer_configuration *of)
{
    switch (of->of->advice) {
    case QV_ADVICE_DITHER:
        return "rounding";
    case QV_ADVICE_RESIDUAL:
        return "feedback";
    default:
        return "none";
    }
}

static void print_buffer(const struct buffer_configuration *of, unsigned others,
                         const struct settings *settings)
{
    printf("blend     qv_%s, %u bits a channel and %u beside\n", of->of->name, of->of->bits,
           of->of->residual);
    printf("dither    %s\n", advice_name(of));
    printf("error     at most %.2f of 255, in a constant fog %.2f\n", of->worst, of->worst_fog);
    printf("memory    %u bytes a pixel and %u beside\n", of->of->bytes, of->of->beside);
    printf("cost      %u %s a pixel of a slice, on %s\n", of->pixel,
           configuration_unit(settings->advise.target), target_name(settings));
    printf("others    %u more reach it: --json lists them\n", others);
}

static void report_buffer(struct json *json, const struct buffer_configuration *of)
{
    char name[NAME_BYTES];
    snprintf(name, sizeof name, "qv_%s", of->of->name);
    json_object(json, NULL);
    json_text(json, "blend", name);
    json_text(json, "dither", advice_name(of));
    json_unsigned(json, "bits", of->of->bits);
    json_unsigned(json, "residual", of->of->residual);
    json_unsigned(json, "pixel_bytes", of->of->bytes);
    json_unsigned(json, "bytes_beside", of->of->beside);
    json_unsigned(json, "cost_of_pixel", of->pixel);
    json_integer(json, "worst_x100", lround(100 * of->worst));
    json_integer(json, "worst_of_fog_x100", lround(100 * of->worst_fog));
    json_close(json);
}

static void refuse_buffers(const struct buffer_wish *wish, const struct settings *settings)
    __attribute__((noreturn));
static void refuse_buffers(const struct buffer_wish *wish, const struct settings *settings)
{
    struct buffer_configuration best;
    buffers_best(&best, wish);
    data_error(target_name(settings), "--error",
               "no frame buffer of these reaches it; the best, qv_%s, is off by at most %.2f, in a "
               "constant fog by %.2f",
               best.of->name, best.worst, best.worst_fog);
}

static struct buffer_wish buffer_wish_of(const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    const struct advise_settings *a = &settings->advise;
    double opacity = a->opacity * OPAQUE; /* at most 2^32 - 1 */
    return (struct buffer_wish){
        .target = a->target,
        .worst = a->error,
        .fog = a->fog,
        .bits = s->framebuffer == FRAMEBUFFER_565 ? 5 : (unsigned)s->framebuffer,
        .residual = s->residual != 0 ? (int)s->residual : -1,
        .slices = (uint16_t)(s->count != 0 ? s->count : SLICES_DEFAULT),
        .opacity = opacity >= 1 ? (uint32_t)opacity : 1,
    };
}

/* ---- Both -------------------------------------------------------------------------- */

static void report_begin(struct json *json, output *out, const struct settings *settings)
{
    const struct advise_settings *a = &settings->advise;
    output_open(out, settings->json);
    json_begin(json, out);
    json_text(json, "target", target_name(settings));
    json_text(json, "unit", configuration_unit(a->target));
    json_array(json, "configurations");
}

static void report_end(struct json *json, output *out)
{
    json_close(json);
    json_end(json);
    output_commit(out);
}

static void advise_rays(const struct settings *settings)
{
    const struct advise_settings *a = &settings->advise;
    const struct ray_wish wish = {a->target, a->error, a->rms, a->samples, a->voxel_bytes};
    struct ray_configuration found[CONFIGURATION_MOST];
    unsigned count = rays_within(found, &wish);
    if (count == 0) {
        refuse_rays(&wish, settings);
    }
    if (settings->json != NULL) {
        struct json json;
        output out;
        report_begin(&json, &out, settings);
        for (unsigned i = 0; i < count; i++) {
            report_ray(&json, &found[i]);
        }
        report_end(&json, &out);
    } else if (!settings->quiet) {
        print_ray(&found[0], count - 1, settings);
    }
}

static void advise_buffers(const struct settings *settings)
{
    const struct buffer_wish wish = buffer_wish_of(settings);
    struct buffer_configuration found[CONFIGURATION_MOST];
    unsigned count = buffers_within(found, &wish);
    if (count == 0) {
        refuse_buffers(&wish, settings);
    }
    if (settings->json != NULL) {
        struct json json;
        output out;
        report_begin(&json, &out, settings);
        for (unsigned i = 0; i < count; i++) {
            report_buffer(&json, &found[i]);
        }
        report_end(&json, &out);
    } else if (!settings->quiet) {
        print_buffer(&found[0], count - 1, settings);
    }
}

int command_advise(const struct settings *settings)
{
    if (settings_advise_buffer(settings)) {
        advise_buffers(settings);
    } else {
        advise_rays(settings);
    }
    if (fflush(stdout) != 0) {
        system_error("standard output", NULL);
    }
    return EXIT_SUCCESS;
}
