/*
 * display.h - what port/display/zephyr.c needs of Zephyr, with its names and types.
 */
#ifndef ZEPHYR_DISPLAY_H
#define ZEPHYR_DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

struct device;

struct display_buffer_descriptor {
    uint32_t buf_size;
    uint16_t width;
    uint16_t height;
    uint16_t pitch;
    bool frame_incomplete;
};

int display_write(const struct device *dev, const uint16_t x, const uint16_t y,
                  const struct display_buffer_descriptor *desc, const void *buf);

#endif /* ZEPHYR_DISPLAY_H */
