/*
 * flash_array.c - constants that a firmware compiles in.
 */
#include "flash_array.h"
#include "error.h"
#include "picture.h"
#include "settings_slices.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TEXT_BYTES   512
#define LINE_COLUMNS 96

static void print(struct flash_array *array, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
static void print(struct flash_array *array, const char *format, ...)
{
    char text[TEXT_BYTES];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    output_write(array->out, text, strlen(text));
}

/* Letters and digits as C has them, in any locale. */
static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* build/small-head.h gives small_head. C reserves names that begin with an underscore:
   what does not begin with a letter gets one. */
static void name_from_file(char name[FLASH_NAME_BYTES], const char *file)
{
    const char *slash = strrchr(file, '/');
    const char *start = slash != NULL ? slash + 1 : file;
    const char *end = strrchr(start, '.');
    size_t used = 0;
    if (!is_letter(start[0])) {
        name[used++] = 'v';
    }
    for (const char *c = start; c < end && used + 1 < FLASH_NAME_BYTES; c++) {
        name[used++] = is_letter(*c) || is_digit(*c) ? *c : '_';
    }
    name[used] = '\0';
}

/* Text inside a comment must not end it. */
static void print_file_name(struct flash_array *array, const char *file)
{
    for (const char *c = file; *c != '\0'; c++) {
        bool ends = c[0] == '*' && c[1] == '/';
        print(array, "%c", ends || *c < ' ' ? '?' : *c);
    }
}

/* Of classification, where it happened here. */
static void print_origin(struct flash_array *array)
{
    const struct model *model = array->model;
    if (model->classified_before) {
        return;
    }
    print(array, " * window     %.9g .. %.9g\n", model->view.window[0], model->view.window[1]);
    print(array, " * transfer   ");
    print_file_name(array, model->transfer.name);
    print(array, "%s\n", model->shaded ? ", shaded" : "");
}

static void print_lengths(struct flash_array *array)
{
    const qv_volume *volume = array->volume;
    double unit = array->model->world_unit;
    print(array, " * spacing    %.6g x %.6g x %.6g\n", unit * volume->spacing[0] / QV_ONE_Q16,
          unit * volume->spacing[1] / QV_ONE_Q16, unit * volume->spacing[2] / QV_ONE_Q16);
    print(array, " * world unit %.6g\n", unit);
    if (volume->extinction != 0) {
        print(array, " * extinction %.9g per world unit, of the full value\n",
              (double)volume->extinction / QV_ONE_Q16);
    }
}

static void print_comment(struct flash_array *array)
{
    const struct model *model = array->model;
    const qv_volume *volume = array->volume;
    print(array, "/*\n * Written by qvol %s; do not edit.\n *\n * source     ",
          array->levels != NULL ? "pyramid" : "classify");
    print_file_name(array, model->scan.file);
    print(array, "\n * size       %u x %u x %u voxels\n", volume->size[0], volume->size[1],
          volume->size[2]);
    print_lengths(array);
    print_origin(array);
    print(array, " * storage    %s\n", storage_name(model->storage));
    if (array->levels != NULL) {
        print(array, " * levels     1 to %u, filter %s, domain %s\n", array->levels->pyramid.levels,
              array->levels->filter, array->levels->domain);
    }
    print(array, " */\n");
}

static const char *linkage(const struct flash_array *array)
{
    return array->header_file ? "static " : "";
}

/* Bytes that lie at a multiple of 4, as associated colours must. */
static void start_aligned(struct flash_array *array, const char *what, uint64_t bytes)
{
    array->word_bytes = 1;
    array->column = 0;
    print(array, "\n%sconst union {\n    uint8_t bytes[%" PRIu64 "];\n    uint32_t aligned;\n",
          linkage(array), bytes);
    print(array, "} %s_%s = {{\n", array->name, what);
}

/* An array of words is aligned as 16-bit storage must be. */
static void start_array(struct flash_array *array, const char *what, unsigned word_bytes,
                        uint64_t words)
{
    array->word_bytes = word_bytes;
    array->column = 0;
    print(array, "\n%sconst uint%u_t %s_%s[%" PRIu64 "] = {\n", linkage(array), 8 * word_bytes,
          array->name, what, words);
}

static void print_declarations(struct flash_array *array)
{
    print(array, "\n/* For those who use it: */\nextern const qv_volume %s_volume;\n", array->name);
    if (array->levels != NULL) {
        print(array, "extern const qv_pyramid %s_pyramid;\n", array->name);
    }
    if (array->settings->dither_table != TABLE_NONE) {
        print(array, "extern const qv_dither_table %s_dither_table;\n", array->name);
    }
}

void flash_array_begin(struct flash_array *array, output *out, const struct model *model,
                       const qv_volume *volume, const struct levels *levels,
                       const struct settings *settings)
{
    bool indexed = storage_is_indexed(model->storage);
    unsigned word_bytes = indexed ? 1 : storage_channel_bytes(model->storage);
    memset(array, 0, sizeof *array);
    array->out = out;
    array->model = model;
    array->volume = volume;
    array->levels = levels;
    array->settings = settings;
    array->header_file = has_ending(settings->output, ".h");
    if (settings->name != NULL) {
        snprintf(array->name, sizeof array->name, "%s", settings->name);
    } else {
        name_from_file(array->name, settings->output);
    }
    print_comment(array);
    print(array, "#include \"qvol.h\"\n");
    if (!array->header_file) {
        print_declarations(array);
    }
    if (storage_is_associated(model->storage)) {
        start_aligned(array, "voxels", volume->voxels_bytes);
    } else {
        start_array(array, "voxels", word_bytes, volume->voxels_bytes / word_bytes);
    }
}

/* Decimal is shorter than hexadecimal, and compilers read it as fast. */
static void print_word(struct flash_array *array, unsigned word)
{
    char text[16];
    int length = snprintf(text, sizeof text, "%u,", word);
    if (array->column + (unsigned)length > LINE_COLUMNS) {
        output_write(array->out, "\n", 1);
        array->column = 0;
    }
    output_write(array->out, text, (size_t)length);
    array->column += (unsigned)length;
}

void flash_array_voxels(struct flash_array *array, const void *voxels, size_t bytes)
{
    const uint8_t *byte = voxels;
    for (size_t i = 0; i < bytes; i += array->word_bytes) {
        uint16_t word = byte[i];
        if (array->word_bytes == 2) {
            memcpy(&word, byte + i, sizeof word);
        }
        print_word(array, word);
    }
}

/* A whole array. */
static void print_words(struct flash_array *array, const char *what, const void *words,
                        uint64_t bytes, unsigned word_bytes)
{
    start_array(array, what, word_bytes, bytes / word_bytes);
    flash_array_voxels(array, words, (size_t)bytes);
    print(array, "\n};\n");
}

/* The palette, or levels. */
static void print_entries(struct flash_array *array, const char *what, const void *entries,
                          uint64_t bytes)
{
    print_words(array, what, entries, bytes, storage_channel_bytes(array->model->storage));
}

/* Positional, so that C++ takes it as well; the order is that of qv_volume. */
static void print_volume(struct flash_array *array)
{
    const qv_volume *volume = array->volume;
    char palette[FLASH_NAME_BYTES + 32] = "0";
    if (volume->palette != NULL) {
        snprintf(palette, sizeof palette, "(qv_address)%s_palette", array->name);
    }
    print(array, "\n%sconst qv_volume %s_volume = {\n", linkage(array), array->name);
    print(array, "    (qv_address)%s_voxels%s,\n    %s,\n", array->name,
          storage_is_associated(array->model->storage) ? ".bytes" : "", palette);
    print(array, "    %" PRIu64 "u, /* bytes of voxels */\n    %" PRIu32 "u, /* of palette */\n",
          volume->voxels_bytes, volume->palette_bytes);
    print(array, "    {%u, %u, %u}, /* size */\n    %s,\n", volume->size[0], volume->size[1],
          volume->size[2], storage_constant((qv_storage)volume->storage));
    print(array, "    {%" PRIu32 "u, %" PRIu32 "u, %" PRIu32 "u}, /* spacing, Q16.16 */\n",
          volume->spacing[0], volume->spacing[1], volume->spacing[2]);
    print(array, "    %" PRIu32 "u, /* unit distance, Q16.16; 0: the step */\n",
          volume->unit_distance);
    print(array, "    %" PRIu32 "u, /* extinction of the full value, Q16.16 */\n",
          volume->extinction);
    print(array, "    {%" PRId32 ", %" PRId32 ", %" PRId32 "}, /* strides */\n", volume->stride[0],
          volume->stride[1], volume->stride[2]);
    print(array, "    0, /* no pages: all of it is in memory */\n};\n");
}

/* In the order of qv_pyramid. */
static void print_pyramid(struct flash_array *array)
{
    const qv_pyramid *pyramid = &array->levels->pyramid;
    print_entries(array, "levels", pyramid->voxels, pyramid->bytes);
    print(array, "\n%sconst qv_pyramid %s_pyramid = {\n", linkage(array), array->name);
    print(array,
          "    (qv_address)%s_levels,\n    %" PRIu64 "u, /* bytes */\n    %u, /* levels */\n};\n",
          array->name, pyramid->bytes, pyramid->levels);
}

/* In the order of qv_dither_table. */
static void print_dither_table(struct flash_array *array)
{
    const struct model *model = array->model;
    uint8_t entry_bytes = (uint8_t)array->settings->dither_table;
    qv_dither dither = {0};
    uint32_t bytes;
    uint8_t *entries;
    settings_alpha(&dither, array->settings);
    bytes = qv_dither_table_bytes(dither.period, entry_bytes);
    entries = allocate(bytes, model->scan.file, "dither table");
    check_status(qv_dither_table_build(entries, bytes, entry_bytes, &dither, &model->table, 0,
                                       QV_PALETTE_ENTRIES),
                 model, "dither table");
    print_words(array, "dither_entries", entries, bytes, 1);
    free(entries);
    print(array, "\n%sconst qv_dither_table %s_dither_table = {\n", linkage(array), array->name);
    print(array, "    (qv_address)%s_dither_entries,\n    %" PRIu32 "u, /* bytes */\n", array->name,
          bytes);
    print(array, "    %u, /* period */\n    %u, /* bytes of an entry */\n};\n", dither.period,
          entry_bytes);
}

void flash_array_end(struct flash_array *array)
{
    const struct model *model = array->model;
    print(array, storage_is_associated(model->storage) ? "\n}};\n" : "\n};\n");
    if (model->palette != NULL) {
        print_entries(array, "palette", model->palette, model->palette_bytes);
    }
    print_volume(array);
    if (array->levels != NULL) {
        print_pyramid(array);
    }
    if (array->settings->dither_table != TABLE_NONE) {
        print_dither_table(array);
    }
}
