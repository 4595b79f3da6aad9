/*
 * report_freevoxel.h - what a FreeVoxel file holds and takes, as JSON and as text.
 */
#ifndef QVOL_HOST_REPORT_FREEVOXEL_H
#define QVOL_HOST_REPORT_FREEVOXEL_H

#include "freevoxel_file.h"
#include "report_model.h"

/* Directions, order and levels, with the memory that they take. */
void report_freevoxels(struct json *json, const struct freevoxel_header *header);

/* A file as the input. */
void report_freevoxel_file(struct json *json, const struct freevoxel_file *file);

/* For reading. */
void print_freevoxel_file(const struct freevoxel_file *file);

#endif
