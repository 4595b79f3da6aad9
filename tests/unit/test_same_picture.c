/*
 * Different scenes that must give the same picture: voxels stored otherwise, both
 * orders of compositing, and the grid of samples moved.
 */
#include "check.h"
#include "length_samplings.h"
#include "ray.h"
#include "scene_fixture.h"

static fixture a, b;

/* ---- Storages ---- */

/* The same seed chooses the same entries of the same palette. */
static void a_palette_gives_the_picture_of_its_colours(void **state)
{
    static const qv_sampling *const pairs[][2] = {
        {&qv_nearest_rgba8, &qv_nearest_indexed8},
        {&qv_separate_rgba8, &qv_separate_indexed8},
        {&qv_weighted_rgba8, &qv_weighted_indexed8},
        {&qv_nearest_rgba16, &qv_nearest_indexed8_16},
        {&qv_separate_rgba16, &qv_separate_indexed8_16},
        {&qv_weighted_rgba16, &qv_weighted_indexed8_16},
        {&qv_nearest_rgba8_back_to_front, &qv_nearest_indexed8_back_to_front},
        {&qv_separate_rgba8_back_to_front, &qv_separate_indexed8_back_to_front},
        {&qv_weighted_rgba8_back_to_front, &qv_weighted_indexed8_back_to_front},
        {&qv_nearest_rgba16_back_to_front, &qv_nearest_indexed8_16_back_to_front},
        {&qv_separate_rgba16_back_to_front, &qv_separate_indexed8_16_back_to_front},
        {&qv_weighted_rgba16_back_to_front, &qv_weighted_indexed8_16_back_to_front},
    };
    (void)state;

    for (unsigned i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        for (uint32_t seed = 1; seed < 6; seed++) {
            fixture_make(&a, pairs[i][0], seed);
            fixture_make(&b, pairs[i][1], seed);
            assert_int_equal(fixture_difference(&a, &b), 0);
        }
}

/* 257 times an 8-bit channel is the same colour of 16 bits. */
static void wide_voxels_agree_with_narrow_ones(void **state)
{
    static const qv_sampling *const pairs[][2] = {
        {&qv_nearest_rgba8, &qv_nearest_rgba16},
        {&qv_separate_rgba8, &qv_separate_rgba16},
        {&qv_weighted_rgba8, &qv_weighted_rgba16},
        {&qv_weighted_rgba8_back_to_front, &qv_weighted_rgba16_back_to_front},
    };
    (void)state;

    for (unsigned i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        for (uint32_t seed = 1; seed < 20; seed++) {
            fixture_make(&a, pairs[i][0], seed);
            fixture_make(&b, pairs[i][1], seed);
            for (unsigned c = 0; c < FIXTURE_VOXELS * 4; c++)
                b.voxels[c] = (uint16_t)(((uint8_t *)a.voxels)[c] * 257);
            assert_in_range(fixture_difference(&a, &b), 0, 1);
        }
}

/* ---- Storages, of modes that weigh by length ---- */

/* A scene of a mode that weighs by length, for a unit distance of two steps. */
static void make_by_length(fixture *f, const qv_sampling *sampling, uint32_t seed)
{
    fixture_make(f, sampling, seed);
    f->scene.volume.unit_distance = 2 * f->scene.camera.step;
    fixture_aim(f, seed % 2 * QUARTER_TURN);
}

static void make_pair(const qv_sampling *of_a, const qv_sampling *of_b, uint32_t seed)
{
    make_by_length(&a, of_a, seed);
    make_by_length(&b, of_b, seed);
}

/* Pyramids of a palette hold its colours. */
static void palettes_by_length(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++)
        for (uint32_t seed = 1; seed < 4 && i % STORAGES < 2; seed++) {
            const length_sampling *colours = &length_samplings[i], *palette = colours + 2;
            make_pair(colours->front, palette->front, seed);
            assert_int_equal(fixture_difference(&a, &b), 0);
            make_pair(colours->back, palette->back, seed);
            assert_int_equal(fixture_difference(&a, &b), 0);
            make_pair(colours->levels, palette->levels, seed);
            fixture_add_pyramid(&a);
            fixture_add_pyramid(&b);
            a.scene.level = b.scene.level = (uint16_t)(seed * 100);
            assert_int_equal(fixture_difference(&a, &b), 0);
        }
}

static void wide_voxels_by_length(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i += STORAGES)
        for (uint32_t seed = 1; seed < 20; seed++) {
            make_pair(length_samplings[i].front, length_samplings[i + 1].front, seed);
            for (unsigned c = 0; c < FIXTURE_VOXELS * 4; c++)
                b.voxels[c] = (uint16_t)(((uint8_t *)a.voxels)[c] * 257);
            assert_in_range(fixture_difference(&a, &b), 0, 1);
        }
}

/* ---- Layouts ---- */

/* Lays b's volume out anew: axes from the fastest to the slowest, each forwards or
   backwards in memory, with a gap after each row. */
