/*
 * vector.c - makes the rows of a stage.
 */
#include "vector.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const vector_flag_names[VECTOR_FLAGS] = {"edge", "tie", "saturate", "overflow",
                                                     "random"};

void vector_fail(const char *stage, const char *what, const char *why)
{
    fprintf(stderr, "vectors: %s: %s: %s\n", stage, what, why);
    exit(1);
}

/* ---- Random numbers --------------------------------------------------------- */

static uint64_t next(vector_random *random)
{
    uint64_t z = random->state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

uint64_t vector_bits(vector_random *random, unsigned bits)
{
    return next(random) >> (64u - bits);
}

static uint64_t full(unsigned bits)
{
    return UINT64_MAX >> (64u - bits);
}

uint64_t vector_any(vector_random *random, unsigned bits)
{
    unsigned kind = (unsigned)vector_bits(random, 3);
    unsigned width = (unsigned)vector_between(random, 1, bits);
    if (kind == 0)
        return full(bits) - vector_bits(random, 2) % (full(bits) / 2 + 1);
    if (kind == 1)
        return (((uint64_t)1 << (width - 1u)) + vector_bits(random, 2) - 2u) & full(bits);
    return kind < 5 ? vector_bits(random, width) : vector_bits(random, bits);
}

int64_t vector_signed(vector_random *random, unsigned bits)
{
    int64_t magnitude = (int64_t)vector_any(random, bits);
    return vector_bits(random, 1) ? -magnitude : magnitude;
}

int64_t vector_between(vector_random *random, int64_t least, int64_t most)
{
    uint64_t numbers = (uint64_t)most - (uint64_t)least + 1u;
    return least + (int64_t)(vector_bits(random, 63) % numbers);
}

/* ---- Columns ---------------------------------------------------------------- */

/* uW, uW.F, sW, sW.F, unorm8, unorm16. */
static void read_format(vector_column *column, const char *stage)
{
    const char *format = column->field->format;
    column->is_signed = format[0] == 's';
    if (strncmp(format, "unorm", 5) == 0)
        column->width = (unsigned)atoi(format + 5);
    else if (format[0] == 'u' || format[0] == 's')
        column->width = (unsigned)atoi(format + 1);
    if (column->width < 1 || column->width > 64)
        vector_fail(stage, column->field->name, "no such format");
}

/* The text with the index in place of each [i]. */
static void set_text(vector_column *column, unsigned index, const char *stage)
{
    const char *from = column->field->text;
    size_t used = 0;
    while (*from != '\0' && used < VECTOR_TEXT - 4) {
        if (strncmp(from, "[i]", 3) == 0) {
            used += (size_t)snprintf(column->text + used, VECTOR_TEXT - used, "%u", index);
            from += 3;
        } else {
            column->text[used++] = *from++;
        }
    }
    if (*from != '\0')
        vector_fail(stage, column->field->name, "its text is too long");
    column->text[used] = '\0';
}

static void set_column(vector_column *column, const vector_field *field, unsigned index,
                       const char *stage)
{
    memset(column, 0, sizeof *column);
    column->field = field;
    if (field->count == 1)
        snprintf(column->name, VECTOR_NAME, "%s", field->name);
    else
        snprintf(column->name, VECTOR_NAME, "%s%u", field->name, index);
    read_format(column, stage);
    set_text(column, index, stage);
}

vector_column *vector_columns(const vector_stage *stage)
{
    vector_column *columns = calloc(stage->columns, sizeof *columns);
    unsigned count = 0;
    if (columns == NULL)
        vector_fail(stage->name, "memory", "exhausted");
    for (const vector_field *field = stage->fields; field->name != NULL; field++)
        for (unsigned i = 0; i < field->count; i++) {
            if (count == stage->columns)
                vector_fail(stage->name, field->name, "more fields than its structure has");
            set_column(&columns[count++], field, i, stage->name);
        }
    if (count != stage->columns)
        vector_fail(stage->name, "fields", "fewer than its structure has");
    return columns;
}

unsigned vector_digits(const vector_column *column)
{
    return (column->width + 3u) / 4u;
}

const char *vector_role(const vector_field *field)
{
    return field->role == 'i' ? "in" : field->role == 'm' ? "mid" : "out";
}

/* ---- Rows ------------------------------------------------------------------- */

/* Whether a value is one of its column's format. */
static int fits(const vector_column *column, uint64_t value)
{
    uint64_t limit = full(column->width);
    if (!column->is_signed)
        return value <= limit;
    return value <= limit >> 1 || ~value <= limit >> 1;
}

static void check_row(const vector_set *set, const uint64_t *row)
{
    for (unsigned i = 0; i < set->stage->columns; i++)
        if (!fits(&set->described[i], row[i])) {
            fprintf(stderr, "row %u, %" PRIu64 "\n", set->count, row[i]);
            vector_fail(set->stage->name, set->described[i].name, "does not fit its width");
        }
}

static void make_room(vector_set *set)
{
    if (set->count < set->room)
        return;
    set->room = set->room * 2 + 64;
    set->columns =
        realloc(set->columns, sizeof(uint64_t) * (size_t)set->room * set->stage->columns);
    set->flags = realloc(set->flags, set->room);
    if (set->columns == NULL || set->flags == NULL)
        vector_fail(set->stage->name, "memory", "exhausted");
}

void vector_add(vector_set *set, const void *inputs, unsigned flags)
{
    make_room(set);
    uint64_t *row = set->columns + (size_t)set->count * set->stage->columns;
    memcpy(row, inputs, sizeof(uint64_t) * set->stage->columns);
    set->flags[set->count] = (uint8_t)(flags | set->stage->compute(row));
    check_row(set, row);
    set->count++;
}

void vector_add_firsts(vector_set *set, const uint64_t *firsts, unsigned count)
{
    uint64_t *row = calloc(set->stage->columns, sizeof *row);
    if (row == NULL)
        vector_fail(set->stage->name, "memory", "exhausted");
    for (unsigned i = 0; i < count; i++) {
        row[0] = firsts[i];
        vector_add(set, row, VECTOR_EDGE);
    }
    free(row);
}

static void add_random(vector_set *set, vector_random *random)
{
    uint64_t *row = calloc(set->stage->columns, sizeof *row);
    if (row == NULL)
        vector_fail(set->stage->name, "memory", "exhausted");
    set->stage->draw(row, random);
    vector_add(set, row, VECTOR_RANDOM);
    free(row);
}

void vector_set_make(vector_set *set, const vector_stage *stage, unsigned wanted)
{
    vector_random random = {stage->seed};
    memset(set, 0, sizeof *set);
    set->stage = stage;
    set->described = vector_columns(stage);
    if (stage->edges != NULL)
        stage->edges(set);
    for (unsigned i = 0; i < stage->random_rows; i++)
        add_random(set, &random);
    if (stage->added != NULL)
        stage->added(set);
    while (stage->draw != NULL && set->count < wanted)
        add_random(set, &random);
}

void vector_set_free(vector_set *set)
{
    free(set->described);
    free(set->columns);
    free(set->flags);
}
