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

/* Its size was compared with the file's, so fewer bytes are a failing disk. */
static void read_values(struct scan *scan, const struct source *source, uint64_t skip)
{
    FILE *file = fopen(source->path, "rb");
    if (file == NULL || fseeko(file, (off_t)skip, SEEK_SET) != 0) {
        system_error(source->name, NULL);
    }
    if (fread(scan->values, (size_t)scan->bytes, 1, file) != 1) { /* in memory, so in size_t */
        data_error(source->name, "data", "cannot be read to the end");
    }
    fclose(file);
}

void read_raw(struct scan *scan, const struct source *source, const raw_options *options)
{
    uint64_t expected;
    unsigned word_bytes;
    scan_clear(scan, source->name, "raw");
    scan->type = (element)(options->type & ~RAW_BIG_ENDIAN);
    memcpy(scan->size, options->size, sizeof scan->size);
    expected = scan_data_bytes(scan);
    if (!source_holds(source, options->skip + expected)) { /* below 2^62 + 2^39 */
        data_error(source->name, "size",
                   "%s%llu bytes, but --skip, --dims and --type make %llu + %llu",
                   source->more ? "more than " : "", (unsigned long long)source->bytes,
                   (unsigned long long)options->skip, (unsigned long long)expected);
    }
    scan_allocate(scan, expected);
    read_values(scan, source, options->skip);
    word_bytes = element_word_bytes(scan->type);
    if (word_bytes > 1 && ((options->type & RAW_BIG_ENDIAN) != 0) != machine_is_big_endian()) {
        swap_words(scan->values, scan->bytes, word_bytes);
    }
}
