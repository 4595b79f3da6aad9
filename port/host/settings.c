/*
 * settings.c - the options: their names, their help, and how each is read.
 */
#include "settings.h"
#include "error.h"
#include "parallel.h"
#include "pixel_format.h"
#include "settings_advise.h"
#include "settings_cache.h"
#include "settings_freevoxel.h"
#include "settings_input.h"
#include "settings_slices.h"

#include <stddef.h>
#include <string.h>

/* A full turn many times over; beyond, degrees lose the digits that matter. */
#define DEGREES_MOST 1e6

/* What the library's 32 bits hold: Q16.16, and after a reduction by FACTOR_MOST too. */
#define EXTINCTION_LEAST    (1.0 / QV_ONE_Q16)
#define EXTINCTION_MOST     65535
#define UNIT_DISTANCE_LEAST (1.0 / 256)
#define UNIT_DISTANCE_MOST  4096

/* Levels of the longest axis. */
#define LEVEL_MOST 12

const choice storage_names[] = {
    {"rgba8", QV_STORAGE_RGBA8},
    {"rgba16", QV_STORAGE_RGBA16},
    {"indexed8", QV_STORAGE_INDEXED8},
    {"rgbt8", QV_STORAGE_RGBT8},
    {"rgbt16", QV_STORAGE_RGBT16},
    {"associated8", QV_STORAGE_ASSOCIATED8},
    {NULL, 0},
};

const choice sampling_names[] = {
    {"nearest", SAMPLING_NEAREST},
    {"separate", SAMPLING_SEPARATE},
    {"weighted", SAMPLING_WEIGHTED},
    {"preweighted", SAMPLING_PREWEIGHTED},
    {"extinction", SAMPLING_EXTINCTION},
    {"bspline-weighted", SAMPLING_BSPLINE_WEIGHTED},
    {"bspline-extinction", SAMPLING_BSPLINE_EXTINCTION},
    {NULL, 0},
};

const choice filter_names[] = {
    {"box2", FILTER_BOX2},
    {"box4", FILTER_BOX4},
    {"quad4", FILTER_QUAD4},
    {NULL, 0},
};

const choice domain_names[] = {
    {"extinction", DOMAIN_EXTINCTION},
    {"opacity", DOMAIN_OPACITY},
    {NULL, 0},
};

static const choice order_names[] = {
    {"front-to-back", ORDER_FRONT_TO_BACK}, {"back-to-front", ORDER_BACK_TO_FRONT}, {NULL, 0}};
static const choice container_names[] = {
    {"png", CONTAINER_PNG}, {"pam", CONTAINER_PAM}, {"raw", CONTAINER_RAW}, {NULL, 0}};

static void set_storage(struct settings *settings, const char *option, const char *value)
{
    settings->storage = choose(option, value, storage_names);
}

static void set_palette_bits(struct settings *settings, const char *option, const char *value)
{
    settings->palette_bits = (unsigned)integer_between(option, value, 8, 16);
    if (settings->palette_bits != 8 && settings->palette_bits != 16) {
        usage_error(option, "'%s' is neither 8 nor 16", value);
    }
}

static void set_extinction(struct settings *settings, const char *option, const char *value)
{
    settings->extinction_given = true;
    settings->extinction = 0;
    if (strcmp(value, "auto") != 0) {
        settings->extinction = decimal_between(option, value, EXTINCTION_LEAST, EXTINCTION_MOST);
    }
}

static void set_unit_distance(struct settings *settings, const char *option, const char *value)
{
    settings->unit_distance =
        decimal_between(option, value, UNIT_DISTANCE_LEAST, UNIT_DISTANCE_MOST);
}

static void set_transfer(struct settings *settings, const char *option, const char *value)
{
    settings_keep_name(&settings->transfer, option, value);
}

static void set_mask(struct settings *settings, const char *option, const char *value)
{
    settings_keep_name(&settings->mask, option, value);
}

static void set_mask_transfer(struct settings *settings, const char *option, const char *value)
{
    settings_keep_name(&settings->mask_transfer, option, value);
}

/* Both ends may be negative: --window=-100:300. */
static void set_window(struct settings *settings, const char *option, const char *value)
{
    double *window = settings->window;
    if (!read_decimals(value, ':', 2, window) || !(window[0] < window[1])) {
        usage_error(option, "'%s' is not LOW:HIGH with LOW below HIGH", value);
    }
    settings->window_given = true;
}

