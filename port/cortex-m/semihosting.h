/*
 * semihosting.h - console, command line and exit through the debugger or the
 * emulator ("Semihosting for AArch32 and AArch64", Arm).
 */
#ifndef SEMIHOSTING_H
#define SEMIHOSTING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

void console_text(const char *text);
void console_decimal(uint32_t number);
void console_hexadecimal(uint32_t number); /* eight digits */

/* Ends the program; the emulator exits with the code modulo 256. */
void semihosting_exit(int code) __attribute__((noreturn));

/* Copies the command line, arguments separated by blanks, and ends it with a
   zero. False where it does not fit or the host has none. */
bool semihosting_command_line(char *line, size_t bytes);

#endif /* SEMIHOSTING_H */
