/*
 * write_rows.c - CSV, $readmemh and C.
 */
#include "write.h"

#include "qvol.h"

#include <ctype.h>
#include <inttypes.h>
#include <string.h>

static const uint64_t *row_of(const vector_set *set, unsigned number)
{
    return set->columns + (size_t)number * set->stage->columns;
}

/* ---- CSV -------------------------------------------------------------------- */

static void write_flags(FILE *to, unsigned flags)
{
    const char *between = "";
    for (unsigned bit = 0; bit < VECTOR_FLAGS; bit++)
        if ((flags >> bit & 1u) != 0) {
            fprintf(to, "%s%s", between, vector_flag_names[bit]);
            between = "+";
        }
}

static void write_decimal(FILE *to, const vector_column *column, uint64_t value)
{
    if (column->is_signed)
        fprintf(to, "%" PRId64, (int64_t)value);
    else
        fprintf(to, "%" PRIu64, value);
}

void write_csv(FILE *to, const vector_set *set)
{
    const vector_column *columns = set->described;
    fputs("id,flags", to);
    for (unsigned i = 0; i < set->stage->columns; i++)
        fprintf(to, ",%s", columns[i].name);
    for (unsigned number = 0; number < set->count; number++) {
        fprintf(to, "\n%s-%05u,", set->stage->name, number);
        write_flags(to, set->flags[number]);
        for (unsigned i = 0; i < set->stage->columns; i++) {
            fputc(',', to);
            write_decimal(to, &columns[i], row_of(set, number)[i]);
        }
    }
    fputc('\n', to);
}

/* ---- $readmemh -------------------------------------------------------------- */

static unsigned bits_of(const vector_column *columns, unsigned count)
{
    unsigned bits = 0;
    for (unsigned i = 0; i < count; i++)
        bits += 4u * vector_digits(&columns[i]);
    return bits;
}

static void write_layout(FILE *to, const vector_set *set)
{
    const vector_column *columns = set->described;
    unsigned count = set->stage->columns, above = bits_of(columns, count);
    fprintf(to, "// schema %s, specification %d, library %s, seed %" PRIu64 "\n", VECTOR_SCHEMA,
            QV_SPECIFICATION, QV_VERSION, set->stage->seed);
    fprintf(to, "// %s: tests/SPEC.md, section %s; %u rows of %u bits, row n is %s-n\n",
            set->stage->name, set->stage->section, set->count, above, set->stage->name);
    for (unsigned i = 0; i < count; i++) {
        unsigned width = 4u * vector_digits(&columns[i]);
        fprintf(to, "// [%u:%u] %s %s %s\n", above - 1u, above - width, columns[i].name,
                columns[i].field->format, vector_role(columns[i].field));
        above -= width;
    }
}

static void write_digits(FILE *to, const vector_column *column, uint64_t value)
{
    unsigned digits = vector_digits(column);
    uint64_t mask = UINT64_MAX >> (64u - 4u * digits);
    fprintf(to, "%0*" PRIx64, (int)digits, value & mask);
}

void write_hex(FILE *to, const vector_set *set)
{
    const vector_column *columns = set->described;
    write_layout(to, set);
    for (unsigned number = 0; number < set->count; number++) {
        for (unsigned i = 0; i < set->stage->columns; i++) {
            if (i != 0)
                fputc('_', to);
            write_digits(to, &columns[i], row_of(set, number)[i]);
        }
        fputc('\n', to);
    }
}

/* ---- C ---------------------------------------------------------------------- */

/* The least standard type of a column, as bits. */
static unsigned type_bits(const vector_column *column)
{
    unsigned bits = 8;
    while (bits < column->width)
        bits *= 2;
    return bits;
}

static void write_structure(FILE *to, const vector_set *set)
{
    const vector_column *columns = set->described;
    fprintf(to, "typedef struct qvol_%s_vector {\n", set->stage->name);
    for (unsigned i = 0; i < set->stage->columns; i += columns[i].field->count) {
        const vector_field *field = columns[i].field;
        fprintf(to, "    %sint%u_t %s", columns[i].is_signed ? "" : "u", type_bits(&columns[i]),
                field->name);
        if (field->count > 1)
            fprintf(to, "[%u]", field->count);
        fprintf(to, "; /* %s, %s */\n", vector_role(field), field->format);
    }
    fprintf(to, "} qvol_%s_vector;\n\n", set->stage->name);
}

/* INT64_MIN has no literal of its own. */
static void write_literal(FILE *to, const vector_column *column, uint64_t value)
{
    if (!column->is_signed)
        fprintf(to, column->width > 32 ? "UINT64_C(%" PRIu64 ")" : "%" PRIu64 "u", value);
    else if ((int64_t)value == INT64_MIN)
        fputs("INT64_MIN", to);
    else
        fprintf(to, column->width > 32 ? "INT64_C(%" PRId64 ")" : "%" PRId64, (int64_t)value);
}

static void write_row(FILE *to, const vector_column *columns, unsigned count, const uint64_t *row)
{
    fputs("    {", to);
    for (unsigned i = 0; i < count;) {
        unsigned end = i + columns[i].field->count, is_array = end - i > 1;
        if (i != 0)
            fputs(", ", to);
        fputs(is_array ? "{" : "", to);
        for (unsigned first = i; i < end; i++) {
            if (i != first)
                fputs(", ", to);
            write_literal(to, &columns[i], row[i]);
        }
        fputs(is_array ? "}" : "", to);
    }
    fputs("},\n", to);
}

/* A stage's name in capitals. */
static void set_capitals(char to[VECTOR_NAME], const char *stage)
{
    unsigned i = 0;
    for (; stage[i] != '\0' && i < VECTOR_NAME - 1; i++)
        to[i] = (char)toupper((unsigned char)stage[i]);
    to[i] = '\0';
}

void write_header(FILE *to, const vector_set *set)
{
    const vector_column *columns = set->described;
    const char *name = set->stage->name;
    char capitals[VECTOR_NAME];
    fputs("/* SPDX-License-Identifier: MIT */\n", to);
    fprintf(to, "/* %s: made by make vectors; not to be edited. Row n is %s-n. */\n", name, name);
    set_capitals(capitals, name);
    fprintf(to, "#ifndef QVOL_VECTORS_%s_H\n#define QVOL_VECTORS_%s_H\n\n", capitals, capitals);
    fputs("#include <stdint.h>\n\n/* clang-format off */\n", to);
    fprintf(to, "#define QVOL_%s_VECTORS %u /* specification %d */\n\n", capitals, set->count,
            QV_SPECIFICATION);
    write_structure(to, set);
    fprintf(to, "static const qvol_%s_vector qvol_%s_vectors[] = {\n", name, name);
    for (unsigned number = 0; number < set->count; number++)
        write_row(to, columns, set->stage->columns, row_of(set, number));
    fputs("};\n\n#endif\n", to);
}
