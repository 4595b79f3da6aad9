/*
 * picture.c - which library reads and writes which picture.
 */
#define _POSIX_C_SOURCE 200809L

#include "picture.h"
#include "error.h"
#include "input.h"

#include <string.h>
#include <strings.h>

/* PNG is known even where its library is not installed. */
#ifdef HAVE_PNG
#define READ_PNG  read_png
#define WRITE_PNG write_png
#else
#define READ_PNG  NULL
#define WRITE_PNG NULL
#endif

struct picture_kind {
    const char *name;
    const char *ending;
    const char *start; /* first bytes of a file */
    const char *package;
    picture_reader *read; /* null: built without the package */
    picture_writer *write;
};

static const struct picture_kind kinds[] = {
    {"PNG", ".png", "\x89PNG", "libpng-dev", READ_PNG, WRITE_PNG},
    {"PAM", ".pam", "P7\n", NULL, read_pam, write_pam},
};

#define KINDS (sizeof kinds / sizeof kinds[0])

void picture_create(struct picture *picture, uint32_t width, uint32_t height, unsigned channels)
{
    picture->width = width;
    picture->height = height;
    picture->channels = channels;
    picture->pixels = allocate((uint64_t)width * height * channels, "picture", "size");
}

bool has_ending(const char *name, const char *ending)
{
    size_t length = strlen(name);
    size_t tail = strlen(ending);
    return length >= tail && strcasecmp(name + length - tail, ending) == 0;
}

/* The writer, or a usage error that names the package. */
static picture_writer *writer_of(const struct picture_kind *kind)
{
    if (kind->write == NULL) {
        usage_error(kind->name, "needs the package %s when qvol is built; PAM (.pam) does not",
                    kind->package);
    }
    return kind->write;
}

picture_writer *picture_writer_png(void)
{
    return writer_of(&kinds[0]);
}

picture_writer *picture_writer_by_name(const char *name)
{
    for (size_t i = 0; i < KINDS; i++) {
        if (has_ending(name, kinds[i].ending)) {
            return writer_of(&kinds[i]);
        }
    }
    return NULL;
}

/* By the first bytes, whatever the name ends in. */
static const struct picture_kind *kind_of(const struct source *source)
{
    char start[4] = "";
    size_t count = source_peek(source, start, sizeof start);
    for (size_t i = 0; i < KINDS; i++) {
        size_t length = strlen(kinds[i].start);
        if (count >= length && memcmp(start, kinds[i].start, length) == 0) {
            return &kinds[i];
        }
    }
    data_error(source->name, "format", "neither PNG nor PAM");
}

void picture_read(struct picture *picture, const char *name)
{
    struct source source;
    const struct picture_kind *kind;
    FILE *file;
    source_open(&source, name, UINT64_MAX);
    kind = kind_of(&source);
    if (kind->read == NULL) {
        data_error(source.name, "format", "%s needs the package %s when qvol is built", kind->name,
                   kind->package);
    }
    file = fopen(source.path, "rb");
    if (file == NULL) {
        system_error(source.name, NULL);
    }
    kind->read(picture, source.name, file, source.bytes);
    fclose(file);
}
