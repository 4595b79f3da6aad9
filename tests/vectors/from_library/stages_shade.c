/*
 * stages_shade.c - gradients and shading: sections 21 and 22.
 */
#include "stages.h"

#include "gradient.h"
#include "shade.h"

/* ---- Gradient and normal ---------------------------------------------------- */

typedef struct gradient_row {
    int64_t d[3];
    uint64_t spacing[3], least, window, g[3], long_enough;
    int64_t normal[3];
} gradient_row;

static unsigned gradient_compute(void *columns)
{
    gradient_row *row = columns;
    qv_gradient gradient;
    uint32_t spacing[3];
    int32_t difference[3], normal[3] = {0, 0, 0};
    for (unsigned axis = 0; axis < 3; axis++) {
        spacing[axis] = (uint32_t)row->spacing[axis];
        difference[axis] = (int32_t)row->d[axis];
    }
    qv_gradient_init(&gradient, spacing, (uint16_t)row->least, (uint32_t)row->window);
    row->long_enough = qv_gradient_normal(normal, &gradient, difference) != 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        row->g[axis] = gradient.scale[axis];
        row->normal[axis] = row->long_enough ? normal[axis] : 0;
    }
    return 0;
}

static uint64_t draw_spacing(vector_random *random)
{
    return vector_bits(random, 1) ? 65536 : (uint64_t)vector_between(random, 4096, 1 << 24);
}

static void gradient_draw(void *columns, vector_random *random)
{
    gradient_row *row = columns;
    for (unsigned axis = 0; axis < 3; axis++) {
        row->d[axis] = vector_signed(random, 16);
        row->spacing[axis] = draw_spacing(random);
    }
    row->least = vector_bits(random, 2) ? vector_any(random, 8) : vector_any(random, 16);
    row->window = (uint64_t)vector_between(random, 1, 196607);
}

