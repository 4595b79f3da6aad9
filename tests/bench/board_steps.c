/*
 * board_steps.c - what a firmware needs of a board, for this machine under tests/emulator/steps.c:
 * a console, and marks that are signals. Only who traces the program sees those.
 */
#include "console.h"
#include "measure.h"

#include <signal.h>
#include <stdio.h>

void measure_begin(void)
{
    signal(SIGUSR1, SIG_IGN);
    signal(SIGUSR2, SIG_IGN);
    raise(SIGUSR1);
}

void measure_end(void)
{
    raise(SIGUSR2);
}

void console_text(const char *text)
{
    fputs(text, stdout);
}

void console_decimal(uint32_t number)
{
    printf("%lu", (unsigned long)number);
}
