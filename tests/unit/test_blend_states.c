/*
 * Every blend against its model: the bytes of a pixel and of what lies beside it, before and
 * after, with nothing around them touched.
 */
#include "blend_model.h"
#include "check.h"
#include "random.h"
#include "scene_fixture.h"

enum { TURNS = 4000, GUARD = 4, MOST_BYTES = 12, MOST_BESIDE = 4 };

/* A pixel between bytes that nobody may touch. */
typedef struct guarded {
    uint8_t pixel[GUARD + MOST_BYTES + GUARD];
    uint8_t beside[GUARD + MOST_BESIDE + GUARD];
} guarded;

static uint8_t *beside_of(guarded *g, const blend_model *of)
{
    return of->beside == 0 ? NULL : g->beside + GUARD;
}

static void expect_pixel(const blend_model *of, const model_pixel *expected, const guarded *is)
{
    guarded model;
    fixture_poison(&model, sizeof model);
    model_write(of, model.pixel + GUARD, model.beside + GUARD, expected);
    if (memcmp(&model, is, sizeof model) != 0)
        fail_msg("%s is not its model", of->name);
}

/* ---- Drawn values ------------------------------------------------------------ */

/* Of any magnitude; often an end. */
static uint32_t draw_opacity(uint32_t *seed)
{
    const uint32_t v = random_next(seed);
    if (v % 16 == 0)
        return 0;
    if (v % 16 == 1)
        return 0xFFFFFFFFu;
    return random_next(seed) >> v / 16 % 32;
}

/* Light within the opacity's, or, by roundings, a little above. */
static qv_fragment draw_fragment(uint32_t *seed)
{
    qv_fragment fragment = {{0, 0, 0}, draw_opacity(seed)};
    const uint64_t opaque = (uint64_t)fragment.opacity * 255 >> 9;
    for (unsigned c = 0; c < 3; c++) {
        const uint32_t part = random_below(seed, 5);
        fragment.light[c] = part == 0   ? 0
                            : part == 1 ? (uint32_t)opaque + random_below(seed, 300)
                                        : (uint32_t)(opaque * (random_next(seed) >> 16) >> 16);
    }
    return fragment;
}

/* A scene's: a colour of 8 bits, weighted by an opacity of 8 bits. */
static qv_fragment draw_background(uint32_t *seed)
{
    const uint32_t opacity = random_below(seed, 256);
    qv_fragment background = {{0, 0, 0}, opacity * 0x01010101u};
    for (unsigned c = 0; c < 3; c++)
        background.light[c] = (uint32_t)(((uint64_t)random_below(seed, 256) * opacity << 23) / 255);
    return background;
}

/* Any states, colours within the opacity. */
static model_pixel draw_pixel(const blend_model *of, uint32_t *seed)
{
    model_pixel p = {{0, 0, 0, 0}, random_next(seed) >> (8 + random_below(seed, 4))};
    uint64_t share = (uint64_t)1 << 32;
    if (of->channels == 4)
        share = random_below(seed, 4) == 0 ? share : random_next(seed);
    for (unsigned c = 0; c < of->channels; c++) {
        const uint64_t most = model_full(of, c) * share >> 32;
        p.state[c] = random_below(seed, 8) == 0 || c == 3 ? most : most * random_next(seed) >> 32;
    }
    return p;
}

/* ---- Blends ------------------------------------------------------------------ */

static void sizes_are_those_of_the_states(void **state)
{
    (void)state;
    for (unsigned i = 0; i < MODELS; i++) {
        assert_int_equal(models[i].blend->bytes, models[i].bytes);
        assert_int_equal(models[i].blend->beside, models[i].beside);
    }
}

static void blends_follow_their_rules(void **state)
{
    uint32_t seed = 1;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        for (unsigned turn = 0; turn < TURNS; turn++) {
            const blend_model *of = &models[i];
            const qv_fragment fragment = draw_fragment(&seed);
            const qv_moment moment = {.u = random_next(&seed), .opacity = random_below(&seed, 256)};
            model_pixel p = draw_pixel(of, &seed);
            guarded g;
            fixture_poison(&g, sizeof g);
            model_write(of, g.pixel + GUARD, g.beside + GUARD, &p);
            of->blend->blend(g.pixel + GUARD, beside_of(&g, of), &fragment, &moment);
            model_blend(of, &p, &fragment, moment.u, moment.opacity);
            expect_pixel(of, &p, &g);
        }
}

/* The model reads the bytes that it has written. */
static void fields_of_bits_do_not_overlap(void **state)
{
    uint32_t seed = 2;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        for (unsigned turn = 0; turn < 100; turn++) {
            const model_pixel p = draw_pixel(&models[i], &seed);
            uint8_t pixel[MOST_BYTES], beside[MOST_BESIDE];
            model_write(&models[i], pixel, beside, &p);
            const model_pixel back = model_read(&models[i], pixel, beside);
            assert_memory_equal(back.state, p.state, sizeof p.state);
        }
}

static void clears_put_the_background_over_nothing(void **state)
{
    uint32_t seed = 3;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        for (unsigned turn = 0; turn < TURNS / 4; turn++) {
            const blend_model *of = &models[i];
            const qv_fragment background = draw_background(&seed);
            guarded g;
            fixture_poison(&g, sizeof g);
            of->blend->clear(g.pixel + GUARD, beside_of(&g, of), &background);
            const model_pixel expected = model_clear(of, &background);
            expect_pixel(of, &expected, &g);
        }
}

