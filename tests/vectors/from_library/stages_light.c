/*
 * stages_light.c - compositing, read-out and pixels: sections 13 to 17.
 */
#include "stages.h"

#include "composite.h"
#include "pixels.h"
#include "ray.h"
#include "sample.h"

#include <string.h>

/* ---- Compositing ------------------------------------------------------------ */

typedef struct composite_inputs {
    uint64_t wide, o, l[3], e[3], t;
} composite_inputs;

typedef struct under_row {
    composite_inputs in;
    uint64_t threshold, a32, part[3], lost, en[3], tn, ended;
} under_row;

typedef struct over_row {
    composite_inputs in;
    uint64_t a32, part[3], lost, half[3], en[3], tn;
} over_row;

static uint64_t unit_of_o(uint64_t wide)
{
    return 65536u * (wide ? 65535u : 255u);
}

/* What a ray has gathered before. */
static qv_light light_of(const composite_inputs *in)
{
    const qv_light light = {
        {(uint32_t)in->e[0], (uint32_t)in->e[1], (uint32_t)in->e[2]}, (uint32_t)in->t, 0, 0};
    return light;
}

static uint32_t opacity_of(const composite_inputs *in)
{
    return qv_opacity_q32(fx_share_of((uint32_t)in->o),
                          in->wide ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8);
}

/* Whether a product of two 32-bit numbers ends with exactly one half of 2^32. */
static int is_tie(uint64_t a, uint64_t b)
{
    return (uint32_t)(a * b) == 0x80000000u;
}

static unsigned composite_flags(const composite_inputs *in, uint64_t a32)
{
    unsigned flags = a32 == UINT32_MAX ? VECTOR_OVERFLOW : 0;
    if (is_tie(in->t, a32) || is_tie(in->l[0], in->t) || is_tie(in->e[0], a32))
        flags |= VECTOR_TIE;
    return flags;
}

static unsigned under_compute(void *columns)
{
    under_row *row = columns;
    const composite_inputs *in = &row->in;
    const uint32_t sample[3] = {(uint32_t)in->l[0], (uint32_t)in->l[1], (uint32_t)in->l[2]};
    const uint32_t opacity = opacity_of(in);
    qv_light light = light_of(in);
    qv_under(&light, sample, opacity);
    for (unsigned c = 0; c < 3; c++) {
        row->part[c] = fx_high_product(sample[c], (uint32_t)in->t);
        row->en[c] = light.colour[c];
    }
    row->a32 = opacity;
    row->lost = fx_high_product((uint32_t)in->t, opacity);
    row->tn = light.transmittance;
    row->ended = light.transmittance <= row->threshold << 15;
    return composite_flags(in, opacity);
}

static unsigned over_compute(void *columns)
{
    over_row *row = columns;
    const composite_inputs *in = &row->in;
    const uint32_t sample[3] = {(uint32_t)in->l[0], (uint32_t)in->l[1], (uint32_t)in->l[2]};
    const uint32_t opacity = opacity_of(in);
    qv_light light = light_of(in);
    qv_over(&light, sample, opacity);
    for (unsigned c = 0; c < 3; c++) {
        row->part[c] = fx_high_product((uint32_t)in->e[c], opacity);
        row->half[c] = (in->l[c] + 1u) / 2u;
        row->en[c] = light.colour[c];
    }
    row->a32 = opacity;
    row->lost = fx_high_product((uint32_t)in->t, opacity);
    row->tn = light.transmittance;
    return composite_flags(in, opacity);
}

/* Colours of a sample are at most its opacity; what a ray has gathered, at most what it covers. */
static void draw_composite(composite_inputs *in, vector_random *random)
{
    in->wide = vector_bits(random, 1);
    in->o = vector_any(random, 32) % (unit_of_o(in->wide) + 1u);
    in->t = vector_any(random, 32) % 0x80000001u;
    for (unsigned c = 0; c < 3; c++) {
        uint64_t colour = vector_any(random, in->wide ? 16 : 8);
        in->l[c] = in->wide ? in->o * colour >> 16 : in->o * colour;
        in->e[c] = (0x80000000u - in->t) * vector_any(random, 16) >> 16;
    }
}

