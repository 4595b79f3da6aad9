/*
 * The worked examples S90 .. S96 of tests/SPEC.md: slices of a ray, and frame buffers that take
 * them. The same inputs and results as there, written out.
 */
#include "buffer.h"
#include "check.h"
#include "composite.h"
#include "pixels.h"
#include "ray.h"

#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum { MOST_BYTES = 12, MOST_BESIDE = 4 };

/* A pixel, and what lies beside it. */
typedef struct bytes {
    uint8_t pixel[MOST_BYTES], beside[MOST_BESIDE];
} bytes;

static unsigned digit(char c)
{
    return (unsigned)(c <= '9' ? c - '0' : c - 'A' + 10);
}

/* Of hexadecimal digits; those beside the pixel stand behind a stroke. */
static bytes bytes_of(const char *text)
{
    bytes b;
    uint8_t *to = b.pixel;
    memset(&b, 0, sizeof b);
    for (; *text != '\0'; text += 2) {
        if (*text == '/') {
            to = b.beside;
            text++;
        }
        *to++ = (uint8_t)(16 * digit(text[0]) + digit(text[1]));
    }
    return b;
}

static void expect_bytes(const bytes *is, const char *text)
{
    const bytes expected = bytes_of(text);
    assert_memory_equal(is, &expected, sizeof expected);
}

static qv_buffer buffer_of(bytes *b, const qv_blend *blend)
{
    const qv_buffer buffer = {.pixels = b->pixel,
                              .beside = b->beside,
                              .bytes = blend->bytes,
                              .beside_bytes = blend->beside,
                              .blend = blend};
    return buffer;
}

/* ---- S90, S91: slices ---------------------------------------------------------- */

static qv_fragment noted;
static int seen;

static void probe_blend(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                        const qv_moment *moment)
{
    (void)pixel;
    (void)beside;
    (void)moment;
    noted = *fragment;
    seen = 1;
}

static const qv_blend probe = {.blend = probe_blend, .bytes = 1, .kind = QV_OVER};

/* What the pixel (1, 2) sees of a slice. */
static int see(const qv_context *context, int32_t slice)
{
    static const qv_rect rect = {1, 2, 2, 3};
    static const qv_dither none = {.sequence = qv_sequence_rounded};
    uint8_t pixel;
    const qv_buffer buffer = {.pixels = &pixel, .bytes = 1, .blend = &probe};
    seen = 0;
    assert_int_equal(qv_slice(&buffer, &none, context, &rect, slice), QV_OK);
    return seen;
}

static void fill_voxels(uint8_t voxels[8][4])
{
    for (unsigned v = 0; v < 8; v++) {
        const unsigned i = v & 1, j = v >> 1 & 1, k = v >> 2;
        voxels[v][0] = (uint8_t)(255 * i);
        voxels[v][1] = (uint8_t)(255 * j);
        voxels[v][2] = (uint8_t)(255 * k);
        voxels[v][3] = (uint8_t)(64 + 16 * i + 32 * j + 64 * k);
    }
}

/* The scene of S30, of any mode; it keeps its voxels. */
static qv_context context_of(const qv_sampling *sampling, int perspective)
{
    static uint8_t voxels[8][4];
    qv_view view = {.pitch = 32768, .step = 32768, .width = 4, .height = 4};
    qv_scene scene = {.sampling = sampling,
                      .phase = 0x8000,
                      .volume = {.voxels = voxels[0],
                                 .voxels_bytes = sizeof voxels,
                                 .size = {2, 2, 2},
                                 .storage = QV_STORAGE_RGBA8,
                                 .unit_distance = sampling->by_length ? 65536 : 0,
                                 .stride = {4, 8, 16}}};
    qv_context context;
    fill_voxels(voxels);
    qv_rotation(view.rotation, 0x15555555, 0x0AAAAAAB, 0);
    if (perspective)
        assert_int_equal(qv_perspective(&scene.camera, &scene.volume, &view, 0x1C71C71C), QV_OK);
    else
        assert_int_equal(qv_orthographic(&scene.camera, &scene.volume, &view), QV_OK);
    assert_int_equal(qv_init(&context, &scene), QV_OK);
    return context;
}

