/* Several elements, by the formulas of one: sections 17, 19, 34 and 69. */
#include "stages.h"

#include "classify.h"
#include "entries.h"
#include "operations.h"
#include "picture.h"

static const char *const letters[4] = {"r", "g", "b", "a"};

enum { PIXELS = 12 };

void stage_line(csv *c)
{
    const long y = small(in(c, "y"));
    row_of_bytes rows[FORMATS] = {{0, {0}}};
    for (unsigned x = 0; x < PIXELS; x++) {
        channels of;
        for (int channel = 0; channel < 4; channel++)
            of.v[channel] = in(c, "%s%u", letters[channel], x);
        for (int format = 0; format < FORMATS; format++)
            put_pixel(&rows[format], (enum pixel_format)format, &of, (long)x, y);
    }
    for (unsigned i = 0; i < FORMATS; i++)
        out(c, whole(crc_of_row(0, &rows[i])), "crc%u", i);
}

void stage_palette(csv *c)
{
    const triple index = in_triple(c, "index");
    number entry = in(c, "entry");
    const int second = is_less(entry, index.v[1]) ? 1 : 2;
    number first = index.v[second - 1], last = index.v[second];
    number place = clamp(entry, first, last);
    for (unsigned i = 0; i < 4; i++) {
        const triple value = in_triple(c, letters[i]);
        number v =
            table_entry(value.v[second - 1], value.v[second], sub(place, first), sub(last, first));
        out(c, v, "rgba16%u", i);
        out(c, to8(v), "rgba8%u", i);
    }
}

enum { RESULTS = 4 };

/* The taps of a result, of which p is the place and n the size of the finer level. */
static void in_taps(csv *c, taps *of, const long p[3], const long n[3])
{
    for (int t = 0; t < TAPS; t++) {
        const long x = tap_voxel(p[0], t % 4, n[0]), y = tap_voxel(p[1], t / 4 % 4, n[1]);
        const long z = tap_voxel(p[2], t / 16, n[2]);
        const unsigned voxel = (unsigned)(x + n[0] * (y + n[1] * z));
        of->X[t] = in(c, "x%u", voxel);
        for (int channel = 0; channel < 3; channel++)
            of->C[channel][t] = in(c, "%s%u", letters[channel], voxel);
    }
}

void stage_coarser(csv *c)
{
    static const int inner[3] = {32, 16, 19};
    const triple size = in_triple(c, "n");
    const long n[3] = {small(size.v[0]), small(size.v[1]), small(size.v[2])};
    const long width = (n[0] + 1) / 2, height = (n[1] + 1) / 2, depth = (n[2] + 1) / 2;
    number tap = whole(inner[small(in(c, "filter")) % 3]);
    const bool is_converted = sign_of(in(c, "converted")) != 0;
    for (long i = 0; i < RESULTS; i++) {
        const long p[3] = {i % width, i / width % height, i / (width * height)};
        reduced r = {.X = whole(0), .c = {{whole(0), whole(0), whole(0)}}};
        if (p[2] < depth) {
            taps of;
            in_taps(c, &of, p, n);
            r = downsample(&of, tap, is_converted);
        }
        for (int channel = 0; channel < 3; channel++)
            out(c, r.c.v[channel], "c%s%u", letters[channel], (unsigned)i);
        out(c, r.X, "cx%u", (unsigned)i);
    }
}

enum { ENTRIES = 3 };

void stage_associated(csv *c)
{
    const bool is_wide = sign_of(in(c, "wide")) != 0;
    for (unsigned i = 0; i < ENTRIES; i++) {
        number A = in(c, "a%u", i);
        for (int channel = 0; channel < 3; channel++) {
            number v = in(c, "%s%u", letters[channel], i);
            out(c, is_wide ? associated_of_16(v, A) : associated_of_8(v, A), "a%s%u",
                letters[channel], i);
        }
        out(c, is_wide ? to8(A) : A, "aa%u", i);
    }
}
