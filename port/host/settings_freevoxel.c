/*
 * settings_freevoxel.c - the options of FreeVoxels.
 */
#include "settings_freevoxel.h"
#include "direction_text.h"
#include "error.h"
#include "freevoxel_file.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COARSER_MOST (FREEVOXEL_LEVELS - 1)
#define PARTS_MOST   UINT32_MAX
/* Of qv_splat_scene.detail, Q8.8. */
#define DETAIL_ONE     256
#define DETAIL_LEAST   (1.0 / DETAIL_ONE)
#define DETAIL_MOST    (65535.0 / DETAIL_ONE)
#define DETAIL_DEFAULT 1
/* As for the camera: a full turn many times over. */
#define DEGREES_MOST 1e6

const choice voxel_order_names[] = {
    {"linear", FREEVOXEL_LINEAR},
    {"morton", FREEVOXEL_MORTON},
    {"hilbert", FREEVOXEL_HILBERT},
    {NULL, 0},
};

/* A file without levels has none, which is not to be asked for by this name. */
const choice hierarchy_names[] = {
    {"geometric", FREEVOXEL_GEOMETRIC},
    {"rebuilt", FREEVOXEL_REBUILT},
    {NULL, 0},
};

const choice splatting_names[] = {{"added", SPLATTING_ADDED}, {"over", SPLATTING_OVER}, {NULL, 0}};
const choice interpolation_names[] = {
    {"light", QV_BETWEEN_LIGHT}, {"nearest", QV_NEAREST}, {"depths", QV_BETWEEN_DEPTHS}, {NULL, 0}};

const choice kernel_names[] = {
    {"linear", KERNEL_LINEAR}, {"quadratic", KERNEL_QUADRATIC}, {NULL, 0}};

/* ---- Making a file ------------------------------------------------------------ */

void set_directions(struct settings *settings, const char *option, const char *value)
{
    if (!read_directions(&settings->freevoxel.directions, value)) {
        usage_error(option, "'%s' is not all, faces or a list like +x,-y+z,+x+y-z", value);
    }
}

void set_voxel_order(struct settings *settings, const char *option, const char *value)
{
    settings->freevoxel.order = choose(option, value, voxel_order_names);
}

void set_level_count(struct settings *settings, const char *option, const char *value)
{
    settings->freevoxel.levels = (unsigned)integer_between(option, value, 0, COARSER_MOST);
    settings->freevoxel.levels_given = true;
}

void set_hierarchy(struct settings *settings, const char *option, const char *value)
{
    settings->freevoxel.hierarchy = choose(option, value, hierarchy_names);
    settings->freevoxel.hierarchy_given = true;
}

void set_uncorrected(struct settings *settings, const char *option, const char *value)
{
    (void)option;
    (void)value;
    settings->freevoxel.uncorrected = true;
}

bool settings_make_levels(const struct settings *settings, int groups)
{
    const struct freevoxel_settings *f = &settings->freevoxel;
    return (groups & GROUP_FREEVOXEL) != 0 && (!f->levels_given || f->levels != 0);
}

/* ---- Drawing it --------------------------------------------------------------- */

void set_splatting(struct settings *settings, const char *option, const char *value)
{
    settings->splat.splatting = choose(option, value, splatting_names);
}

void set_kernel(struct settings *settings, const char *option, const char *value)
{
    settings->splat.kernel = choose(option, value, kernel_names);
}

void set_interpolation(struct settings *settings, const char *option, const char *value)
{
    settings->splat.interpolation = choose(option, value, interpolation_names);
}

void set_finest_level(struct settings *settings, const char *option, const char *value)
{
    settings->splat.level = (unsigned)integer_between(option, value, 0, COARSER_MOST);
}

void set_coarser_levels(struct settings *settings, const char *option, const char *value)
{
    (void)option;
    (void)value;
    settings->splat.levels = true;
}

void set_detail(struct settings *settings, const char *option, const char *value)
{
    settings->splat.detail = decimal_between(option, value, DETAIL_LEAST, DETAIL_MOST);
    settings->splat.detail_given = true;
}

