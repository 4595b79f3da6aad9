/*
 * stages_light.c - compositing and read-out: sections 13 to 16.
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
