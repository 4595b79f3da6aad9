/*
 * values.c - numbers and names as the user writes them.
 */
#include "values.h"
#include "error.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LIST_MOST  8
#define TEXT_BYTES 128
/* So many digits tell any two doubles apart. */
#define DIGITS_MOST 17

bool read_unsigned(const char *text, uint64_t most, uint64_t *value)
{
    char *end;
    unsigned long long number;
    if (text[0] < '0' || text[0] > '9') {
        return false;
    }
    errno = 0;
    number = strtoull(text, &end, 10);
    if (errno != 0 || *end != '\0' || number > most) {
        return false;
    }
    *value = number;
    return true;
}

bool read_decimal(const char *text, double *value)
{
    char *end;
    double number;
    if (text[0] == '\0' || strspn(text, "0123456789+-.eE") != strlen(text)) {
        return false;
    }
    number = strtod(text, &end);
    if (*end != '\0' || !isfinite(number)) {
        return false;
    }
    *value = number;
    return true;
}

void print_decimal(char text[DECIMAL_BYTES], double value)
{
    int digits = 6;
    do {
        snprintf(text, DECIMAL_BYTES, "%.*g", digits, value);
    } while (digits++ < DIGITS_MOST && (strtod(text, NULL) < value || strtod(text, NULL) > value));
}

/* Splits a copy of the text in place; false unless it has `count` parts. */
static bool split(char *copy, char separator, unsigned count, const char *parts[LIST_MOST])
{
    unsigned found = 0;
    char *rest = copy;
    while (rest != NULL) {
        char *next = strchr(rest, separator);
        if (found == count) {
            return false;
        }
        if (next != NULL) {
            *next++ = '\0';
        }
        parts[found++] = rest;
        rest = next;
    }
    return found == count;
}

/* False if it is longer than any value needs to be. */
static bool copy_text(char copy[TEXT_BYTES], const char *text)
{
    return snprintf(copy, TEXT_BYTES, "%s", text) < TEXT_BYTES;
}

bool read_decimals(const char *text, char separator, unsigned count, double *values)
{
    char copy[TEXT_BYTES];
    const char *parts[LIST_MOST];
    if (!copy_text(copy, text) || !split(copy, separator, count, parts)) {
        return false;
    }
    for (unsigned i = 0; i < count; i++) {
        if (!read_decimal(parts[i], &values[i])) {
            return false;
        }
    }
    return true;
}

bool read_sizes(const char *text, unsigned count, uint64_t most, uint32_t *values)
{
    char copy[TEXT_BYTES];
    const char *parts[LIST_MOST];
    if (!copy_text(copy, text) || !split(copy, 'x', count, parts)) {
        return false;
    }
    for (unsigned i = 0; i < count; i++) {
        uint64_t value;
        if (!read_unsigned(parts[i], most, &value) || value == 0) {
            return false;
        }
        values[i] = (uint32_t)value;
    }
    return true;
}

double decimal_between(const char *option, const char *value, double least, double most)
{
    double number;
    if (!read_decimal(value, &number) || number < least || number > most) {
        usage_error(option, "'%s' is not a number from %g to %g", value, least, most);
    }
    return number;
}

uint64_t integer_between(const char *option, const char *value, uint64_t least, uint64_t most)
{
    uint64_t number;
    if (!read_unsigned(value, most, &number) || number < least) {
        usage_error(option, "'%s' is not a whole number from %llu to %llu", value,
                    (unsigned long long)least, (unsigned long long)most);
    }
    return number;
}

bool read_colour(const char *text, uint8_t rgb[3])
{
    unsigned long number;
    if (strlen(text) != 6 || strspn(text, "0123456789abcdefABCDEF") != 6) {
        return false;
    }
    number = strtoul(text, NULL, 16);
    rgb[0] = (uint8_t)(number >> 16 & 255);
    rgb[1] = (uint8_t)(number >> 8 & 255);
    rgb[2] = (uint8_t)(number & 255);
    return true;
}

/* "a, b, c"; what does not fit is cut off. */
static void list_names(char *names, size_t bytes, const choice *choices)
{
    names[0] = '\0';
    for (const choice *c = choices; c->name != NULL; c++) {
        size_t used = strlen(names);
        snprintf(names + used, bytes - used, "%s%s", c == choices ? "" : ", ", c->name);
    }
}

int choose(const char *option, const char *text, const choice *choices)
{
    char names[512];
    for (const choice *c = choices; c->name != NULL; c++) {
        if (strcmp(c->name, text) == 0) {
            return c->value;
        }
    }
    list_names(names, sizeof names, choices);
    usage_error(option, "unknown '%s', use one of %s", text, names);
}

const char *choice_name(const choice *choices, int value)
{
    const choice *c = choices;
    while (c->name != NULL && c->value != value) {
        c++;
    }
    return c->name != NULL ? c->name : "unknown";
}
