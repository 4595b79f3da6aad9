/*
 * json.h - writes JSON. A null key stands for an element of an array.
 */
#ifndef QVOL_HOST_JSON_H
#define QVOL_HOST_JSON_H

#include "output.h"

#include <stdint.h>

#define JSON_DEPTH 8

struct json {
    output *out;
    int depth;
    bool filled[JSON_DEPTH];  /* a value stands there already */
    char closing[JSON_DEPTH]; /* '}' or ']' */
};

/* The whole document is one object. */
void json_begin(struct json *json, output *out);
void json_end(struct json *json);

void json_object(struct json *json, const char *key);
void json_array(struct json *json, const char *key);
void json_close(struct json *json);

void json_text(struct json *json, const char *key, const char *text);
/* A decimal string where a double could not hold the number. */
void json_integer(struct json *json, const char *key, int64_t value);
void json_unsigned(struct json *json, const char *key, uint64_t value);
/* Enough digits to read back the same double; null if it is not finite. */
void json_decimal(struct json *json, const char *key, double value);
void json_boolean(struct json *json, const char *key, bool value);
void json_null(struct json *json, const char *key);

/* Arrays on one line. */
void json_triple(struct json *json, const char *key, int64_t x, int64_t y, int64_t z);
void json_integers(struct json *json, const char *key, const int64_t *values, unsigned count);
void json_decimals(struct json *json, const char *key, const double *values, unsigned count);

#endif
