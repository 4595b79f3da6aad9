/*
 * semihosting.h - command line and exit through the debugger or the emulator
 * ("Semihosting for AArch32 and AArch64", Arm, and "RISC-V Semihosting"); so is the
 * console (port/console.h).
 */
#ifndef SEMIHOSTING_H
#define SEMIHOSTING_H

#include <stdbool.h>
#include <stddef.h>

/* Ends the program; the emulator exits with the code modulo 256. */
void semihosting_exit(int code) __attribute__((noreturn));

/* Copies the command line, arguments separated by blanks, and ends it with a
   zero. False where it does not fit or the host has none. */
bool semihosting_command_line(char *line, size_t bytes);

#endif /* SEMIHOSTING_H */
