/*
 * Voxels through pages: pictures are those of voxels in memory, whatever the cache; each brick is
 * read when it is wanted and not before; what cannot be read is 0.
 */
#include "pages.h"
#include "pages_fixture.h"
#include "slices_fixture.h"

static paged p;

static const uint8_t cubes[3] = {1, 1, 1}, eighths[3] = {2, 2, 1};
static const uint8_t slices[3] = {12, 12, 0}, all[3] = {12, 12, 12};

/* One of each kind of sampling, and two storages. */
static const qv_sampling *const modes[][2] = {
    {&qv_nearest_rgba8, &qv_nearest_rgba8_paged},
    {&qv_weighted_indexed8, &qv_weighted_indexed8_paged},
    {&qv_separate_rgba16, &qv_separate_rgba16_paged},
    {&qv_corrected_indexed8_16, &qv_corrected_indexed8_16_paged},
    {&qv_extinction_rgba8_back_to_front, &qv_extinction_rgba8_paged_back_to_front},
    {&qv_extinction_rgbt16, &qv_extinction_rgbt16_paged},
    {&qv_bspline_weighted_rgba16, &qv_bspline_weighted_rgba16_paged},
    {&qv_bspline_extinction_rgba8, &qv_bspline_extinction_rgba8_paged},
};

enum { MODES = sizeof modes / sizeof *modes };

/* ---- Reading ---------------------------------------------------------------- */

/* Bricks of 2 x 2 x 2 voxels: 3 x 3 x 2 of them, those at the upper y face half outside. */
static void bricks_are_asked_for_by_number_and_block(void **state)
{
    (void)state;

    paged_make(&p, modes[1][0], modes[1][1], cubes, 18);
    assert_true(paged_same(&p, QV_OK));
    for (unsigned number = 0; number < 18; number++) {
        const uint16_t first[3] = {(uint16_t)(2 * (number % 3)), (uint16_t)(2 * (number / 3 % 3)),
                                   (uint16_t)(2 * (number / 9))};
        const qv_block *block = &p.blocks[number];
        for (unsigned axis = 0; axis < 3; axis++) {
            const unsigned end = first[axis] + 2u, size = p.linear.size[axis];
            assert_int_equal(block->first[axis], first[axis]);
            assert_int_equal(block->end[axis], end < size ? end : size);
        }
    }
    paged_free(&p);
}

/* 8 bricks in one set of pages: nothing is read twice, not in a second picture either, though a
   new context sees it from elsewhere. */
static void bricks_that_all_have_pages_are_read_once(void **state)
{
    (void)state;

    for (unsigned i = 0; i < MODES; i++) {
        paged_make(&p, modes[i][0], modes[i][1], eighths, 8);
        assert_true(paged_same(&p, QV_OK));
        fixture_aim(&p.in_memory, QUARTER_TURN / 2);
        p.through_pages.scene.camera = p.in_memory.scene.camera;
        assert_true(paged_same(&p, QV_OK));
        assert_int_equal(p.pages.failures, 0);
        assert_true(p.pages.searches >= p.pages.reads);
        for (unsigned brick = 0; brick < 8; brick++)
            assert_true(p.reads[brick] <= 1);
        paged_free(&p);
    }
}

/* Of 8 pages, the least that cubes need, bricks make room for each other. */
static void few_pages_are_read_often(void **state)
{
    (void)state;

    for (unsigned i = 0; i < MODES; i++) {
        paged_make(&p, modes[i][0], modes[i][1], cubes, 8);
        assert_true(paged_same(&p, QV_OK));
        assert_true(p.pages.reads > 18);
        paged_free(&p);
    }
}

/* Modes of all kinds take turns pixel by pixel: what one drops from the cache, no other sees. */
static void modes_share_pages(void **state)
{
    qv_progress progress[3] = {{0}};
    fixture_pixels pixels[3], expected[3];
    qv_context contexts[3];
    static const qv_sampling *const turns[3][2] = {
        {&qv_weighted_rgba8, &qv_weighted_rgba8_paged},
        {&qv_nearest_rgba8, &qv_nearest_rgba8_paged},
        {&qv_bspline_weighted_rgba8, &qv_bspline_weighted_rgba8_paged}};
    qv_status status = QV_MORE;
    (void)state;

    paged_make(&p, turns[0][0], turns[0][1], cubes, 8);
    for (unsigned i = 0; i < 3; i++) {
        p.in_memory.scene.sampling = turns[i][0];
        p.through_pages.scene.sampling = turns[i][1];
        fixture_render(expected[i], &p.in_memory);
        contexts[i] = fixture_context(&p.through_pages);
    }
    while (status == QV_MORE)
        for (unsigned i = 0; i < 3; i++) {
            const qv_image image = {pixels[i], sizeof pixels[i], FIXTURE_WIDTH * 4,
                                    &qv_format_rgba8888};
            status = qv_render_some(&image, &progress[i], &contexts[i], &fixture_frame, 1);
        }
    assert_int_equal(status, QV_OK);
    assert_memory_equal(pixels, expected, sizeof pixels);
    paged_free(&p);
}

