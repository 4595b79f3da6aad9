/*
 * main.c - writes the test vectors of every stage: vectors FOLDER [ROWS]. There are at least so
 * many rows of each stage, 1 .. 100000; those of the smaller set come first, with the same ids.
 */
#include "write.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static FILE *open_file(const char *folder, const char *name, const char *ending)
{
    char path[FILENAME_MAX];
    snprintf(path, sizeof path, "%s/%s%s", folder, name, ending);
    FILE *file = fopen(path, "wb");
    if (file == NULL)
        vector_fail(path, "cannot be written", strerror(errno));
    return file;
}

static void close_file(FILE *file, const char *name)
{
    if (ferror(file) || fclose(file) != 0)
        vector_fail(name, "cannot be written", strerror(errno));
}

typedef void write_set(FILE *to, const vector_set *set);

static void write_to(const char *folder, const char *ending, write_set *write,
                     const vector_set *set)
{
    FILE *file = open_file(folder, set->stage->name, ending);
    write(file, set);
    close_file(file, set->stage->name);
}

static void write_stage(FILE *manifest, const char *folder, unsigned number, unsigned rows)
{
    vector_set set;
    vector_set_make(&set, vector_stages[number], rows);
    write_to(folder, ".csv", write_csv, &set);
    write_to(folder, ".hex", write_hex, &set);
    write_to(folder, ".h", write_header, &set);
    write_manifest_stage(manifest, &set, folder, number == 0);
    vector_set_free(&set);
}

static void write_text(const char *folder, const char *name, void (*write)(FILE *to))
{
    FILE *file = open_file(folder, name, "");
    write(file);
    close_file(file, name);
}

/* Ids have five digits. */
enum { MOST_ROWS = 100000 };

static unsigned rows_of(const char *text)
{
    char *end;
    const unsigned long rows = strtoul(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != 0 || rows == 0 || rows > MOST_ROWS)
        vector_fail("VECTORS", text, "is no number of rows, 1 .. 100000");
    return (unsigned)rows;
}

int main(int argc, char **argv)
{
    if (argc < 2 || argc > 3) {
        fputs("vectors: usage: vectors FOLDER [ROWS]\n", stderr);
        return 2;
    }
    const unsigned rows = argc == 3 ? rows_of(argv[2]) : 0;
    FILE *manifest = open_file(argv[1], "manifest.json", "");
    write_manifest_begin(manifest);
    for (unsigned i = 0; vector_stages[i] != NULL; i++)
        write_stage(manifest, argv[1], i, rows);
    write_manifest_end(manifest);
    close_file(manifest, "manifest.json");
    write_text(argv[1], "fields.tsv", write_fields);
    write_text(argv[1], "STAGES.md", write_tables);
    return 0;
}