static void rearrange(uint8_t memory[8192], const unsigned order[3], unsigned mirrored)
{
    qv_volume *volume = &b.scene.volume;
    const qv_volume old = *volume;
    const int32_t bytes = fixture_voxel_bytes(volume->storage);
    int32_t stride = bytes, first = 0;
    for (unsigned i = 0; i < 3; i++) {
        const unsigned axis = order[i];
        const int backwards = (mirrored >> axis & 1) != 0;
        volume->stride[axis] = backwards ? -stride : stride;
        first += backwards ? stride * (volume->size[axis] - 1) : 0;
        stride = stride * volume->size[axis] + 2 * bytes;
    }
    volume->voxels = memory + first;
    volume->voxels_bytes = (uint64_t)stride;
    fixture_poison(memory, 8192);
    for (int32_t i = 0; i < FIXTURE_VOXELS; i++) {
        const int32_t at[3] = {i % FIXTURE_NX, i / FIXTURE_NX % FIXTURE_NY,
                               i / (FIXTURE_NX * FIXTURE_NY)};
        ptrdiff_t from = 0, to = first;
        for (unsigned axis = 0; axis < 3; axis++) {
            from += at[axis] * old.stride[axis];
            to += at[axis] * volume->stride[axis];
        }
        memcpy(memory + to, old.voxels + from, (size_t)bytes);
    }
}

static void every_layout_gives_the_same_picture(void **state)
{
    static const unsigned orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                          {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const qv_sampling *const modes[4] = {&qv_weighted_rgba8, &qv_separate_rgba16,
                                                &qv_nearest_indexed8, &qv_weighted_indexed8_16};
    static uint16_t memory[4096];
    (void)state;

    for (unsigned m = 0; m < 4; m++)
        for (unsigned o = 0; o < 6; o++)
            for (unsigned mirrored = 0; mirrored < 8; mirrored++) {
                fixture_make(&a, modes[m], 7);
                fixture_make(&b, modes[m], 7);
                rearrange((uint8_t *)memory, orders[o], mirrored);
                assert_int_equal(fixture_difference(&a, &b), 0);
            }
}

static void every_layout_by_length(void **state)
{
    static const unsigned orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                          {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static uint16_t memory[4096];
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++)
        for (unsigned o = 0; o < 6; o++) {
            make_pair(length_samplings[i].front, length_samplings[i].front, 7);
            rearrange((uint8_t *)memory, orders[o], (i + o) % 8);
            assert_int_equal(fixture_difference(&a, &b), 0);
        }
}

/* Bytes may stand at any address. */
static void narrow_voxels_need_no_alignment(void **state)
{
    static uint8_t memory[FIXTURE_VOXELS * 4 + 4];
    (void)state;

    for (unsigned offset = 1; offset < 4; offset++) {
        fixture_make(&a, &qv_weighted_rgba8, 7);
        fixture_make(&b, &qv_weighted_rgba8, 7);
        memcpy(memory + offset, b.voxels, FIXTURE_VOXELS * 4);
        b.scene.volume.voxels = memory + offset;
        assert_int_equal(fixture_difference(&a, &b), 0);
    }
}

/* ---- Orders of compositing ---- */

static void both_orders_agree(void **state)
{
    static const qv_sampling *const pairs[][2] = {
        {&qv_nearest_rgba8, &qv_nearest_rgba8_back_to_front},
        {&qv_separate_rgba8, &qv_separate_rgba8_back_to_front},
        {&qv_weighted_rgba8, &qv_weighted_rgba8_back_to_front},
        {&qv_nearest_rgba16, &qv_nearest_rgba16_back_to_front},
        {&qv_separate_rgba16, &qv_separate_rgba16_back_to_front},
        {&qv_weighted_rgba16, &qv_weighted_rgba16_back_to_front},
        {&qv_weighted_indexed8, &qv_weighted_indexed8_back_to_front},
        {&qv_weighted_indexed8_16, &qv_weighted_indexed8_16_back_to_front},
    };
    (void)state;

    for (unsigned i = 0; i < sizeof pairs / sizeof pairs[0]; i++)
        for (uint32_t seed = 1; seed < 20; seed++) {
            fixture_make(&a, pairs[i][0], seed);
            fixture_make(&b, pairs[i][1], seed);
            fixture_aim(&a, seed % 2 * QUARTER_TURN);
            fixture_aim(&b, seed % 2 * QUARTER_TURN);
            assert_in_range(fixture_difference(&a, &b), 0, 1);
        }
}

static void both_orders_by_length(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++)
        for (uint32_t seed = 1; seed < 12; seed++) {
            make_pair(length_samplings[i].front, length_samplings[i].back, seed);
            assert_in_range(fixture_difference(&a, &b), 0, 1);
        }
}

/* ---- Lengths ---- */

