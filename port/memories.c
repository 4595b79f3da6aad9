/*
 * memories.c - what start-up code does to RAM before main.
 */
#include "memories.h"

#include <stdint.h>

extern const uint32_t link_data_load[];
extern uint32_t link_data_start[], link_data_end[];
extern uint32_t link_bss_start[], link_bss_end[];

void memories_load(void)
{
    const uint32_t *from = link_data_load;
    for (uint32_t *to = link_data_start; to < link_data_end; to++)
        *to = *from++;
    for (uint32_t *to = link_bss_start; to < link_bss_end; to++)
        *to = 0;
}