static void under_draw(void *columns, vector_random *random)
{
    under_row *row = columns;
    draw_composite(&row->in, random);
    row->threshold = vector_any(random, 16);
}

static void over_draw(void *columns, vector_random *random)
{
    over_row *row = columns;
    draw_composite(&row->in, random);
}

enum { COVERS = 6, OPACITIES = 6, COMPOSITE_EDGES = 2 * COVERS * OPACITIES };

/* Transmittances and opacities next to 0, 1/2 and 1, with colours 0, 1/2 and 1. */
static void composite_edge(composite_inputs *in, unsigned number)
{
    static const uint64_t covers[COVERS] = {0, 1, 0x40000000, 0x7FFFFFFE, 0x7FFFFFFF, 0x80000000};
    static const uint64_t opacities[OPACITIES] = {0, 1, 2, 128, 254, 255};
    in->wide = number / (COVERS * OPACITIES);
    in->o = opacities[number / COVERS % OPACITIES] * (unit_of_o(in->wide) / 255u);
    in->t = covers[number % COVERS];
    for (unsigned c = 0; c < 3; c++) {
        in->l[c] = in->wide ? in->o * (c * 32767u) >> 16 : in->o * (c * 127u);
        in->e[c] = (0x80000000u - in->t) / (c + 1u);
    }
}