/* Extinction of a world unit and opacity for it say the same. */
static void extinction_is_depth_of_opacity(void **state)
{
    (void)state;

    for (uint32_t seed = 1; seed < 12; seed++) {
        qv_entries opacities = {.count = FIXTURE_VOXELS, .storage = QV_STORAGE_RGBA16};
        make_pair(&qv_extinction_rgba16, &qv_extinction_rgbt16, seed);
        opacities.entries = (qv_address)a.voxels;
        opacities.unit_distance = a.scene.volume.unit_distance;
        b.scene.volume.extinction = QV_ONE_Q16;
        assert_int_equal(qv_opacity_to_extinction(b.voxels, sizeof b.voxels, QV_STORAGE_RGBT16,
                                                  QV_ONE_Q16, &opacities),
                         QV_OK);
        assert_in_range(fixture_difference(&a, &b), 0, 1);
    }
}

/* The same box and the same medium in world units: voxels of another spacing. */
static void spacings_only_scale(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++) {
        make_pair(length_samplings[i].front, length_samplings[i].front, 9);
        for (unsigned axis = 0; axis < 3; axis++)
            b.scene.volume.spacing[axis] = 2 * QV_ONE_Q16;
        b.scene.volume.extinction /= 2;
        b.scene.volume.unit_distance *= 2;
        b.scene.camera.step *= 2;
        assert_int_equal(fixture_difference(&a, &b), 0);
    }
}

/* ---- The grid of samples ---- */

/* A phase is a shift of the origin along the rays. */
static void a_phase_moves_the_samples(void **state)
{
    static const uint16_t phases[4] = {1, 0x4000, 0x8000, 0xFFFF};
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        fixture_make(&a, &qv_weighted_rgba8, 11);
        fixture_make(&b, &qv_weighted_rgba8, 11);
        a.scene.phase = phases[i];
        for (unsigned axis = 0; axis < 3; axis++)
            b.scene.camera.origin[axis] += qv_phase_of(b.scene.camera.along[axis], phases[i]);
        assert_int_equal(fixture_difference(&a, &b), 0);
        b.scene.camera.origin[2] += VOXEL / 4;
        assert_true(fixture_difference(&a, &b) > 0);
    }
}

/* Whole steps along the rays lead to the same grid. */
static void a_whole_step_changes_nothing(void **state)
{
    (void)state;

    for (int steps = -3; steps <= 3; steps++) {
        fixture_make(&a, &qv_weighted_rgba8, 13);
        fixture_make(&b, &qv_weighted_rgba8, 13);
        for (unsigned axis = 0; axis < 3; axis++)
            b.scene.camera.origin[axis] += steps * b.scene.camera.along[axis];
        assert_int_equal(fixture_difference(&a, &b), 0);
    }
}

/* ---- The edge of the volume ---- */

/* Beyond the outermost centres voxels repeat: more voxels of the same values
   there, under a ray that stays within half a voxel of the face. */
static void values_are_clamped_at_the_edge(void **state)
{
    static uint8_t memory[FIXTURE_VOXELS * 8];
    (void)state;

    fixture_make(&a, &qv_weighted_rgba8, 17);
    for (unsigned axis = 0; axis < 3; axis++) { /* along y, at z = 0 .. 1/2 */
        a.scene.camera.across[axis] = axis == 0 ? VOXEL / 4 : 0;
        a.scene.camera.down[axis] = axis == 2 ? VOXEL / 32 : 0;
        a.scene.camera.along[axis] = axis == 1 ? VOXEL / 2 : 0;
        a.scene.camera.origin[axis] = axis == 0 ? VOXEL / 7 : 0;
    }
    b = a;
    const size_t slice = (size_t)a.scene.volume.stride[2];
    memcpy(memory, a.voxels, slice);
    memcpy(memory + slice, a.voxels, slice * FIXTURE_NZ);
    b.scene.volume.voxels = memory;
    b.scene.volume.size[2] = FIXTURE_NZ + 1;
    b.scene.volume.voxels_bytes += slice;
    b.scene.camera.origin[2] += VOXEL; /* now above a slice of the same values */
    assert_int_equal(fixture_difference(&a, &b), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_palette_gives_the_picture_of_its_colours),
        cmocka_unit_test(wide_voxels_agree_with_narrow_ones),
        cmocka_unit_test(palettes_by_length),
        cmocka_unit_test(wide_voxels_by_length),
        cmocka_unit_test(every_layout_gives_the_same_picture),
        cmocka_unit_test(every_layout_by_length),
        cmocka_unit_test(narrow_voxels_need_no_alignment),
        cmocka_unit_test(both_orders_agree),
        cmocka_unit_test(both_orders_by_length),
        cmocka_unit_test(extinction_is_depth_of_opacity),
        cmocka_unit_test(spacings_only_scale),
        cmocka_unit_test(a_phase_moves_the_samples),
        cmocka_unit_test(a_whole_step_changes_nothing),
        cmocka_unit_test(values_are_clamped_at_the_edge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
