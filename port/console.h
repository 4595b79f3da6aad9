/*
 * console.h - where a firmware reports. A device family defines console_text.
 */
#ifndef CONSOLE_H
#define CONSOLE_H

#include <stdint.h>

void console_text(const char *text);
void console_decimal(uint32_t number);
void console_hexadecimal(uint32_t number); /* eight digits */

#endif /* CONSOLE_H */
