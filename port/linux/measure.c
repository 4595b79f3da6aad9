/*
 * measure.c - marks that the plugin tests/emulator/count.c finds by their names. Each stores the
 * word below the caller's stack pointer, so that a plugin that sees addresses but no registers
 * learns it: the word's address + 4. On x86 that is a part of the return address, which stays.
 */
#include "measure.h"

#if defined(__x86_64__)
#define STORE_WORD "movl 4(%%rsp), %%eax\n\tmovl %%eax, 4(%%rsp)"
#define SPOILED    "eax", "memory"
#elif defined(__i386__)
#define STORE_WORD "movl (%%esp), %%eax\n\tmovl %%eax, (%%esp)"
#define SPOILED    "eax", "memory"
#elif defined(__powerpc__)
#define STORE_WORD "stw 0, -4(1)"
#define SPOILED    "memory"
#else
#error "how is a word stored below the caller's stack pointer?"
#endif

__attribute__((noinline)) void measure_begin(void)
{
    __asm__ volatile(STORE_WORD ::: SPOILED);
}

__attribute__((noinline)) void measure_end(void)
{
    __asm__ volatile(STORE_WORD ::: SPOILED);
}
