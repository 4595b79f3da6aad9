/*
 * picture.h - pictures of 8 bits a channel, and the files that hold them.
 */
#ifndef QVOL_HOST_PICTURE_H
#define QVOL_HOST_PICTURE_H

#include "output.h"

#include <stddef.h>
#include <stdint.h>

struct picture {
    uint32_t width, height;
    unsigned channels; /* 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; alpha is straight */
    uint8_t *pixels;   /* tightly packed, top row first */
};

/* Side of the largest picture that is read: what the library could render. */
#define PICTURE_SIDE_MOST 32767

void picture_create(struct picture *picture, uint32_t width, uint32_t height, unsigned channels);

/* Writes one kind of file, or ends with a data error. */
typedef void picture_writer(output *out, const struct picture *picture);
picture_writer write_png, write_pam;

/* The writer of a name's ending, or null. A usage error if a package is missing. */
picture_writer *picture_writer_by_name(const char *name);
picture_writer *picture_writer_png(void);

/* Reads PNG or PAM, known by their first bytes. */
void picture_read(struct picture *picture, const char *name);

/* The readers; `file` is at its start and `bytes` long. */
typedef void picture_reader(struct picture *picture, const char *name, FILE *file, uint64_t bytes);
picture_reader read_png, read_pam;

/* True if the name ends so, in either case. */
bool has_ending(const char *name, const char *ending);

#endif