/* A ray that goes on in the box of cells of another one's last sample, once other modes have taken
   its pages away: it finds the same voxel. */
static void boxes_do_not_outlive_their_pages(void **state)
{
    static const qv_coord place[3] = {0, 0, 0};
    static const uint16_t corner[3] = {0, 0, 0};
    (void)state;

    paged_make(&p, &qv_weighted_rgba8, &qv_weighted_rgba8_paged, cubes, 8);
    qv_pages_seek(&p.pages, place);
    assert_int_equal(p.pages.cells[0], 1);
    for (uint16_t brick = 1; brick < 18; brick++) {
        const uint16_t other[3] = {(uint16_t)(2 * (brick % 3)), (uint16_t)(2 * (brick / 3 % 3)),
                                   (uint16_t)(2 * (brick / 9))};
        (void)qv_pages_voxel(&p.pages, other);
    }
    assert_int_equal(p.pages.cells[0], 0);
    qv_pages_seek(&p.pages, place);
    assert_true(p.pages.corner[0] == qv_pages_voxel(&p.pages, corner));
    paged_free(&p);
}

/* ---- Failing reads ------------------------------------------------------------ */

/* Sets the voxels of a block to 0. */
static void clear_block(fixture *f, const qv_block *block)
{
    const qv_volume *volume = &f->scene.volume;
    for (unsigned z = block->first[2]; z < block->end[2]; z++)
        for (unsigned y = block->first[1]; y < block->end[1]; y++)
            for (unsigned x = block->first[0]; x < block->end[0]; x++)
                memset((uint8_t *)f->voxels + (int)x * volume->stride[0] +
                           (int)y * volume->stride[1] + (int)z * volume->stride[2],
                       0, (size_t)volume->stride[0]);
}

/* Whatever brick it is, the picture is that of a volume with 0 there. */
static void what_cannot_be_read_is_0(void **state)
{
    (void)state;

    for (unsigned i = 0; i < MODES; i++)
        for (uint32_t failing = 0; failing < 18; failing++) {
            fixture_pixels actual, expected;
            paged_make(&p, modes[i][0], modes[i][1], cubes, (uint16_t)(8 + failing));
            p.failing = failing;
            assert_int_equal(paged_render(actual, &p.through_pages), QV_ERROR_READ);
            assert_int_equal(p.pages.status, QV_ERROR_READ);
            assert_int_equal(p.pages.error, PAGED_ERROR);
            assert_int_equal(p.pages.failures, p.reads[failing]);
            clear_block(&p.in_memory, &p.blocks[failing]);
            fixture_render(expected, &p.in_memory);
            assert_memory_equal(actual, expected, sizeof actual);
            paged_free(&p);
        }
}

/* The status stays until the caller takes it away; the brick stays 0 while it keeps its page. */
static void failure_stays_until_it_is_taken_away(void **state)
{
    fixture_pixels broken, again;
    (void)state;

    paged_make(&p, modes[1][0], modes[1][1], all, 1);
    p.failing = 0;
    assert_int_equal(paged_render(broken, &p.through_pages), QV_ERROR_READ);
    p.failing = PAGED_BRICKS;
    assert_int_equal(paged_render(again, &p.through_pages), QV_ERROR_READ);
    assert_memory_equal(broken, again, sizeof broken);
    p.pages.status = QV_OK;
    assert_int_equal(paged_render(again, &p.through_pages), QV_OK);
    assert_memory_equal(broken, again, sizeof broken);
    assert_int_equal(p.pages.reads, 1);
    assert_int_equal(qv_pages_init(&p.pages, &p.through_pages.scene.volume), QV_OK);
    assert_true(paged_same(&p, QV_OK));
    paged_free(&p);
}

static void slices_tell_of_failures_too(void **state)
{
    static frame target;
    const qv_dither dither = {.sequence = qv_sequence_rounded};
    (void)state;

    paged_make(&p, modes[1][0], modes[1][1], slices, 2);
    const qv_context context = fixture_context(&p.through_pages);
    frame_make(&target, &qv_over_rgba8888, 0);
    const qv_buffer buffer = frame_part(&target, &fixture_frame);
    assert_int_equal(qv_slice(&buffer, &dither, &context, &fixture_frame, 0), QV_OK);
    assert_true(p.pages.reads > 0);
    p.pages.status = QV_ERROR_READ;
    assert_int_equal(qv_slice(&buffer, &dither, &context, &fixture_frame, 0), QV_ERROR_READ);
    paged_free(&p);
}

/* ---- From linear memory --------------------------------------------------------- */

