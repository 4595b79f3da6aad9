/*
 * startup.c - reset and the vector table of any Cortex-M.
 *
 * Names that begin with `link_` come from toolchain/cortex-m.ld.
 */
#include <stdint.h>
#include "console.h"
#include "semihosting.h"
#include "stack.h"

extern const uint32_t link_data_load[];
extern uint32_t link_data_start[], link_data_end[];
extern uint32_t link_bss_start[], link_bss_end[];

int main(void);

void reset_handler(void);
void fault_handler(void);
void systick_handler(void);

/* What a fault returns to the shell: 128 + SIGSEGV, as on a Unix host. */
enum { FAULT_EXIT_CODE = 139 };

enum { SYSTEM_EXCEPTIONS = 15 };

typedef struct {
    uint32_t *stack_top;
    void (*handler[SYSTEM_EXCEPTIONS])(void); /* exceptions 1 .. 15 of the architecture */
} vector_table;

__attribute__((section(".vectors"), used)) static const vector_table vectors = {
    .stack_top = link_stack_top,
    .handler =
        {
            [0] = reset_handler,   /* 1 reset */
            [1] = fault_handler,   /* 2 non-maskable interrupt */
            [2] = fault_handler,   /* 3 hard fault */
            [3] = fault_handler,   /* 4 memory management */
            [4] = fault_handler,   /* 5 bus fault */
            [5] = fault_handler,   /* 6 usage fault */
            [10] = fault_handler,  /* 11 supervisor call */
            [11] = fault_handler,  /* 12 debug monitor */
            [13] = fault_handler,  /* 14 pended service */
            [14] = systick_handler /* 15 system timer */
        },
};

/* A firmware without a timer has no systick_handler of its own. */
__attribute__((weak)) void systick_handler(void)
{
    fault_handler();
}

void fault_handler(void)
{
    console_text("fault\n");
    semihosting_exit(FAULT_EXIT_CODE);
}

static void load_data(void)
{
    const uint32_t *from = link_data_load;
    for (uint32_t *to = link_data_start; to < link_data_end; to++)
        *to = *from++;
    for (uint32_t *to = link_bss_start; to < link_bss_end; to++)
        *to = 0;
}

void reset_handler(void)
{
    load_data();
    stack_paint();
    semihosting_exit(main());
}
