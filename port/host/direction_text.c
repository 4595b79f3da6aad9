/*
 * direction_text.c - directions as text.
 */
#include "direction_text.h"
#include "qvol.h"

#include <string.h>

static const char axis_names[] = "xyz";

void direction_name(char text[DIRECTION_BYTES], unsigned direction)
{
    unsigned place = direction < 13 ? direction : direction + 1; /* without the middle */
    unsigned steps[3] = {place % 3, place / 3 % 3, place / 9};
    for (unsigned a = 0; a < 3; a++) {
        if (steps[a] != 1) {
            *text++ = steps[a] == 2 ? '+' : '-';
            *text++ = axis_names[a];
        }
    }
    *text = '\0';
}

/* Signs and axes up to a comma or the end; null if there is anything else, or an axis twice. */
static const char *read_direction(uint32_t *set, const char *text)
{
    int step[3] = {0, 0, 0};
    uint8_t direction;
    while (*text == '+' || *text == '-') {
        const char *axis = text[1] != '\0' ? strchr(axis_names, text[1]) : NULL;
        if (axis == NULL || step[axis - axis_names] != 0) {
            return NULL;
        }
        step[axis - axis_names] = *text == '+' ? 1 : -1;
        text += 2;
    }
    direction = qv_direction(step[0], step[1], step[2]);
    if (direction >= QV_DIRECTIONS || (*text != ',' && *text != '\0')) {
        return NULL;
    }
    *set |= (uint32_t)1 << direction;
    return text;
}

bool read_directions(uint32_t *set, const char *text)
{
    if (strcmp(text, "all") == 0 || strcmp(text, "faces") == 0) {
        *set = text[0] == 'a' ? QV_DIRECTIONS_ALL : QV_DIRECTIONS_FACES;
        return true;
    }
    *set = 0;
    text = read_direction(set, text);
    while (text != NULL && *text == ',') {
        text = read_direction(set, text + 1);
    }
    return text != NULL;
}
