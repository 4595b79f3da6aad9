/*
 * flash_array.c - constants that a firmware compiles in.
 */
#include "flash_array.h"
#include "error.h"
#include "picture.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
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

static void print_comment(struct flash_array *array)
{
    const struct model *model = array->model;
    const qv_scalars *scalars = &model->classifier.scalars;
    print(array, "/*\n * Written by qvol classify; do not edit.\n *\n * source     ");
    print_file_name(array, model->scan.file);
    print(array, "\n * size       %u x %u x %u voxels\n", scalars->size[0], scalars->size[1],
          scalars->size[2]);
    print(array, " * spacing    %.6g x %.6g x %.6g\n",
          model->world_unit * scalars->spacing[0] / QV_ONE_Q16,
          model->world_unit * scalars->spacing[1] / QV_ONE_Q16,
          model->world_unit * scalars->spacing[2] / QV_ONE_Q16);
    print(array, " * world unit %.6g\n", model->world_unit);
    print(array, " * window     %.9g .. %.9g\n", model->view.window[0], model->view.window[1]);
    print(array, " * transfer   ");
    print_file_name(array, model->transfer.name);
    print(array, "%s\n * storage    %s\n */\n", model->shaded ? ", shaded" : "",
          storage_name(model->storage));
}

/* An array of words is aligned as 16-bit storage must be. */
static void start_array(struct flash_array *array, const char *what, unsigned word_bytes,
                        uint64_t words)
{
    array->word_bytes = word_bytes;
    array->column = 0;
    print(array, "\n%sconst uint%u_t %s_%s[%" PRIu64 "] = {\n", array->header_file ? "static " : "",
          8 * word_bytes, array->name, what, words);
}

static uint64_t voxel_count(const qv_scalars *scalars)
{
    return (uint64_t)scalars->size[0] * scalars->size[1] * scalars->size[2];
}

void flash_array_begin(struct flash_array *array, output *out, const struct model *model,
                       const struct settings *settings)
{
    unsigned bytes = storage_voxel_bytes(model->storage);
    unsigned word_bytes = model->storage == QV_STORAGE_RGBA16 ? 2 : 1;
    memset(array, 0, sizeof *array);
    array->out = out;
    array->model = model;
    array->header_file = has_ending(settings->output, ".h");
    if (settings->name != NULL) {
        snprintf(array->name, sizeof array->name, "%s", settings->name);
    } else {
        name_from_file(array->name, settings->output);
    }
    print_comment(array);
    print(array, "#include \"qvol.h\"\n");
    if (!array->header_file) {
        print(array, "\n/* For those who use it: */\nextern const qv_volume %s_volume;\n",
              array->name);
    }
    start_array(array, "voxels", word_bytes,
                voxel_count(&model->classifier.scalars) * bytes / word_bytes);
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

static void print_palette(struct flash_array *array)
{
    const struct model *model = array->model;
    unsigned word_bytes = model->palette_bytes == QV_PALETTE16_BYTES ? 2 : 1;
    start_array(array, "palette", word_bytes, model->palette_bytes / word_bytes);
    flash_array_voxels(array, model->palette, model->palette_bytes);
    print(array, "\n};\n");
}

static const char *storage_constant(qv_storage storage)
{
    switch (storage) {
    case QV_STORAGE_RGBA8:
        return "QV_STORAGE_RGBA8";
    case QV_STORAGE_RGBA16:
        return "QV_STORAGE_RGBA16";
    case QV_STORAGE_INDEXED8:
        return "QV_STORAGE_INDEXED8";
    default:
        return "QV_STORAGE_INDEXED8_16";
    }
}

/* Positional, so that C++ takes it as well; the order is that of qv_volume. */
static void print_descriptor(struct flash_array *array)
{
    const struct model *model = array->model;
    const qv_scalars *scalars = &model->classifier.scalars;
    unsigned bytes = storage_voxel_bytes(model->storage);
    unsigned row = bytes * scalars->size[0];
    char palette[FLASH_NAME_BYTES + 32] = "0";
    if (model->palette != NULL) {
        snprintf(palette, sizeof palette, "(qv_address)%s_palette", array->name);
    }
    print(array, "\n%sconst qv_volume %s_volume = {\n", array->header_file ? "static " : "",
          array->name);
    print(array, "    (qv_address)%s_voxels,\n    %s,\n", array->name, palette);
    print(array, "    %" PRIu64 "u, /* bytes of voxels */\n    %" PRIu32 "u, /* of palette */\n",
          voxel_count(scalars) * bytes, model->palette_bytes);
    print(array, "    {%u, %u, %u}, /* size */\n    %s,\n", scalars->size[0], scalars->size[1],
          scalars->size[2], storage_constant(model->storage));
    print(array, "    {%" PRIu32 "u, %" PRIu32 "u, %" PRIu32 "u}, /* spacing, Q16.16 */\n",
          scalars->spacing[0], scalars->spacing[1], scalars->spacing[2]);
    print(array, "    0, /* unit distance: the step */\n    0, /* extinction */\n");
    print(array, "    {%u, %u, %u}, /* strides */\n};\n", bytes, row, row * scalars->size[1]);
}

void flash_array_end(struct flash_array *array)
{
    print(array, "\n};\n");
    if (array->model->palette != NULL) {
        print_palette(array);
    }
    print_descriptor(array);
}
