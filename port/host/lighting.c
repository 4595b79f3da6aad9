/*
 * lighting.c - lamps from angles.
 */
#include "lighting.h"
#include "model.h"

#include <math.h>
#include <string.h>

#define Q30 1073741824.0
/* A lamp's direction as a vector of about this length. */
#define LENGTH 32767
/* 255 of 8 bits is 65535 of 16. */
#define WIDEN 257

static void widen(uint16_t to[3], const uint8_t colour[3])
{
    for (unsigned c = 0; c < 3; c++) {
        to[c] = (uint16_t)(colour[c] * WIDEN);
    }
}

/* It shines from where a viewer of these angles would stand: against that one's forward. */
static void set_lamp_from(qv_lamp *lamp, const struct lamp_settings *from)
{
    int32_t rotation[3][3];
    qv_rotation(rotation, binary_angle(from->angles[0]), binary_angle(from->angles[1]), 0);
    for (unsigned a = 0; a < 3; a++) {
        lamp->direction[a] = (int16_t)lround(-rotation[2][a] / Q30 * LENGTH);
    }
    widen(lamp->colour, from->colour);
}

void lighting_create(qv_lighting *lighting, const struct settings *settings)
{
    const struct lighting_settings *from = &settings->lighting;
    memset(lighting, 0, sizeof *lighting);
    lighting->count = (uint8_t)from->count;
    for (unsigned i = 0; i < from->count; i++) {
        set_lamp_from(&lighting->lamps[i], &from->lamps[i]);
    }
    widen(lighting->ambient, from->ambient);
}

void report_lighting(struct json *json, const qv_lighting *lighting)
{
    const uint16_t *ambient = lighting->ambient;
    json_object(json, "lighting");
    json_array(json, "lamps");
    for (unsigned i = 0; i < lighting->count; i++) {
        const int16_t *direction = lighting->lamps[i].direction;
        const uint16_t *colour = lighting->lamps[i].colour;
        json_object(json, NULL);
        json_triple(json, "direction", direction[0], direction[1], direction[2]);
        json_triple(json, "colour", colour[0], colour[1], colour[2]);
        json_close(json);
    }
    json_close(json);
    json_triple(json, "ambient", ambient[0], ambient[1], ambient[2]);
    json_close(json);
}
