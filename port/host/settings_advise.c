/*
 * settings_advise.c - the options of qvol advise.
 */
#include "settings_advise.h"
#include "configuration.h"
#include "error.h"
#include "settings_slices.h"

#include <stddef.h>

/* The table's errors are in 1/100 of a level. */
#define ERROR_LEAST 0.01
#define ERROR_MOST  255

#define VOXEL_BYTES_MOST 8
#define SLICES_MOST      4096 /* of qv_recommend */

/* The least that a slice has in Q0.32. */
#define OPACITY_LEAST (1.0 / UINT32_MAX)

static const choice against_names[] = {{"medium", 0}, {"samples", 1}, {NULL, 0}};
static const choice content_names[] = {{"any", 0}, {"fog", 1}, {NULL, 0}};

void set_target(struct settings *settings, const char *option, const char *value)
{
    settings->advise.target = choose(option, value, configuration_targets);
}

void set_error(struct settings *settings, const char *option, const char *value)
{
    settings->advise.error = decimal_between(option, value, ERROR_LEAST, ERROR_MOST);
}

void set_rms(struct settings *settings, const char *option, const char *value)
{
    settings->advise.rms = decimal_between(option, value, ERROR_LEAST, ERROR_MOST);
}

void set_against(struct settings *settings, const char *option, const char *value)
{
    settings->advise.samples = choose(option, value, against_names) != 0;
    settings->advise.against_given = true;
}

void set_voxel_bytes(struct settings *settings, const char *option, const char *value)
{
    settings->advise.voxel_bytes = (unsigned)integer_between(option, value, 1, VOXEL_BYTES_MOST);
}

void set_opacity(struct settings *settings, const char *option, const char *value)
{
    settings->advise.opacity = decimal_between(option, value, OPACITY_LEAST, 1);
}

void set_content(struct settings *settings, const char *option, const char *value)
{
    settings->advise.fog = choose(option, value, content_names) != 0;
    settings->advise.content_given = true;
}

bool settings_advise_buffer(const struct settings *settings)
{
    const struct advise_settings *a = &settings->advise;
    const struct slice_settings *s = &settings->slices;
    return s->count != 0 || s->framebuffer != 0 || s->residual != 0 || a->opacity > 0 ||
           a->content_given;
}

void settings_check_advise(const struct settings *settings)
{
    const struct advise_settings *a = &settings->advise;
    const struct slice_settings *s = &settings->slices;
    const char *rays = "advice on rays: none of the options of frame buffers";
    bool buffer = settings_advise_buffer(settings);
    const struct option_need needs[] = {
        {"--target", true, a->target != 0, "a device"},
        {"--error", a->error <= 0, a->rms > 0, "a number of levels, or --rms"},
        {"--error", a->error <= 0 && buffer, false, "a number of levels"},
        {"--rms", a->rms > 0, !buffer, rays},
        {"--against", a->against_given, !buffer, rays},
        {"--voxel-bytes", a->voxel_bytes != 0, !buffer, rays},
        {"--slices", s->count > SLICES_MOST, false, "at most 4096 slices"},
        {"--residual", s->residual != 0, s->framebuffer == 0 || s->framebuffer == 8,
         "--framebuffer 8"},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
}
