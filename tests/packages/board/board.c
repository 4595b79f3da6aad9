/*
 * board.c - what an ecosystem brings besides the library, as little as the examples need: reset,
 * the memory functions and a console. For a Cortex-M0 that QEMU emulates, by semihosting.
 */
#include <stddef.h>
#include <stdint.h>

/* Operations of semihosting, and the reason of an exit: the application says so. */
enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20 };
#define ADP_STOPPED_APPLICATION_EXIT 0x20026u

extern uint32_t link_stack_top[], link_bss_start[], link_bss_end[]; /* board.ld */

int main(void);
void reset(void);
int puts(const char *text);
void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memset(void *to, int value, size_t count);

static void call_host(uint32_t operation, const void *parameter)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = parameter;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

int puts(const char *text)
{
    call_host(SYS_WRITE0, text);
    call_host(SYS_WRITE0, "\n");
    return 0;
}

void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    for (size_t i = 0; i < count; i++)
        ((uint8_t *)to)[i] = ((const uint8_t *)from)[i];
    return to;
}

void *memset(void *to, int value, size_t count)
{
    for (size_t i = 0; i < count; i++)
        ((uint8_t *)to)[i] = (uint8_t)value;
    return to;
}

/* Also what a fault does, with the code of an error. */
static void leave(uint32_t code)
{
    const uint32_t block[2] = {ADP_STOPPED_APPLICATION_EXIT, code};
    for (;;)
        call_host(SYS_EXIT_EXTENDED, block);
}

static void fault(void)
{
    leave(1);
}

/* No variable of the examples or of the library begins with a value: board.ld sees to it. */
void reset(void)
{
    for (uint32_t *word = link_bss_start; word < link_bss_end; word++)
        *word = 0;
    leave((uint32_t)main());
}

typedef struct {
    uint32_t *stack_top;
    void (*handler[3])(void); /* reset, non-maskable interrupt, hard fault */
} vectors;

__attribute__((section(".vectors"), used)) static const vectors table = {link_stack_top,
                                                                         {reset, fault, fault}};
