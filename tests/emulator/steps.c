/*
 * steps.c - counts what a program of this machine executes between its calls of measure_begin
 * and measure_end, instruction by instruction:
 *
 *     steps FILE out=FILE
 *
 * tests/bench/board_steps.c tells them by signals. For every such region, one line in the file
 * out, as of the emulators:
 *     region NUMBER instructions COUNT
 * with a dash for what takes too long to count. The few instructions of the signals are counted
 * too, the same for every region.
 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ptrace.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

/* Instructions of a region: some seconds, as each stops the program. */
#define MOST 40000ul

enum { BEGIN = SIGUSR1, END = SIGUSR2, USAGE_EXIT_CODE = 2, FAULT_EXIT_CODE = 139 };

/* Lets the program run, by one instruction or up to a signal. Returns the signal that stopped it;
   0 where it has ended, with its exit code. */
static int resume(pid_t program, int by_step, int *exit_code)
{
    int state = 0;
    if (ptrace(by_step ? PTRACE_SINGLESTEP : PTRACE_CONT, program, NULL, NULL) != 0 ||
        waitpid(program, &state, 0) != program) {
        perror("steps");
        exit(USAGE_EXIT_CODE);
    }
    if (WIFSTOPPED(state))
        return WSTOPSIG(state);
    *exit_code = WIFEXITED(state) ? WEXITSTATUS(state) : FAULT_EXIT_CODE;
    return 0;
}

static void report_region(FILE *report, unsigned region, unsigned long instructions)
{
    fprintf(report, "region %u instructions ", region);
    if (instructions < MOST)
        fprintf(report, "%lu\n", instructions);
    else
        fprintf(report, "-\n");
}

/* Returns the program's exit code. */
static int count_regions(FILE *report, pid_t program)
{
    unsigned region = 0;
    unsigned long instructions = 0;
    int exit_code = 0, inside = 0, stop;
    while ((stop = resume(program, inside && instructions < MOST, &exit_code)) != 0) {
        if (stop == BEGIN) {
            inside = 1;
            instructions = 0;
        } else if (stop == END) {
            inside = 0;
            report_region(report, region++, instructions);
        } else if (stop == SIGTRAP) {
            instructions++;
        } else {
            fprintf(stderr, "steps: signal %d\n", stop);
            kill(program, SIGKILL);
            return FAULT_EXIT_CODE;
        }
    }
    return exit_code;
}

/* Stops before its first instruction. */
static pid_t start(const char *file)
{
    pid_t program = fork();
    if (program != 0)
        return program;
    if (ptrace(PTRACE_TRACEME, 0, NULL, NULL) == 0)
        execl(file, file, (char *)NULL);
    perror(file);
    _exit(USAGE_EXIT_CODE);
}

int main(int count, char **arguments)
{
    int state;
    if (count != 3 || strncmp(arguments[2], "out=", 4) != 0) {
        fprintf(stderr, "usage: steps FILE out=FILE\n");
        return USAGE_EXIT_CODE;
    }
    FILE *report = fopen(arguments[2] + 4, "w");
    pid_t program = report != NULL ? start(arguments[1]) : -1;
    if (program < 0 || waitpid(program, &state, 0) != program || !WIFSTOPPED(state)) {
        perror("steps");
        return USAGE_EXIT_CODE;
    }
    int exit_code = count_regions(report, program);
    return fclose(report) == 0 ? exit_code : USAGE_EXIT_CODE;
}
