/*
 * transfer_text.c - reads the text form of transfer functions.
 */
#include "transfer_text.h"
#include "error.h"
#include "values.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TEXT_BYTES 65536
#define WORDS      6
#define GLOSS_MOST 7

static const qv_shading default_shading = {
    .ambient = 77, .diffuse = 179, .specular = 51, .gloss = 4, .least_gradient = 8};

struct place {
    const char *name;
    unsigned line;
};

/* FILE: line N: reason. */
static void text_error(const struct place *place, const char *reason)
{
    char field[32];
    snprintf(field, sizeof field, "line %u", place->line);
    data_error(place->name, field, "%s", reason);
}

/* 0 .. most. */
static double number(const struct place *place, const char *word, double most)
{
    double value;
    if (!read_decimal(word, &value) || value < 0 || value > most) {
        text_error(place, "a number is missing, or outside its range");
    }
    return value;
}

/* 8 bits become 16 by * 257, which takes 255 to 65535. */
static void read_point(struct transfer *transfer, const struct place *place, char *words[WORDS])
{
    qv_control_point *point = &transfer->points[transfer->count];
    double index = number(place, words[0], QV_PALETTE_ENTRIES - 1);
    if (index != floor(index)) {
        text_error(place, "the index is not a whole number");
    }
    if (transfer->count > 0 && index <= point[-1].index) {
        text_error(place, "the index does not rise");
    }
    point->index = (uint8_t)index;
    for (unsigned c = 0; c < 3; c++) {
        point->rgba[c] = (uint16_t)lround(number(place, words[c + 1], 255) * 257);
    }
    point->rgba[3] = (uint16_t)lround(number(place, words[4], 1) * 65535);
    transfer->count++;
}

/* The logarithm of 1, 2, 4 .. 128. */
static uint8_t gloss(const struct place *place, const char *word)
{
    double exponent = number(place, word, 1 << GLOSS_MOST);
    for (uint8_t g = 0; g <= GLOSS_MOST; g++) {
        if (lround(exponent) == 1L << g) {
            return g;
        }
    }
    text_error(place, "the exponent is none of 1, 2, 4 .. 128");
    return 0;
}

static void read_shading(struct transfer *transfer, const struct place *place, char *words[WORDS])
{
    qv_shading *shading = &transfer->shading;
    shading->ambient = (uint16_t)lround(number(place, words[1], 1) * 256);
    shading->diffuse = (uint16_t)lround(number(place, words[2], 1) * 256);
    shading->specular = (uint16_t)lround(number(place, words[3], 1) * 256);
    shading->gloss = gloss(place, words[4]);
    shading->least_gradient = (uint16_t)lround(number(place, words[5], 1) * 256);
}

/* Cuts the line in place; WORDS + 1 if there are too many. */
static unsigned split_words(char *line, char *words[WORDS])
{
    unsigned count = 0;
    char *comment = strchr(line, '#');
    if (comment != NULL) {
        *comment = '\0';
    }
    for (char *c = line; *(c += strspn(c, " \t\r")) != '\0';) {
        if (count == WORDS) {
            return WORDS + 1;
        }
        words[count++] = c;
        c += strcspn(c, " \t\r");
        if (*c != '\0') {
            *c++ = '\0';
        }
    }
    return count;
}

/* Blank lines and comments say nothing. */
static void read_line(struct transfer *transfer, const struct place *place, char *line)
{
    char *words[WORDS];
    unsigned count = split_words(line, words);
    if (count == 0) {
        return;
    }
    if (count == 6 && strcmp(words[0], "shading") == 0) {
        read_shading(transfer, place, words);
    } else if (count == 5) {
        read_point(transfer, place, words);
    } else {
        text_error(place, "expected: index red green blue opacity");
    }
}

static void read_text(struct transfer *transfer, const char *name, char *text)
{
    struct place place = {name, 1};
    transfer->name = name;
    transfer->count = 0;
    transfer->shading = default_shading;
    for (char *line = text; line != NULL; place.line++) {
        char *end = strchr(line, '\n');
        if (end != NULL) {
            *end++ = '\0';
        }
        read_line(transfer, &place, line);
        line = end;
    }
    if (transfer->count == 0) {
        data_error(name, "transfer function", "has no control point");
    }
}

/* Null if there is no preset of that name. */
static const char *preset_text(const char *name)
{
    const struct preset *p = presets;
    while (p->name != NULL && strcmp(p->name, name) != 0) {
        p++;
    }
    return p->text;
}

/* A bare word that is no file was meant as a preset. */
static void read_file(const char *name, char text[TEXT_BYTES])
{
    FILE *file = fopen(name, "rb");
    size_t count;
    if (file == NULL && errno == ENOENT && strpbrk(name, "./") == NULL) {
        usage_error("--tf", "'%s' is neither a preset nor a file", name);
    }
    if (file == NULL) {
        system_error(name, NULL);
    }
    count = fread(text, 1, TEXT_BYTES - 1, file);
    if (ferror(file)) {
        system_error(name, NULL);
    }
    if (!feof(file) || memchr(text, '\0', count) != NULL) {
        data_error(name, "transfer function", "not a text of at most %d bytes", TEXT_BYTES - 2);
    }
    text[count] = '\0';
    fclose(file);
}

void transfer_read(struct transfer *transfer, const char *name)
{
    char *text = allocate(TEXT_BYTES, name, NULL);
    if (preset_text(name) != NULL) {
        snprintf(text, TEXT_BYTES, "%s", preset_text(name));
    } else {
        read_file(name, text);
    }
    read_text(transfer, name, text);
    free(text);
}
