/*
 * stack.c - painting the stack and looking for the paint.
 */
#include "stack.h"
#include "machine.h"

/* Unlikely as data, an address or an instruction. */
#define PAINT 0x5AC35AC3u

/* Words left alone: registers that stack_paint saves after it has read the pointer. */
enum { OWN_WORDS = 16 };

void stack_paint(void)
{
    uint32_t *end = machine_stack_pointer() - OWN_WORDS;
    for (volatile uint32_t *word = link_stack_limit; word < end; word++)
        *word = PAINT;
}

uint32_t stack_high_water(void)
{
    const uint32_t *word = link_stack_limit;
    while (word < link_stack_top && *word == PAINT)
        word++;
    return (uint32_t)(link_stack_top - word) * (uint32_t)sizeof *word;
}
