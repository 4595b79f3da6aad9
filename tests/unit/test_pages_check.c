/*
 * What pages are refused, by qv_pages_init and by qv_init, with nothing written.
 */
#include "pages_fixture.h"

static paged p;

static const uint8_t cubes[3] = {1, 1, 1}, slices[3] = {12, 12, 0}, all[3] = {12, 12, 12};
static const uint8_t rows[3] = {12, 0, 0};

static qv_volume *volume(void)
{
    return &p.through_pages.scene.volume;
}

static void make(const uint8_t shift[3], uint16_t count)
{
    paged_make(&p, &qv_weighted_rgba16, &qv_weighted_rgba16_paged, shift, count);
}

/* Refused, and neither the pages nor their memory touched. */
static void expect(qv_status status)
{
    const qv_pages before = p.pages;
    fixture_poison(before.memory, before.bytes);
    assert_int_equal(qv_pages_init(&p.pages, volume()), status);
    assert_memory_equal(&before, &p.pages, sizeof before);
    assert_true(fixture_untouched(before.memory, before.bytes));
}

static void null_pointers(void **state)
{
    (void)state;

    make(cubes, 8);
    assert_int_equal(qv_pages_init(NULL, volume()), QV_ERROR_NULL);
    assert_int_equal(qv_pages_init(&p.pages, NULL), QV_ERROR_NULL);
    qv_pages good = p.pages;
    p.pages.read = NULL;
    expect(QV_ERROR_NULL);
    p.pages = good;
    p.pages.table = NULL;
    expect(QV_ERROR_NULL);
    p.pages = good;
    p.pages.memory = NULL;
    assert_int_equal(qv_pages_init(&p.pages, volume()), QV_ERROR_NULL);
    p.pages = good;
    paged_free(&p);
}

static void volumes_are_checked_but_for_voxels(void **state)
{
    (void)state;

    make(cubes, 8);
    const qv_volume good = *volume();
    volume()->storage = 0;
    expect(QV_ERROR_STORAGE);
    volume()->storage = QV_STORAGE_ASSOCIATED8 + 1;
    expect(QV_ERROR_STORAGE);
    *volume() = good;
    volume()->size[1] = 0;
    expect(QV_ERROR_SIZE);
    volume()->size[1] = QV_AXIS_MAX + 1;
    expect(QV_ERROR_SIZE);
    *volume() = good;
    volume()->storage = QV_STORAGE_INDEXED8;
    expect(QV_ERROR_PALETTE);
    *volume() = good;
    volume()->spacing[2] = 1;
    expect(QV_ERROR_SPACING);
    *volume() = good;
    assert_int_equal(qv_pages_init(&p.pages, volume()), QV_OK);
    paged_free(&p);
}

static void memory_must_hold_the_pages(void **state)
{
    (void)state;

    make(cubes, 8);
    const qv_pages good = p.pages;
    p.pages.count = 0;
    expect(QV_ERROR_PAGES);
    p.pages = good;
    p.pages.bytes--;
    expect(QV_ERROR_PAGES);
    p.pages = good;
    p.pages.count++;
    expect(QV_ERROR_PAGES);
    p.pages = good;
    p.pages.shift[1] = QV_PAGE_SHIFT_MAX + 1;
    expect(QV_ERROR_PAGES);
    p.pages = good;
    p.pages.shift[2]++;
    expect(QV_ERROR_PAGES);
    p.pages = good;
    p.pages.memory = (uint8_t *)good.memory + 1;
    p.pages.bytes--;
    p.pages.count--;
    expect(QV_ERROR_PAGES);
    volume()->storage = QV_STORAGE_RGBA8; /* 8 bits may lie anywhere */
    assert_int_equal(qv_pages_init(&p.pages, volume()), QV_OK);
    p.pages = good;
    paged_free(&p);
}

/* 2^36 bricks have no numbers of 32 bits; 2^33 - 2^21 neither. */
static void bricks_must_have_numbers(void **state)
{
    static const uint8_t voxels[3] = {0, 0, 0}, pairs[3] = {1, 1, 1}, rows_of_8[3] = {3, 1, 1};
    (void)state;

    make(cubes, 8);
    for (unsigned axis = 0; axis < 3; axis++)
        volume()->size[axis] = QV_AXIS_MAX;
    memcpy(p.pages.shift, voxels, 3);
    expect(QV_ERROR_PAGES);
    memcpy(p.pages.shift, pairs, 3);
    expect(QV_ERROR_PAGES);
    memcpy(p.pages.shift, rows_of_8, 3);
    p.pages.count = 2;
    assert_int_equal(qv_pages_init(&p.pages, volume()), QV_OK);
    paged_free(&p);
}

static void bytes_of_pages(void **state)
{
    static const uint16_t size[3] = {181, 217, 3}, most[3] = {4096, 4096, 4096},
                          none[3] = {1, 0, 1};
    static const uint8_t brick[3] = {3, 4, 2}, too_wide[3] = {13, 0, 0};
    (void)state;

    assert_int_equal(qv_page_bytes(brick, size, QV_STORAGE_RGBA8), 8 * 16 * 3 * 4);
    assert_int_equal(qv_page_bytes(slices, size, QV_STORAGE_INDEXED8), 181 * 217);
    assert_true(qv_page_bytes(all, most, QV_STORAGE_RGBT16) == (uint64_t)1 << 39);
    assert_int_equal(qv_page_bytes(brick, none, QV_STORAGE_RGBA8), 0);
    assert_int_equal(qv_page_bytes(too_wide, size, QV_STORAGE_RGBA8), 0);
}

