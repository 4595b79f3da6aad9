/*
 * output.c - write beside the target, then rename.
 */
#define _POSIX_C_SOURCE 200809L

#include "output.h"
#include "error.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Picture, palette, report and the copy of standard input. */
#define TEMPORARY_FILES 8

static char *volatile temporaries[TEMPORARY_FILES];

bool is_standard_stream(const char *name)
{
    return strcmp(name, "-") == 0;
}

static void remove_temporaries(void)
{
    for (unsigned i = 0; i < TEMPORARY_FILES; i++) {
        if (temporaries[i] != NULL) {
            unlink(temporaries[i]);
        }
    }
}

/* unlink, signal and raise are safe in a handler. */
static void remove_on_signal(int number)
{
    remove_temporaries();
    signal(number, SIG_DFL);
    raise(number);
}

void remove_at_exit(char *path)
{
    static bool installed = false;
    unsigned slot = 0;
    if (!installed) {
        atexit(remove_temporaries);
        signal(SIGINT, remove_on_signal);
        signal(SIGTERM, remove_on_signal);
        signal(SIGHUP, remove_on_signal);
        signal(SIGXFSZ, SIG_IGN); /* a limit on the size of files: fwrite fails and says so */
        installed = true;
    }
    while (slot + 1 < TEMPORARY_FILES && temporaries[slot] != NULL) {
        slot++;
    }
    temporaries[slot] = path;
}

/* It has its final name, and stays. */
static void forget_temporary(const char *path)
{
    for (unsigned i = 0; i < TEMPORARY_FILES; i++) {
        if (temporaries[i] == path) {
            temporaries[i] = NULL;
        }
    }
}

/* Renaming would replace a device or a pipe by a file. */
static bool written_directly(const char *target)
{
    struct stat status;
    return is_standard_stream(target) || (stat(target, &status) == 0 && !S_ISREG(status.st_mode));
}

/* TARGET.PID.tmp: the same folder, so that rename does not cross file systems. */
static char *temporary_name(const char *target)
{
    size_t bytes = strlen(target) + 32;
    char *name = allocate(bytes, target, NULL);
    snprintf(name, bytes, "%s.%ld.tmp", target, (long)getpid());
    return name;
}

/* O_EXCL: never over a file, nor through a link, that stands there. */
static void open_temporary(output *out)
{
    int descriptor;
    out->temporary = temporary_name(out->target);
    descriptor = open(out->temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (descriptor < 0) {
        system_error(out->target, NULL);
    }
    remove_at_exit(out->temporary);
    out->stream = fdopen(descriptor, "wb");
}

void output_open(output *out, const char *target)
{
    out->target = target;
    out->temporary = NULL;
    if (is_standard_stream(target)) {
        out->stream = stdout;
    } else if (written_directly(target)) {
        out->stream = fopen(target, "wb");
    } else {
        open_temporary(out);
    }
    if (out->stream == NULL) {
        system_error(target, NULL);
    }
}

void output_write(output *out, const void *bytes, size_t count)
{
    if (fwrite(bytes, 1, count, out->stream) != count) {
        system_error(out->target, NULL);
    }
}

void output_commit(output *out)
{
    bool failed = fflush(out->stream) != 0 || ferror(out->stream);
    if (!failed && out->stream != stdout) {
        failed = fclose(out->stream) != 0;
    }
    if (!failed && out->temporary != NULL) {
        failed = rename(out->temporary, out->target) != 0;
    }
    if (failed) {
        system_error(out->target, NULL);
    }
    if (out->temporary != NULL) {
        forget_temporary(out->temporary);
        free(out->temporary);
    }
}
