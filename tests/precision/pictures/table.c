#include "pictures.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

enum { cell_bytes = 128 };

/* A cell of both; after the last one the row ends. */
static void put(table *to, const char *text)
{
    const bool last = ++to->filled == to->columns;
    const char *quote = strchr(text, ',') != NULL ? "\"" : "";
    printf("| %s %s", text, last ? "|\n" : "");
    fprintf(to->csv, "%s%s%s%s", quote, text, quote, last ? "\n" : ",");
    to->filled = last ? 0 : to->filled;
}

void table_begin(table *made, const char *folder, const char *name, const char *columns)
{
    char file[cell_bytes];
    (void)snprintf(file, sizeof file, "%s.csv", name);
    made->csv = paper_open(folder, file);
    made->filled = 0;
    made->columns = 1;
    for (const char *c = columns; *c != '\0'; c++) {
        made->columns += *c == '|';
    }
    for (const char *from = columns; from != NULL;) {
        const char *bar = strchr(from, '|');
        char text[cell_bytes];
        const size_t length = bar != NULL ? (size_t)(bar - from) : strlen(from);
        (void)snprintf(text, sizeof text, "%.*s", (int)length, from);
        put(made, text);
        from = bar != NULL ? bar + 1 : NULL;
    }
    for (unsigned i = 0; i < made->columns; i++) {
        printf("|---");
    }
    printf("|\n");
}

void table_text(table *to, const char *text)
{
    put(to, text);
}

void table_number(table *to, const char *format, double number)
{
    char text[cell_bytes];
    (void)snprintf(text, sizeof text, format, number);
    put(to, number == HUGE_VAL ? "exact" : text);
}

void table_error(table *to, const picture_error *error)
{
    table_number(to, "%.3g", error_rms(error));
    table_number(to, "%.3g", error->worst);
    table_number(to, "%.1f", error_psnr(error));
}

void table_end(table *of)
{
    paper_close(of->csv);
    printf("\n");
}

void goal(bool reached, const char *format, ...)
{
    char text[4 * cell_bytes];
    va_list values;
    va_start(values, format);
    (void)vsnprintf(text, sizeof text, format, values);
    va_end(values);
    printf("- %s: %s\n", reached ? "reached" : "MISSED", text);
}

void goals_end(void)
{
    printf("\n");
}
