/*
 * board_host.c - what a firmware needs of a board, for this machine: a console, and marks that
 * measure nothing.
 */
#include "console.h"
#include "measure.h"

#include <stdio.h>

void measure_begin(void)
{
}

void measure_end(void)
{
}

void console_text(const char *text)
{
    fputs(text, stdout);
}

void console_decimal(uint32_t number)
{
    printf("%lu", (unsigned long)number);
}