/* S33, and both sides of its limits; differences alone on each axis. */
static void gradient_edges(vector_set *set)
{
    for (uint64_t least = 36; least < 42; least++) {
        const gradient_row row = {
            .d = {300, -20, 7}, .spacing = {65536, 98304, 43691}, .least = least, .window = 1000};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (unsigned i = 0; i < 24; i++) {
        gradient_row row = {.spacing = {65536, i % 2 ? 65536 : 4096, 1 << 24},
                            .least = i / 12 ? 1 : 0,
                            .window = 128};
        row.d[i % 3] = i / 3 % 2 ? -1 : 1;
        row.d[(i + 1) % 3] = i / 6 % 2 ? 65535 : 0;
        vector_add(set, &row, VECTOR_EDGE);
    }
    const gradient_row none = {.spacing = {65536, 65536, 65536}, .window = 1};
    vector_add(set, &none, VECTOR_EDGE);
}

#define GRADIENT_FIELDS                                                                            \
    {"d", 3, 'i', "s17", "difference along axis [i]"},                                             \
        {"spacing", 3, 'i', "u32.16", "of axis [i]"}, {"least", 1, 'i', "u16", "least gradient"},  \
    {                                                                                              \
        "window", 1, 'i', "u18", "high - low"                                                      \
    }

/* Gradients as long as the least, and a little shorter; the least and the longest of all. */
static void add_longest(vector_set *set)
{
    for (unsigned i = 0; i < 8; i++) {
        const gradient_row row = {
            .d = {65535, -65535, 65535},
            .spacing = {i & 1 ? 1 << 24 : 4096, i & 2 ? 1 << 24 : 4096, i & 4 ? 1 << 24 : 4096},
            .least = 65535,
            .window = 196607};
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
}

/* As long as the least: the lower bits of both squares are odd numbers of many bits, times 2^46
   for the least one. A second difference makes the gradient longer in the last words alone. */
static void add_odd_squares(vector_set *set)
{
    static const uint64_t odd[4] = {65537, 4099, 16777215, 9999999};
    for (unsigned i = 0; i < 4 * 3 * 2; i++) {
        const unsigned axis = i / 2 % 3;
        const int64_t length = 1 + 254 * (int64_t)(i % 2);
        gradient_row row = {.least = 1, .window = 128 * (uint64_t)length};
        row.spacing[axis] = 65536;
        row.spacing[(axis + 1) % 3] = odd[i / 6];
        row.spacing[(axis + 2) % 3] = odd[(i / 6 + 1) % 4];
        row.d[axis] = length;
        vector_add(set, &row, VECTOR_EDGE);
        row.window++;
        row.d[(axis + 1) % 3] = i % 4 ? 4 : 1000;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static void gradient_added(vector_set *set)
{
    static const uint16_t lengths[] = {1, 2, 3, 255, 1000, 1535};
    for (unsigned i = 0; i < 6 * 3; i++) {
        const int64_t length = lengths[i / 3];
        const gradient_row row = {.d = {0, length, 0},
                                  .spacing = {65536, 65536, 65536},
                                  .least = 1,
                                  .window = (uint64_t)(128 * length) + i % 3 - 1};
        vector_add(set, &row, VECTOR_EDGE);
    }
    add_longest(set);
    add_odd_squares(set);
    /* 387 * 5419 = 2^21 + 1: shorter than the least in the lowest word of the squares alone */
    const gradient_row shorter = {
        .d = {1024, 1, 0}, .spacing = {4096, 4096, 4096}, .least = 387, .window = 5419};
    vector_add(set, &shorter, VECTOR_EDGE);
}

static const vector_field gradient_fields[] = {
    GRADIENT_FIELDS,
    {"g0", 1, 'm', "u64", "spacing1 * spacing2"},
    {"g1", 1, 'm', "u64", "spacing0 * spacing2"},
    {"g2", 1, 'm', "u64", "spacing0 * spacing1"},
    {"long_enough", 1, 'o', "u1",
     "1 where a d is not 0 and (d0^2 g0^2 + d1^2 g1^2 + d2^2 g2^2) * 2^46 >= (least * window * "
     "spacing0 * spacing1 * spacing2)^2; else normal is 0"},
    {"normal", 3, 'o', "s32.30", "component [i] of unit(-d, g)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_gradient = {
    .name = "gradient",
    .section = "21",
    .title = "a gradient, whether it is long enough, and its normal",
    .rounding = "the decision is exact; magnitudes of the normal to nearest",
    .saturation = "components at 2^30",
    .fields = gradient_fields,
    .columns = VECTOR_COLUMNS(gradient_row),
    .seed = 2100,
    .random_rows = 250,
    .edges = gradient_edges,
    .added = gradient_added,
    .draw = gradient_draw,
    .compute = gradient_compute,
};

/* ---- Shading ---------------------------------------------------------------- */

typedef struct shade_row {
    int64_t d[3];
    uint64_t spacing[3], least, window;
    int64_t light[3], viewer[3];
    uint64_t ambient, diffuse, specular, gloss, colour[3];
    int64_t to_light[3], half[3];
    uint64_t shaded[3];
} shade_row;

static void set_shading(qv_shading *shading, const shade_row *row)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        shading->light[axis] = (int16_t)row->light[axis];
        shading->viewer[axis] = (int16_t)row->viewer[axis];
    }
    shading->ambient = (uint16_t)row->ambient;
    shading->diffuse = (uint16_t)row->diffuse;
    shading->specular = (uint16_t)row->specular;
    shading->gloss = (uint8_t)row->gloss;
    shading->least_gradient = (uint16_t)row->least;
}

static unsigned shade_compute(void *columns)
{
    shade_row *row = columns;
    qv_shading shading;
    qv_shader shader;
    uint32_t spacing[3];
    int32_t difference[3];
    uint16_t rgba[4] = {(uint16_t)row->colour[0], (uint16_t)row->colour[1],
                        (uint16_t)row->colour[2], 0};
    for (unsigned axis = 0; axis < 3; axis++) {
        spacing[axis] = (uint32_t)row->spacing[axis];
        difference[axis] = (int32_t)row->d[axis];
    }
    set_shading(&shading, row);
    if (qv_shader_init(&shader, &shading, spacing, (uint32_t)row->window) != QV_OK)
        vector_fail("shade", "shading", "refused");
    qv_shade(rgba, &shader, difference);
    for (unsigned i = 0; i < 3; i++) {
        row->to_light[i] = shader.light[i];
        row->half[i] = shader.specular != 0 ? shader.half[i] : 0;
        row->shaded[i] = rgba[i];
    }
    return rgba[0] == 65535 || rgba[1] == 65535 || rgba[2] == 65535 ? VECTOR_SATURATE : 0;
}

static void draw_direction(int64_t v[3], vector_random *random)
{
    for (unsigned axis = 0; axis < 3; axis++)
        v[axis] = vector_between(random, -1000, 1000);
    const int64_t along = vector_between(random, 0, 2); /* drawn first, by every compiler */
    v[along] = vector_between(random, 1, 32767);
}

static void shade_draw(void *columns, vector_random *random)
{
    shade_row *row = columns;
    draw_direction(row->light, random);
    draw_direction(row->viewer, random);
    for (unsigned axis = 0; axis < 3; axis++) {
        row->spacing[axis] = vector_bits(random, 1) ? 65536 : 98304;
        row->d[axis] = vector_between(random, -300, 300);
        row->colour[axis] = vector_any(random, 16);
    }
    row->window = 1000;
    row->least = vector_bits(random, 2);
    row->ambient = (uint64_t)vector_between(random, 0, 256);
    row->diffuse = (uint64_t)vector_between(random, 0, 256);
    row->specular = vector_bits(random, 1) ? (uint64_t)vector_between(random, 0, 256) : 0;
    row->gloss = vector_bits(random, 3);
}

/* Light along the normal and against it, a viewer beside the light and opposite to it. */
static void shade_edges(vector_set *set)
{
    for (unsigned i = 0; i < 64; i++) {
        shade_row row = {.d = {0, 0, i % 2 ? 100 : -100},
                         .spacing = {65536, 65536, 65536},
                         .least = i / 2 % 2 ? 65535 : 0,
                         .window = 100,
                         .light = {0, 0, 1},
                         .viewer = {i / 4 % 2, 0, i / 8 % 2 ? 1 : -1},
                         .ambient = i / 16 % 2 ? 256 : 0,
                         .diffuse = 256,
                         .specular = i / 32 ? 256 : 0,
                         .gloss = i % 8,
                         .colour = {65535, 32768, 0}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Found by search: here a product that is cut, and not rounded, shows. */
static void add_rounded_shades(vector_set *set)
{
    static const shade_row rows[] = {{.d = {41, 187, -171},
                                      .light = {479, -377, 388},
                                      .viewer = {242, 353, 47},
                                      .ambient = 173,
                                      .diffuse = 153,
                                      .specular = 167,
                                      .gloss = 1,
                                      .colour = {24260, 1913, 41783}},
                                     {.d = {-83, 210, 31},
                                      .light = {153, -250, 124},
                                      .viewer = {318, 209, -81},
                                      .ambient = 169,
                                      .diffuse = 153,
                                      .specular = 242,
                                      .gloss = 4,
                                      .colour = {21881, 48019, 30244}},
                                     {.d = {179, 161, 41},
                                      .light = {-453, -322, 261},
                                      .viewer = {-321, 97, 101},
                                      .ambient = 65,
                                      .diffuse = 174,
                                      .specular = 244,
                                      .gloss = 4,
                                      .colour = {50015, 44825, 25607}}};
    static const uint64_t spacing[3] = {65536, 98304, 43691};
    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        shade_row row = rows[i];
        row.window = 1000;
        for (unsigned axis = 0; axis < 3; axis++)
            row.spacing[axis] = spacing[axis];
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* The least highlight that there is, with a viewer beside the light and opposite to it. */
static void add_faint_highlights(vector_set *set)
{
    for (unsigned i = 0; i < 4; i++) {
        const shade_row row = {.d = {0, 0, -100},
                               .spacing = {65536, 65536, 65536},
                               .window = 100,
                               .light = {0, 0, i % 2 ? 1000 : 1},
                               .viewer = {0, i / 2 ? 1 : 0, i / 2 ? 1 : -1},
                               .ambient = 100,
                               .diffuse = 100,
                               .specular = 1,
                               .colour = {1000, 2000, 3000}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* A viewer almost opposite to the light: from some angle on there is a highlight. */
static void shade_added(vector_set *set)
{
    static const int16_t sideways[] = {63, 64, 65, 127, 128, 129, 255, 257};
    for (unsigned i = 0; i < 8; i++) {
        const shade_row row = {.d = {-100, 0, 0},
                               .spacing = {65536, 65536, 65536},
                               .window = 100,
                               .light = {0, 0, 32767},
                               .viewer = {sideways[i], 0, -32767},
                               .ambient = 100,
                               .diffuse = 100,
                               .specular = 200,
                               .gloss = i % 4,
                               .colour = {1000, 2000, 3000}};
        vector_add(set, &row, VECTOR_EDGE);
    }
    add_rounded_shades(set);
    add_faint_highlights(set);
}

static const vector_field shade_fields[] = {
    GRADIENT_FIELDS,
    {"light", 3, 'i', "s16", "direction to the light, axis [i]"},
    {"viewer", 3, 'i', "s16", "direction to the viewer, axis [i]"},
    {"ambient", 1, 'i', "u9.8", "coefficient, 0 .. 256"},
    {"diffuse", 1, 'i', "u9.8", "coefficient, 0 .. 256"},
    {"specular", 1, 'i', "u9.8", "coefficient, 0 .. 256; without a highlight 0"},
    {"gloss", 1, 'i', "u3", "squarings"},
    {"colour", 3, 'i', "unorm16", "of the voxel, channel [i]"},
    {"to_light", 3, 'm', "s32.30", "component [i] of unit(light, 1)"},
    {"half", 3, 'm', "s32.30", "component [i] of half; 0 where there is no highlight"},
    {"shaded", 3, 'o', "unorm16",
     "colour [i] of section 22; colour[i] where the gradient is not long enough"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_shade = {
    .name = "shade",
    .section = "22",
    .title = "light on a voxel",
    .rounding = "each product to nearest, ties upwards",
    .saturation = "dot at 0 and 2^30, colours at 65535",
    .fields = shade_fields,
    .columns = VECTOR_COLUMNS(shade_row),
    .seed = 2200,
    .random_rows = 250,
    .edges = shade_edges,
    .added = shade_added,
    .draw = shade_draw,
    .compute = shade_compute,
};
