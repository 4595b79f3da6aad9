/*
 * frame_file.c - a frame as a file.
 */
#include "frame_file.h"
#include "error.h"

#include <stdlib.h>
#include <string.h>

static picture_writer *choose_writer(const struct settings *settings)
{
    const char *name = settings->output;
    picture_writer *writer = picture_writer_by_name(name);
    switch (settings->container) {
    case CONTAINER_PNG:
        return picture_writer_png();
    case CONTAINER_PAM:
        return write_pam;
    case CONTAINER_RAW:
        return NULL;
    default:
        break;
    }
    if (writer == NULL && is_standard_stream(name)) {
        return write_pam;
    }
    if (writer == NULL && !has_ending(name, ".raw") && !has_ending(name, ".bin")) {
        usage_error("--output", "'%s' does not end in .png, .pam, .raw or .bin; give --as", name);
    }
    return writer;
}

/* What can be refused before anything is read. */
static void check_outputs(const struct settings *settings)
{
    if (settings->output == NULL) {
        usage_error("--output", "is missing");
    }
    if (settings->json != NULL && strcmp(settings->json, settings->output) == 0) {
        usage_error("--json", "report and picture cannot both go to '%s'", settings->json);
    }
}

picture_writer *frame_file_writer(const struct settings *settings)
{
    check_outputs(settings);
    return choose_writer(settings);
}

void frame_file_write(output *out, const struct frame *frame, picture_writer *writer)
{
    struct picture picture;
    if (writer == NULL) {
        output_write(out, frame->bytes, frame->byte_count);
        return;
    }
    pixel_format_show(&picture, frame->format, frame->bytes, frame->width, frame->height);
    writer(out, &picture);
    free(picture.pixels);
}
