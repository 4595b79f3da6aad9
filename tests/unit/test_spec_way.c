/*
 * The worked examples S55, S56 and S62 of tests/SPEC.md: a ray's way through the box, its
 * pieces and their levels. The same inputs and results as there, written out.
 */
#include "check.h"
#include "level.h"

#define VOXEL INT64_C(0x100000000)

#define expect_vector(v, x, y, z)                                                                  \
    do {                                                                                           \
        assert_int_equal((v)[0], x);                                                               \
        assert_int_equal((v)[1], y);                                                               \
        assert_int_equal((v)[2], z);                                                               \
    } while (0)

/* ---- The way through the box -------------------------------------------------- */

static const qv_ray perspective_ray = {.place = {12323212785, 1843947829, 21687010078},
                                       .advance = {-1519078587, 1887679198, -339392442}};
static const qv_ray orthographic_ray = {.place = {5221135781, 8677510410, 9398355452},
                                        .advance = {-1394831547, 1610612738, -2415900672},
                                        .first = -QV_GRID_LIMIT};

/* Clips a ray to a box of size (3, 4, 5). */
static void clip(qv_ray *ray)
{
    const qv_context context = {.scene = {.phase = 0x5555, .volume = {.size = {3, 4, 5}}}};
    qv_path_clip(ray, &context);
}

static void S55_way(void **state)
{
    qv_ray perspective = perspective_ray, orthographic = orthographic_ray;
    qv_ray inside = {.place = {VOXEL, VOXEL, VOXEL}, .advance = {VOXEL / 2, 0, 0}};
    (void)state;
    clip(&perspective);
    assert_int_equal(perspective.enter, 10488394);
    assert_int_equal(perspective.leave, 136101716);
    clip(&orthographic);
    assert_int_equal(orthographic.enter, -83865090);
    assert_int_equal(orthographic.leave, 62800502);
    clip(&inside);
    assert_int_equal(inside.enter, -5592320);
    assert_int_equal(inside.leave, 67108864);
}

/* Clips a ray along x that starts n before the box: cut(n, d) is where it enters, or,
   where it runs backwards, leaves. */
static qv_ray towards_box(qv_coord n, qv_coord d)
{
    qv_ray ray = {.place = {-n, VOXEL, VOXEL}, .advance = {d, 0, 0}, .first = -QV_GRID_LIMIT};
    clip(&ray);
    return ray;
}

static void S55_cuts(void **state)
{
    (void)state;
    assert_int_equal(towards_box(-5, 3).enter, -27962026);
    assert_int_equal(towards_box((VOXEL << 8) + (VOXEL << 7) - 1, VOXEL << 8).enter, 25165822);
    assert_int_equal(towards_box(123456789012345, -987654321).leave, -2097151981098);
}

/* ---- Pieces ------------------------------------------------------------------- */

static void expect_piece(const qv_run *run, const qv_ray *ray, uint32_t length, qv_coord x,
                         qv_coord y, qv_coord z)
{
    assert_int_equal(run->length, length);
    expect_vector(ray->place, x, y, z);
}

/* The first piece, the whole ones and the last one are three runs. */
static void S56_pieces(void **state)
{
    qv_ray ray = perspective_ray;
    qv_run run;
    (void)state;
    clip(&ray);
    qv_run_begin(&run, &ray);
    assert_int_equal(ray.samples, 8);
    assert_int_equal(qv_next_run(&run, &ray, ray.leave, 0), 1);
    expect_piece(&run, &ray, 57334, 8569977500, 1710660118, 19187283926);
    assert_int_equal(qv_next_run(&run, &ray, ray.leave, 0), 1);
    assert_int_equal(run.samples, 6);
    expect_piece(&run, &ray, 65536, 7145960571, 3480211185, 18869130154);
    assert_int_equal(qv_next_run(&run, &ray, ray.leave, 0), 1);
    expect_piece(&run, &ray, 40127, -1674033340, 14440354508, 16898567671);
    assert_int_equal(qv_next_run(&run, &ray, ray.leave, 0), 0);
}

