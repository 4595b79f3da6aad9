/*
 * output.c - write beside the target, then rename.
 */
#define _XOPEN_SOURCE 700 /* realpath */

#include "output.h"
#include "error.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

/* Picture, palette, report and the copy of standard input. */
#define TEMPORARY_FILES 8
/* "qvol-PID-N.tmp": two numbers of at most 20 digits. */
#define TEMPORARY_NAME_BYTES 64

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

/* The signals that end the program from without; one that was ignored when it
   started (nohup, a shell's background job) stays ignored. SIGPIPE is what a reader
   that has seen enough sends. */
static const int fatal_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};

/* unlink, signal and raise are safe in a handler. */
static void remove_on_signal(int number)
{
    remove_temporaries();
    signal(number, SIG_DFL);
    raise(number);
}

static void install_handlers(void)
{
    for (unsigned i = 0; i < sizeof fatal_signals / sizeof fatal_signals[0]; i++) {
        if (signal(fatal_signals[i], remove_on_signal) == SIG_IGN) {
            signal(fatal_signals[i], SIG_IGN);
        }
    }
    signal(SIGXFSZ, SIG_IGN); /* a limit on the size of files: fwrite fails and says so */
}

void remove_at_exit(char *path)
{
    static bool installed = false;
    unsigned slot = 0;
    if (!installed) {
        atexit(remove_temporaries);
        install_handlers();
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

/* Reading from the one or writing to the other two fails, as it should. */
void claim_standard_streams(void)
{
    for (int descriptor = 0; descriptor < 3; descriptor++) {
        if (fcntl(descriptor, F_GETFD) < 0) {
            open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY);
        }
    }
}

/* /dev/stdout, or a file into which the shell has redirected it. */
static bool is_standard_output(const struct stat *status)
{
    struct stat standard;
    return fstat(STDOUT_FILENO, &standard) == 0 && standard.st_dev == status->st_dev &&
           standard.st_ino == status->st_ino;
}

/* What a link leads to: renaming would replace the link itself. */
static char *resolved(const char *target)
{
    char *path = realpath(target, NULL);
    if (path == NULL) {
        system_error(target, NULL);
    }
    return path;
}

/* qvol-PID-N.tmp in the folder of the path, so that rename does not cross file systems;
   with the path's own name in it, it might be too long. O_EXCL: never over a file, nor
   through a link, that stands there. */
static int create_temporary(output *out, const char *path)
{
    const char *slash = strrchr(path, '/');
    size_t folder = slash != NULL ? (size_t)(slash + 1 - path) : 0;
    size_t bytes = folder + TEMPORARY_NAME_BYTES;
    int descriptor = -1;
    out->temporary = allocate(bytes, path, NULL);
    memcpy(out->temporary, path, folder);
    for (unsigned n = 0; descriptor < 0 && (n == 0 || errno == EEXIST); n++) {
        snprintf(out->temporary + folder, TEMPORARY_NAME_BYTES, "qvol-%ld-%u.tmp", (long)getpid(),
                 n);
        descriptor = open(out->temporary, O_RDWR | O_CREAT | O_EXCL, 0666);
    }
    return descriptor;
}

/* A file that is replaced hands on its permissions. */
static void open_temporary(output *out, const struct stat *replaced)
{
    int descriptor;
    out->path = replaced != NULL ? resolved(out->target) : NULL;
    descriptor = create_temporary(out, replaced != NULL ? out->path : out->target);
    if (descriptor < 0) {
        system_error(out->target, NULL);
    }
    remove_at_exit(out->temporary);
    if (replaced != NULL) {
        fchmod(descriptor, replaced->st_mode & 0777);
    }
    out->stream = fdopen(descriptor, "w+b");
}

/* Renaming would replace a device or a pipe by a file: these are written directly. A
   name that cannot be a file's, being too long, is found here, not by rename. */
void output_open(output *out, const char *target)
{
    struct stat status;
    bool exists = !is_standard_stream(target) && stat(target, &status) == 0;
    if (!exists && !is_standard_stream(target) && errno != ENOENT) {
        system_error(target, NULL);
    }
    *out = (output){.target = target};
    if (is_standard_stream(target) || (exists && is_standard_output(&status))) {
        out->stream = stdout;
    } else if (exists && !S_ISREG(status.st_mode)) {
        out->stream = fopen(target, "wb");
    } else {
        open_temporary(out, exists ? &status : NULL);
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

/* The disk's blocks are taken at once: writing to the memory cannot tell that there are none. */
void *output_map(output *out, uint64_t bytes)
{
    int descriptor = fileno(out->stream);
    if (out->temporary == NULL) {
        data_error(out->target, NULL, "no regular file, which is needed to map it into memory");
    }
    errno = bytes <= SIZE_MAX ? posix_fallocate(descriptor, 0, (off_t)bytes) : EFBIG;
    if (errno == 0) {
        out->map_bytes = (size_t)bytes;
        out->map = mmap(NULL, out->map_bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    }
    if (errno != 0 || out->map == MAP_FAILED) {
        system_error(out->target, NULL);
    }
    return out->map;
}

void output_commit(output *out)
{
    bool failed = fflush(out->stream) != 0 || ferror(out->stream);
    if (out->map != NULL) {
        failed = msync(out->map, out->map_bytes, MS_ASYNC) != 0 || failed;
        failed = munmap(out->map, out->map_bytes) != 0 || failed;
    }
    if (!failed && out->stream != stdout) {
        failed = fclose(out->stream) != 0;
    }
    if (!failed && out->temporary != NULL) {
        failed = rename(out->temporary, out->path != NULL ? out->path : out->target) != 0;
    }
    if (failed) {
        system_error(out->target, NULL);
    }
    if (out->temporary != NULL) {
        forget_temporary(out->temporary);
        free(out->temporary);
        free(out->path);
    }
}
