/*
 * input.c - opens a source and finds the reader for it.
 */
#define _POSIX_C_SOURCE 200809L

#include "input.h"
#include "error.h"
#include "output.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Formats that need a library are known even where it is not installed. */
#ifdef HAVE_NIFTI
#define READ_NIFTI read_nifti
#else
#define READ_NIFTI NULL
#endif
#ifdef HAVE_NRRD
#define READ_NRRD read_nrrd
#else
#define READ_NRRD NULL
#endif

#define PEEK_BYTES 4
#define COPY_BYTES 65536

typedef struct reader {
    const char *name;
    const char *package;
    bool (*matches)(const unsigned char *start);
    void (*read)(struct scan *scan,
                 const struct source *source); /* null: built without the package */
} reader;

/* gzip's mark, or the size of a header of either version in either byte order. */
static bool matches_nifti(const unsigned char *start)
{
    static const unsigned char marks[][PEEK_BYTES] = {
        {0x5c, 1, 0, 0}, {0, 0, 1, 0x5c}, {0x1c, 2, 0, 0}, {0, 0, 2, 0x1c}};
    bool found = start[0] == 0x1f && start[1] == 0x8b;
    for (unsigned i = 0; i < sizeof marks / sizeof marks[0]; i++) {
        found = found || memcmp(start, marks[i], PEEK_BYTES) == 0;
    }
    return found;
}

/* Its version follows; the library judges that. */
static bool matches_nrrd(const unsigned char *start)
{
    return memcmp(start, "NRRD", PEEK_BYTES) == 0;
}

static const reader readers[] = {
    {"NIfTI", "libnifti2-dev", matches_nifti, READ_NIFTI},
    {"NRRD", "libteem-dev", matches_nrrd, READ_NRRD},
};

bool machine_is_big_endian(void)
{
    const uint16_t word = 1;
    unsigned char bytes[2];
    memcpy(bytes, &word, sizeof bytes);
    return bytes[1] == 1;
}

/* mkstemp fills the six letters. */
static char *temporary_copy_name(const char *name)
{
    const char *folder = getenv("TMPDIR");
    size_t bytes;
    char *path;
    folder = folder != NULL && folder[0] != '\0' ? folder : "/tmp";
    bytes = strlen(folder) + 32;
    path = allocate(bytes, name, NULL);
    snprintf(path, bytes, "%s/qvol-input-XXXXXX", folder);
    return path;
}

/* Readers seek, and sizes are checked against the file's: a pipe becomes a file. */
static void copy_stream(struct source *source, FILE *from, uint64_t most)
{
    static unsigned char buffer[COPY_BYTES];
    char *path = temporary_copy_name(source->name);
    int descriptor = mkstemp(path);
    FILE *to = descriptor >= 0 ? fdopen(descriptor, "wb") : NULL;
    size_t count;
    if (to == NULL) {
        system_error(path, NULL);
    }
    remove_at_exit(path);
    source->path = path;
    while (source->bytes <= most && (count = fread(buffer, 1, sizeof buffer, from)) > 0) {
        source->bytes += count;
        if (fwrite(buffer, 1, count, to) != count) {
            system_error(path, NULL);
        }
    }
    source->more = source->bytes > most;
    source->bytes = source->more ? most : source->bytes;
    if (ferror(from)) {
        system_error(source->name, NULL);
    }
    if (fclose(to) != 0) {
        system_error(path, NULL);
    }
}

void source_open(struct source *source, const char *name, uint64_t most)
{
    struct stat status;
    FILE *file = is_standard_stream(name) ? stdin : fopen(name, "rb");
    *source =
        (struct source){.name = is_standard_stream(name) ? "standard input" : name, .path = name};
    if (file == NULL || fstat(fileno(file), &status) != 0) {
        system_error(source->name, NULL);
    }
    if (file == stdin || S_ISFIFO(status.st_mode)) {
        copy_stream(source, file, most);
    } else if (S_ISREG(status.st_mode)) {
        source->bytes = (uint64_t)status.st_size;
    } else {
        data_error(source->name, NULL, "neither a file nor a pipe");
    }
    if (file != stdin) {
        fclose(file);
    }
}

bool source_holds(const struct source *source, uint64_t bytes)
{
    return source->bytes == bytes && !source->more;
}

size_t source_peek(const struct source *source, void *start, size_t bytes)
{
    FILE *file = fopen(source->path, "rb");
    size_t count;
    if (file == NULL) {
        system_error(source->name, NULL);
    }
    count = fread(start, 1, bytes, file);
    fclose(file);
    return count;
}

/* What the file begins with decides, whatever its name ends in. */
static void read_by_content(struct scan *scan, const struct source *source)
{
    unsigned char start[PEEK_BYTES];
    size_t count = source_peek(source, start, sizeof start);
    for (unsigned i = 0; i < sizeof readers / sizeof readers[0]; i++) {
        if (count < sizeof start || !readers[i].matches(start)) {
            continue;
        }
        if (readers[i].read == NULL) {
            data_error(source->name, "format", "%s needs the package %s when qvol is built",
                       readers[i].name, readers[i].package);
        }
        readers[i].read(scan, source);
        return;
    }
    data_error(source->name, "format", "neither NIfTI nor NRRD; raw data need --dims and --type");
}

/* What raw data on a pipe may hold, coarser levels of the widest voxels included: no more
   is copied. */
static uint64_t most_bytes(const raw_options *raw)
{
    const uint16_t size[3] = {(uint16_t)raw->size[0], (uint16_t)raw->size[1],
                              (uint16_t)raw->size[2]};
    uint64_t voxels = (uint64_t)size[0] * size[1] * size[2];
    element type = (element)(raw->type & ~RAW_BIG_ENDIAN);
    uint64_t levels = element_is_classified(type)
                          ? qv_pyramid_bytes(size, QV_STORAGE_RGBA16, qv_pyramid_levels(size))
                          : 0;
    return raw->skip + voxels * element_bytes(type) + levels;
}

/* Options, then the name, then the content say what the file is. */
void input_read(struct scan *scan, const char *name, const raw_options *options)
{
    raw_options raw = *options;
    struct source source;
    bool is_raw = raw_options_from_name(&raw, name) || raw.size[0] != 0 || raw.type != 0;
    if (is_raw && (raw.size[0] == 0 || raw.type == 0)) {
        usage_error(raw.size[0] == 0 ? "--dims" : "--type", "raw data need both --dims and --type");
    }
    if (!is_raw && raw.skip != 0) {
        usage_error("--skip", "only raw data are skipped; give --dims and --type");
    }
    source_open(&source, name, is_raw ? most_bytes(&raw) : UINT64_MAX);
    if (is_raw) {
        read_raw(scan, &source, &raw);
    } else {
        read_by_content(scan, &source);
    }
    if (raw.spacing[0] > 0) {
        memcpy(scan->spacing, raw.spacing, sizeof scan->spacing);
    }
}
