/*
 * startup.c - reset and the vector table of any Cortex-M.
 *
 * Names that begin with `link_` come from toolchain/cortex-m.ld.
 */
#include <stdint.h>
#include "console.h"
#include "memories.h"
#include "semihosting.h"
#include "stack.h"

int main(void);

void reset_handler(void);
void fault_handler(void);

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
            [0] = reset_handler,  /* 1 reset */
            [1] = fault_handler,  /* 2 non-maskable interrupt */
            [2] = fault_handler,  /* 3 hard fault */
            [3] = fault_handler,  /* 4 memory management */
            [4] = fault_handler,  /* 5 bus fault */
            [5] = fault_handler,  /* 6 usage fault */
            [10] = fault_handler, /* 11 supervisor call */
            [11] = fault_handler, /* 12 debug monitor */
            [13] = fault_handler, /* 14 pended service */
            [14] = fault_handler  /* 15 system timer */
        },
};

void fault_handler(void)
{
    console_text("fault\n");
    semihosting_exit(FAULT_EXIT_CODE);
}

/* Where the compiler may use the vector registers, it may use them anywhere, so they are switched
   on before anything else: CPACR, full access to coprocessors 10 and 11 (Armv8-M architecture
   manual, D1.2). */
static void enable_vectors(void)
{
#ifdef __ARM_FEATURE_MVE
    *(volatile uint32_t *)0xE000ED88u |= 0xF00000u;
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
}

/* Apart from reset_handler, which must not save vector registers either. */
__attribute__((noinline, noreturn)) static void start(void)
{
    memories_load();
    stack_paint();
    semihosting_exit(main());
}

void reset_handler(void)
{
    enable_vectors();
    start();
}