static void set_shade(struct settings *settings, const char *option, const char *value)
{
    (void)option;
    (void)value;
    settings->shade = true;
}

/* That of --shade has two numbers; light from outside has a colour, too. */
static void set_light(struct settings *settings, const char *option, const char *value)
{
    const char *comma = strchr(value, ',');
    if (comma != NULL && strchr(comma + 1, ',') != NULL) {
        set_lamp(settings, option, value);
        return;
    }
    if (!read_decimals(value, ',', 2, settings->light)) {
        usage_error(option, "'%s' is not RIGHT,UP in degrees, nor AZ,EL,RRGGBB", value);
    }
    settings->light_given = true;
}

static void set_sampling(struct settings *settings, const char *option, const char *value)
{
    settings->sampling = choose(option, value, sampling_names);
}

static void set_order(struct settings *settings, const char *option, const char *value)
{
    settings->order = choose(option, value, order_names);
}

static void set_level(struct settings *settings, const char *option, const char *value)
{
    settings->level_given = true;
    settings->level_auto = strcmp(value, "auto") == 0;
    if (!settings->level_auto) {
        settings->level = decimal_between(option, value, 0, LEVEL_MOST);
    }
}

static void set_filter(struct settings *settings, const char *option, const char *value)
{
    settings->filter = choose(option, value, filter_names);
}

static void set_domain(struct settings *settings, const char *option, const char *value)
{
    settings->domain = choose(option, value, domain_names);
}

static void set_size(struct settings *settings, const char *option, const char *value)
{
    if (!read_sizes(value, 2, QV_PIXEL_MAX, settings->size)) {
        usage_error(option, "'%s' is not WxH, each 1 to %d", value, QV_PIXEL_MAX);
    }
}

static void set_azimuth(struct settings *settings, const char *option, const char *value)
{
    settings->angles[0] = decimal_between(option, value, -DEGREES_MOST, DEGREES_MOST);
}

static void set_elevation(struct settings *settings, const char *option, const char *value)
{
    settings->angles[1] = decimal_between(option, value, -DEGREES_MOST, DEGREES_MOST);
}

static void set_roll(struct settings *settings, const char *option, const char *value)
{
    settings->angles[2] = decimal_between(option, value, -DEGREES_MOST, DEGREES_MOST);
}

static void set_zoom(struct settings *settings, const char *option, const char *value)
{
    settings->zoom = decimal_between(option, value, 1.0 / 1024, 1024);
}

static void set_perspective(struct settings *settings, const char *option, const char *value)
{
    settings->perspective = decimal_between(option, value, 1, 150);
}

static void set_step(struct settings *settings, const char *option, const char *value)
{
    settings->step = decimal_between(option, value, STEP_LEAST, STEP_MOST);
    settings->step_given = true;
}

static void set_phase(struct settings *settings, const char *option, const char *value)
{
    settings->phase = decimal_between(option, value, 0, 65535.0 / 65536);
    settings->phase_given = true;
}

static void set_termination(struct settings *settings, const char *option, const char *value)
{
    settings->termination = decimal_between(option, value, 0, 1);
}

static void set_background(struct settings *settings, const char *option, const char *value)
{
    settings->background[3] = 255;
    if (strcmp(value, "transparent") == 0) {
        memset(settings->background, 0, sizeof settings->background);
    } else if (!read_colour(value, settings->background)) {
        usage_error(option, "'%s' is neither RRGGBB nor transparent", value);
    }
}

/* Looked up here so that a wrong name ends the command at once. */
static void set_format(struct settings *settings, const char *option, const char *value)
{
    pixel_format_find(option, value);
    settings->format = value;
}

static void set_container(struct settings *settings, const char *option, const char *value)
{
    settings->container = choose(option, value, container_names);
}

static void set_strip(struct settings *settings, const char *option, const char *value)
{
    settings->strip = (uint32_t)integer_between(option, value, 1, QV_PIXEL_MAX);
}

/* One factor stands for all axes. */
static void set_reduce(struct settings *settings, const char *option, const char *value)
{
    uint32_t *reduce = settings->reduce;
    if (read_sizes(value, 1, FACTOR_MOST, reduce)) {
        reduce[1] = reduce[2] = reduce[0];
    } else if (!read_sizes(value, 3, FACTOR_MOST, reduce)) {
        usage_error(option, "'%s' is neither F nor FXxFYxFZ, each 1 to %d", value, FACTOR_MOST);
    }
}

