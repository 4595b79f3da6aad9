/*
 * Levels of a pyramid along a ray: what is refused, pictures that must be alike, and a
 * level that rises with the distance.
 */
#include "check.h"
#include "length_samplings.h"
#include "level.h"
#include "scene_fixture.h"

#include <stdlib.h>

static fixture a, b;

/* ---- What is refused ---- */

static void make(void)
{
    fixture_make(&a, &qv_corrected_rgba16_levels, 1);
    fixture_add_pyramid(&a);
}

static void expect(qv_status status)
{
    qv_context context;
    fixture_poison(&context, sizeof context);
    assert_int_equal(qv_init(&context, &a.scene), status);
    assert_true((status == QV_OK) != fixture_untouched(&context, sizeof context));
}

static void pyramids_are_checked(void **state)
{
    (void)state;

    make();
    expect(QV_OK);
    a.scene.pyramid = NULL;
    expect(QV_ERROR_LEVEL);
    make();
    a.pyramid.voxels = NULL;
    expect(QV_ERROR_NULL);
    make();
    a.pyramid.voxels++;
    expect(QV_ERROR_STRIDE);
    make();
    a.pyramid.bytes = qv_pyramid_bytes(a.scene.volume.size, QV_STORAGE_RGBA16, 3) - 1;
    expect(QV_ERROR_BUFFER);
    make();
    a.pyramid.levels++;
    expect(QV_ERROR_LEVEL);
    a.pyramid.levels = 0;
    expect(QV_ERROR_LEVEL);
}

static void every_mode_needs_a_pyramid(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++) {
        fixture_make(&a, length_samplings[i].levels, 1);
        expect(QV_ERROR_LEVEL);
        fixture_add_pyramid(&a);
        expect(QV_OK);
    }
}

static void levels_have_limits(void **state)
{
    (void)state;

    make();
    a.scene.level = 3 * 256;
    expect(QV_OK);
    a.scene.level++;
    expect(QV_ERROR_LEVEL);
    make();
    a.scene.level_distance = 1; /* without an eye */
    expect(QV_ERROR_LEVEL);
    fixture_aim(&a, QUARTER_TURN);
    expect(QV_OK);
    a.scene.level_distance = (1u << 23) - 1;
    expect(QV_OK);
    a.scene.level_distance++;
    expect(QV_ERROR_LEVEL);
}

/* The medium's own errors come through. */
static void lengths_are_checked_too(void **state)
{
    (void)state;

    make();
    a.scene.volume.unit_distance = UINT32_MAX;
    expect(QV_ERROR_UNIT);
}

/* ---- Pictures ---- */

static fixture_pixels pixels_a, pixels_b;

static void level_0_is_the_volume(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++)
        for (unsigned perspective = 0; perspective < 2; perspective++) {
            fixture_make(&a, length_samplings[i].levels, 5 + i);
            fixture_make(&b, length_samplings[i].front, 5 + i);
            fixture_aim(&a, perspective * QUARTER_TURN);
            fixture_aim(&b, perspective * QUARTER_TURN);
            fixture_add_pyramid(&a);
            a.scene.level_distance = perspective * 100000; /* farther than anything */
            assert_in_range(fixture_difference(&a, &b), 0, 1);
        }
}

/* Level 1 of an even volume by itself: as many steps of twice the length, whose samples
   lie half a step of the finer grid after its own. */
static void a_level_is_a_volume(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++) {
        qv_view view = fixture_view(QUARTER_TURN / 3, QUARTER_TURN / 4, 0);
        fixture_make(&a, length_samplings[i].levels, 40 + i);
        a.scene.volume.size[1]--; /* 6 x 4 x 4 */
        a.scene.volume.unit_distance = QV_ONE_Q16;
        a.scene.level = 256;
        fixture_add_pyramid(&a);
        assert_int_equal(qv_orthographic(&a.scene.camera, &a.scene.volume, &view), QV_OK);
        b.scene = a.scene;
        b.scene.pyramid = NULL;
        b.scene.sampling = length_samplings[i % STORAGES < 2 ? i : i - 2].front;
        assert_int_equal(qv_pyramid_level(&b.scene.volume, &a.scene.volume, &a.pyramid, 1), QV_OK);
        view.step *= 2;
        b.scene.phase = 0x4000;
        assert_int_equal(qv_orthographic(&b.scene.camera, &b.scene.volume, &view), QV_OK);
        assert_in_range(fixture_difference(&a, &b), 0, 1);
    }
}

/* Voxels of one colour: each level, and what lies between two, is the same picture. */
static void equal_voxels_look_the_same_on_every_level(void **state)
{
    static const uint8_t entry[4] = {255, 100, 0, 40};
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i += STORAGES)
        for (uint16_t level = 0; level <= 3 * 256; level = (uint16_t)(level + 64)) {
            fixture_make(&a, length_samplings[i].levels, 1);
            for (unsigned v = 0; v < FIXTURE_VOXELS; v++)
                memcpy((uint8_t *)a.voxels + 4 * v, entry, 4);
            fixture_add_pyramid(&a);
            a.scene.volume.unit_distance = QV_ONE_Q16;
            b = a;
            b.scene.sampling = length_samplings[i].front;
            b.scene.volume.voxels = (qv_address)b.voxels;
            b.scene.pyramid = NULL;
            a.scene.level = level;
            assert_in_range(fixture_difference(&a, &b), 0, 1);
        }
}

/* ---- Blends ---- */

