/*
 * avr.c - runs a firmware on a simulated AVR, exact to the cycle, with libsimavr:
 *
 *     avr MACHINE [out=FILE] FILE.elf
 *
 * The first serial port is standard output. The firmware ends the run by writing its
 * exit code to GPIOR0, and marks what is measured by writing 1, then 0 to GPIOR1
 * (port/avr/simulator.c). For every such region, one line in the file out:
 *     region NUMBER instructions COUNT cycles COUNT ram BYTES stack BYTES
 * RAM is what data and stack have taken since the reset; the stack is counted downwards
 * from the caller of measure_begin.
 */
#include <fcntl.h>
#include <gelf.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_io.h>

/* Addresses of an ATmega1284P's registers as data. */
enum { GPIOR0 = 0x3E, GPIOR1 = 0x4A, SPL = 0x5D, SPH = 0x5E };

/* What a call pushes in 128 KB of flash. */
enum { RETURN_ADDRESS = 2 };

/* Where linkers put RAM, which starts without contents, beside the flash. */
#define RAM_BASE 0x800000u

/* What RAM holds until it is written. */
enum { PAINT = 0xA5 };

/* What a fault returns to the shell, as the Cortex-M firmware does: 128 + SIGSEGV. */
enum { FAULT_EXIT_CODE = 139, USAGE_EXIT_CODE = 2 };

#define CLOCK_HZ 16000000u

/* Cycles of a call of the simulator. One of them is one instruction, so that instructions can be
   counted; more take half the time. */
#define CYCLES_A_CALL 10000

typedef struct {
    FILE *report; /* NULL where none is wanted */
    unsigned region;
    uint64_t instructions; /* since the reset, where there is a report */
    uint64_t instructions_at_begin;
    avr_cycle_count_t cycles_at_begin;
    unsigned free_first; /* of what lies between the data and the stack */
    unsigned stack_start;
    unsigned ram_before; /* used until the region began, which paints what is free */
    bool ended;
    int exit_code;
} run;

static void put_character(struct avr_irq_t *irq, uint32_t value, void *parameter)
{
    (void)irq;
    (void)parameter;
    putchar((int)value);
}

static void end_run(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *parameter)
{
    run *r = parameter;
    (void)avr;
    (void)address;
    r->ended = true;
    r->exit_code = value;
}

/* The longest stretch that was never written: what lies between the data and the deepest
   stack. Returns its length. */
static unsigned find_free(unsigned *first_free, const avr_t *avr)
{
    unsigned longest = 0, stretch = 0, first = avr->ioend + 1u;
    for (unsigned address = first; address <= avr->ramend; address++) {
        stretch = avr->data[address] == PAINT ? stretch + 1 : 0;
        if (stretch > longest) {
            longest = stretch;
            *first_free = address + 1 - stretch;
        }
    }
    return longest;
}

static unsigned ram_used(const avr_t *avr)
{
    unsigned first_free = 0;
    return avr->ramend - avr->ioend - find_free(&first_free, avr);
}

/* Called in measure_begin. The stack pointer is the first free byte below the stack. */
static void begin(avr_t *avr, run *r)
{
    unsigned used = ram_used(avr);
    unsigned pointer = avr->data[SPL] | (unsigned)avr->data[SPH] << 8;
    r->ram_before = used > r->ram_before ? used : r->ram_before;
    find_free(&r->free_first, avr);
    memset(avr->data + r->free_first, PAINT, pointer + 1 - r->free_first);
    r->stack_start = pointer + RETURN_ADDRESS;
    r->instructions_at_begin = r->instructions;
    r->cycles_at_begin = avr->cycle;
}

static void end(const avr_t *avr, run *r)
{
    unsigned lowest = r->free_first, used = ram_used(avr);
    while (lowest <= r->stack_start && avr->data[lowest] == PAINT)
        lowest++;
    fprintf(r->report, "region %u instructions %" PRIu64 " cycles %" PRIu64 " ram %u stack %u\n",
            r->region++, r->instructions - r->instructions_at_begin,
            avr->cycle - r->cycles_at_begin, used > r->ram_before ? used : r->ram_before,
            r->stack_start + 1 - lowest);
}

