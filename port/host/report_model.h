/*
 * report_model.h - where voxels come from and what they are, as JSON: what the reports of
 * all commands share.
 */
#ifndef QVOL_HOST_REPORT_MODEL_H
#define QVOL_HOST_REPORT_MODEL_H

#include "json.h"
#include "levels.h"

/* The file: name, format, size, type, spacing, orientation. */
void report_input(struct json *json, const struct scan *scan);

/* Who writes, the input, and how it is classified; a mask too. */
void report_model(struct json *json, const struct model *model);

/* The step, Q16.16, is the unit distance of opacities where none is given; 0: unknown. */
void report_volume(struct json *json, const qv_volume *volume, const struct model *model,
                   uint32_t step);

/* Coarser levels; the first has that offset, in bytes. */
void report_levels(struct json *json, const struct levels *levels, const qv_volume *volume,
                   const struct model *model, uint64_t first_offset);

#endif
