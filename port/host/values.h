/*
 * values.h - numbers and names as the user writes them. Every reader takes the
 * whole text or refuses it.
 */
#ifndef QVOL_HOST_VALUES_H
#define QVOL_HOST_VALUES_H

#include <stdbool.h>
#include <stdint.h>

/* A decimal integer from 0 to most. */
bool read_unsigned(const char *text, uint64_t most, uint64_t *value);

/* A finite decimal number; no hexadecimal, no "inf". */
bool read_decimal(const char *text, double *value);

#define DECIMAL_BYTES 32

/* With as few digits, but at least six, as read back to the same number. */
void print_decimal(char text[DECIMAL_BYTES], double value);

/* Exactly `count` decimals (at most 8) between single separators. */
bool read_decimals(const char *text, char separator, unsigned count, double *values);

/* Exactly `count` integers from 1 to most, as in 181x217x181. */
bool read_sizes(const char *text, unsigned count, uint64_t most, uint32_t *values);

/* Of an option, or a usage error that tells the range. */
double decimal_between(const char *option, const char *value, double least, double most);
uint64_t integer_between(const char *option, const char *value, uint64_t least, uint64_t most);

/* RRGGBB. */
bool read_colour(const char *text, uint8_t rgb[3]);

/* A named value of an option; lists end with a null name. */
typedef struct choice {
    const char *name;
    int value;
} choice;

/* The choice of that name, or a usage error that lists the names. */
int choose(const char *option, const char *text, const choice *choices);

/* The name of a value that is in the list. */
const char *choice_name(const choice *choices, int value);

#endif
