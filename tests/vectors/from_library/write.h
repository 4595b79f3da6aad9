/*
 * write.h - the forms that a set of vectors is printed in.
 */
#ifndef VECTORS_WRITE_H
#define VECTORS_WRITE_H

#include <stdio.h>

#include "vector.h"

/* Line 1 names id, flags and columns; then a row a line, numbers decimal. */
void write_csv(FILE *to, const vector_set *set);

/* For $readmemh: a row a line, all columns, the first highest, each in whole digits. */
void write_hex(FILE *to, const vector_set *set);

/* A structure and a constant array. */
void write_header(FILE *to, const vector_set *set);

/* What a manifest says of a stage; `folder` holds its three files. Begin and end come once. */
void write_manifest_begin(FILE *to);
void write_manifest_stage(FILE *to, const vector_set *set, const char *folder, int is_first);
void write_manifest_end(FILE *to);

/* All columns of all stages: stage, section, column, role, format and text, with tabs between. */
void write_fields(FILE *to);

/* Markdown: a table of stages, then one of the fields of each. */
void write_tables(FILE *to);

#endif