static void mark(struct avr_t *avr, avr_io_addr_t address, uint8_t value, void *parameter)
{
    run *r = parameter;
    (void)address;
    if (value != 0)
        begin(avr, r);
    else if (r->report != NULL)
        end(avr, r);
}

static void log_errors(struct avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR)
        vfprintf(stderr, format, arguments);
}

/* Loads every segment of the file that has contents where a programmer puts it; the
   simulator's own loader knows sections of some names alone. */
static bool load_segments(avr_t *avr, Elf *elf)
{
    size_t count, size;
    char *image = elf_rawfile(elf, &size);
    if (image == NULL || elf_getphdrnum(elf, &count) != 0)
        return false;
    for (size_t i = 0; i < count; i++) {
        GElf_Phdr segment;
        if (gelf_getphdr(elf, (int)i, &segment) == NULL)
            return false;
        if (segment.p_type != PT_LOAD || segment.p_filesz == 0)
            continue;
        if (segment.p_offset > size || segment.p_filesz > size - segment.p_offset ||
            segment.p_paddr >= RAM_BASE || segment.p_paddr + segment.p_filesz > avr->flashend + 1)
            return false;
        avr_loadcode(avr, (uint8_t *)image + segment.p_offset, (uint32_t)segment.p_filesz,
                     (avr_flashaddr_t)segment.p_paddr);
    }
    avr->codeend = avr->flashend;
    return true;
}

static bool load_file(avr_t *avr, const char *name)
{
    int file = open(name, O_RDONLY);
    if (file < 0 || elf_version(EV_CURRENT) == EV_NONE)
        return false;
    Elf *elf = elf_begin(file, ELF_C_READ, NULL);
    bool loaded = elf != NULL && load_segments(avr, elf);
    elf_end(elf);
    close(file);
    return loaded;
}

/* NULL where there is no such machine or file. */
static avr_t *power_up(const char *machine, const char *file)
{
    avr_t *avr = avr_make_mcu_by_name(machine);
    if (avr == NULL)
        return NULL;
    avr_init(avr);
    avr->frequency = CLOCK_HZ;
    memset(avr->data + avr->ioend + 1, PAINT, (size_t)avr->ramend - avr->ioend);
    return load_file(avr, file) ? avr : NULL;
}

/* The port's own output to the terminal, and its naps while it is polled, are off. */
static void connect(avr_t *avr, run *r)
{
    uint32_t flags = 0;
    avr_ioctl(avr, AVR_IOCTL_UART_GET_FLAGS('0'), &flags);
    flags &= ~(uint32_t)(AVR_UART_FLAG_STDIO | AVR_UART_FLAG_POLL_SLEEP);
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT),
                            put_character, r);
    avr_register_io_write(avr, GPIOR0, end_run, r);
    avr_register_io_write(avr, GPIOR1, mark, r);
}

static int execute(avr_t *avr, run *r)
{
    while (!r->ended) {
        int state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed) {
            fprintf(stderr, "avr: fault at 0x%x\n", (unsigned)avr->pc);
            return FAULT_EXIT_CODE;
        }
        r->instructions++;
    }
    return r->exit_code;
}

int main(int count, char **arguments)
{
    run r = {.report = NULL};
    bool reports = count == 4 && strncmp(arguments[2], "out=", 4) == 0;
    if (count != 3 && !reports) {
        fprintf(stderr, "usage: avr MACHINE [out=FILE] FILE.elf\n");
        return USAGE_EXIT_CODE;
    }
    if (reports && (r.report = fopen(arguments[2] + 4, "w")) == NULL) {
        perror(arguments[2] + 4);
        return USAGE_EXIT_CODE;
    }
    avr_global_logger_set(log_errors);
    const char *file = arguments[count - 1];
    avr_t *avr = power_up(arguments[1], file);
    if (avr == NULL) {
        fprintf(stderr, "avr: cannot run %s on %s\n", file, arguments[1]);
        return USAGE_EXIT_CODE;
    }
    connect(avr, &r);
    avr->run_cycle_limit = reports ? 1 : CYCLES_A_CALL;
    int code = execute(avr, &r);
    avr_terminate(avr);
    if (r.report != NULL && fclose(r.report) != 0)
        code = USAGE_EXIT_CODE;
    return fflush(stdout) == 0 ? code : USAGE_EXIT_CODE;
}
