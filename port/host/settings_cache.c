/*
 * settings_cache.c - how many pages there are, and how many voxels each holds.
 */
#include "settings_cache.h"
#include "error.h"

void set_cache(struct settings *settings, const char *option, const char *value)
{
    settings->cache.pages = (uint32_t)integer_between(option, value, 1, UINT16_MAX);
}

static bool is_power_of_2(uint32_t width)
{
    return (width & (width - 1)) == 0;
}

void set_page(struct settings *settings, const char *option, const char *value)
{
    uint32_t *page = settings->cache.page;
    settings->cache.page_given = true;
    if (!read_sizes(value, 3, QV_AXIS_MAX, page) || !is_power_of_2(page[0]) ||
        !is_power_of_2(page[1]) || !is_power_of_2(page[2])) {
        usage_error(option, "'%s' is not XxYxZ, each a power of 2 from 1 to %d", value,
                    QV_AXIS_MAX);
    }
}
