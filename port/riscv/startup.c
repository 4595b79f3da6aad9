/*
 * startup.c - reset of any RISC-V in machine mode.
 *
 * Names that begin with `link_` come from toolchain/riscv.ld.
 */
#include <stdint.h>
#include "console.h"
#include "memories.h"
#include "semihosting.h"
#include "stack.h"

int main(void);

void reset_handler(void);
void start(void);
void fault_handler(void);

/* What a fault returns to the shell: 128 + SIGSEGV, as on a Unix host. */
enum { FAULT_EXIT_CODE = 139 };

/* Four bytes: the lowest two bits of the trap vector tell its mode. */
__attribute__((aligned(4))) void fault_handler(void)
{
    console_text("fault\n");
    semihosting_exit(FAULT_EXIT_CODE);
}

void start(void)
{
    memories_load();
    stack_paint();
    semihosting_exit(main());
}

/* The instructions that write control registers are an extension with a name of its own since
   2019; to name it for the whole file would choose other libraries. */
__attribute__((naked, section(".reset"))) void reset_handler(void)
{
    __asm__ volatile("la sp, link_stack_top\n\t"
                     "la t0, fault_handler\n\t"
                     ".option push\n\t"
                     ".option arch, +zicsr\n\t"
                     "csrw mtvec, t0\n\t"
                     ".option pop\n\t"
                     "j start");
}
