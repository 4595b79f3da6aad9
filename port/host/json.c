/*
 * json.c - writes JSON, indented by two.
 */
#include "json.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Beyond, a reader that keeps numbers as doubles would change them. */
#define EXACT_MOST (INT64_C(1) << 53)

static void put(struct json *json, const char *text)
{
    output_write(json->out, text, strlen(text));
}

/* Bytes of the UTF-8 sequence that starts here; 0 if none does. Overlong forms
   and surrogates are let through: readers take them. */
static unsigned sequence_bytes(const char *text)
{
    unsigned char first = (unsigned char)text[0];
    unsigned bytes = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (first > 0xF4) {
        return 0;
    }
    for (unsigned i = 1; i < bytes; i++) {
        if (((unsigned char)text[i] & 0xC0) != 0x80) {
            return 0;
        }
    }
    return bytes;
}

/* Names of files may be any bytes: what is no UTF-8 becomes U+FFFD. */
static void put_string(struct json *json, const char *text)
{
    put(json, "\"");
    while (*text != '\0') {
        char piece[16];
        unsigned bytes = sequence_bytes(text);
        if (bytes == 0) {
            snprintf(piece, sizeof piece, "\\ufffd");
            bytes = 1;
        } else if (*text == '"' || *text == '\\') {
            snprintf(piece, sizeof piece, "\\%c", *text);
        } else if (bytes == 1 && *text < ' ') {
            snprintf(piece, sizeof piece, "\\u%04x", (unsigned)*text);
        } else {
            snprintf(piece, sizeof piece, "%.*s", (int)bytes, text);
        }
        put(json, piece);
        text += bytes;
    }
    put(json, "\"");
}

static void start_line(struct json *json)
{
    put(json, "\n");
    for (int i = 0; i < json->depth; i++) {
        put(json, "  ");
    }
}

/* Comma, line and key before a value. */
static void start_value(struct json *json, const char *key)
{
    if (json->filled[json->depth]) {
        put(json, ",");
    }
    json->filled[json->depth] = true;
    start_line(json);
    if (key != NULL) {
        put_string(json, key);
        put(json, ": ");
    }
}

static void open_level(struct json *json, char opening, char closing)
{
    char text[2] = {opening, '\0'};
    put(json, text);
    json->depth++;
    json->filled[json->depth] = false;
    json->closing[json->depth] = closing;
}

void json_begin(struct json *json, output *out)
{
    memset(json, 0, sizeof *json);
    json->out = out;
    open_level(json, '{', '}');
}

void json_close(struct json *json)
{
    char text[2] = {json->closing[json->depth], '\0'};
    json->depth--;
    start_line(json);
    put(json, text);
}

void json_end(struct json *json)
{
    json_close(json);
    put(json, "\n");
}

void json_object(struct json *json, const char *key)
{
    start_value(json, key);
    open_level(json, '{', '}');
}

void json_array(struct json *json, const char *key)
{
    start_value(json, key);
    open_level(json, '[', ']');
}

void json_text(struct json *json, const char *key, const char *text)
{
    start_value(json, key);
    put_string(json, text);
}

static void put_integer(struct json *json, int64_t value)
{
    char text[32];
    bool exact = value >= -EXACT_MOST && value <= EXACT_MOST;
    snprintf(text, sizeof text, exact ? "%" PRId64 : "\"%" PRId64 "\"", value);
    put(json, text);
}

void json_integer(struct json *json, const char *key, int64_t value)
{
    start_value(json, key);
    put_integer(json, value);
}

void json_unsigned(struct json *json, const char *key, uint64_t value)
{
    char text[32];
    start_value(json, key);
    snprintf(text, sizeof text, value <= (uint64_t)EXACT_MOST ? "%" PRIu64 : "\"%" PRIu64 "\"",
             value);
    put(json, text);
}

/* 17 digits tell every double from its neighbours. */
static void put_decimal(struct json *json, double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.17g", value);
    put(json, isfinite(value) ? text : "null");
}

void json_decimal(struct json *json, const char *key, double value)
{
    start_value(json, key);
    put_decimal(json, value);
}

void json_boolean(struct json *json, const char *key, bool value)
{
    start_value(json, key);
    put(json, value ? "true" : "false");
}

void json_null(struct json *json, const char *key)
{
    start_value(json, key);
    put(json, "null");
}

void json_integers(struct json *json, const char *key, const int64_t *values, unsigned count)
{
    start_value(json, key);
    put(json, "[");
    for (unsigned i = 0; i < count; i++) {
        put(json, i > 0 ? ", " : "");
        put_integer(json, values[i]);
    }
    put(json, "]");
}

void json_decimals(struct json *json, const char *key, const double *values, unsigned count)
{
    start_value(json, key);
    put(json, "[");
    for (unsigned i = 0; i < count; i++) {
        put(json, i > 0 ? ", " : "");
        put_decimal(json, values[i]);
    }
    put(json, "]");
}

void json_triple(struct json *json, const char *key, int64_t x, int64_t y, int64_t z)
{
    const int64_t values[3] = {x, y, z};
    json_integers(json, key, values, 3);
}