static void expect_range(const qv_context *context, const qv_rect *rect, int32_t first,
                         int32_t last)
{
    int32_t is_first, end;
    assert_int_equal(qv_slice_range(&is_first, &end, context, rect), QV_OK);
    assert_int_equal(is_first, first);
    assert_int_equal(end, last + 1);
}

typedef struct slice_example {
    int32_t slice;
    qv_fragment fragment;
} slice_example;

static void expect_slices(const qv_context *context, const slice_example *examples, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        assert_true(see(context, examples[i].slice));
        assert_memory_equal(&noted, &examples[i].fragment, sizeof noted);
    }
}

static void S90_slices_of_a_ray(void **state)
{
    static const slice_example weighted[] = {{-2, {{621477888, 0, 527876096}, 1749567560}},
                                             {-1, {{382599168, 113541120, 376684544}, 1604296608}},
                                             {0, {{179200000, 493793280, 242483200}, 1625350368}},
                                             {1, {{0, 792985600, 82968576}, 1654825634}},
                                             {2, {{0, 805306368, 0}, 1616928864}}};
    static const slice_example corrected[] = {{-2, {{333345712, 0, 284359666}, 948085056}},
                                              {0, {{100201500, 276109524, 135586942}, 908831244}},
                                              {2, {{0, 378165714, 0}, 759297504}}};
    static const slice_example extinction[] = {{-2, {{352004508, 0, 319028012}, 987371238}},
                                               {2, {{0, 378165760, 0}, 759297476}}};
    static const slice_example by_eye[] = {{3, {{306358668, 0, 272604034}, 728603194}},
                                           {8, {{0, 252346976, 0}, 506673114}}};
    static const qv_rect pixel = {1, 2, 2, 3}, frame = {0, 0, 4, 4};
    qv_context context = context_of(&qv_weighted_rgba8, 0);
    (void)state;
    expect_slices(&context, weighted, COUNT(weighted));
    expect_range(&context, &pixel, -3, 3);
    expect_range(&context, &frame, -4, 3);
    assert_false(see(&context, -3) || see(&context, 3));
    context = context_of(&qv_corrected_rgba8, 0);
    expect_slices(&context, corrected, COUNT(corrected));
    context = context_of(&qv_extinction_rgba8_back_to_front, 0);
    expect_slices(&context, extinction, COUNT(extinction));
    context = context_of(&qv_extinction_rgba8, 1);
    expect_slices(&context, by_eye, COUNT(by_eye));
    expect_range(&context, &pixel, 2, 9);
    expect_range(&context, &frame, 1, 9);
}

/* A mode whose rays bring this light. */
static qv_light given;

static void march_given(qv_light *light, qv_ray *ray, const qv_context *context)
{
    (void)ray;
    (void)context;
    *light = given;
}

static void S91_light_of_a_slice(void **state)
{
    static const struct {
        uint32_t read_out;
        qv_light light;
        qv_fragment fragment;
    } examples[] = {{QV_READ_OUT_8,
                     {{54578080, 406920480, 97734516}, 1579032094, 0, 0},
                     {{54792112, 408516246, 98117788}, 1136903108}},
                    {QV_READ_OUT_16,
                     {{2147418112, 2147418049, 0}, 0, 0, 0},
                     {{2139095040, 2139094976, 0}, 0xFFFFFFFFu}},
                    {QV_READ_OUT_CONVERTED, {{1, 0, 7}, 0x7FFFFFFF, 0, 0}, {{2, 0, 14}, 2}}};
    qv_sampling sampling = {0, march_given, 0, QV_STORAGE_RGBA8, 0};
    qv_context context = context_of(&qv_weighted_rgba8, 0);
    (void)state;
    context.scene.sampling = &sampling;
    for (unsigned i = 0; i < COUNT(examples); i++) {
        sampling.read_out = examples[i].read_out;
        given = examples[i].light;
        assert_true(see(&context, 0));
        assert_memory_equal(&noted, &examples[i].fragment, sizeof noted);
    }
    given.transmittance = QV_CLEAR;
    assert_false(see(&context, 0));
}

