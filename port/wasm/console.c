/*
 * console.c - the console is a function that run.mjs offers: it takes a text by address and
 * length in the module's memory.
 */
#include "console.h"

__attribute__((import_module("console"), import_name("write"))) void console_write(const char *text,
                                                                                   uint32_t length);

void console_text(const char *text)
{
    uint32_t length = 0;
    while (text[length] != '\0')
        length++;
    console_write(text, length);
}
