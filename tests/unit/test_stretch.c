/*
 * A ray's way through the box and its pieces: where it enters and leaves, that pieces add
 * up to the way, where their middles lie, and both directions.
 */
#include "check.h"
#include "random.h"
#include "stretch.h"

#include <math.h>
#include <string.h>

#define VOXEL  ((qv_coord)1 << 32)
#define LIMIT  (QV_GRID_LIMIT * QV_STEP)
#define LEVELS 4

/* Clips a ray to a box of this size. */
static void clip(qv_ray *ray, const uint16_t size[3], uint16_t phase)
{
    qv_context context;
    memset(&context, 0, sizeof context);
    memcpy(context.scene.volume.size, size, sizeof context.scene.volume.size);
    context.scene.phase = phase;
    qv_path_clip(ray, &context);
}

/* ---- Where a ray meets a plane ---- */

/* A ray along x that starts so far before the box, which is as long as can be. */
static qv_ray towards_box(qv_coord way, qv_coord advance)
{
    static const uint16_t size[3] = {QV_AXIS_MAX, 1, 1};
    qv_ray ray = {.place = {-way, 0, 0}, .advance = {advance, 0, 0}, .first = -QV_GRID_LIMIT};
    clip(&ray, size, 0);
    return ray;
}

/* Even, cut towards sample 0, and less than 2^-23 step from the plane. */
static void expect_near(int64_t position, qv_coord way, qv_coord advance)
{
    const double exact = (double)way / (double)advance * (double)QV_STEP;
    const double short_of = fabs(exact) - fabs((double)position);
    const double rounding = ldexp(fabs(exact), -50) + ldexp(1, -5);
    assert_true(position % 2 == 0);
    assert_true(short_of > -rounding && short_of < 2 + rounding);
}

/* Steps from 2^-20 voxel to the longest, ways of up to 2^22 steps and 2^24 voxels. */
static void ends_are_cut_towards_sample_0(void **state)
{
    uint32_t seed = 1;
    (void)state;

    for (unsigned i = 0; i < 200000; i++) {
        const qv_coord advance = 1 + ((qv_coord)random_next(&seed) << 8 >> random_below(&seed, 28));
        const qv_coord most = advance << 21 < VOXEL << 24 ? advance << 21 : VOXEL << 24;
        const qv_coord way =
            (qv_coord)((uint64_t)random_next(&seed) << 32 | random_next(&seed)) % most;
        expect_near(towards_box(way, advance).enter, way, advance);
        expect_near(towards_box(way, -advance).leave, way, -advance);
    }
}

/* Up to 2^32 the cut is exact. */
static void cuts_of_short_steps_are_exact(void **state)
{
    uint32_t seed = 2;
    (void)state;

    for (unsigned i = 0; i < 200000; i++) {
        const uint32_t advance = random_next(&seed) >> random_below(&seed, 24) | 1u;
        const uint64_t way = (uint64_t)random_next(&seed) << random_below(&seed, 12);
        const uint64_t whole = way / advance, rest = way % advance;
        if (whole >= QV_GRID_LIMIT)
            continue;
        const uint64_t exact = (whole << 24) + (((rest << 24) / advance) & ~UINT64_C(1));
        assert_true(towards_box((qv_coord)way, advance).enter == (int64_t)exact);
    }
}

/* A whisker before a sample, where the dropped bits of long steps round it to 1. */
static void the_last_fraction_stays_below_1(void **state)
{
    (void)state;

    for (unsigned bits = 33; bits <= 40; bits++) {
        const qv_coord advance = (qv_coord)1 << bits;
        assert_int_equal(towards_box(3 * advance - 1, advance).enter, 3 * QV_STEP - 2);
        assert_int_equal(towards_box(3 * advance, advance).enter, 3 * QV_STEP);
        assert_int_equal(towards_box(3 * advance - 4, advance - 1).enter, 3 * QV_STEP - 2);
    }
}

/* Positions end with the grid; what lies beyond is not reached. */
static void the_grid_has_ends(void **state)
{
    static const qv_coord beyond[2] = {(qv_coord)QV_GRID_LIMIT * 16, (qv_coord)1 << 60};
    (void)state;

    assert_int_equal(towards_box(1 - VOXEL, 1).enter, -LIMIT);
    assert_int_equal(towards_box(1 - VOXEL, 1).leave, LIMIT);
    assert_int_equal(towards_box(1 - VOXEL, 1).samples, 2 * QV_GRID_LIMIT + 1);
    for (unsigned i = 0; i < 2; i++) {
        assert_int_equal(towards_box(beyond[i], 8).samples, 0);
        assert_int_equal(towards_box(beyond[i], -8).samples, 0);
    }
}

/* ---- Rays that miss ---- */