/* One call for a slice, or for all; else one for each row of a brick. */
static void whole_rows_and_slices_are_read_at_once(void **state)
{
    (void)state;

    paged_make(&p, modes[0][0], modes[0][1], slices, FIXTURE_NZ);
    assert_true(paged_same(&p, QV_OK));
    assert_int_equal(p.linear.reads, FIXTURE_NZ);
    assert_int_equal(p.linear.bytes, 4 * FIXTURE_VOXELS);
    paged_free(&p);

    paged_make(&p, modes[0][0], modes[0][1], all, 1);
    assert_true(paged_same(&p, QV_OK));
    assert_int_equal(p.linear.reads, 1);
    assert_int_equal(p.linear.bytes, 4 * FIXTURE_VOXELS);
    paged_free(&p);

    paged_make(&p, modes[0][0], modes[0][1], cubes, 18);
    assert_true(paged_same(&p, QV_OK));
    assert_true(p.linear.reads <= 3 * FIXTURE_NY * FIXTURE_NZ);
    assert_true(p.linear.bytes <= 4 * FIXTURE_VOXELS);
    paged_free(&p);
}

/* The device fails on a read of its own, not on a brick. */
static int calls_left;

static int failing_device(void *user, void *to, uint64_t offset, uint32_t bytes)
{
    return calls_left-- == 0 ? PAGED_ERROR - 1 : paged_device(user, to, offset, bytes);
}

/* The first failure is told, and nothing is read after it. */
static void failing_device_is_told(void **state)
{
    static uint8_t page[FIXTURE_VOXELS];
    const qv_brick brick = {.block = {{1, 1, 1}, {3, 3, 3}}, .row = 2, .slice = 4, .bytes = 8};
    (void)state;

    paged_make(&p, modes[1][0], modes[1][1], cubes, 18);
    p.linear.read = failing_device;
    for (int good = 0; good <= 4; good++) {
        calls_left = good;
        p.linear.reads = 0;
        assert_int_equal(qv_linear_read(&p.linear, page, &brick), good < 4 ? PAGED_ERROR - 1 : 0);
        assert_int_equal(p.linear.reads, good < 4 ? good + 1 : 4);
    }
    paged_free(&p);
}

/* ---- Any shape ------------------------------------------------------------------ */

/* Any size within the fixture's memory. */
static void random_size(fixture *f, uint32_t *seed)
{
    qv_volume *volume = &f->scene.volume;
    do {
        for (unsigned axis = 0; axis < 3; axis++)
            volume->size[axis] = (uint16_t)(1 + random_below(seed, 11));
    } while (volume->size[0] * volume->size[1] * volume->size[2] > FIXTURE_VOXELS);
    volume->stride[1] = volume->stride[0] * volume->size[0];
    volume->stride[2] = volume->stride[1] * volume->size[1];
    fixture_aim(f, random_below(seed, 2) != 0 ? QUARTER_TURN / 2 : 0);
}

/* As many pages as qv_init asks for, or more. */
static void random_cache(uint32_t *seed)
{
    uint8_t shift[3];
    qv_context context;
    qv_status status = QV_ERROR_PAGES;
    for (unsigned axis = 0; axis < 3; axis++)
        shift[axis] = (uint8_t)random_below(seed, 5);
    for (uint16_t count = 1; status == QV_ERROR_PAGES; count++) {
        if (count > 1)
            paged_free(&p);
        paged_pages(&p, shift, (uint16_t)(count + random_below(seed, 2) * random_below(seed, 40)));
        assert_int_equal(qv_pages_init(&p.pages, &p.through_pages.scene.volume), QV_OK);
        status = qv_init(&context, &p.through_pages.scene);
        assert_true(count <= 27);
    }
    assert_int_equal(status, QV_OK);
}

static void any_shape_gives_the_same_picture(void **state)
{
    uint32_t seed = 12345;
    (void)state;

    for (unsigned i = 0; i < 1500; i++) {
        const unsigned mode = random_below(&seed, MODES);
        paged_make(&p, modes[mode][0], modes[mode][1], all, 1);
        paged_free(&p);
        random_size(&p.in_memory, &seed);
        memcpy(p.linear.size, p.in_memory.scene.volume.size, sizeof p.linear.size);
        memcpy(p.through_pages.scene.volume.size, p.linear.size, sizeof p.linear.size);
        p.through_pages.scene.camera = p.in_memory.scene.camera;
        random_cache(&seed);
        assert_true(paged_same(&p, QV_OK));
        paged_free(&p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bricks_are_asked_for_by_number_and_block),
        cmocka_unit_test(bricks_that_all_have_pages_are_read_once),
        cmocka_unit_test(few_pages_are_read_often),
        cmocka_unit_test(modes_share_pages),
        cmocka_unit_test(boxes_do_not_outlive_their_pages),
        cmocka_unit_test(what_cannot_be_read_is_0),
        cmocka_unit_test(failure_stays_until_it_is_taken_away),
        cmocka_unit_test(slices_tell_of_failures_too),
        cmocka_unit_test(whole_rows_and_slices_are_read_at_once),
        cmocka_unit_test(failing_device_is_told),
        cmocka_unit_test(any_shape_gives_the_same_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
