/*
 * measure.c - marks that the plugin tests/emulator/count.c finds by their names. What it tells of
 * the stack means nothing here: no word is stored.
 */
#include "measure.h"

__attribute__((noinline)) void measure_begin(void)
{
    __asm__ volatile("" ::: "memory");
}

__attribute__((noinline)) void measure_end(void)
{
    __asm__ volatile("" ::: "memory");
}
