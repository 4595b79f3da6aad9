/*
 * options.c - getopt_long over the table of options.
 */
#define _POSIX_C_SOURCE 200809L

#include "options.h"
#include "error.h"
#include "output.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define OPTIONS_MOST 80
/* Values of getopt_long beyond those of letters. */
#define HELP_VALUE    1000
#define VERSION_VALUE 1001
#define FIRST_VALUE   1002

static bool is_optional(const struct option_spec *spec)
{
    return spec->argument != NULL && spec->argument[0] == '[';
}

static int argument_kind(const struct option_spec *spec)
{
    if (spec->argument == NULL) {
        return no_argument;
    }
    return is_optional(spec) ? optional_argument : required_argument;
}

/* The table of getopt_long for a command, and its string of letters. */
static void make_table(struct option table[OPTIONS_MOST], char letters[OPTIONS_MOST], int groups)
{
    struct option *entry = table;
    char *letter = letters;
    *letter++ = ':'; /* tells a missing argument from an unknown option */
    *letter++ = 'h';
    *entry++ = (struct option){"help", no_argument, NULL, HELP_VALUE};
    *entry++ = (struct option){"version", no_argument, NULL, VERSION_VALUE};
    for (int i = 0; option_specs[i].name != NULL; i++) {
        const struct option_spec *spec = &option_specs[i];
        if ((spec->group & groups) == 0) {
            continue;
        }
        *entry++ = (struct option){spec->name, argument_kind(spec), NULL, FIRST_VALUE + i};
        if (spec->letter != 0) {
            *letter++ = spec->letter;
        }
        if (spec->letter != 0 && spec->argument != NULL) {
            *letter++ = ':';
        }
    }
    *entry = (struct option){NULL, 0, NULL, 0};
    *letter = '\0';
}

/* The value is an index for long options, a letter for short ones; getopt_long
   returns none that the table lacks. */
static const struct option_spec *spec_of(int value)
{
    const struct option_spec *spec = option_specs;
    if (value >= FIRST_VALUE) {
        return &option_specs[value - FIRST_VALUE];
    }
    while (spec->letter != value) {
        spec++;
    }
    return spec;
}

/* What getopt_long refused: a letter may stand amid others in one word. */
static void refuse_option(int value, char **argv) __attribute__((noreturn));
static void refuse_option(int value, char **argv)
{
    const char letter[] = {'-', (char)optopt, '\0'};
    bool is_letter = optopt > 0 && optopt < HELP_VALUE;
    usage_error(is_letter ? letter : argv[optind - 1],
                value == ':' ? "needs a value" : "unknown, ambiguous or with a value too many");
}

static void read_option(struct settings *settings, const struct command *command, int value,
                        char **argv)
{
    char option[64];
    const struct option_spec *spec;
    if (value == HELP_VALUE || value == 'h') {
        print_help(command);
    }
    if (value == VERSION_VALUE) {
        print_version();
    }
    if (value == '?' || value == ':') {
        refuse_option(value, argv);
    }
    spec = spec_of(value);
    snprintf(option, sizeof option, "--%s", spec->name);
    spec->set(settings, option, optarg);
}

static void set_defaults(struct settings *settings)
{
    memset(settings, 0, sizeof *settings);
    settings->size[0] = settings->size[1] = 512;
    settings->light[0] = -40;
    settings->light[1] = 40;
    settings->zoom = 1;
    settings->step = 1;
    settings->termination = -1;
    settings->background[3] = 255;
    settings->gain = 16;
    settings->cache.page[0] = settings->cache.page[1] = settings->cache.page[2] = 8;
}

void options_read(struct settings *settings, const struct command *command, int argc, char **argv)
{
    struct option table[OPTIONS_MOST];
    char letters[OPTIONS_MOST];
    int value;
    set_defaults(settings);
    make_table(table, letters, command->groups);
    opterr = 0;
    while ((value = getopt_long(argc, argv, letters, table, NULL)) != -1) {
        read_option(settings, command, value, argv);
    }
    settings_check_needs(settings, command->groups);
    settings->operand_count = argc - optind;
    if (settings->operand_count != command->operands) {
        usage_error("operands", "%d given, usage: %s %s", settings->operand_count, command->name,
                    command->synopsis);
    }
    for (int i = 0; i < settings->operand_count; i++) {
        settings->operands[i] = argv[optind + i];
        if (settings->operands[i][0] == '\0') {
            usage_error("operands", "the name of number %d is empty", i + 1);
        }
    }
}

void finish_output(void)
{
    if (fflush(stdout) != 0 || ferror(stdout)) {
        system_error("standard output", NULL);
    }
    exit(EXIT_SUCCESS);
}

/* A line of help; "[FILE]" is shown as it is typed: --json[=FILE]. */
static void print_option(const struct option_spec *spec)
{
    char text[64];
    const char *equals = is_optional(spec) ? "[=" : " ";
    const char *argument = spec->argument != NULL ? spec->argument : "";
    snprintf(text, sizeof text, "--%s%s%s", spec->name, spec->argument != NULL ? equals : "",
             argument + (is_optional(spec) ? 1 : 0));
    if (spec->letter != 0) {
        printf("  -%c, %-24s %s\n", spec->letter, text, spec->help);
    } else {
        printf("      %-24s %s\n", text, spec->help);
    }
}

void print_help(const struct command *command)
{
    printf("Usage: %s %s\n%s\n\n", command->name, command->synopsis, command->summary);
    for (const struct option_spec *spec = option_specs; spec->name != NULL; spec++) {
        if ((spec->group & command->groups) != 0) {
            print_option(spec);
        }
    }
    printf("  -h, %-24s %s\n", "--help", "this text");
    printf("      %-24s %s\n", "--version", "the version");
    if (command->details != NULL) {
        printf("\n%s", command->details);
    }
    finish_output();
}

void print_version(void)
{
    printf("qvol %s\n", qv_version());
    finish_output();
}
