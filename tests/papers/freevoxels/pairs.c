/*
 * pairs.c - tables of what comes out in two ways.
 */
#include "freevoxels.h"

void pairs_begin(FILE *table, const char *title, const char *left, const char *right)
{
    fprintf(table, "%s\n\n| what | %s | %s |\n|---|---|---|\n", title, left, right);
}

void pairs_add(FILE *table, const char *what, double left, double right)
{
    fprintf(table, "| %s | %.6f | %.6f |\n", what, left, right);
}
