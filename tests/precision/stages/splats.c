/*
 * splats.c - FreeVoxels: the bytes of attenuation, and the pixels of a footprint.
 */
#include "search.h"

#include "attenuation.h"
#include "kernel.h"

#include <string.h>

#define LN_2 0.693147180559945309417232121458176568L

/* ---- Bytes -------------------------------------------------------------------------------- */

static double byte_error(const uint64_t depth[], unsigned unused)
{
    (void)unused;
    return (double)(qv_attenuation_byte(depth[0]) -
                    255 * exp2l(-ldexpl((long double)depth[0], -32)));
}

static void tell_depth(measured *m, const uint64_t depth[], unsigned unused)
{
    (void)unused;
    measured_input(m, "0x%llX", (unsigned long long)depth[0]);
}

static void measure_byte(measured *m, unsigned parameter)
{
    static const search s = {byte_error, tell_depth, 1, {(uint64_t)10 << 32}};
    search_worst(m, &s, parameter);
}

/* ---- Paths -------------------------------------------------------------------------------- */

/* A row of voxels along x, of which as many as the period says follow each other again. */
enum { PATH_MOST = 256, PERIOD = 4, AHEAD = 13 }; /* the direction (1, 0, 0) */

typedef struct path {
    uint16_t entry[PATH_MOST][4];
    uint8_t byte[PATH_MOST];
    qv_volume volume;
    qv_attenuation attenuation;
} path;

static void make_path(path *made, const uint64_t input[], unsigned voxels)
{
    memset(made, 0, sizeof *made);
    for (unsigned i = 0; i < voxels; i++)
        made->entry[i][3] = (uint16_t)input[i % PERIOD];
    made->volume.voxels = (qv_address)made->entry;
    made->volume.voxels_bytes = sizeof made->entry[0] * voxels;
    made->volume.storage = QV_STORAGE_RGBA16;
    for (unsigned axis = 0; axis < 3; axis++) {
        made->volume.size[axis] = (uint16_t)(axis == 0 ? voxels : 1);
        made->volume.stride[axis] = (int32_t)sizeof made->entry[0];
        made->attenuation.size[axis] = made->volume.size[axis];
    }
    made->attenuation.records = made->byte;
    made->attenuation.bytes = voxels;
    made->attenuation.directions = (uint32_t)1 << AHEAD;
}

/* Of the first voxel's byte, behind which all others lie. */
static double path_error(const uint64_t input[], unsigned voxels)
{
    static path made;
    long double sum = 0;
    make_path(&made, input, voxels);
    if (qv_attenuate(made.byte, voxels, NULL, &made.attenuation, &made.volume,
                     &qv_domain_extinction, AHEAD) != QV_OK)
        return (double)INFINITY;
    for (unsigned i = 1; i < voxels; i++)
        sum -= log1pl(-(long double)made.entry[i][3] / 65535);
    return (double)(made.byte[0] - 255 * expl(-sum));
}

static void tell_path(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "opacities %u, %u, %u, %u again and again", (unsigned)input[0],
                   (unsigned)input[1], (unsigned)input[2], (unsigned)input[3]);
}

/* Thin voxels, so that the byte lies between its ends. */
static void measure_path(measured *m, unsigned voxels)
{
    const uint64_t most = 4 * 65535u / voxels;
    const search s = {path_error, tell_path, PERIOD, {most, most, most, most}};
    search_worst(m, &s, voxels);
}

/* ---- Footprints --------------------------------------------------------------------------- */

/* The integral of a kernel from its middle to t voxels on. */
static long double half_integral(const qv_kernel *kernel, long double t)
{
    if (2 * t >= kernel->halves)
        return .5L;
    if (kernel == &qv_kernel_linear)
        return t - t * t / 2;
    if (t <= .5L)
        return .75L * t - t * t * t / 3;
    return .5L - (1.5L - t) * (1.5L - t) * (1.5L - t) / 6;
}

static long double integral(const qv_kernel *kernel, long double t)
{
    return t < 0 ? -half_integral(kernel, -t) : half_integral(kernel, t);
}

/* Numbers of an input: the centre in a pixel, u0.16, the size less the least, and the pixel. A
   parameter is a kernel, and the greatest size in pixels. */
