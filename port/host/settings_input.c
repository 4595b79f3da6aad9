/*
 * settings_input.c - the options of files that are read: raw data and palettes.
 */
#include "settings_input.h"
#include "error.h"

static const choice endian_names[] = {{"little", 0}, {"big", 1}, {NULL, 0}};

void settings_keep_name(const char **name, const char *option, const char *value)
{
    if (value[0] == '\0') {
        usage_error(option, "the name is empty");
    }
    *name = value;
}

void set_dims(struct settings *settings, const char *option, const char *value)
{
    if (!read_sizes(value, 3, QV_AXIS_MAX, settings->raw.size)) {
        usage_error(option, "'%s' is not XxYxZ, each 1 to %d", value, QV_AXIS_MAX);
    }
}

void set_type(struct settings *settings, const char *option, const char *value)
{
    settings->raw.type = choose(option, value, raw_type_names);
}

void set_skip(struct settings *settings, const char *option, const char *value)
{
    settings->raw.skip = integer_between(option, value, 0, INT64_MAX / 2);
}

void set_spacing(struct settings *settings, const char *option, const char *value)
{
    double *spacing = settings->raw.spacing;
    if (!read_decimals(value, 'x', 3, spacing) || spacing[0] <= 0 || spacing[1] <= 0 ||
        spacing[2] <= 0) {
        usage_error(option, "'%s' is not XxYxZ, each above 0", value);
    }
}

void set_palette(struct settings *settings, const char *option, const char *value)
{
    settings_keep_name(&settings->palette, option, value);
}

void set_endian(struct settings *settings, const char *option, const char *value)
{
    settings->big_endian = choose(option, value, endian_names) != 0;
    settings->endian_given = true;
}