static void under_edges(vector_set *set)
{
    for (unsigned i = 0; i < COMPOSITE_EDGES; i++) {
        under_row row = {.threshold = i % 2 ? 65535 : 0};
        composite_edge(&row.in, i);
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static void over_edges(vector_set *set)
{
    for (unsigned i = 0; i < COMPOSITE_EDGES; i++) {
        over_row row = {.a32 = 0};
        composite_edge(&row.in, i);
        vector_add(set, &row, VECTOR_EDGE);
    }
}

#define COMPOSITE_INPUTS                                                                           \
    {"wide", 1, 'i', "u1", "storage: 0 of 8 bits, 1 of 16 bits"},                                  \
        {"o", 1, 'i', "u32", "opacity of the sample, in its unit (section 12)"},                   \
        {"l", 3, 'i', "u32", "light of the sample, colour [i]"},                                   \
        {"e", 3, 'i', "u32", "light of the ray before, colour [i]"},                               \
    {                                                                                              \
        "t", 1, 'i', "u32.31", "transmittance of the ray before"                                   \
    }

#define A32                                                                                        \
    {                                                                                              \
        "a32", 1, 'm', "u32.32",                                                                   \
            "257 o + floor(o / 256) + floor(o / 65536) where wide = 0, else o + floor(o / 65536)"  \
    }

static const vector_field under_fields[] = {
    COMPOSITE_INPUTS,
    {"threshold", 1, 'i', "u16.16", "of termination"},
    A32,
    {"part", 3, 'm', "u32", "hi(l[i], t)"},
    {"lost", 1, 'm', "u32.31", "hi(t, a32)"},
    {"en", 3, 'o', "u32", "e[i] + part[i]"},
    {"tn", 1, 'o', "u32.31", "t - lost"},
    {"ended", 1, 'o', "u1", "1 where tn <= 32768 threshold, else 0"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_under = {
    .name = "under",
    .section = "13, 14, 15",
    .title = "a sample behind what a ray has gathered: front to back",
    .rounding = "products to nearest, ties upwards; a32 is cut",
    .saturation = "none",
    .fields = under_fields,
    .columns = VECTOR_COLUMNS(under_row),
    .seed = 14,
    .random_rows = 400,
    .edges = under_edges,
    .draw = under_draw,
    .compute = under_compute,
};

static const vector_field over_fields[] = {COMPOSITE_INPUTS,
                                           A32,
                                           {"part", 3, 'm', "u32", "hi(e[i], a32)"},
                                           {"lost", 1, 'm', "u32.31", "hi(t, a32)"},
                                           {"half", 3, 'm', "u32", "floor((l[i] + 1) / 2)"},
                                           {"en", 3, 'o', "u32", "e[i] - part[i] + half[i]"},
                                           {"tn", 1, 'o', "u32.31", "t - lost"},
                                           {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_over = {
    .name = "over",
    .section = "13, 14",
    .title = "a sample before what a ray has gathered: back to front",
    .rounding = "products and halves to nearest, ties upwards; a32 is cut",
    .saturation = "none",
    .fields = over_fields,
    .columns = VECTOR_COLUMNS(over_row),
    .seed = 1407,
    .random_rows = 400,
    .edges = over_edges,
    .draw = over_draw,
    .compute = over_compute,
};

/* ---- Read-out --------------------------------------------------------------- */

typedef struct readout_row {
    uint64_t kind, e[3], t, background[4], p[4], g[4], channel[4];
} readout_row;

/* A camera whose rays are nowhere, a mode that finds light there, a format that keeps channels:
   what is left of qv_render is the read-out. */
static qv_light found;

static int any_ray(qv_ray *ray, const qv_context *context, int32_t x, int32_t y)
{
    (void)context;
    (void)x;
    (void)y;
    memset(ray, 0, sizeof *ray);
    return 1;
}

static int any_camera(const qv_camera *camera)
{
    (void)camera;
    return 1;
}

static const qv_projection projection = {any_ray, any_camera};

static qv_status no_preparation(qv_context *context, const qv_scene *scene)
{
    (void)context;
    (void)scene;
    return QV_OK;
}

static void find_light(qv_light *light, qv_ray *ray, const qv_context *context)
{
    (void)ray;
    (void)context;
    *light = found;
}

static void keep_channels(uint8_t *to, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)column;
    (void)line;
    memcpy(to, pixel->channel, sizeof pixel->channel);
}

static const qv_format channels = {keep_channels, 8 * sizeof(uint32_t[4]), 0};

enum { KINDS = 4 };

static const uint32_t read_outs[KINDS] = {QV_READ_OUT_8, QV_READ_OUT_16, QV_READ_OUT_CONVERTED,
                                          QV_READ_OUT_ASSOCIATED};

static void render(uint32_t channel[4], qv_context *context, const readout_row *row)
{
    const qv_sampling sampling = {no_preparation, find_light, read_outs[row->kind],
                                  QV_STORAGE_RGBA8, 0};
    const qv_rect rect = {0, 0, 1, 1};
    const qv_image image = {channel, sizeof(uint32_t[4]), sizeof(uint32_t[4]), &channels};
    qv_scene scene = {.sampling = &sampling,
                      .volume = {.storage = QV_STORAGE_RGBA8},
                      .camera = {.projection = &projection, .step = QV_ONE_Q16}};
    scene.camera.across[0] = scene.camera.down[1] = scene.camera.along[2] = (qv_coord)1 << 32;
    for (unsigned c = 0; c < 4; c++)
        scene.background[c] = (uint8_t)row->background[c];
    if (qv_init(context, &scene) != QV_OK || qv_render(&image, context, &rect) != QV_OK)
        vector_fail("readout", "scene", "refused");
}

static unsigned readout_compute(void *columns)
{
    readout_row *row = columns;
    uint32_t channel[4], most = 0;
    qv_context context;
    found.transmittance = (uint32_t)row->t;
    for (unsigned c = 0; c < 3; c++)
        found.colour[c] = (uint32_t)row->e[c];
    render(channel, &context, row);
    for (unsigned c = 0; c < 4; c++) {
        row->p[c] = row->background[3] * (c < 3 ? row->background[c] : 255u);
        row->g[c] = context.background[c];
        row->channel[c] = channel[c];
    }
    for (unsigned c = 0; c < 3; c++)
        most |= row->channel[c] == row->channel[3] && row->e[c] != 0;
    return most ? VECTOR_SATURATE : 0;
}

static void readout_draw(void *columns, vector_random *random)
{
    readout_row *row = columns;
    row->kind = vector_bits(random, 2);
    row->t = vector_any(random, 32) % 0x80000001u;
    for (unsigned c = 0; c < 3; c++)
        row->e[c] = (0x80000000u - row->t) * vector_any(random, 16) >> 16;
    for (unsigned c = 0; c < 4; c++)
        row->background[c] = vector_any(random, 8);
}

static void readout_edges(vector_set *set)
{
    static const uint64_t rest[] = {0, 1, 2, 0x40000000, 0x7FFFFFFF, 0x80000000};
    static const uint64_t backgrounds[] = {0, 1, 128, 255};
    for (unsigned i = 0; i < KINDS * 6 * 4; i++) {
        readout_row row = {.kind = i % KINDS, .t = rest[i / KINDS % 6]};
        uint64_t opacity = backgrounds[i / KINDS / 6];
        for (unsigned c = 0; c < 3; c++) {
            row.e[c] = (0x80000000u - row.t) >> c;
            row.background[c] = backgrounds[c + 1];
        }
        row.background[3] = opacity;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field readout_fields[] = {
    {"kind", 1, 'i', "u2",
     "storage: 0 of 8 bits, 1 of 16 bits, 2 extinction of stored opacity, 3 associated8"},
    {"e", 3, 'i', "u32", "light of the ray, colour [i]"},
    {"t", 1, 'i', "u32.31", "its transmittance"},
    {"background", 4, 'i', "unorm8", "B[[i]] of section 16"},
    {"p0", 1, 'm', "u16", "background0 * background3"},
    {"p1", 1, 'm', "u16", "background1 * background3"},
    {"p2", 1, 'm', "u16", "background2 * background3"},
    {"p3", 1, 'm', "u16", "255 background3"},
    {"g", 4, 'm', "u32.17", "2 (257 p[i] + div255(p[i]))"},
    {"channel0", 1, 'o', "u32.16", "min(channel3, hi(e0, readout(kind)) + hi(t, g0))"},
    {"channel1", 1, 'o', "u32.16", "min(channel3, hi(e1, readout(kind)) + hi(t, g1))"},
    {"channel2", 1, 'o', "u32.16", "min(channel3, hi(e2, readout(kind)) + hi(t, g2))"},
    {"channel3", 1, 'o', "u32.16", "16711680 - hi(t, 33423360) + hi(t, g3)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_readout = {
    .name = "readout",
    .section = "16",
    .title = "light and background to a pixel's channels",
    .rounding = "products to nearest, ties upwards",
    .saturation = "colours at the opacity channel3",
    .fields = readout_fields,
    .columns = VECTOR_COLUMNS(readout_row),
    .seed = 16,
    .random_rows = 300,
    .edges = readout_edges,
    .draw = readout_draw,
    .compute = readout_compute,
};

/* ---- Pixel formats ---------------------------------------------------------- */

typedef struct pixel_row {
    uint64_t channel[4];
    int64_t x, y;
    uint64_t threshold, grey, rgba8888, bgra8888, rgb888, rgb565_le, rgb565_be, l8, grey4, mono;
} pixel_row;

/* The bytes of a pixel in a format, first byte highest. */
static uint64_t stored(const qv_format *format, const qv_pixel *pixel)
{
    uint8_t bytes[4] = {0, 0, 0, 0};
    uint64_t value = 0;
    format->store(bytes, 0, 0, pixel);
    for (unsigned i = 0; i < (format->bits + 7u) / 8u; i++)
        value = value << 8 | bytes[i];
    return value;
}

/* The threshold t of section 17 as it shows: grey v is 1 of 1 where v >= 130560 (127 - 2 t), so t
   + 1 of the odd multiples of 130560 are. */
static uint64_t threshold_of(qv_pixel pixel)
{
    uint64_t lit = 0;
    for (uint32_t v = 130560; v < 16711680u; v += 261120u) {
        for (unsigned c = 0; c < 3; c++)
            pixel.channel[c] = v;
        lit += stored(&qv_format_mono_horizontal, &pixel) >> 7;
    }
    return lit - 1u;
}

static unsigned pixel_compute(void *columns)
{
    pixel_row *row = columns;
    qv_pixel pixel = {{0, 0, 0, 0}, (uint32_t)row->x, (uint32_t)row->y};
    for (unsigned c = 0; c < 4; c++)
        pixel.channel[c] = (uint32_t)row->channel[c];
    row->threshold = threshold_of(pixel);
    row->grey = (77 * row->channel[0] + 150 * row->channel[1] + 29 * row->channel[2] + 128) / 256;
    row->rgba8888 = stored(&qv_format_rgba8888, &pixel);
    row->bgra8888 = stored(&qv_format_bgra8888, &pixel);
    row->rgb888 = stored(&qv_format_rgb888, &pixel);
    row->rgb565_le = stored(&qv_format_rgb565_le, &pixel);
    row->rgb565_be = stored(&qv_format_rgb565_be, &pixel);
    row->l8 = stored(&qv_format_l8, &pixel);
    row->grey4 = stored(&qv_format_grey4, &pixel) >> 4;
    row->mono = stored(&qv_format_mono_horizontal, &pixel) >> 7;
    return (row->channel[0] & 0xFFFFu) == 0x8000u ? VECTOR_TIE : 0;
}

static void pixel_draw(void *columns, vector_random *random)
{
    pixel_row *row = columns;
    row->channel[3] = vector_any(random, 24) % (QV_LEVEL_ONE + 1u);
    for (unsigned c = 0; c < 3; c++)
        row->channel[c] = vector_any(random, 24) % (row->channel[3] + 1u);
    row->x = vector_between(random, -32767, 32766);
    row->y = vector_between(random, -32767, 32766);
}

/* Each threshold with a channel that it just lifts and one that it just does not; ties of 8
   bits. */
static void pixel_edges(vector_set *set)
{
    for (unsigned i = 0; i < 64; i++) {
        uint64_t reached = (16711680u - 130560u * (2u * i + 1u) + 30u) / 31u;
        const pixel_row row = {.channel = {reached, reached / 2u, reached - 1u, QV_LEVEL_ONE},
                               .x = (int64_t)(i % 8) - 8,
                               .y = i / 8};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (unsigned i = 0; i < 256; i++) {
        uint64_t half = i < 255 ? (uint64_t)i * 65536u + 32768u : QV_LEVEL_ONE;
        const pixel_row row = {.channel = {half, half - 1u, (uint64_t)i * 65536u, half}, .x = i};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Greys on both sides of a half: 77 R + 150 G + 29 B is 256 * 32768 - 129 and one more. */
static void pixel_added(vector_set *set)
{
    static const uint64_t colours[][3] = {{0, 11, 289201}, {0, 17, 289170}};
    for (unsigned i = 0; i < sizeof colours / sizeof colours[0]; i++) {
        const pixel_row row = {
            .channel = {colours[i][0], colours[i][1], colours[i][2], QV_LEVEL_ONE}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field pixel_fields[] = {
    {"channel", 4, 'i', "u24.16", "channel [i]: levels, at most 16711680"},
    {"x", 1, 'i', "s16", "absolute column"},
    {"y", 1, 'i', "s16", "absolute line"},
    {"threshold", 1, 'm', "u6", "t of the table in section 17, by x mod 8 and y mod 8"},
    {"grey", 1, 'm', "u24.16", "floor((77 channel0 + 150 channel1 + 29 channel2 + 128) / 256)"},
    {"rgba8888", 1, 'o', "u32", "bytes level8(channel 0, 1, 2, 3), the first highest"},
    {"bgra8888", 1, 'o', "u32", "bytes level8(channel 2, 1, 0, 3), the first highest"},
    {"rgb888", 1, 'o', "u24", "bytes level8(channel 0, 1, 2), the first highest"},
    {"rgb565_le", 1, 'o', "u16", "bytes of rgb565_le, the first highest"},
    {"rgb565_be", 1, 'o', "u16",
     "2048 dither(channel0, 31) + 32 dither(channel1, 63) + "
     "dither(channel2, 31), with the threshold"},
    {"l8", 1, 'o', "u8", "floor((grey + 32768) / 65536)"},
    {"grey4", 1, 'o', "u4", "floor((15 grey + 130560 (2 threshold + 1)) / 16711680)"},
    {"mono", 1, 'o', "u1", "floor((grey + 130560 (2 threshold + 1)) / 16711680)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_pixel = {
    .name = "pixel",
    .section = "17",
    .title = "a pixel's channels to the formats of displays",
    .rounding = "8 bits to nearest, ties upwards; narrower ones dithered",
    .saturation = "none",
    .fields = pixel_fields,
    .columns = VECTOR_COLUMNS(pixel_row),
    .seed = 17,
    .random_rows = 300,
    .edges = pixel_edges,
    .added = pixel_added,
    .draw = pixel_draw,
    .compute = pixel_compute,
};
