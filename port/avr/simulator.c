/*
 * simulator.c - what a firmware tells the simulator, tests/emulator/avr.c, through
 * registers that mean nothing to the machine.
 */
#include "measure.h"

#include <avr/io.h>
#include <stdlib.h>

void measure_begin(void)
{
    GPIOR1 = 1;
}

void measure_end(void)
{
    GPIOR1 = 0;
}

/* The start-up of avr-libc passes on what main returns. */
void exit(int code)
{
    GPIOR0 = (uint8_t)code;
    for (;;)
        ;
}