/* The least number of pages for a shape, trilinear and by B-spline. */
static void expect_least(const uint8_t shift[3], uint16_t linear, uint16_t bspline)
{
    static const qv_sampling *const modes[] = {&qv_weighted_rgba16_paged,
                                               &qv_bspline_weighted_rgba16_paged};
    for (unsigned mode = 0; mode < 2; mode++)
        for (uint16_t count = 1; count < 40; count++) {
            qv_context context;
            make(shift, count);
            p.through_pages.scene.sampling = modes[mode];
            p.through_pages.scene.volume.unit_distance = p.through_pages.scene.camera.step;
            fixture_poison(&context, sizeof context);
            const qv_status status = qv_init(&context, &p.through_pages.scene);
            assert_int_equal(status,
                             count < (mode == 0 ? linear : bspline) ? QV_ERROR_PAGES : QV_OK);
            assert_int_equal(fixture_untouched(&context, sizeof context), status != QV_OK);
            paged_free(&p);
        }
}

static void samples_need_pages_at_a_time(void **state)
{
    static const uint8_t voxels[3] = {0, 0, 0}, halves[3] = {12, 2, 12};
    (void)state;

    expect_least(cubes, 8, 8);
    expect_least(slices, 2, 3);
    expect_least(rows, 4, 9);
    expect_least(voxels, 8, 27);
    expect_least(halves, 2, 2);
    expect_least(all, 1, 1);
}

static void scenes_want_pages_of_their_volume(void **state)
{
    qv_scene *scene = &p.through_pages.scene;
    qv_context context;
    (void)state;

    make(cubes, 8);
    const qv_scene good = *scene;
    assert_int_equal(qv_init(&context, scene), QV_OK);
    scene->volume.pages = NULL;
    assert_int_equal(qv_init(&context, scene), QV_ERROR_NULL);
    *scene = good;
    scene->volume.size[2]++;
    assert_int_equal(qv_init(&context, scene), QV_ERROR_PAGES);
    *scene = good;
    scene->volume.spacing[0] = 1;
    assert_int_equal(qv_init(&context, scene), QV_ERROR_SPACING);
    *scene = good;
    scene->volume.unit_distance = scene->camera.step + 1;
    assert_int_equal(qv_init(&context, scene), QV_ERROR_UNIT);
    *scene = good;
    scene->sampling = &qv_weighted_rgba8_paged;
    scene->volume.storage = QV_STORAGE_RGBA8; /* half as wide */
    assert_int_equal(qv_init(&context, scene), QV_ERROR_PAGES);
    paged_free(&p);
}

/* What reads voxels in memory takes no others. */
static void voxels_in_pages_are_not_in_memory(void **state)
{
    qv_scene *scene = &p.through_pages.scene;
    uint8_t voxels[FIXTURE_VOXELS * 8];
    qv_context context;
    (void)state;

    make(cubes, 8);
    assert_int_equal(qv_volume_check(&scene->volume), QV_ERROR_NULL);
    assert_int_equal(qv_downsample(voxels, sizeof voxels, &scene->volume, &qv_filter_box2,
                                   &qv_domain_stored, 0, 1),
                     QV_ERROR_NULL);
    scene->sampling = &qv_weighted_rgba16;
    assert_int_equal(qv_init(&context, scene), QV_ERROR_NULL);
    paged_free(&p);
}

/* The table of a dither stands for voxels in memory. */
static void tables_want_voxels_in_memory(void **state)
{
    static uint8_t entries[2 * 1024], pixels[FIXTURE_HEIGHT][FIXTURE_WIDTH][4];
    const qv_buffer buffer = {.pixels = pixels,
                              .bytes = sizeof pixels,
                              .stride = sizeof pixels[0],
                              .blend = &qv_hardware_rgba8888};
    const qv_dither_table table = {entries, sizeof entries, 2, 4};
    const qv_dither dither = {.sequence = qv_sequence_rounded};
    (void)state;

    paged_make(&p, &qv_nearest_indexed8, &qv_nearest_indexed8_paged, cubes, 8);
    const qv_context in_memory = fixture_context(&p.in_memory);
    const qv_context through = fixture_context(&p.through_pages);
    assert_int_equal(qv_slice_table(&buffer, &table, &dither, &in_memory, &fixture_frame, 0),
                     QV_OK);
    assert_int_equal(qv_slice_table(&buffer, &table, &dither, &through, &fixture_frame, 0),
                     QV_ERROR_STORAGE);
    paged_free(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(null_pointers),
        cmocka_unit_test(volumes_are_checked_but_for_voxels),
        cmocka_unit_test(memory_must_hold_the_pages),
        cmocka_unit_test(bricks_must_have_numbers),
        cmocka_unit_test(bytes_of_pages),
        cmocka_unit_test(samples_need_pages_at_a_time),
        cmocka_unit_test(scenes_want_pages_of_their_volume),
        cmocka_unit_test(voxels_in_pages_are_not_in_memory),
        cmocka_unit_test(tables_want_voxels_in_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
