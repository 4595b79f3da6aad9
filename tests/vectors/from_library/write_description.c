/*
 * write_description.c - the manifest, the columns for the command, and STAGES.md.
 */
#include "write.h"

#include "qvol.h"
#include "sha256.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

/* ---- Manifest --------------------------------------------------------------- */

/* Texts hold neither quotes nor backslashes; the test parses what comes of them. */
void write_manifest_begin(FILE *to)
{
    fprintf(to, "{\n  \"schema\": \"%s\",\n", VECTOR_SCHEMA);
    fputs("  \"spdx_license\": \"MIT\",\n", to);
    fprintf(to, "  \"specification\": {\"file\": \"tests/SPEC.md\", \"version\": %d},\n",
            QV_SPECIFICATION);
    fprintf(to, "  \"library\": \"qvol %s\",\n", QV_VERSION);
    fputs("  \"generator\": \"tests/vectors/from_library\",\n  \"stages\": [", to);
}

void write_manifest_end(FILE *to)
{
    fputs("\n  ]\n}\n", to);
}

/* A field, by its first column. */
static void write_field(FILE *to, const vector_column *column)
{
    const vector_field *field = column->field;
    fprintf(to,
            "        {\"name\": \"%s\", \"columns\": %u, \"role\": \"%s\", \"width\": %u, "
            "\"signed\": %s, \"format\": \"%s\", \"text\": \"%s\"}",
            field->name, field->count, vector_role(field), column->width,
            column->is_signed ? "true" : "false", field->format, field->text);
}

/* How many rows have each flag. */
static void write_coverage(FILE *to, const vector_set *set)
{
    fputs("      \"coverage\": {", to);
    for (unsigned bit = 0; bit < VECTOR_FLAGS; bit++) {
        unsigned rows = 0;
        for (unsigned i = 0; i < set->count; i++)
            rows += set->flags[i] >> bit & 1u;
        fprintf(to, "%s\"%s\": %u", bit ? ", " : "", vector_flag_names[bit], rows);
    }
    fputs("},\n", to);
}

static void write_file(FILE *to, const char *folder, const char *stage, const char *ending)
{
    char path[FILENAME_MAX], hash[SHA256_TEXT];
    snprintf(path, sizeof path, "%s/%s.%s", folder, stage, ending);
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        vector_fail(stage, path, "cannot be read");
    sha256_of_stream(hash, file);
    fclose(file);
    fprintf(to, "        {\"name\": \"%s.%s\", \"sha256\": \"%s\"}", stage, ending, hash);
}

void write_manifest_stage(FILE *to, const vector_set *set, const char *folder, int is_first)
{
    static const char *const endings[] = {"csv", "hex", "h"};
    const vector_stage *stage = set->stage;
    fprintf(to, "%s\n    {\n      \"stage\": \"%s\",\n", is_first ? "" : ",", stage->name);
    fprintf(to, "      \"title\": \"%s\",\n      \"section\": \"%s\",\n", stage->title,
            stage->section);
    fprintf(to, "      \"rounding\": \"%s\",\n      \"saturation\": \"%s\",\n", stage->rounding,
            stage->saturation);
    fprintf(to, "      \"seed\": %" PRIu64 ",\n      \"count\": %u,\n", stage->seed, set->count);
    write_coverage(to, set);
    fputs("      \"fields\": [\n", to);
    for (unsigned i = 0; i < stage->columns; i += set->described[i].field->count) {
        fputs(i != 0 ? ",\n" : "", to);
        write_field(to, &set->described[i]);
    }
    fputs("\n      ],\n      \"files\": [\n", to);
    for (unsigned i = 0; i < 3; i++) {
        write_file(to, folder, stage->name, endings[i]);
        fputs(i < 2 ? ",\n" : "\n", to);
    }
    fputs("      ]\n    }", to);
}

/* ---- Columns, for the command ----------------------------------------------- */

void write_fields(FILE *to)
{
    fputs("stage\tsection\tcolumn\trole\tformat\ttext\n", to);
    for (unsigned i = 0; vector_stages[i] != NULL; i++) {
        const vector_stage *stage = vector_stages[i];
        vector_column *columns = vector_columns(stage);
        for (unsigned c = 0; c < stage->columns; c++)
            fprintf(to, "%s\t%s\t%s\t%s\t%s\t%s\n", stage->name, stage->section, columns[c].name,
                    vector_role(columns[c].field), columns[c].field->format, columns[c].text);
        free(columns);
    }
}

/* ---- Tables ----------------------------------------------------------------- */

static void write_stage_table(FILE *to, const vector_stage *stage)
{
    fprintf(to, "\n## %s\n\n", stage->name);
    fprintf(to, "Section %s: %s. Rounding: %s. Limits: %s.\n\n", stage->section, stage->title,
            stage->rounding, stage->saturation);
    fputs("| field | columns | role | format | meaning or formula |\n|---|---|---|---|---|\n", to);
    for (const vector_field *field = stage->fields; field->name != NULL; field++)
        fprintf(to, "| %s | %u | %s | %s | %s |\n", field->name, field->count, vector_role(field),
                field->format, field->text);
}

void write_tables(FILE *to)
{
    fputs(
        "<!-- made by make vectors; not to be edited -->\n\n# Stages\n\n"
        "What the columns hold; README.md says in which forms. `[i]` stands for the number of a "
        "column of\nseveral, which is part of its name: w0, w1, ... Functions as hi and div255 are "
        "those of\ntests/SPEC.md.\n\n",
        to);
    fputs("| stage | section | what | seed |\n|---|---|---|---|\n", to);
    for (unsigned i = 0; vector_stages[i] != NULL; i++)
        fprintf(to, "| %s | %s | %s | %" PRIu64 " |\n", vector_stages[i]->name,
                vector_stages[i]->section, vector_stages[i]->title, vector_stages[i]->seed);
    for (unsigned i = 0; vector_stages[i] != NULL; i++)
        write_stage_table(to, vector_stages[i]);
}
