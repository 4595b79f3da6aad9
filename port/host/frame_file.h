/*
 * frame_file.h - a frame as a file: a picture, or the device's own bytes.
 */
#ifndef QVOL_HOST_FRAME_FILE_H
#define QVOL_HOST_FRAME_FILE_H

#include "frame.h"

/* Checks the settings' outputs. The writer of pictures, or null for the device's own bytes. */
picture_writer *frame_file_writer(const struct settings *settings);

void frame_file_write(output *out, const struct frame *frame, picture_writer *writer);

#endif