static void reads_show_states(void **state)
{
    uint32_t seed = 4;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        for (unsigned turn = 0; turn < TURNS; turn++) {
            const blend_model *of = &models[i];
            const model_pixel p = draw_pixel(of, &seed);
            const qv_fragment expected = model_shown(of, &p);
            qv_fragment shown;
            uint8_t pixel[MOST_BYTES], beside[MOST_BESIDE];
            model_write(of, pixel, beside, &p);
            of->blend->read(&shown, pixel, of->beside == 0 ? NULL : beside);
            assert_memory_equal(&shown, &expected, sizeof shown);
        }
}

/* A slice without opacity; front to back, states that no pixel reaches come within it. */
static void nothing_changes_nothing(void **state)
{
    static const qv_fragment nothing = {{0, 0, 0}, 0};
    uint32_t seed = 5;
    (void)state;

    for (unsigned i = 0; i < MODELS - 1; i++)
        for (unsigned turn = 0; turn < 300; turn++) {
            const blend_model *of = &models[i];
            const qv_moment moment = {.u = random_next(&seed)};
            model_pixel p = draw_pixel(of, &seed);
            guarded g;
            fixture_poison(&g, sizeof g);
            for (unsigned c = 0; c < 3 && of->rule == RULE_UNDER; c++)
                p.state[c] = model_least(p.state[c], model_share(p.transmittance, of->fraction));
            model_write(of, g.pixel + GUARD, g.beside + GUARD, &p);
            of->blend->blend(g.pixel + GUARD, beside_of(&g, of), &nothing, &moment);
            expect_pixel(of, &p, &g);
        }
}

static void white_hides_all(void **state)
{
    static const qv_fragment white = {{FX_LIGHT_ONE, FX_LIGHT_ONE, FX_LIGHT_ONE}, 0xFFFFFFFFu};
    uint32_t seed = 6;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        for (unsigned turn = 0; turn < 100 && models[i].rule != RULE_UNDER; turn++) {
            const blend_model *of = &models[i];
            const qv_moment moment = {.u = random_next(&seed), .opacity = 255};
            model_pixel p = draw_pixel(of, &seed);
            guarded g;
            fixture_poison(&g, sizeof g);
            model_write(of, g.pixel + GUARD, g.beside + GUARD, &p);
            of->blend->blend(g.pixel + GUARD, beside_of(&g, of), &white, &moment);
            for (unsigned c = 0; c < of->channels; c++)
                p.state[c] = model_full(of, c);
            expect_pixel(of, &p, &g);
        }
}

/* ---- Sums of many slices ------------------------------------------------------ */

/* Of pixels with opacity, whatever the slices: no colour above it. */
static void colours_stay_within_the_opacity(void **state)
{
    uint32_t seed = 8;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        for (unsigned run = 0; run < 20; run++) {
            const blend_model *of = &models[i];
            uint8_t pixel[MOST_BYTES], beside[MOST_BESIDE];
            const qv_fragment background = draw_background(&seed);
            of->blend->clear(pixel, beside, &background);
            for (unsigned slice = 0; slice < 400; slice++) {
                const model_pixel p = model_read(of, pixel, beside);
                const uint64_t most = of->rule == RULE_UNDER
                                          ? model_share(p.transmittance, of->fraction)
                                          : p.state[3];
                for (unsigned c = 0; c < 3 && (of->channels == 4 || of->rule == RULE_UNDER); c++)
                    assert_true(p.state[c] <= most);
                const qv_fragment fragment = draw_fragment(&seed);
                const qv_moment moment = {.u = random_next(&seed),
                                          .opacity = random_below(&seed, 256)};
                of->blend->blend(pixel, of->beside == 0 ? NULL : beside, &fragment, &moment);
            }
        }
}

/* Black, grey and white slices keep every pixel grey. */
static void grey_stays_grey(void **state)
{
    uint32_t seed = 7;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++) {
        const blend_model *of = &models[i];
        uint8_t pixel[MOST_BYTES], beside[MOST_BESIDE];
        const qv_fragment nothing = {{0, 0, 0}, 0};
        of->blend->clear(pixel, beside, &nothing);
        for (unsigned slice = 0; slice < 400 && !model_is_565(of); slice++) {
            qv_fragment fragment = draw_fragment(&seed);
            const qv_moment moment = {.u = random_next(&seed), .opacity = random_below(&seed, 256)};
            fragment.light[1] = fragment.light[2] = fragment.light[0];
            of->blend->blend(pixel, of->beside == 0 ? NULL : beside, &fragment, &moment);
            const model_pixel p = model_read(of, pixel, beside);
            assert_true(p.state[0] == p.state[1] && p.state[1] == p.state[2]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sizes_are_those_of_the_states),
        cmocka_unit_test(blends_follow_their_rules),
        cmocka_unit_test(fields_of_bits_do_not_overlap),
        cmocka_unit_test(clears_put_the_background_over_nothing),
        cmocka_unit_test(reads_show_states),
        cmocka_unit_test(nothing_changes_nothing),
        cmocka_unit_test(white_hides_all),
        cmocka_unit_test(colours_stay_within_the_opacity),
        cmocka_unit_test(grey_stays_grey),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
