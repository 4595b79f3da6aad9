/*
 * console.c - the console is standard output.
 */
#include "console.h"

#include <stdio.h>

void console_text(const char *text)
{
    fputs(text, stdout);
}