/* ---- S92: dither ------------------------------------------------------------------ */

static void S92_dither_of_a_slice(void **state)
{
    static const struct {
        int32_t slice;
        uint8_t period, still;
        uint32_t frame;
        int32_t x, y;
        uint32_t u, phase;
    } examples[] = {{0, 2, 0, 0, 0, 0, 0x52C3863D, 0},
                    {3, 7, 0, 5, 11, -2, 0x8D959161u, 5},
                    {-1000, 32, 0, 1, 640, 479, 0x9B19FCE7u, 11},
                    {4194303, 64, 0, 0xFFFFFFFFu, -1, -1, 0xE093807Bu, 43},
                    {-5, 10, 1, 3, 1, 7, 0x92531039u, 2}};
    (void)state;
    for (unsigned i = 0; i < COUNT(examples); i++) {
        const qv_dither dither = {.sequence = qv_sequence_blocks,
                                  .technique = &qv_technique_ordered,
                                  .frame = examples[i].frame,
                                  .period = examples[i].period,
                                  .still = examples[i].still};
        qv_moment slice, pixel;
        assert_int_equal(qv_moment_of(&slice, &dither, &qv_hardware_rgb888, examples[i].slice),
                         QV_OK);
        pixel = slice;
        qv_moment_at(&pixel, slice.u + qv_dither_shift(slice.spread, examples[i].x, examples[i].y));
        assert_int_equal(pixel.u, examples[i].u);
        assert_int_equal(pixel.phase, examples[i].phase);
        assert_true(pixel.alpha.slope[0] == 65536 && pixel.alpha.cutoff == 255);
    }
}

/* ---- S93 .. S96: frame buffers ------------------------------------------------------ */

/* The states, after the slice, cleared. */
static const struct {
    const qv_blend *blend;
    const char *states, *after, *cleared;
} blends[] = {
    {&qv_over_rgb888, "2D9812", "3C9611", "64052D"},
    {&qv_over_rgba8888, "2D981298", "3C96119F", "64052D80"},
    {&qv_over_rgb888_residual4, "2E9913/9C0D", "3C9712/0608", "64052D/0603"},
    {&qv_over_rgba8888_residual4, "2E991399/9C9D", "3C9712A0/06E8", "64052D80/0603"},
    {&qv_over_rgb888_residual8, "2E9913/C696D6", "3C9711/66027F", "64052D/64052D"},
    {&qv_over_rgba8888_residual8, "2E991399/C696D696", "3C9711A0/66027FDE", "64052D80/64052D00"},
    {&qv_over_rgb565, "A22C", "A23C", "2560"},
    {&qv_over_rgba12, "DC92982D9198", "C6039718E19F", "460605D30280"},
    {&qv_over_rgb16, "C62D9698D612", "663C02977F11", "646405052D2D"},
    {&qv_over_rgba16, "C62D9698D6129698", "663C02977F11DE9F", "646405052D2D0080"},
    {&qv_over_rgb24, "C0C62D7F969887D612", "0E673C4F0297987F11", "6464640505052D2D2D"},
    {&qv_over_rgba24, "C0C62D7F969887D612809698", "0E673C4F0297987F11DBDE9F",
     "6464640505052D2D2D000080"},
    {&qv_under_rgb888, "2D9812/80841E", "2F9912/F2581C", "000000/FFFFFF"},
    {&qv_under_rgb16, "C62D9698D612/80841E", "E82FB199D612/F2581C", "000000000000/FFFFFF"},
    {&qv_under_rgb24, "C0C62D7F969887D612/80841E", "72E82F73B19987D612/F2581C",
     "000000000000000000/FFFFFF"},
    {&qv_hardware_rgb888, "2D9812", "3C9611", "64052D"},
    {&qv_hardware_rgb565, "A22C", "A23C", "2560"},
    {&qv_hardware_rgba8888, "2D981298", "3D9711A0", "64052D80"},
    {&qv_hardware_rgba12, "DF22992E2199", "CA93971971A0", "4C1605D58280"},
    {&qv_hand_out_rgba8888, "2D981298", "130A0013", "64052D80"},
};

