/*
 * read_nrrd.c - NRRD through teem: raw and gzip, header attached or detached.
 *
 * The library first reads the header alone; only when sizes fit the data file
 * does it read the data. File names with a printf pattern never reach it.
 */
#define _POSIX_C_SOURCE 200809L

#include "input.h"
#include "error.h"
#include "quiet.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include <teem/nrrd.h>

/* deflate makes at most 1032 bytes of one. */
#define DEFLATE_RATIO 1032u
/* A header line is short; teem reads lines of any length. */
#define LINE_BYTES 1024

/* The types that have a meaning as one scalar. */
static element element_of(int type)
{
    switch (type) {
    case nrrdTypeUChar:
        return ELEMENT_U8;
    case nrrdTypeChar:
        return ELEMENT_S8;
    case nrrdTypeUShort:
        return ELEMENT_U16;
    case nrrdTypeShort:
        return ELEMENT_S16;
    case nrrdTypeUInt:
        return ELEMENT_U32;
    case nrrdTypeInt:
        return ELEMENT_S32;
    case nrrdTypeFloat:
        return ELEMENT_F32;
    case nrrdTypeDouble:
        return ELEMENT_F64;
    default:
        return ELEMENT_NONE;
    }
}

/* teem hands a pattern to sprintf. */
static void check_data_file(const struct source *source, const char *line)
{
    if (strncasecmp(line, "data file:", 10) != 0 && strncasecmp(line, "datafile:", 9) != 0) {
        return;
    }
    if (strchr(line, '%') != NULL || strstr(line, "LIST") != NULL) {
        data_error(source->name, "data file", "several data files cannot be read");
    }
}

/* Looks at the header's lines, to its empty line or the file's end. */
static void check_header_text(const struct source *source)
{
    char line[LINE_BYTES];
    FILE *file = fopen(source->path, "rb");
    if (file == NULL) {
        system_error(source->name, NULL);
    }
    while (fgets(line, sizeof line, file) != NULL && line[0] != '\n' && line[0] != '\r') {
        if (strchr(line, '\n') == NULL && !feof(file)) {
            data_error(source->name, "header", "a line is longer than %d characters",
                       LINE_BYTES - 2);
        }
        check_data_file(source, line);
    }
    fclose(file);
}

/* The last line of teem's account says what is wrong, those above where. */
static void teem_error(const struct source *source, const char *field)
{
    char *account = biffGetDone(NRRD);
    char *reason = account;
    size_t length = account != NULL ? strlen(account) : 0;
    while (length > 0 && account[length - 1] == '\n') {
        account[--length] = '\0';
    }
    if (account != NULL && strrchr(account, '\n') != NULL) {
        reason = strrchr(account, '\n') + 1;
    }
    data_error(source->name, field, "%s", reason != NULL ? reason : "refused by teem");
}

/* Header or all, as the state says. */
static void load(const struct source *source, Nrrd *nrrd, NrrdIoState *state, const char *field)
{
    int saved = quiet_begin();
    int failed = nrrdLoad(nrrd, source->path, state);
    quiet_end(saved);
    if (failed) {
        teem_error(source, field);
    }
}

/* teem knows more (text, bzip2); they are not needed here. */
static void check_encoding(const struct source *source, const NrrdIoState *state)
{
    if (state->encoding != nrrdEncodingRaw && state->encoding != nrrdEncodingGzip) {
        data_error(source->name, "encoding", "neither raw nor gzip");
    }
}

/* Bytes from where the data begin to the end of their file. */
static uint64_t available_bytes(const struct source *source, const NrrdIoState *state)
{
    struct stat status;
    off_t place = state->dataFile != NULL ? ftello(state->dataFile) : -1;
    if (place < 0 || fstat(fileno(state->dataFile), &status) != 0) {
        data_error(source->name, "data file", "cannot be read");
    }
    return status.st_size > place ? (uint64_t)(status.st_size - place) : 0;
}

/* The world's axes are right, anterior, superior. */
static void world_signs(int space, double sign[3])
{
    bool left = space == nrrdSpaceLeftPosteriorSuperior || space == nrrdSpaceLeftAnteriorSuperior;
    sign[0] = left ? -1 : 1;
    sign[1] = space == nrrdSpaceLeftPosteriorSuperior ? -1 : 1;
    sign[2] = 1;
}

/* Directions before spacings, as the format has it. */
static void set_geometry(struct scan *scan, const Nrrd *nrrd)
{
    double direction[3][3];
    double sign[3];
    world_signs(nrrd->space, sign);
    for (unsigned a = 0; a < 3; a++) {
        const NrrdAxisInfo *axis = &nrrd->axis[a];
        scan->size[a] = axis->size < UINT32_MAX ? (uint32_t)axis->size : UINT32_MAX;
        scan->spacing[a] = isnan(axis->spacing) ? 1 : fabs(axis->spacing);
        for (unsigned w = 0; w < 3; w++) {
            direction[w][a] = sign[w] * axis->spaceDirection[w];
        }
    }
    if (nrrd->spaceDim == 3 && !scan_orient(scan, direction)) {
        data_error(scan->file, "space directions", "the matrix has no inverse");
    }
    scan->oriented = scan->oriented && nrrd->space != nrrdSpaceUnknown;
}

/* Everything but the values. */
static void set_description(struct scan *scan, const struct source *source, const Nrrd *nrrd)
{
    scan_clear(scan, source->name, "NRRD");
    scan->type = element_of(nrrd->type);
    if (scan->type == ELEMENT_NONE) {
        data_error(source->name, "type", "64-bit integers and blocks cannot be read");
    }
    if (nrrd->dim != 3) {
        data_error(source->name, "dimension", "%u axes, 3 are needed (no colours, no time)",
                   nrrd->dim);
    }
    set_geometry(scan, nrrd);
}

/* Reads the header alone and compares what it implies with the data file. */
static void read_description(struct scan *scan, const struct source *source)
{
    Nrrd *nrrd = nrrdNew();
    NrrdIoState *state = nrrdIoStateNew();
    uint64_t available;
    nrrdIoStateSet(state, nrrdIoStateSkipData, 1);
    nrrdIoStateSet(state, nrrdIoStateKeepNrrdDataFileOpen, 1);
    load(source, nrrd, state, "header");
    check_encoding(source, state);
    set_description(scan, source, nrrd);
    scan->bytes = scan_data_bytes(scan);
    available = available_bytes(source, state);
    if (state->encoding == nrrdEncodingRaw ? available != scan->bytes
                                           : available * DEFLATE_RATIO < scan->bytes) {
        data_error(source->name, "data", "the header implies %llu bytes, the file has %llu",
                   (unsigned long long)scan->bytes, (unsigned long long)available);
    }
    fclose(state->dataFile);
    nrrdIoStateNix(state);
    nrrdNuke(nrrd);
}

void read_nrrd(struct scan *scan, const struct source *source)
{
    Nrrd *nrrd = nrrdNew();
    NrrdIoState *state = nrrdIoStateNew();
    check_header_text(source);
    read_description(scan, source);
    load(source, nrrd, state, "data");
    scan->values = nrrd->data;
    nrrdIoStateNix(state);
    nrrdNix(nrrd);
}
