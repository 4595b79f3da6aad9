/*
 * direction_text.h - directions as text: +x, -y+z, +x+y-z.
 */
#ifndef QVOL_HOST_DIRECTION_TEXT_H
#define QVOL_HOST_DIRECTION_TEXT_H

#include <stdbool.h>
#include <stdint.h>

#define DIRECTION_BYTES 8

/* 0 .. QV_DIRECTIONS - 1. */
void direction_name(char text[DIRECTION_BYTES], unsigned direction);

/* all, faces, or directions between commas; false if it is none of these. */
bool read_directions(uint32_t *set, const char *text);

#endif
