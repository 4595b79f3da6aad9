/*
 * vector_explain.c - prints formulas with the numbers of a row in them.
 */
#include "vector_explain.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAME_WIDTH  12
#define ROLE_WIDTH  3
#define INDENTATION (ROLE_WIDTH + 1 + NAME_WIDTH + 1)

/* The value of 1 in a format: 255 of unorm8, 2^16 of u17.16; 0 where there is no point. */
static double unit_of(const char *format)
{
    const char *point = strchr(format, '.');
    if (strcmp(format, "unorm8") == 0) {
        return UINT8_MAX;
    }
    if (strcmp(format, "unorm16") == 0) {
        return UINT16_MAX;
    }
    return point != NULL ? ldexp(1, atoi(point + 1)) : 0;
}

static void print_value(const char *value, const char *format)
{
    double unit = unit_of(format);
    printf("= %s", value);
    if (unit > 0) {
        printf("  (%s: %.9g)", format, strtod(value, NULL) / unit);
    } else {
        printf("  (%s)", format);
    }
    printf("\n");
}

static bool is_in_name(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* The value of the column with a name of so many characters, or null. */
static const char *value_of(const struct vectors *vectors, size_t row, const char *name,
                            size_t length)
{
    const struct table_file *rows = &vectors->rows;
    for (size_t i = VECTOR_FIRST; i < rows->columns; i++) {
        const char *heading = table_file_heading(rows, i);
        if (strncmp(heading, name, length) == 0 && heading[length] == '\0') {
            return table_file_cell(rows, row, i);
        }
    }
    return NULL;
}

/* Whether the text is a formula, or one name of a column; prose stays as it is. */
static bool is_formula(const char *text)
{
    size_t length = 0;
    while (is_in_name(text[length])) {
        length++;
    }
    return text[length] == '\0' || strpbrk(text, "+-*/(=<>") != NULL ||
           strstr(text, " mod ") != NULL;
}

/* The formula with a value in place of each name of a column; where that is a factor without a
   sign, as in `256 f0` and not in `n mod 5`, with one. */
static void print_with_values(const struct vectors *vectors, size_t row, const char *text)
{
    bool behind_factor = false; /* the last that was no blank is a number, a column or a bracket */
    while (*text != '\0') {
        size_t length = 0;
        while (is_in_name(text[length])) {
            length++;
        }
        const char *value = length != 0 ? value_of(vectors, row, text, length) : NULL;
        if (length == 0) {
            length = 1;
        }
        if (value != NULL) {
            printf("%s%s", behind_factor ? "* " : "", value);
        } else {
            printf("%.*s", (int)length, text);
        }
        if (*text != ' ') {
            behind_factor = value != NULL || isdigit((unsigned char)*text) || *text == ')';
        }
        text += length;
    }
}

static void explain_column(const struct vectors *vectors, size_t row, size_t column)
{
    const struct table_file *rows = &vectors->rows;
    const char *role = vectors_field(vectors, column, FIELD_ROLE);
    const char *text = vectors_field(vectors, column, FIELD_TEXT);
    bool is_input = strcmp(role, "in") == 0;
    printf("%-*s %-*s ", ROLE_WIDTH, role, NAME_WIDTH, table_file_heading(rows, column));
    if (is_input) {
        print_value(table_file_cell(rows, row, column),
                    vectors_field(vectors, column, FIELD_FORMAT));
        return;
    }
    printf("= %s\n", text);
    if (is_formula(text)) {
        printf("%*s= ", INDENTATION, "");
        print_with_values(vectors, row, text);
        printf("\n");
    }
    printf("%*s", INDENTATION, "");
    print_value(table_file_cell(rows, row, column), vectors_field(vectors, column, FIELD_FORMAT));
}

void vector_explain(const struct vectors *vectors, size_t row)
{
    const struct table_file *rows = &vectors->rows;
    printf("%s: tests/SPEC.md, section %s; %s\n", table_file_cell(rows, row, VECTOR_ID),
           vectors_field(vectors, VECTOR_FIRST, FIELD_SECTION),
           table_file_cell(rows, row, VECTOR_FLAGS));
    for (size_t i = VECTOR_FIRST; i < rows->columns; i++) {
        explain_column(vectors, row, i);
    }
}
