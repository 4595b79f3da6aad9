/* The stage of whole pictures. */
#include "stages.h"

#include "picture.h"
#include "view.h"

static void in_voxels(csv *c, scene *s)
{
    static const char *const colours[3] = {"r", "g", "b"};
    s->size = in_triple(c, "n");
    s->bits = sign_of(in(c, "wide")) != 0 ? 16 : 8;
    for (int channel = 0; channel < 3; channel++)
        in_all(c, colours[channel], s->K[channel], VOXELS_MAX);
    in_all(c, "a", s->A, VOXELS_MAX);
}

static void in_camera(csv *c, scene *s)
{
    const view v = {.size = s->size,
                    .spacing = in_triple(c, "spacing"),
                    .M = rotation_of(in(c, "azimuth"), in(c, "elevation"), in(c, "roll")),
                    .pitch = in(c, "pitch"),
                    .step = in(c, "step"),
                    .W = in(c, "width"),
                    .H = in(c, "height")};
    number field = in(c, "field"), unit = in(c, "unit");
    number U = sign_of(unit) == 0 ? v.step : unit;
    const bool is_dense = s->mode == MODE_EXTINCTION || s->mode == MODE_BSPLINE_EXTINCTION;
    s->camera = sign_of(field) == 0 ? orthographic(&v) : perspective(&v, field);
    s->medium =
        medium_of(is_dense ? MEDIUM_OPACITY : MEDIUM_CORRECTED, U, whole(0), v.step, whole(0));
}

static scene in_scene(csv *c)
{
    scene s = {.mode = (enum picture_mode)(small(in(c, "mode")) % MODES),
               .is_back_to_front = sign_of(in(c, "back")) != 0,
               .phase = in(c, "phase"),
               .threshold = in(c, "threshold")};
    in_voxels(c, &s);
    in_camera(c, &s);
    in_all(c, "background", s.background.v, 4);
    return s;
}

enum { ROWS = 8 };

/* The rows of bytes of a picture; returns their number. */
static unsigned draw(row_of_bytes rows[], const scene *s, enum pixel_format format, long width,
                     long height, statistics *sum)
{
    const unsigned lines = format == FORMAT_MONO_VERTICAL ? 8 : 1;
    for (long y = 0; y < height; y++)
        for (long x = 0; x < width; x++) {
            const channels of = pixel_of(s, x, y, sum);
            put_pixel(&rows[(unsigned)y / lines], format, &of, x, y);
        }
    return ((unsigned)height + lines - 1) / lines;
}

void stage_picture(csv *c)
{
    row_of_bytes rows[ROWS] = {{0, {0}}};
    statistics sum = {0, 0, 0};
    const scene s = in_scene(c);
    const long width = small(in(c, "width")), height = small(in(c, "height"));
    if (width > ROWS || height > ROWS)
        fail("a picture of %ld * %ld pixels", width, height);
    const enum pixel_format format = (enum pixel_format)(small(in(c, "format")) % FORMATS);
    const unsigned count = draw(rows, &s, format, width, height, &sum);
    uint32_t all = 0;
    for (unsigned i = 0; i < ROWS; i++) {
        out(c, whole(i < count ? crc_of_row(0, &rows[i]) : 0), "crc%u", i);
        all = crc_of_row(all, &rows[i]);
    }
    out(c, whole(all), "picture");
    out(c, whole(sum.samples), "samples");
    out(c, whole(sum.skipped), "skipped");
    out(c, whole(sum.terminated), "terminated");
}
