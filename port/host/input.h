/*
 * input.h - from a name to a scan: which format, and from where.
 */
#ifndef QVOL_HOST_INPUT_H
#define QVOL_HOST_INPUT_H

#include "scan.h"

/* What options say about a file without a header. Zero: not given. */
typedef struct raw_options {
    uint32_t size[3];
    int type;          /* an element, with RAW_BIG_ENDIAN */
    uint64_t skip;     /* bytes before the data */
    double spacing[3]; /* replaces the spacing of any format */
} raw_options;

#define RAW_BIG_ENDIAN 0x100

/* u8, u16le, rgba16be, ...: values of raw_options.type. */
extern const choice raw_type_names[];

/* A regular file that a reader may open by name, as often as it likes. */
struct source {
    const char *name; /* as the user gave it, for messages */
    const char *path;
    uint64_t bytes;
    bool more; /* than these bytes came out of a pipe; they were not read */
};

/* Exactly so many bytes. */
bool source_holds(const struct source *source, uint64_t bytes);

/* Opens a file, a pipe or "-"; what cannot be sought is first copied, at most
   `most` bytes of it. */
void source_open(struct source *source, const char *name, uint64_t most);

/* The start of the file; returns the bytes that were there. */
size_t source_peek(const struct source *source, void *start, size_t bytes);

/* Reads a volume of any known format. Errors end the command. */
void input_read(struct scan *scan, const char *name, const raw_options *options);

/* The readers. Each checks sizes against the file before it allocates. */
void read_raw(struct scan *scan, const struct source *source, const raw_options *options);
void read_nifti(struct scan *scan, const struct source *source);
void read_nrrd(struct scan *scan, const struct source *source);

/* Fills what options leave open from a name like foot_256x256x256_uint8.raw;
   false if the name says nothing. */
bool raw_options_from_name(raw_options *options, const char *name);

/* Machine's byte order. */
bool machine_is_big_endian(void);

#endif