static void rays_beside_the_box_have_no_pieces(void **state)
{
    static const uint16_t size[3] = {4, 4, 4};
    static const qv_coord outside[2] = {-1, 4 * VOXEL};
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++)
        for (unsigned i = 0; i < 2; i++) {
            qv_ray beside = {.place = {VOXEL, VOXEL, VOXEL}, .first = -QV_GRID_LIMIT}, inside;
            beside.advance[(axis + 1) % 3] = VOXEL;
            inside = beside;
            beside.place[axis] = outside[i];
            inside.place[axis] = outside[i] < 0 ? 0 : 4 * VOXEL - 1;
            clip(&beside, size, 0);
            clip(&inside, size, 0);
            assert_int_equal(beside.samples, 0);
            assert_int_equal(beside.all, 0);
            assert_int_equal(inside.samples, 5); /* half a step at either end */
        }
}

/* Past a corner, where the slabs of two axes do not overlap. */
static void rays_past_a_corner_have_no_pieces(void **state)
{
    static const uint16_t size[3] = {4, 4, 4};
    qv_ray past = {.place = {-3 * VOXEL, 2 * VOXEL, VOXEL},
                   .advance = {VOXEL, VOXEL, 0},
                   .first = -QV_GRID_LIMIT};
    qv_ray through = past;
    (void)state;

    through.place[1] = 0;
    clip(&past, size, 0);
    clip(&through, size, 0);
    assert_int_equal(past.samples, 0);
    assert_true(through.samples != 0);
}

/* The eye lies a phase before sample 0; nothing is seen behind it. */
static void the_way_begins_at_the_eye(void **state)
{
    static const uint16_t size[3] = {4, 4, 4}, phases[4] = {0, 1, 0x5555, 0xFFFF};
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        qv_ray ray = {.place = {VOXEL, VOXEL, VOXEL}, .advance = {VOXEL / 4, 0, 0}};
        clip(&ray, size, phases[i]);
        assert_int_equal(ray.enter, -(phases[i] * QV_STEP / 65536));
        assert_int_equal(ray.leave, 12 * QV_STEP);
        ray.place[0] = 5 * VOXEL;
        clip(&ray, size, phases[i]);
        assert_int_equal(ray.samples, 0);
    }
}

/* ---- Pieces ---- */

/* Rays from near the box, in steps of up to four voxels; some axes stand still. */
static qv_ray random_ray(uint16_t size[3], uint32_t *seed)
{
    qv_ray ray = {.first = random_below(seed, 2) != 0 ? 0 : -QV_GRID_LIMIT};
    for (unsigned axis = 0; axis < 3; axis++) {
        const qv_coord advance = (qv_coord)random_next(seed) << 2 >> random_below(seed, 6);
        size[axis] = (uint16_t)(1 + random_below(seed, 12));
        ray.place[axis] = (qv_coord)random_below(seed, 20) * VOXEL - 4 * VOXEL + random_next(seed);
        ray.advance[axis] = random_below(seed, 2) != 0 ? advance : -advance;
        if (random_below(seed, 5) == 0)
            ray.advance[axis] = 0;
    }
    ray.advance[random_below(seed, 3)] = VOXEL / 3;
    return ray;
}

/* The point at a position, in voxels of a level, as sampling wants it. The way is below
   2^20 steps of at most four voxels. */
static qv_coord point_at(const qv_run *run, const qv_ray *ray, unsigned axis, int64_t position,
                         unsigned level)
{
    const int64_t whole = fx_shift_floor(position, QV_STEP_BITS);
    const qv_coord part = ray->advance[axis] * (position - whole * QV_STEP); /* <= 2^58 */
    const qv_coord rest = fx_shift_floor(part + QV_STEP / 2, QV_STEP_BITS);
    const qv_coord point = run->origin[axis] + ray->advance[axis] * whole + rest;
    return fx_shift_floor(point, level) + QV_CENTRED;
}

/* Compares the first and the last piece of a run that led from one position to another. */
static void expect_run(const qv_run *run, const qv_ray *ray, int64_t begin, int64_t end,
                       unsigned level)
{
    const uint32_t later = run->samples - 1u;
    const int64_t length = (end - begin) / run->samples, last = end - length;
    assert_true((end - begin) % (2 * run->samples) == 0);
    assert_int_equal(run->length, (length + 128) / 256);
    assert_true(run->middle == begin + length / 2);
    for (unsigned axis = 0; axis < 3; axis++) {
        const qv_coord place = ray->place[axis], advance = ray->advance[axis];
        assert_true(place == point_at(run, ray, axis, run->middle, level));
        assert_true(place + advance * later == point_at(run, ray, axis, last + length / 2, level));
    }
}

/* Walks a ray up to `end`; returns the number of its pieces. */
static uint32_t walk(qv_ray *ray, int64_t end, unsigned level)
{
    const int64_t whole = QV_STEP << level, stop = end < ray->leave ? end : ray->leave;
    uint32_t pieces = 0;
    qv_run run;
    qv_run_begin(&run, ray);
    for (int64_t begin = ray->enter; qv_next_run(&run, ray, end, level); begin = ray->enter) {
        expect_run(&run, ray, begin, ray->enter, level);
        pieces += run.samples;
        if (ray->enter < stop) /* at a border, all whole before it */
            assert_true(((ray->enter + QV_STEP / 2) & (whole - 1)) == 0);
        if (run.samples > 1)
            assert_true(run.length == whole / 256 && whole > stop - ray->enter);
    }
    memcpy(ray->place, run.origin, sizeof run.origin); /* for another walk */
    return pieces;
}

