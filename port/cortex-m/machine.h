/*
 * machine.h - what only instructions of a Cortex-M do.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include <stdint.h>

static inline uint32_t *machine_stack_pointer(void)
{
    uint32_t *pointer;
    __asm__ volatile("mov %0, sp" : "=r"(pointer));
    return pointer;
}

/* The breakpoint instruction with the number that Arm keeps for semihosting. */
static inline uint32_t machine_call_host(uint32_t operation, const volatile void *parameters)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const volatile void *r1 __asm__("r1") = parameters;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

/* Stops the machine until something happens. */
static inline void machine_wait(void)
{
    __asm__ volatile("wfi");
}

#endif /* MACHINE_H */
