/*
 * vector_files.h - the test vectors of one stage, as tests/vectors/README.md describes them.
 */
#ifndef QVOL_HOST_VECTOR_FILES_H
#define QVOL_HOST_VECTOR_FILES_H

#include "settings.h"
#include "table_file.h"

#include <stdbool.h>
#include <stdint.h>

/* The first columns of every stage. */
enum { VECTOR_ID, VECTOR_FLAGS, VECTOR_FIRST };

/* What fields.tsv tells of a column. */
enum { FIELD_STAGE, FIELD_SECTION, FIELD_NAME, FIELD_ROLE, FIELD_FORMAT, FIELD_TEXT, FIELDS };

#define VECTORS_PATH_BYTES 4096

struct vectors {
    char path[2][VECTORS_PATH_BYTES]; /* which the messages of both tables name */
    const char *stage;
    struct table_file fields; /* of all stages */
    size_t first_field;       /* of this one: the row of its column VECTOR_FIRST */
    struct table_file rows;
};

/* Reads a stage from the folder of --from, or that of the installation. A stage that there is not
   is an error of the command line. */
void vectors_open(struct vectors *vectors, const struct settings *settings, const char *stage);
void vectors_close(struct vectors *vectors);

/* The number of the row with an id; false where there is none. */
bool vectors_find(size_t *row, const struct vectors *vectors, const char *id);

/* One of FIELD_... of a column from VECTOR_FIRST on. */
const char *vectors_field(const struct vectors *vectors, size_t column, int which);

/* A number of 64 bits of either sign, decimal or, after 0x, hexadecimal. */
struct vector_number {
    bool negative;
    uint64_t magnitude;
};

/* False where the text is none. */
bool vector_number_read(struct vector_number *number, const char *text);

#endif
