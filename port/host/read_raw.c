/*
 * read_raw.c - volumes without a header: size and type come from options or
 * from a name like foot_256x256x256_uint8.raw.
 */
#define _POSIX_C_SOURCE 200809L

#include "input.h"
#include "error.h"

#include <stdio.h>
#include <string.h>

const choice raw_type_names[] = {
    {"u8", ELEMENT_U8},
    {"s8", ELEMENT_S8},
    {"u16le", ELEMENT_U16},
    {"u16be", ELEMENT_U16 | RAW_BIG_ENDIAN},
    {"s16le", ELEMENT_S16},
    {"s16be", ELEMENT_S16 | RAW_BIG_ENDIAN},
    {"u32le", ELEMENT_U32},
    {"u32be", ELEMENT_U32 | RAW_BIG_ENDIAN},
    {"s32le", ELEMENT_S32},
    {"s32be", ELEMENT_S32 | RAW_BIG_ENDIAN},
    {"f32le", ELEMENT_F32},
    {"f32be", ELEMENT_F32 | RAW_BIG_ENDIAN},
    {"f64le", ELEMENT_F64},
    {"f64be", ELEMENT_F64 | RAW_BIG_ENDIAN},
    {"rgba8", ELEMENT_RGBA8},
    {"rgba16le", ELEMENT_RGBA16},
    {"rgba16be", ELEMENT_RGBA16 | RAW_BIG_ENDIAN},
    {"rgbt8", ELEMENT_RGBT8},
    {"rgbt16le", ELEMENT_RGBT16},
    {"rgbt16be", ELEMENT_RGBT16 | RAW_BIG_ENDIAN},
    {"associated8", ELEMENT_ASSOCIATED8},
    {"indexed8", ELEMENT_INDEXED8},
    {NULL, 0},
};

/* The types of the Open-SciVis names; their data are little-endian. */
static const choice name_types[] = {
    {"uint8", ELEMENT_U8},    {"int8", ELEMENT_S8},     {"uint16", ELEMENT_U16},
    {"int16", ELEMENT_S16},   {"uint32", ELEMENT_U32},  {"int32", ELEMENT_S32},
    {"float32", ELEMENT_F32}, {"float64", ELEMENT_F64}, {NULL, 0},
};

#define NAME_BYTES 256

/* 0 for a word that names no type. */
static int type_from_name(const char *text)
{
    const choice *c = name_types;
    while (c->name != NULL && strcmp(c->name, text) != 0) {
        c++;
    }
    return c->value;
}

bool raw_options_from_name(raw_options *options, const char *name)
{
    char copy[NAME_BYTES];
    const char *slash = strrchr(name, '/');
    const char *ending = strrchr(name, '.');
    uint32_t size[3] = {0, 0, 0};
    int type = 0;
    char *rest;
    if (ending == NULL || strcmp(ending, ".raw") != 0) {
        return false;
    }
    slash = slash != NULL ? slash + 1 : name;
    snprintf(copy, sizeof copy, "%.*s", (int)(ending - slash), slash);
    for (char *part = strtok_r(copy, "_", &rest); part != NULL; part = strtok_r(NULL, "_", &rest)) {
        if (!read_sizes(part, 3, QV_AXIS_MAX, size) && type == 0) {
            type = type_from_name(part);
        }
    }
    if (size[0] == 0 || type == 0) {
        return false;
    }
    if (options->size[0] == 0) {
        memcpy(options->size, size, sizeof size);
    }
    options->type = options->type == 0 ? type : options->type;
    return true;
}

/* Bytes beyond the voxels: none, or those of coarser levels. Of indexed8 data the palette
   decides later how wide these are. */
static bool take_rest(struct scan *scan, uint64_t rest)
{
    bool wide = element_word_bytes(scan->type) == 2;
    bool indexed = scan->type == ELEMENT_INDEXED8;
    scan->level_bytes = rest;
    return rest == 0 || (element_is_classified(scan->type) &&
                         (((!wide || indexed) && scan_levels(scan, QV_STORAGE_RGBA8) > 0) ||
                          ((wide || indexed) && scan_levels(scan, QV_STORAGE_RGBA16) > 0)));
}

/* In memory, so in size_t. The size was compared with the file's: fewer bytes are a failing
   disk. */
static void read_bytes(void *bytes, uint64_t count, FILE *file, const struct source *source)
{
    if (fread(bytes, (size_t)count, 1, file) != 1) {
        data_error(source->name, "data", "cannot be read to the end");
    }
}

static void read_values(struct scan *scan, const struct source *source, uint64_t skip)
{
    FILE *file = fopen(source->path, "rb");
    if (file == NULL || fseeko(file, (off_t)skip, SEEK_SET) != 0) {
        system_error(source->name, NULL);
    }
    read_bytes(scan->values, scan->bytes, file, source);
    if (scan->level_bytes > 0) {
        scan->levels = allocate(scan->level_bytes, source->name, "levels");
        read_bytes(scan->levels, scan->level_bytes, file, source);
    }
    fclose(file);
}

static void turn_words(struct scan *scan, bool big_endian)
{
    unsigned word_bytes = element_word_bytes(scan->type);
    if (word_bytes == 1 || big_endian == machine_is_big_endian()) {
        return;
    }
    swap_words(scan->values, scan->bytes, word_bytes);
    if (scan->levels != NULL) {
        swap_words(scan->levels, scan->level_bytes, word_bytes);
    }
}

void read_raw(struct scan *scan, const struct source *source, const raw_options *options)
{
    uint64_t bytes, end;
    scan_clear(scan, source->name, "raw");
    scan->type = (element)(options->type & ~RAW_BIG_ENDIAN);
    memcpy(scan->size, options->size, sizeof scan->size);
    bytes = scan_data_bytes(scan);
    end = options->skip + bytes; /* below 2^62 + 2^39 */
    if (source->more || source->bytes < end || !take_rest(scan, source->bytes - end)) {
        data_error(source->name, "size",
                   "%s%llu bytes, but --skip, --dims and --type make %llu + %llu",
                   source->more ? "more than " : "", (unsigned long long)source->bytes,
                   (unsigned long long)options->skip, (unsigned long long)bytes);
    }
    scan_allocate(scan, bytes);
    read_values(scan, source, options->skip);
    turn_words(scan, (options->type & RAW_BIG_ENDIAN) != 0);
}