static void pieces_add_up_to_the_way(void **state)
{
    uint32_t seed = 3, ways = 0;
    (void)state;

    for (unsigned i = 0; i < 100000; i++) {
        uint16_t size[3];
        qv_ray ray = random_ray(size, &seed);
        clip(&ray, size, (uint16_t)random_next(&seed));
        if (ray.samples == 0)
            continue;
        ways++;
        assert_int_equal(ray.samples, ray.all);
        assert_int_equal(walk(&ray, ray.leave, 0), ray.all);
        assert_true(ray.enter == ray.leave);
    }
    assert_true(ways > 5000);
}

/* On level l they are 2^l steps long, but for the ends; a span may end anywhere. */
static void pieces_of_levels(void **state)
{
    uint32_t seed = 4, cut = 0;
    (void)state;

    for (unsigned i = 0; i < 100000; i++) {
        uint16_t size[3];
        qv_ray ray = random_ray(size, &seed);
        clip(&ray, size, (uint16_t)random_next(&seed));
        if (ray.samples == 0)
            continue;
        const int64_t middle = (ray.enter + ray.leave) / 4 * 2;
        const unsigned level = random_below(&seed, LEVELS);
        const uint32_t before = walk(&ray, middle, level);
        cut += before > 2;
        assert_true(ray.enter == middle || before == 0);
        (void)walk(&ray, INT64_MAX, random_below(&seed, LEVELS));
        assert_true(ray.enter == ray.leave);
    }
    assert_true(cut > 1000);
}

/* A middle lies in the box, or beside it by what the ends are cut. */
static void middles_lie_in_the_box(void **state)
{
    uint32_t seed = 5;
    (void)state;

    for (unsigned i = 0; i < 50000; i++) {
        uint16_t size[3];
        qv_ray ray = random_ray(size, &seed);
        qv_run run;
        clip(&ray, size, 0);
        qv_run_begin(&run, &ray);
        if (!qv_next_run(&run, &ray, ray.leave, 0))
            continue;
        for (unsigned axis = 0; axis < 3; axis++) {
            const qv_coord advance = ray.advance[axis] < 0 ? -ray.advance[axis] : ray.advance[axis];
            const qv_coord point = ray.place[axis] - QV_CENTRED, off = 1 + (advance >> 23);
            assert_true(point >= -off && point < size[axis] * VOXEL + off);
        }
    }
}

/* ---- Both directions ---- */

enum { MOST_PIECES = 256 };

typedef struct pieces {
    uint32_t count, length[MOST_PIECES];
    qv_coord place[MOST_PIECES][3];
} pieces;

static void collect(pieces *all, qv_ray ray)
{
    qv_run run;
    all->count = 0;
    qv_run_begin(&run, &ray);
    while (qv_next_run(&run, &ray, ray.leave, 0))
        for (; run.samples != 0 && all->count < MOST_PIECES; run.samples--) {
            memcpy(all->place[all->count], ray.place, sizeof ray.place);
            all->length[all->count++] = run.length;
            for (unsigned axis = 0; axis < 3; axis++)
                ray.place[axis] += ray.advance[axis];
        }
}

/* The same pieces and the same points, to the last bit. */
static void a_ray_may_be_turned_round(void **state)
{
    static pieces forwards, backwards;
    uint32_t seed = 6;
    (void)state;

    for (unsigned i = 0; i < 20000; i++) {
        uint16_t size[3];
        qv_ray ray = random_ray(size, &seed);
        clip(&ray, size, 0);
        collect(&forwards, ray);
        qv_path_reverse(&ray);
        collect(&backwards, ray);
        assert_int_equal(forwards.count, backwards.count);
        for (uint32_t k = 0; k < forwards.count && forwards.count < MOST_PIECES; k++) {
            const uint32_t twin = forwards.count - 1 - k;
            assert_int_equal(forwards.length[k], backwards.length[twin]);
            assert_memory_equal(forwards.place[k], backwards.place[twin], sizeof forwards.place[k]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_cut_towards_sample_0),
        cmocka_unit_test(cuts_of_short_steps_are_exact),
        cmocka_unit_test(the_last_fraction_stays_below_1),
        cmocka_unit_test(the_grid_has_ends),
        cmocka_unit_test(rays_beside_the_box_have_no_pieces),
        cmocka_unit_test(rays_past_a_corner_have_no_pieces),
        cmocka_unit_test(the_way_begins_at_the_eye),
        cmocka_unit_test(pieces_add_up_to_the_way),
        cmocka_unit_test(pieces_of_levels),
        cmocka_unit_test(middles_lie_in_the_box),
        cmocka_unit_test(a_ray_may_be_turned_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
