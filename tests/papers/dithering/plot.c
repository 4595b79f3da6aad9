/*
 * plot.c - what a figure's program hands to gnuplot, and the lines of numbers.txt.
 */
#include "dithering.h"

#include <math.h>

double worst_of(const double *errors, uint32_t slices)
{
    double worst = 0;
    for (uint32_t n = 0; n <= slices; n++) {
        if (fabs(errors[n]) > fabs(worst)) {
            worst = errors[n];
        }
    }
    return worst;
}

static void write_row(FILE *data, const plot *of, const double (*columns)[REF_FOG_SLICES_MAX + 1],
                      uint32_t n)
{
    for (int c = 0; c < CURVES; c++) {
        if (of->shown & SHOWS(c)) {
            fprintf(data, " %.4f", columns[c][n]);
        } else {
            fputs(" -", data);
        }
    }
}

/* The file begins with the columns' names, "-" for a curve that is not shown. */
void write_plot(const char *folder, FILE *index, const figure_text *text, const plot *of)
{
    char name[64];
    (void)snprintf(name, sizeof name, "figure%02d.dat", text->number);
    FILE *data = paper_open(folder, name);
    fputs("slices", data);
    for (int c = 0; c < CURVES; c++) {
        fprintf(data, " \"%s\"", of->shown & SHOWS(c) ? of->names[c] : "-");
    }
    fputc('\n', data);
    for (uint32_t n = 0; n <= of->slices; n++) {
        fprintf(data, "%u", (unsigned)n);
        write_row(data, of, of->values, n);
        write_row(data, of, of->errors, n);
        fputc('\n', data);
    }
    paper_close(data);
    fprintf(index, "figure%02d|%s|%s|%s\n", text->number, text->kind, text->title, text->caption);
}

void numbers_add(FILE *numbers, const char *place, const char *what, const char *paper,
                 double computed)
{
    fprintf(numbers, "| %-10s | %-58s | %8s | %8.2f |\n", place, what, paper, computed);
}
