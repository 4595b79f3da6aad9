/*
 * count.c - a QEMU plugin that counts what happens between a firmware's calls
 * of measure_begin and measure_end (port/measure.h).
 *
 * For every such region, one line in the file given as out=FILE:
 *     region NUMBER instructions COUNT stack BYTES
 * followed, with functions=on, by one line for each function that ran there:
 *     function COUNT NAME
 * The stack is counted downwards from the caller of measure_begin.
 *
 * The few declarations of the plugin interface (version 1, QEMU 5.2 to 8.x;
 * docs/devel/tcg-plugins.rst there) are repeated here, since Debian does not
 * package qemu-plugin.h.
 */
#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t qemu_plugin_id_t;
typedef uint32_t qemu_plugin_meminfo_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;

typedef void translation_callback(qemu_plugin_id_t, struct qemu_plugin_tb *);
typedef void execution_callback(unsigned cpu, void *data);
typedef void memory_callback(unsigned cpu, qemu_plugin_meminfo_t, uint64_t address, void *data);
typedef void exit_callback(qemu_plugin_id_t, void *data);

void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t, translation_callback *);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *, size_t);
const char *qemu_plugin_insn_symbol(const struct qemu_plugin_insn *);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *, execution_callback *,
                                            int flags, void *data);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *, int operation,
                                                void *counter, uint64_t addend);
void qemu_plugin_register_vcpu_mem_cb(struct qemu_plugin_insn *, memory_callback *, int flags,
                                      int access, void *data);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t, exit_callback *, void *data);

extern int qemu_plugin_version;
int qemu_plugin_install(qemu_plugin_id_t, const void *info, int count, char **options);

int qemu_plugin_version = 1;

enum { INLINE_ADD_U64 = 0, CALLBACK_NO_REGISTERS = 0, ACCESS_WRITE = 2 };

/* Translated code holds the addresses of the counters, so they never move. */
enum { FUNCTIONS_MAX = 4096, NAME_BYTES = 64 };

typedef struct {
    char name[NAME_BYTES];
    uint64_t executed;
    uint64_t at_begin;
} function_count;

static function_count functions[FUNCTIONS_MAX];
static size_t function_total;
static uint64_t executed;

static FILE *report;
static bool list_functions;

/* The region that is being measured. */
static unsigned region;
static bool measuring;
static bool stack_known; /* measure_begin has stored its word */
static uint64_t executed_at_begin;
static uint64_t stack_start;
static uint64_t stack_lowest;

/* How far below the caller a write still counts as stack, rather than data. */
enum { STACK_REACH = 2048, WORD_BYTES = 4 };

static function_count *find_function(const char *name)
{
    if (name == NULL)
        name = "(no symbol)";
    for (size_t i = 0; i < function_total; i++) {
        if (strncmp(functions[i].name, name, NAME_BYTES - 1) == 0)
            return &functions[i];
    }
    if (function_total == FUNCTIONS_MAX) {
        fprintf(stderr, "count: more than %d functions\n", FUNCTIONS_MAX);
        exit(EXIT_FAILURE);
    }
    function_count *added = &functions[function_total++];
    snprintf(added->name, NAME_BYTES, "%s", name);
    return added;
}

static void begin(unsigned cpu, void *data)
{
    (void)cpu;
    (void)data;
    measuring = true;
    stack_known = false;
    for (size_t i = 0; i < function_total; i++)
        functions[i].at_begin = functions[i].executed;
    executed_at_begin = executed;
}

static int by_count(const void *left, const void *right)
{
    const function_count *l = *(function_count *const *)left;
    const function_count *r = *(function_count *const *)right;
    uint64_t of_l = l->executed - l->at_begin;
    uint64_t of_r = r->executed - r->at_begin;
    return (of_l < of_r) - (of_l > of_r);
}

static void print_functions(void)
{
    static const function_count *sorted[FUNCTIONS_MAX];
    for (size_t i = 0; i < function_total; i++)
        sorted[i] = &functions[i];
    qsort(sorted, function_total, sizeof *sorted, by_count);
    for (size_t i = 0; i < function_total; i++) {
        uint64_t count = sorted[i]->executed - sorted[i]->at_begin;
        if (count > 0)
            fprintf(report, "function %" PRIu64 " %s\n", count, sorted[i]->name);
    }
}

static void end(unsigned cpu, void *data)
{
    (void)cpu;
    (void)data;
    if (!measuring)
        return;
    measuring = false;
    fprintf(report, "region %u instructions %" PRIu64 " stack %" PRIu64 "\n", region++,
            executed - executed_at_begin, stack_start - stack_lowest);
    if (list_functions)
        print_functions();
}

static void written(unsigned cpu, qemu_plugin_meminfo_t info, uint64_t address, void *data)
{
    (void)cpu;
    (void)info;
    (void)data;
    if (!measuring)
        return;
    if (!stack_known) { /* measure_begin's own */
        stack_known = true;
        stack_start = address + WORD_BYTES;
        stack_lowest = stack_start;
    } else if (address < stack_lowest && stack_start - address <= STACK_REACH) {
        stack_lowest = address;
    }
}

static void translate(qemu_plugin_id_t id, struct qemu_plugin_tb *block)
{
    (void)id;
    size_t count = qemu_plugin_tb_n_insns(block);
    for (size_t i = 0; i < count; i++) {
        struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(block, i);
        function_count *function = find_function(qemu_plugin_insn_symbol(instruction));
        if (i == 0 && strcmp(function->name, "measure_begin") == 0)
            qemu_plugin_register_vcpu_insn_exec_cb(instruction, begin, CALLBACK_NO_REGISTERS, NULL);
        if (i == 0 && strcmp(function->name, "measure_end") == 0)
            qemu_plugin_register_vcpu_insn_exec_cb(instruction, end, CALLBACK_NO_REGISTERS, NULL);
        qemu_plugin_register_vcpu_insn_exec_inline(instruction, INLINE_ADD_U64, &executed, 1);
        qemu_plugin_register_vcpu_insn_exec_inline(instruction, INLINE_ADD_U64, &function->executed,
                                                   1);
        qemu_plugin_register_vcpu_mem_cb(instruction, written, CALLBACK_NO_REGISTERS, ACCESS_WRITE,
                                         NULL);
    }
}

static void finish(qemu_plugin_id_t id, void *data)
{
    (void)id;
    (void)data;
    if (fclose(report) != 0)
        perror("count: report");
}

static bool read_option(const char *option)
{
    if (strncmp(option, "out=", 4) == 0 && report == NULL) {
        report = fopen(option + 4, "w");
        return report != NULL;
    }
    if (strcmp(option, "functions=on") == 0) {
        list_functions = true;
        return true;
    }
    return false;
}

int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int count, char **options)
{
    (void)info;
    for (int i = 0; i < count; i++) {
        if (!read_option(options[i])) {
            fprintf(stderr, "count: cannot use option %s\n", options[i]);
            return -1;
        }
    }
    if (report == NULL) {
        fprintf(stderr, "count: out=FILE is missing\n");
        return -1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
    qemu_plugin_register_atexit_cb(id, finish, NULL);
    return 0;
}