static void S56_pieces_of_both_directions(void **state)
{
    qv_ray ray = orthographic_ray;
    qv_run run;
    (void)state;
    clip(&ray);
    qv_run_begin(&run, &ray);
    assert_int_equal(ray.samples, 10);
    assert_int_equal(qv_next_run(&run, &ray, ray.leave, 0), 1);
    expect_piece(&run, &ray, 32686, 9706618051, -1110987615, 18733277336);
    ray = orthographic_ray;
    clip(&ray);
    qv_path_reverse(&ray);
    qv_run_begin(&run, &ray);
    assert_int_equal(qv_next_run(&run, &ray, ray.leave, 0), 1);
    expect_piece(&run, &ray, 15938, -1969482315, 12371411761, -1490167411);
}

/* ---- Levels ------------------------------------------------------------------- */

/* A run of pieces, of which it compares the first; its number, and the share of the last. */
typedef struct row {
    unsigned level;
    uint32_t length, share, count, last_share;
    qv_coord x;
} row;

static void expect_row_of_levels(qv_run *run, qv_ray *ray, const qv_scene *scene,
                                 const row *expected)
{
    qv_span span;
    qv_span_begin(&span, ray, scene);
    assert_int_equal(qv_next_run(run, ray, span.end, span.level), 1);
    qv_span_blend(&span, run);
    assert_int_equal(span.level, expected->level);
    assert_int_equal(run->length, expected->length);
    assert_int_equal(run->samples, expected->count);
    assert_int_equal(ray->place[0], expected->x);
    assert_int_equal(span.blend, expected->share);
    assert_int_equal(span.blend + (expected->count - 1) * span.rise, expected->last_share);
}

static void S62_rising_levels(void **state)
{
    static const qv_pyramid two = {.levels = 2};
    static const row rows[6] = {{0, 54613, 0, 1, 0, 2178242560},
                                {0, 65536, 0, 2, 0, 2424307712},
                                {0, 65536, 0x2AAAAAAA, 3, 0xD5555554, 2961178624},
                                {1, 131072, 0x2AAAAAAA, 3, 0xD5555554, 880803840},
                                {2, 262144, 0, 5, 0, -159383552},
                                {2, 32768, 0, 1, 0, 1065353216}};
    const qv_scene scene = {.level_distance = 3, .pyramid = &two};
    qv_ray ray = {.place = {VOXEL, VOXEL, VOXEL}, .advance = {VOXEL / 16, 0, 0}};
    qv_run run;
    (void)state;
    clip(&ray);
    assert_int_equal(ray.enter, -5592320);
    assert_int_equal(ray.leave, 536870912);
    qv_run_begin(&run, &ray);
    for (unsigned i = 0; i < 6; i++)
        expect_row_of_levels(&run, &ray, &scene, &rows[i]);
    assert_int_equal(ray.enter, ray.leave);
}

static void S62_one_level(void **state)
{
    static const qv_pyramid three = {.levels = 3};
    static const row rows[3] = {{1, 57334, 0x2C000000, 1, 0x2C000000, 3215441230},
                                {1, 131072, 0x2C000000, 3, 0x2C000000, 2123663119},
                                {1, 40127, 0x2C000000, 1, 0x2C000000, -1906564190}};
    const qv_scene scene = {.level = 300, .pyramid = &three};
    qv_ray ray = perspective_ray;
    qv_run run;
    (void)state;
    clip(&ray);
    qv_run_begin(&run, &ray);
    for (unsigned i = 0; i < 3; i++)
        expect_row_of_levels(&run, &ray, &scene, &rows[i]);
    assert_int_equal(ray.enter, ray.leave);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S55_way),           cmocka_unit_test(S55_cuts),
        cmocka_unit_test(S56_pieces),        cmocka_unit_test(S56_pieces_of_both_directions),
        cmocka_unit_test(S62_rising_levels), cmocka_unit_test(S62_one_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
