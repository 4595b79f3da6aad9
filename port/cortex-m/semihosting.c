/*
 * semihosting.c - calls of the host by the breakpoint instruction.
 */
#include "semihosting.h"
#include "console.h"

typedef enum {
    SYS_WRITE0 = 0x04,       /* writes a string */
    SYS_GET_CMDLINE = 0x15,  /* reads the command line */
    SYS_EXIT_EXTENDED = 0x20 /* ends the program with an exit code */
} operation;

/* Reason of an exit: the application says so. */
#define ADP_STOPPED_APPLICATION_EXIT 0x20026u

/* A parameter block is an array of machine words; SYS_WRITE0 takes a string. */
static uint32_t call_host(operation what, const volatile void *parameters)
{
    register uint32_t r0 __asm__("r0") = what;
    register const volatile void *r1 __asm__("r1") = parameters;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void console_text(const char *text)
{
    (void)call_host(SYS_WRITE0, text);
}

bool semihosting_command_line(char *line, size_t bytes)
{
    volatile uint32_t block[2] = {(uint32_t)line, bytes};
    return call_host(SYS_GET_CMDLINE, block) == 0;
}

void semihosting_exit(int code)
{
    volatile uint32_t block[2] = {ADP_STOPPED_APPLICATION_EXIT, (uint32_t)code};
    for (;;)
        (void)call_host(SYS_EXIT_EXTENDED, block);
}