static void set_fit(struct settings *settings, const char *option, const char *value)
{
    settings->fit = integer_between(option, value, 1, INT64_MAX);
}

static void set_name(struct settings *settings, const char *option, const char *value)
{
    if (value[0] == '\0' ||
        strspn(value, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                      "0123456789_") != strlen(value) ||
        (value[0] >= '0' && value[0] <= '9')) {
        usage_error(option, "'%s' is not a name in C", value);
    }
    settings->name = value;
}

static void set_tolerance(struct settings *settings, const char *option, const char *value)
{
    settings->tolerance = decimal_between(option, value, 0, 255);
}

static void set_gain(struct settings *settings, const char *option, const char *value)
{
    settings->gain = decimal_between(option, value, 0, 255);
    settings->gain_given = true;
}

static void set_threads(struct settings *settings, const char *option, const char *value)
{
    settings->threads = (unsigned)integer_between(option, value, 1, THREADS_MOST);
}

static void set_from(struct settings *settings, const char *option, const char *value)
{
    settings_keep_name(&settings->from, option, value);
}

static void set_output(struct settings *settings, const char *option, const char *value)
{
    settings_keep_name(&settings->output, option, value);
}

static void set_json(struct settings *settings, const char *option, const char *value)
{
    settings_keep_name(&settings->json, option, value != NULL ? value : "-");
}

static void set_quiet(struct settings *settings, const char *option, const char *value)
{
    (void)option;
    (void)value;
    settings->quiet = true;
}

