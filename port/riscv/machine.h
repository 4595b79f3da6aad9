/*
 * machine.h - what only instructions of a RISC-V do.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include <stdint.h>

static inline uint32_t *machine_stack_pointer(void)
{
    uint32_t *pointer;
    __asm__ volatile("mv %0, sp" : "=r"(pointer));
    return pointer;
}

/* A breakpoint between two shifts that do nothing: three uncompressed instructions, which must
   lie on one page ("RISC-V Semihosting", 2). */
static inline uint32_t machine_call_host(uint32_t operation, const volatile void *parameters)
{
    register uint32_t a0 __asm__("a0") = operation;
    register const volatile void *a1 __asm__("a1") = parameters;
    __asm__ volatile(".balign 16\n\t"
                     ".option push\n\t"
                     ".option norvc\n\t"
                     "slli zero, zero, 0x1f\n\t"
                     "ebreak\n\t"
                     "srai zero, zero, 7\n\t"
                     ".option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
    return a0;
}

/* Stops the machine until something happens. */
static inline void machine_wait(void)
{
    __asm__ volatile("wfi");
}

#endif /* MACHINE_H */