static const qv_fragment slice = {{150000000, 77777777, 5}, 0x12345678};

static void S93_blends(void **state)
{
    static const qv_rect pixel = {0, 0, 1, 1};
    static const uint8_t background[4] = {200, 10, 90, 128};
    static const qv_moment moment = {.u = 0x87654321u, .opacity = 19};
    qv_scene scene = context_of(&qv_weighted_rgba8, 0).scene;
    qv_context context;
    (void)state;
    memcpy(scene.background, background, sizeof background);
    assert_int_equal(qv_init(&context, &scene), QV_OK);
    for (unsigned i = 0; i < COUNT(blends); i++) {
        const qv_blend *blend = blends[i].blend;
        bytes b = bytes_of(blends[i].states);
        blend->blend(b.pixel, b.beside, &slice, &moment);
        expect_bytes(&b, blends[i].after);
        const qv_buffer buffer = buffer_of(&b, blend);
        assert_int_equal(qv_clear(&buffer, &context, &pixel), QV_OK);
        expect_bytes(&b, blends[i].cleared);
    }
}

static uint32_t told[3];

static uint32_t listen(const qv_moment *moment, uint32_t level, uint32_t value, uint32_t colour)
{
    (void)moment;
    told[0] = level;
    told[1] = colour;
    told[2] = value;
    return 255;
}

/* Handed out with opacity 1, a slice shows its colours. */
static void S94_techniques(void **state)
{
    static const qv_technique listening = {listen, 1, 0};
    static const struct {
        const qv_blend *blend;
        const char *states;
        uint32_t colour, value;
    } examples[] = {{&qv_hardware_rgb888, "2D9812", 251, 45},
                    {&qv_hardware_rgb565, "A22C", 251, 41},
                    {&qv_hardware_rgba8888, "2D981298", 255, 152},
                    {&qv_hand_out_rgba8888, "2D981298", 255, 0}};
    (void)state;
    for (unsigned i = 0; i < COUNT(examples); i++) {
        qv_moment moment = {.technique = &listening};
        bytes b = bytes_of(examples[i].states);
        qv_moment_opacity(&moment, examples[i].blend, b.pixel, &slice);
        assert_int_equal(told[0], 1188386);
        assert_int_equal(told[1], examples[i].colour);
        assert_int_equal(told[2], examples[i].value);
        if (examples[i].blend == &qv_hand_out_rgba8888) {
            qv_hand_out_rgba8888.blend(b.pixel, b.beside, &slice, &moment);
            expect_bytes(&b, "FB8200FF");
        }
    }
}

static void store_pixel(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)column;
    (void)line;
    memcpy(row, pixel, sizeof *pixel);
}

