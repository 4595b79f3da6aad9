/*
 * ways.c - tables of what the library does another way than the paper says, or than one might.
 */
#include "freevoxels.h"

void ways_begin(FILE *table, const char *title)
{
    fprintf(table, "%s\n\n| what | that way | ours |\n|---|---|---|\n", title);
}

void ways_add(FILE *table, const char *what, double that, double ours)
{
    fprintf(table, "| %s | %.6f | %.6f |\n", what, that, ours);
}
