/*
 * lighting.h - light from outside, as the library wants it.
 */
#ifndef QVOL_HOST_LIGHTING_H
#define QVOL_HOST_LIGHTING_H

#include "json.h"
#include "settings.h"

void lighting_create(qv_lighting *lighting, const struct settings *settings);

void report_lighting(struct json *json, const qv_lighting *lighting);

#endif