static void S95_read_outs(void **state)
{
    static const struct {
        const qv_blend *blend;
        const char *states;
        qv_fragment shown;
        uint32_t channel[4];
    } examples[] = {
        {&qv_over_rgb888,
         "2D9812",
         {{377487360, 1275068416, 150994944}, 4294967295u},
         {2949120, 9961472, 1179648, 16711680}},
        {&qv_over_rgb565,
         "A22C",
         {{345015329, 1256293912, 138006132}, 4294967295u},
         {2695432, 9814796, 1078173, 16711680}},
        {&qv_over_rgba12,
         "DC92982D9198",
         {{383778816, 1279787008, 157810688}, 2569611560u},
         {2998272, 9998336, 1232896, 9998336}},
        {&qv_over_rgba24,
         "C0C62D7F969887D612809698",
         {{384000000, 1279999872, 158024576}, 2570039214u},
         {3000000, 9999999, 1234567, 10000000}},
        {&qv_under_rgb888,
         "2D9812/80841E",
         {{377487360, 1275068416, 150994944}, 3782967423u},
         {3733433, 10000687, 1532589, 15719493}},
        {&qv_under_rgb16,
         "C62D9698D612/80841E",
         {{383975424, 1279983616, 158007296}, 3782967423u},
         {3784121, 10039087, 1587373, 15719493}},
        {&qv_hardware_rgba12,
         "DF22992E2199",
         {{383940135, 1279800451, 157754994}, 2569638553u},
         {2999532, 9998441, 1232461, 9998441}},
    };
    static const qv_format whole = {store_pixel, 8 * sizeof(qv_pixel), 0};
    static const qv_rect rect = {0, 0, 1, 1};
    qv_scene scene = context_of(&qv_weighted_rgba8, 0).scene;
    qv_context context;
    const uint8_t background[4] = {200, 10, 90, 128};
    (void)state;
    memcpy(scene.background, background, sizeof background);
    assert_int_equal(qv_init(&context, &scene), QV_OK);
    for (unsigned i = 0; i < COUNT(examples); i++) {
        qv_pixel pixel;
        qv_fragment shown;
        bytes b = bytes_of(examples[i].states);
        const qv_buffer buffer = buffer_of(&b, examples[i].blend);
        const qv_image image = {&pixel, sizeof pixel, 0, &whole};
        examples[i].blend->read(&shown, b.pixel, b.beside);
        assert_memory_equal(&shown, &examples[i].shown, sizeof shown);
        assert_int_equal(qv_read_out(&image, &buffer, &context, &rect), QV_OK);
        assert_memory_equal(pixel.channel, examples[i].channel, sizeof pixel.channel);
    }
}

static void S96_combinations(void **state)
{
    static const struct {
        const qv_blend *blend, *front;
        const char *states, *front_states, *after;
    } examples[] = {
        {&qv_over_rgba16, &qv_hardware_rgba8888, "C62D9698D6129698", "164C094C",
         "21361CB739161CB7"},
        {&qv_over_rgb24, &qv_under_rgb888, "C0C62D7F969887D612", "164C09/80841E",
         "FC741B9C305EE43E0B"},
        {&qv_hardware_rgba8888, &qv_over_rgba12, "2D981298", "6E414C96404C", "37B716B7"},
        {&qv_over_rgb565, &qv_over_rgb888, "A22C", "164C09", "6112"},
    };
    static const qv_rect rect = {1, 7, 2, 8};
    static const qv_dither dither = {.sequence = qv_sequence_blocks,
                                     .technique = &qv_technique_rounded,
                                     .frame = 3,
                                     .period = 2};
    (void)state;
    for (unsigned i = 0; i < COUNT(examples); i++) {
        bytes behind = bytes_of(examples[i].states), front = bytes_of(examples[i].front_states);
        const qv_buffer b = buffer_of(&behind, examples[i].blend);
        const qv_buffer f = buffer_of(&front, examples[i].front);
        assert_int_equal(qv_combine(&b, &f, &dither, &rect, -5), QV_OK);
        expect_bytes(&behind, examples[i].after);
        expect_bytes(&front, examples[i].front_states);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S90_slices_of_a_ray),   cmocka_unit_test(S91_light_of_a_slice),
        cmocka_unit_test(S92_dither_of_a_slice), cmocka_unit_test(S93_blends),
        cmocka_unit_test(S94_techniques),        cmocka_unit_test(S95_read_outs),
        cmocka_unit_test(S96_combinations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
