#include "csv.h"

#include <stdarg.h>
#include <string.h>

/* Cuts a line at its commas, and returns the number of its parts. */
static unsigned split(char *line, const char *part[], unsigned limit)
{
    unsigned count = 0;
    line[strcspn(line, "\r\n")] = '\0';
    while (line != NULL) {
        if (count == limit)
            fail("a line has more than %u values", limit);
        part[count++] = line;
        line = strchr(line, ',');
        if (line != NULL)
            *line++ = '\0';
    }
    return count;
}

static unsigned split_line(csv *c, char *line, const char *field[])
{
    const char *part[FIELDS_MAX + 2];
    const unsigned count = split(line, part, FIELDS_MAX + 2);
    if (count < 2)
        fail("a line without id and flags");
    c->id = part[0];
    c->flags = part[1];
    memcpy(field, part + 2, (count - 2) * sizeof *part);
    return count - 2;
}

/* False at the end of the file. */
static bool read_line(csv *c, char *line)
{
    if (fgets(line, LINE_BYTES, c->from) == NULL)
        return false;
    if (strlen(line) == LINE_BYTES - 1)
        fail("a line of more than %d bytes", LINE_BYTES - 2);
    return true;
}

void csv_open(csv *c, FILE *from, FILE *to)
{
    *c = (csv){.from = from, .to = to};
    if (!read_line(c, c->header))
        fail("an empty file");
    fputs(c->header, to);
    c->fields = split_line(c, c->header, c->name);
}

bool csv_next(csv *c)
{
    if (!read_line(c, c->line))
        return false;
    const unsigned count = split_line(c, c->line, c->text);
    numbers_at(c->id);
    if (count != c->fields)
        fail("%u fields, where the header has %u", count, c->fields);
    memset(c->result, 0, sizeof c->result);
    return true;
}

void csv_write(csv *c)
{
    fprintf(c->to, "%s,%s", c->id, c->flags);
    for (unsigned i = 0; i < c->fields; i++) {
        if (c->role[i] != ROLE_RESULT) {
            fprintf(c->to, ",%s", c->text[i]);
        } else {
            if (c->result[i] == NULL)
                fail("%s is not computed", c->name[i]);
            gmp_fprintf(c->to, ",%Zd", c->result[i]);
        }
    }
    fputc('\n', c->to);
    c->rows++;
}

void csv_close(csv *c)
{
    for (unsigned i = 0; i < c->fields; i++)
        if (c->role[i] == ROLE_UNKNOWN)
            fail("%s is neither read nor computed", c->name[i]);
    if (fflush(c->to) != 0 || ferror(c->from) || ferror(c->to))
        fail("an error of the file system");
}

static int find(const csv *c, const char *name)
{
    for (unsigned i = 0; i < c->fields; i++)
        if (strcmp(c->name[i], name) == 0)
            return (int)i;
    return -1;
}

static unsigned find_format(const csv *c, const char *format, va_list arguments)
{
    char name[NAME_BYTES];
    vsnprintf(name, sizeof name, format, arguments);
    const int i = find(c, name);
    if (i < 0)
        fail("there is no field %s", name);
    return (unsigned)i;
}

number in(csv *c, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const unsigned i = find_format(c, format, arguments);
    va_end(arguments);
    if (c->role[i] == ROLE_RESULT)
        fail("%s is a result and read", c->name[i]);
    c->role[i] = ROLE_INPUT;
    number value = parse(c->text[i]);
    if (value == NULL)
        fail("%s is no number: \"%s\"", c->name[i], c->text[i]);
    return value;
}

void out(csv *c, number value, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const unsigned i = find_format(c, format, arguments);
    va_end(arguments);
    /* Rows before it have been written as if it were none. */
    if (c->role[i] == ROLE_INPUT || (c->role[i] == ROLE_UNKNOWN && c->rows > 0))
        fail("%s is a result, and was none before", c->name[i]);
    c->role[i] = ROLE_RESULT;
    c->result[i] = value;
}
