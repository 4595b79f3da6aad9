/*
 * systick.c - the 24-bit timer, made longer by counting its wraps.
 */
#include "systick.h"

/* SysTick registers: Armv6-M and Armv7-M architecture manuals, B3.3. */
#define SYST_CSR (*(volatile uint32_t *)0xE000E010u) /* control and status */
#define SYST_RVR (*(volatile uint32_t *)0xE000E014u) /* reload value */
#define SYST_CVR (*(volatile uint32_t *)0xE000E018u) /* current value, counting down */

enum {
    CSR_ENABLE = 1,
    CSR_INTERRUPT = 2,
    CSR_PROCESSOR_CLOCK = 4,
};

#define PERIOD 0x1000000u /* of the 24-bit counter */

/* Time of one instruction under -icount shift=8, in nanoseconds. */
#define INSTRUCTION_NS 256u

static volatile uint32_t wraps;

void systick_handler(void);

void systick_handler(void)
{
    wraps++;
}

void systick_start(void)
{
    wraps = 0;
    SYST_RVR = PERIOD - 1;
    SYST_CVR = 0; /* any write clears the counter */
    SYST_CSR = CSR_ENABLE | CSR_INTERRUPT | CSR_PROCESSOR_CLOCK;
}

uint64_t systick_ticks(void)
{
    uint32_t before, current;
    do {
        before = wraps;
        current = SYST_CVR;
    } while (wraps != before);
    return (uint64_t)before * PERIOD + (PERIOD - 1 - current);
}

uint32_t systick_instructions(uint64_t ticks)
{
    uint64_t nanoseconds = ticks * (1000000000u / 500000u) / (SYSTICK_HZ / 500000u);
    return (uint32_t)(nanoseconds / INSTRUCTION_NS);
}