const struct option_spec option_specs[] = {
    {"dims", 0, "XxYxZ", "voxels of raw data, x fastest", set_dims, GROUP_INPUT},
    {"type", 0, "TYPE", "u8 s8 u16le s16be f32le ... or rgba8 rgba16le rgbt8 rgbt16be indexed8",
     set_type, GROUP_INPUT},
    {"skip", 0, "BYTES", "before raw data (0)", set_skip, GROUP_INPUT},
    {"spacing", 0, "XxYxZ", "between voxels; replaces the file's", set_spacing, GROUP_INPUT},
    {"palette", 0, "FILE", "of indexed8 data: 1024 or 2048 bytes of RGBA or RGBT", set_palette,
     GROUP_INPUT},
    {"endian", 0, "little|big", "of a 16-bit palette, and of 16-bit raw output (little)",
     set_endian, GROUP_INPUT},

    {"storage", 0, "KIND", "rgba8, rgba16, indexed8, rgbt8, rgbt16 or associated8", set_storage,
     GROUP_CLASSIFY},
    {"palette-bits", 0, "8|16", "width of the palette of indexed8 (8)", set_palette_bits,
     GROUP_CLASSIFY},
    {"extinction", 0, "E|auto", "depth of the full value of rgbt8, rgbt16 or an indexed8 palette",
     set_extinction, GROUP_CLASSIFY},
    {"unit-distance", 0, "VOXELS", "length for which opacities hold (the step, or 1)",
     set_unit_distance, GROUP_CLASSIFY},
    {"tf", 0, "NAME|FILE", "transfer function: a preset or a text file", set_transfer,
     GROUP_CLASSIFY},
    {"window", 0, "LOW:HIGH", "values of entries 0 and 255 (0:255, or the data's range)",
     set_window, GROUP_CLASSIFY},
    {"shade", 0, NULL, "shade voxels by their gradient, not with indexed8", set_shade,
     GROUP_CLASSIFY},
    {"mask", 0, "FILE", "a scan of one organ: where it is above 0 it stands in for IN", set_mask,
     GROUP_CLASSIFY},
    {"mask-tf", 0, "NAME|FILE", "transfer function of the mask", set_mask_transfer, GROUP_CLASSIFY},
    {"light", 0, "RIGHT,UP", "degrees from the viewer to the light of --shade (-40,40)", set_light,
     GROUP_CLASSIFY},

    {"sampling", 0, "MODE", "how samples are made, see below (weighted)", set_sampling,
     GROUP_PICTURE},
    {"order", 0, "ORDER", "front-to-back or back-to-front (rays: the one, slices: the other)",
     set_order, GROUP_PICTURE},
    {"level", 0, "L|auto", "level of detail, 1.5 lies between two; 0 is the volume", set_level,
     GROUP_PICTURE},
    {"filter", 0, "FILTER", "of coarser levels: box2, box4 or quad4 (box4; B-splines: quad4)",
     set_filter, GROUP_LEVELS},
    {"domain", 0, "DOMAIN", "averaged for them: extinction or opacity (extinction)", set_domain,
     GROUP_LEVELS},
    {"size", 's', "WxH", "of the frame in pixels (512x512)", set_size, GROUP_FRAME},
    {"azimuth", 0, "DEG", "moves the viewer from -y towards +x (0)", set_azimuth, GROUP_VIEW},
    {"elevation", 0, "DEG", "lifts the viewer towards +z (0)", set_elevation, GROUP_VIEW},
    {"roll", 0, "DEG", "turns the camera clockwise (0)", set_roll, GROUP_VIEW},
    {"zoom", 0, "FACTOR", "at 1 the whole box fits at any angle (1)", set_zoom, GROUP_FRAME},
    {"perspective", 0, "DEG", "field of view from top to bottom, 1 to 150", set_perspective,
     GROUP_FRAME},
    {"step", 0, "VOXELS", "between samples, of the smallest spacing (1)", set_step, GROUP_PICTURE},
    {"phase", 0, "SHARE", "of a step: shifts the samples, below 1 (0)", set_phase, GROUP_PICTURE},
    {"background", 0, "COLOUR", "RRGGBB or transparent (000000)", set_background, GROUP_FRAME},
    {"termination", 0, "SHARE", "of light at which a ray or pixel ends, front to back (64/65535)",
     set_termination, GROUP_PICTURE},
    {"format", 0, "FORMAT", "pixels as a display takes them, see below", set_format, GROUP_FRAME},
    {"as", 0, "KIND", "png, pam or raw (the device's bytes), whatever FILE ends in", set_container,
     GROUP_FRAME},
    {"compositing", 0, "HOW", "rays, or slices in a frame buffer that stays, see below (rays)",
     set_compositing, GROUP_PICTURE},
    {"framebuffer", 0, "BITS", "8, 12, 16 or 24 a channel, or 565 (8)", set_framebuffer,
     GROUP_PICTURE},
    {"dither", 0, "HOW",
     "none, random, ordered, bump, rounding, feedback, auto (rounding; 24: none)", set_dither,
     GROUP_PICTURE},
    {"residual", 0, "4|8", "bits a channel beside the frame buffer, for feedback (8) or auto (0)",
     set_residual, GROUP_PICTURE},
    {"sequence", 0, "NAME", "of dither values: golden, hash or blocks (blocks; random: hash)",
     set_sequence, GROUP_PICTURE},
    {"period", 0, "SLICES", "of random, ordered and bumped dither and tables, 2 to 64 (32)",
     set_period, GROUP_PICTURE | GROUP_TABLE},
    {"slope", 0, "A[,B]", "multiplies dithered opacities; bumped, by B from the knee on (1)",
     set_slope, GROUP_PICTURE | GROUP_TABLE},
    {"cutoff", 0, "LEVEL", "of 255: opacities above are rounded, not dithered (255)", set_cutoff,
     GROUP_PICTURE | GROUP_TABLE},
    {"frame", 0, "N", "shifts the dither from frame to frame (0)", set_frame, GROUP_PICTURE},
    {"still", 0, NULL, "the same dither for all pixels of a slice", set_still, GROUP_PICTURE},
    {"chunk", 0, "SLICES", "drawn into a buffer of their own, and that into the picture", set_chunk,
     GROUP_PICTURE},
    {"slices", 0, "N", "through the box, in place of --step; opacities hold for 1 voxel",
     set_slices, GROUP_PICTURE},
    {"bricks", 0, "XxYxZ", "parts of the volume, each drawn into a buffer of its own", set_bricks,
     GROUP_PICTURE},
    {"strip", 0, "ROWS", "rendered at a time; changes no byte (16)", set_strip, GROUP_PICTURE},
    {"cache", 0, "PAGES", "voxels through so many; changes no byte, --json counts reads", set_cache,
     GROUP_PICTURE},
    {"page", 0, "XxYxZ", "voxels in a page, powers of 2; 4096x4096x1: slices (8x8x8)", set_page,
     GROUP_PICTURE},

    {"directions", 0, "SET", "that light is kept for: all, faces, or a list as +x,-y,+x+z (all)",
     set_directions, GROUP_FREEVOXEL},
    {"order", 0, "ORDER", "of voxels in the file: linear, morton or hilbert (linear)",
     set_voxel_order, GROUP_FREEVOXEL},
    {"levels", 0, "N", "coarser levels (all, down to one voxel)", set_level_count, GROUP_FREEVOXEL},
    {"hierarchy", 0, "KIND", "light of levels: rebuilt of each, or geometric means (rebuilt)",
     set_hierarchy, GROUP_FREEVOXEL},
    {"uncorrected", 0, NULL, "opacities hold for a step of any direction, as published",
     set_uncorrected, GROUP_FREEVOXEL},

    {"splatting", 0, "HOW", "added: no leak; or over, the conventional one (added)", set_splatting,
     GROUP_SPLAT},
    {"kernel", 0, "KERNEL", "linear or quadratic, 2 or 3 voxels wide (quadratic)", set_kernel,
     GROUP_SPLAT},
    {"interpolation", 0, "HOW",
     "light, depths or nearest: what is known between directions (light)", set_interpolation,
     GROUP_SPLAT},
    {"level", 0, "L", "the finest that is drawn; 0 is the volume (0)", set_finest_level,
     GROUP_SPLAT},
    {"levels", 0, NULL, "coarser ones, too, where their voxels are narrow in the picture",
     set_coarser_levels, GROUP_SPLAT},
    {"detail", 0, "PIXELS", "that width, below 256 (1)", set_detail, GROUP_SPLAT},
    {"part", 0, "K/N", "of the voxels: those whose place in the file is K - 1 modulo N", set_part,
     GROUP_SPLAT},
    {"light", 0, "AZ,EL,RRGGBB", "from where a viewer of these angles stands; up to 4 times",
     set_lamp, GROUP_SPLAT},
    {"ambient", 0, "RRGGBB", "light from everywhere, beside --light AZ,EL,RRGGBB (000000)",
     set_ambient, GROUP_LIGHTING},

    {"reduce", 0, "F|FXxFYxFZ", "means over boxes of that many voxels", set_reduce, GROUP_REDUCE},
    {"fit", 0, "BYTES", "smallest factors with which voxels and palette fit", set_fit,
     GROUP_REDUCE},
    {"dither-table", 0, "KIND", "of the transfer function, in C: opacity or colour",
     set_dither_table, GROUP_TABLE},
    {"name", 0, "NAME", "of the C array (from FILE)", set_name, GROUP_EXPORT},

    {"target", 0, "NAME", "the device, or host", set_target, GROUP_ADVISE},
    {"error", 0, "E", "levels of 255 that no pixel may be off by more", set_error, GROUP_ADVISE},
    {"rms", 0, "E", "levels of 255 that the RMS error may have at most", set_rms, GROUP_ADVISE},
    {"against", 0, "WHAT", "errors from the medium, or from the same samples (medium)", set_against,
     GROUP_ADVISE},
    {"voxel-bytes", 0, "N", "that a voxel may take at most", set_voxel_bytes, GROUP_ADVISE},
    {"slices", 0, "N", "that are not empty behind a pixel: advises a frame buffer (1000)",
     set_slices, GROUP_ADVISE},
    {"framebuffer", 0, "BITS", "8, 12, 16 or 24 a channel, or 565 (any)", set_framebuffer,
     GROUP_ADVISE},
    {"residual", 0, "4|8", "bits a channel beside a frame buffer of 8 (any)", set_residual,
     GROUP_ADVISE},
    {"opacity", 0, "A", "that no slice has less of, above 0 (any)", set_opacity, GROUP_ADVISE},
    {"content", 0, "KIND", "of slices: any, or fog, which is constant (any)", set_content,
     GROUP_ADVISE},

    {"from", 0, "FOLDER", "with the test vectors (those that are installed)", set_from,
     GROUP_VECTORS},

    {"tolerance", 0, "LEVELS", "differences that count as equal (0)", set_tolerance, GROUP_COMPARE},
    {"gain", 0, "FACTOR", "of the difference picture (16)", set_gain, GROUP_COMPARE},

    {"output", 'o', "FILE", "what to write; - is standard output", set_output, GROUP_OUTPUT},
    {"json", 0, "[FILE]", "report as JSON (standard output)", set_json, GROUP_REPORT},
    {"threads", 0, "N", "1 to 256; changes no byte (all processors)", set_threads, GROUP_THREADS},
    {"quiet", 'q', NULL, "no progress, no summary", set_quiet, GROUP_COMMON},
    {NULL, 0, NULL, NULL, NULL, 0},
};