/* Between a volume and nothing, or nothing and a level: the share of what there is. */
static void empty_levels_count_as_nothing(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i += STORAGES)
        for (unsigned empty = 0; empty < 2; empty++) {
            fixture_make(&a, length_samplings[i].levels, 3);
            fixture_add_pyramid(&a);
            memset(empty == 0 ? a.voxels : a.coarser, 0,
                   empty == 0 ? sizeof a.voxels : sizeof a.coarser);
            a.scene.level = 128;
            fixture_render(pixels_a, &a);
            a.scene.level = empty == 0 ? 255 : 1; /* nearly all of the other */
            fixture_render(pixels_b, &a);
            uint32_t less = 0, more = 0;
            for (unsigned p = 3; p < sizeof pixels_a; p += 4) {
                less += (&pixels_a[0][0][0])[p] < (&pixels_b[0][0][0])[p];
                more += (&pixels_a[0][0][0])[p] > (&pixels_b[0][0][0])[p];
            }
            assert_true(less > 40);
            assert_true(more < less / 10);
        }
}

/* Half way between two levels the opacity of a thin medium is half way too, but for where
   samples lie: on average that goes away. */
static void blends_lie_between_their_levels(void **state)
{
    static const uint16_t levels[3] = {0, 128, 256};
    (void)state;

    for (unsigned i = 4 * STORAGES; i < LENGTH_SAMPLINGS; i++) {
        uint8_t opacity[3][FIXTURE_HEIGHT][FIXTURE_WIDTH];
        int32_t off = 0, worst = 0;
        fixture_make(&a, length_samplings[i].levels, 60 + i);
        fixture_add_pyramid(&a);
        a.scene.volume.extinction = QV_ONE_Q16;
        for (unsigned l = 0; l < 3; l++) {
            a.scene.level = levels[l];
            fixture_render(pixels_a, &a);
            for (unsigned p = 0; p < FIXTURE_WIDTH * FIXTURE_HEIGHT; p++)
                (&opacity[l][0][0])[p] = (&pixels_a[0][0][0])[4 * p + 3];
        }
        for (unsigned p = 0; p < FIXTURE_WIDTH * FIXTURE_HEIGHT; p++) {
            const int32_t ends = (&opacity[0][0][0])[p] + (&opacity[2][0][0])[p];
            const int32_t twice = 2 * (&opacity[1][0][0])[p] - ends;
            off += twice;
            worst = abs(twice) > worst ? abs(twice) : worst;
        }
        assert_in_range(worst, 0, 5);
        assert_in_range(abs(off), 0, 60);
    }
}

/* ---- Levels that rise ---- */

/* Each octave is a span, up to the coarsest level. */
static void spans_are_octaves(void **state)
{
    static const struct {
        int64_t stretch, end;
        unsigned level;
        uint32_t octave;
    } cases[] = {{0, 5, 0, 0},    {4, 5, 0, 0},    {5, 10, 0, 5},  {9, 10, 0, 5},
                 {10, 20, 1, 10}, {19, 20, 1, 10}, {20, 40, 2, 20}};
    (void)state;

    make();
    fixture_aim(&a, QUARTER_TURN);
    a.scene.level_distance = 5;
    for (unsigned i = 0; i < sizeof cases / sizeof *cases; i++) {
        const qv_ray ray = {.enter = cases[i].stretch * QV_STEP};
        qv_span span;
        qv_span_begin(&span, &ray, &a.scene);
        assert_true(span.end == cases[i].end * QV_STEP - QV_STEP / 2);
        assert_int_equal(span.level, cases[i].level);
        assert_int_equal(span.octave, cases[i].octave);
        assert_int_equal(span.blend, 0);
    }
    for (int64_t far = 40; far < 1 << 22; far *= 2) {
        const qv_ray ray = {.enter = far * QV_STEP};
        qv_span span;
        qv_span_begin(&span, &ray, &a.scene);
        assert_true(span.end == INT64_MAX);
        assert_int_equal(span.level, 3);
        assert_int_equal(span.octave, 0);
    }
}

/* Behind the distance there are fewer pieces, and none is left out. */
static void rays_take_fewer_pieces_far_away(void **state)
{
    const qv_image image = {pixels_a, sizeof pixels_a, FIXTURE_WIDTH * 4, &qv_format_rgba8888};
    uint32_t before = UINT32_MAX;
    (void)state;

    for (uint32_t distance = 64; distance != 0; distance /= 2) {
        qv_progress progress = {0, 0, 0, 0, 0};
        make();
        fixture_aim(&a, QUARTER_TURN);
        a.scene.level_distance = distance;
        const qv_context context = fixture_context(&a);
        assert_int_equal(qv_render_some(&image, &progress, &context, &fixture_frame, 10000), QV_OK);
        assert_true(progress.samples <= before);
        before = progress.samples;
    }
    assert_in_range(before, 1, 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pyramids_are_checked),
        cmocka_unit_test(every_mode_needs_a_pyramid),
        cmocka_unit_test(levels_have_limits),
        cmocka_unit_test(lengths_are_checked_too),
        cmocka_unit_test(level_0_is_the_volume),
        cmocka_unit_test(a_level_is_a_volume),
        cmocka_unit_test(equal_voxels_look_the_same_on_every_level),
        cmocka_unit_test(empty_levels_count_as_nothing),
        cmocka_unit_test(blends_lie_between_their_levels),
        cmocka_unit_test(spans_are_octaves),
        cmocka_unit_test(rays_take_fewer_pieces_far_away),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
