/*
 * vector.h - stages, their fields, and rows of test vectors.
 *
 * A stage describes its fields once; CSV, hex, C header, manifest and STAGES.md are all
 * printed from that description. A row is an array of 64-bit columns in the order of
 * the fields, signed ones in two's complement; a stage sees it as a structure of uint64_t and
 * int64_t members.
 */
#ifndef VECTORS_VECTOR_H
#define VECTORS_VECTOR_H

#include <stddef.h>
#include <stdint.h>

#define VECTOR_SCHEMA "qvol-vectors-1"

/* What a row is there for, or what happens in it. */
enum {
    VECTOR_EDGE = 1,     /* the ends of a range, and what is next to them */
    VECTOR_TIE = 2,      /* a rounding meets exactly one half */
    VECTOR_SATURATE = 4, /* a result is limited */
    VECTOR_OVERFLOW = 8, /* a sum or a product is the greatest that there is */
    VECTOR_RANDOM = 16,
    VECTOR_FLAGS = 5
};

extern const char *const vector_flag_names[VECTOR_FLAGS];

typedef struct vector_field {
    const char *name;   /* a null name ends a list */
    unsigned count;     /* columns: name0, name1, ...; of 1 the name alone */
    char role;          /* 'i' in, 'm' mid, 'o' out */
    const char *format; /* u17.16, s64.32, unorm8: see tests/SPEC.md, section 1 */
    const char *text;   /* what an input means; the formula of the rest, with [i] for the index */
} vector_field;

/* SplitMix64 (Steele, Lea and Flood 2014). */
typedef struct vector_random {
    uint64_t state;
} vector_random;

/* So many random bits, 1 .. 64. */
uint64_t vector_bits(vector_random *random, unsigned bits);

/* The same, but each width up to `bits` as often as any other, and every fourth next to a power
   of 2 or full: where roundings and limits are. */
uint64_t vector_any(vector_random *random, unsigned bits);

/* The same as a magnitude, with either sign; bits below 64. */
int64_t vector_signed(vector_random *random, unsigned bits);

/* least .. most, at most 2^63 numbers. */
int64_t vector_between(vector_random *random, int64_t least, int64_t most);

typedef struct vector_set vector_set;

typedef struct vector_stage {
    const char *name;
    const char *section; /* of tests/SPEC.md */
    const char *title;
    const char *rounding;   /* how, and where */
    const char *saturation; /* what is limited; "none" */
    const vector_field *fields;
    unsigned columns; /* of its structure */
    uint64_t seed;
    unsigned random_rows; /* of the committed set */
    void (*edges)(vector_set *set);
    void (*added)(vector_set *set); /* rows that came later, after the random ones; or null */
    void (*draw)(void *row, vector_random *random); /* random inputs; the rest is 0 */
    unsigned (*compute)(void *row); /* mids and outs from inputs; returns flags that it saw */
} vector_stage;

/* All stages, up to a null pointer. */
extern const vector_stage *const vector_stages[];

/* ---- Columns, as fields part into them -------------------------------------- */

enum { VECTOR_NAME = 24, VECTOR_TEXT = 400 };

typedef struct vector_column {
    const vector_field *field;
    char name[VECTOR_NAME];
    char text[VECTOR_TEXT]; /* with the index in place of [i] */
    unsigned width;         /* bits */
    int is_signed;
} vector_column;

/* Describes all columns of a stage, for free(). A description that does not fit its structure ends
   the program. */
vector_column *vector_columns(const vector_stage *stage);

/* Hexadecimal digits of a column, and "in", "mid" or "out". */
unsigned vector_digits(const vector_column *column);
const char *vector_role(const vector_field *field);

/* ---- Sets --------------------------------------------------------------------- */

struct vector_set {
    const vector_stage *stage;
    vector_column *described; /* its columns */
    unsigned count, room;     /* rows */
    uint64_t *columns;        /* of row after row */
    uint8_t *flags;           /* of rows */
};

/* Computes a row of these inputs and appends it. */
void vector_add(vector_set *set, const void *inputs, unsigned flags);

/* The same of rows of which the first column alone is an input. */
void vector_add_firsts(vector_set *set, const uint64_t *firsts, unsigned count);

/* All rows of a stage: edges, random ones, those that were added; then more random ones up to
   `wanted` rows. */
void vector_set_make(vector_set *set, const vector_stage *stage, unsigned wanted);
void vector_set_free(vector_set *set);

/* Ends the program with a line on standard error. */
void vector_fail(const char *stage, const char *what, const char *why) __attribute__((noreturn));

/* A structure's columns. */
#define VECTOR_COLUMNS(type) ((unsigned)(sizeof(type) / sizeof(uint64_t)))

#endif