enum { PIXELS = 48 };

static const qv_kernel *kernel_of(unsigned parameter)
{
    return parameter % 2 == 0 ? &qv_kernel_linear : &qv_kernel_quadratic;
}

static double footprint_error(const uint64_t input[], unsigned parameter)
{
    const qv_kernel *kernel = kernel_of(parameter);
    const uint32_t size = (uint32_t)input[1] + QV_LEAST_WIDTH;
    const int32_t pixel = (int32_t)input[2] - PIXELS / 2;
    const long double middle = input[0] / 65536.L, voxel = size / 65536.L;
    qv_footprint footprint;
    qv_footprint_of(&footprint, kernel, (int64_t)input[0], size);
    const long double exact = voxel * (integral(kernel, (pixel + .5L - middle) / voxel) -
                                       integral(kernel, (pixel - .5L - middle) / voxel));
    return (double)(qv_footprint_weight(&footprint, pixel) - ldexpl(exact, 15));
}

static void tell_footprint(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "x %u, size %u, pixel %d", (unsigned)input[0],
                   (unsigned)input[1] + QV_LEAST_WIDTH, (int)input[2] - PIXELS / 2);
}

static void measure_footprint(measured *m, unsigned parameter)
{
    const search s = {footprint_error,
                      tell_footprint,
                      3,
                      {65535, (uint64_t)(parameter / 2) * 65536 - QV_LEAST_WIDTH, PIXELS}};
    search_worst(m, &s, parameter);
}

/* ---- The chapter -------------------------------------------------------------------------- */

#define PATH(n)                                                                                    \
    {                                                                                              \
        "attenuation, n = " #n, "unorm16 opacities to u8", "log, exp; to nearest", "1/255",        \
            .5001 + n * 6.3e-6, 4, "search, thin voxels", measure_path, n, NULL                    \
    }
#define FOOTPRINT(name, size, kernel, bound, reason)                                               \
    {                                                                                              \
        "footprint, " name, "centre, size u32.16 to u16.15", "table, parabola; cut", "2^-15",      \
            bound, 2, "search", measure_footprint, 2 * (size) + (kernel), reason                   \
    }

static const stage stages[] = {
    {"byte of attenuation", "depth u64.32 to u8", "exp; to nearest", "1/255", .5001, 2,
     "search, depths to 10", measure_byte, 0, NULL},
    PATH(4),
    PATH(64),
    PATH(256),
    FOOTPRINT("linear, to 1 pixel", 1, 0, 2.33, NULL),
    FOOTPRINT("linear, to 16 pixels", 16, 0, 3.53, NULL),
    FOOTPRINT("quadratic, to 1 pixel", 1, 1, 3.2, NULL),
    FOOTPRINT(
        "quadratic, to 16 pixels", 16, 1, 17.3,
        "Two edges have all of their errors at once,\n  and of unlike signs, in no footprint: "
        "table, bend and cubic are farthest off at different places."),
};

const chapter chapter_splats = {
    "Attenuation and footprint (SPEC 62, 66)",
    "**Byte.** One rounding, 1/2, of 24 bits of exp, which are 255 * 2^-24 off: .00002.\n\n"
    "**Path.** Depths sum up exactly; each voxel's is an extinction, off by .6 of 2^-24, which\n"
    "moves a transmittance by ln 2 of that at most: 6.3e-6 of a level of 255.\n\n"
    "**Footprint.** A weight is the difference of two edges, each cut towards the middle: less\n"
    "than 2 of 2^-15. Half the width is cut to whole 2^-16, which moves an edge by 1/8 at most.\n"
    "In units of 2^-16 of the kernel's integral, of which an edge of a voxel w pixels wide has\n"
    "w / 2: the reciprocal puts it 4 of 2^22 of half the width too near, the place is cut:\n"
    "below .08; the table of the linear kernel is exact, as is its parabola; that of the\n"
    "quadratic is rounded, by 1/2, the bend of its parabola by 2 of which 1/8 counts, and the\n"
    "cubic is .11 off the parabola: .86. Two edges: 2.25 + .08 w and 2.25 + .94 w.\n",
    stages, COUNT(stages)};