uint16_t settings_detail(const struct settings *settings)
{
    double detail = settings->splat.detail_given ? settings->splat.detail : DETAIL_DEFAULT;
    return (uint16_t)lround(detail * DETAIL_ONE);
}

/* K/N, as many are told to draw one part each. */
void set_part(struct settings *settings, const char *option, const char *value)
{
    const char *slash = strchr(value, '/');
    char part[DECIMAL_BYTES] = "";
    uint64_t k, n;
    if (slash != NULL && slash - value < DECIMAL_BYTES) {
        snprintf(part, sizeof part, "%.*s", (int)(slash - value), value);
    }
    if (slash == NULL || !read_unsigned(slash + 1, PARTS_MOST, &n) || !read_unsigned(part, n, &k) ||
        k == 0) {
        usage_error(option, "'%s' is not K/N with K from 1 to N", value);
    }
    settings->splat.part = (uint32_t)k;
    settings->splat.parts = (uint32_t)n;
}

/* ---- Light -------------------------------------------------------------------- */

/* Angles, and behind the second comma the colour. */
static bool read_lamp(struct lamp_settings *lamp, const char *value)
{
    const char *comma = strrchr(value, ',');
    char angles[2 * DECIMAL_BYTES];
    if (comma == NULL || (size_t)(comma - value) >= sizeof angles) {
        return false;
    }
    snprintf(angles, sizeof angles, "%.*s", (int)(comma - value), value);
    return read_decimals(angles, ',', 2, lamp->angles) && read_colour(comma + 1, lamp->colour) &&
           fabs(lamp->angles[0]) <= DEGREES_MOST && fabs(lamp->angles[1]) <= DEGREES_MOST;
}

void set_lamp(struct settings *settings, const char *option, const char *value)
{
    struct lighting_settings *lighting = &settings->lighting;
    if (lighting->count == QV_LAMPS_MAX) {
        usage_error(option, "more than %u", QV_LAMPS_MAX);
    }
    if (!read_lamp(&lighting->lamps[lighting->count], value)) {
        usage_error(option, "'%s' is not AZ,EL,RRGGBB: degrees and a colour", value);
    }
    lighting->count++;
}

void set_ambient(struct settings *settings, const char *option, const char *value)
{
    if (!read_colour(value, settings->lighting.ambient)) {
        usage_error(option, "'%s' is not RRGGBB", value);
    }
    settings->lighting.ambient_given = true;
}

/* ---- Together ----------------------------------------------------------------- */

static void check_making(const struct settings *settings)
{
    const struct freevoxel_settings *f = &settings->freevoxel;
    const struct option_need needs[] = {
        {"--hierarchy", f->hierarchy_given, !f->levels_given || f->levels != 0, "--levels above 0"},
        {"--uncorrected", f->uncorrected, settings->unit_distance <= 0,
         "opacities without --unit-distance: they hold for a step"},
        {"--hierarchy", f->hierarchy == FREEVOXEL_REBUILT, !f->uncorrected,
         "lengths to rebuild levels by, which --uncorrected takes away"},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
}

void settings_check_freevoxel(const struct settings *settings, int groups)
{
    const struct splat_settings *s = &settings->splat;
    const struct lighting_settings *l = &settings->lighting;
    const struct option_need needs[] = {
        {"--light", l->count != 0, (groups & GROUP_LIGHTING) != 0,
         "qvol render or qvol splat; that of --shade is RIGHT,UP"},
        {"--ambient", l->ambient_given, l->count != 0, "--light AZ,EL,RRGGBB"},
        {"--detail", s->detail_given, s->levels, "--levels"},
        {"--levels", s->levels, s->splatting != SPLATTING_OVER,
         "--splatting added: one level is drawn back to front"},
        {"--part", s->parts != 0, s->splatting != SPLATTING_OVER,
         "--splatting added: what is drawn back to front depends on all"},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
    check_making(settings);
}
