/*
 * semihosting.c - calls of the host through the debugger or the emulator.
 */
#include "semihosting.h"
#include "console.h"
#include "machine.h"

/* Operations. */
enum {
    SYS_WRITE0 = 0x04,       /* writes a string */
    SYS_GET_CMDLINE = 0x15,  /* reads the command line */
    SYS_EXIT_EXTENDED = 0x20 /* ends the program with an exit code */
};

/* Reason of an exit: the application says so. */
#define ADP_STOPPED_APPLICATION_EXIT 0x20026u

/* Parameters are an array of machine words; SYS_WRITE0 takes the string itself. */
void console_text(const char *text)
{
    (void)machine_call_host(SYS_WRITE0, text);
}

bool semihosting_command_line(char *line, size_t bytes)
{
    volatile uint32_t block[2] = {(uint32_t)line, bytes};
    return machine_call_host(SYS_GET_CMDLINE, block) == 0;
}

void semihosting_exit(int code)
{
    volatile uint32_t block[2] = {ADP_STOPPED_APPLICATION_EXIT, (uint32_t)code};
    for (;;)
        (void)machine_call_host(SYS_EXIT_EXTENDED, block);
}
