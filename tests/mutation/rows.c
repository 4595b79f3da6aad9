/*
 * rows.c - computes the rows of the test vectors, and tells at the first stage that has others.
 *
 * rows                      prints a line for each stage: its name and a hash of all its rows
 * rows FILE [STAGE ...]     compares with such lines; these stages first. Prints the first one
 *                           that differs and exits with 1, or exits with 0
 */
#include "vector.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

/* All stages together take less than half a second and 64 MiB. What a mutant makes of them may
   not end, and may want all memory that there is. */
enum { SECONDS = 5, MEBIBYTES = 1024 };

static void set_limits(void)
{
    const struct rlimit time = {SECONDS, SECONDS};
    const struct rlimit memory = {(rlim_t)MEBIBYTES << 20, (rlim_t)MEBIBYTES << 20};
    if (setrlimit(RLIMIT_CPU, &time) != 0 || setrlimit(RLIMIT_AS, &memory) != 0)
        vector_fail("rows", "limits", "cannot be set");
}

/* FNV-1a, 64 bits. */
#define HASH_START UINT64_C(0xCBF29CE484222325)
#define HASH_PRIME UINT64_C(0x100000001B3)

static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    for (size_t i = 0; i < count; i++)
        hash = (hash ^ byte[i]) * HASH_PRIME;
    return hash;
}

static uint64_t hash_rows(const vector_stage *stage)
{
    vector_set set;
    vector_set_make(&set, stage, 0);
    size_t numbers = (size_t)set.count * stage->columns;
    uint64_t hash = hash_bytes(HASH_START, set.columns, numbers * sizeof *set.columns);
    hash = hash_bytes(hash, set.flags, set.count);
    vector_set_free(&set);
    return hash;
}

static uint64_t expected_hash(const char *path, const char *name)
{
    FILE *file = fopen(path, "r");
    char line_name[64];
    uint64_t hash = 0;
    while (file != NULL && fscanf(file, "%63s %" SCNx64, line_name, &hash) == 2)
        if (strcmp(line_name, name) == 0) {
            fclose(file);
            return hash;
        }
    vector_fail(name, path, "does not have it");
}

static void compare(const vector_stage *stage, const char *path)
{
    if (hash_rows(stage) != expected_hash(path, stage->name)) {
        puts(stage->name);
        exit(1);
    }
}

static int is_first(char **names, const char *name)
{
    while (*names != NULL)
        if (strcmp(*names++, name) == 0)
            return 1;
    return 0;
}

int main(int argc, char **argv)
{
    set_limits();
    if (argc < 2) {
        for (unsigned i = 0; vector_stages[i] != NULL; i++)
            printf("%s %016" PRIx64 "\n", vector_stages[i]->name, hash_rows(vector_stages[i]));
        return 0;
    }
    for (int first = 1; first >= 0; first--)
        for (unsigned i = 0; vector_stages[i] != NULL; i++)
            if (is_first(argv + 2, vector_stages[i]->name) == first)
                compare(vector_stages[i], argv[1]);
    return 0;
}
