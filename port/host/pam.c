/*
 * pam.c - Netpbm's PAM: a few lines of text, then the samples.
 */
#include "picture.h"
#include "error.h"
#include "values.h"

#include <stdio.h>
#include <string.h>

#define LINE_BYTES 128

static const char *const tuple_types[] = {"", "GRAYSCALE", "GRAYSCALE_ALPHA", "RGB", "RGB_ALPHA"};

void write_pam(output *out, const struct picture *picture)
{
    char header[LINE_BYTES * 2];
    int length = snprintf(header, sizeof header,
                          "P7\nWIDTH %u\nHEIGHT %u\nDEPTH %u\nMAXVAL 255\nTUPLTYPE %s\nENDHDR\n",
                          picture->width, picture->height, picture->channels,
                          tuple_types[picture->channels]);
    output_write(out, header, (size_t)length);
    output_write(out, picture->pixels,
                 (size_t)picture->width * picture->height * picture->channels);
}

struct pam_header {
    uint32_t width, height, depth, maximum;
};

/* Lines with other keys (TUPLTYPE, comments) do not matter here. */
static void read_field(struct pam_header *header, const char *name, const char *line)
{
    const struct {
        const char *key;
        uint32_t *value;
    } fields[] = {{"WIDTH ", &header->width},
                  {"HEIGHT ", &header->height},
                  {"DEPTH ", &header->depth},
                  {"MAXVAL ", &header->maximum}};
    for (unsigned i = 0; i < sizeof fields / sizeof fields[0]; i++) {
        size_t length = strlen(fields[i].key);
        if (strncmp(line, fields[i].key, length) == 0 &&
            !read_sizes(line + length, 1, PICTURE_SIDE_MOST, fields[i].value)) {
            data_error(name, fields[i].key, "'%s' is not a number in range", line + length);
        }
    }
}

/* Fields come in any order; one that is missing stays 0. */
static void read_header(struct pam_header *header, const char *name, FILE *file)
{
    char line[LINE_BYTES];
    memset(header, 0, sizeof *header);
    while (fgets(line, sizeof line, file) != NULL) {
        size_t length = strcspn(line, "\n");
        line[length] = '\0';
        if (strcmp(line, "ENDHDR") == 0) {
            return;
        }
        read_field(header, name, line);
    }
    data_error(name, "header", "has no ENDHDR");
}

void read_pam(struct picture *picture, const char *name, FILE *file, uint64_t bytes)
{
    struct pam_header header;
    uint64_t expected;
    long place;
    read_header(&header, name, file);
    if (header.width == 0 || header.height == 0 || header.depth < 1 || header.depth > 4) {
        data_error(name, "header", "WIDTH, HEIGHT or DEPTH (1 to 4) is missing");
    }
    if (header.maximum != 255) {
        data_error(name, "MAXVAL", "only 255 can be read");
    }
    expected = (uint64_t)header.width * header.height * header.depth; /* below 2^32 */
    place = ftell(file);
    if (place < 0 || bytes - (uint64_t)place != expected) {
        data_error(name, "data", "%llu bytes, the header implies %llu",
                   (unsigned long long)(bytes - (uint64_t)place), (unsigned long long)expected);
    }
    picture_create(picture, header.width, header.height, header.depth);
    if (fread(picture->pixels, 1, (size_t)expected, file) != expected) {
        data_error(name, "data", "cannot be read to the end");
    }
}
