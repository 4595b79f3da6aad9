/*
 * report_slices.h - how slices were blended, as JSON.
 */
#ifndef QVOL_HOST_REPORT_SLICES_H
#define QVOL_HOST_REPORT_SLICES_H

#include "frame.h"
#include "json.h"

void report_slices(struct json *json, const struct slicing *slicing, const struct frame *frame,
                   const struct settings *settings);

#endif
