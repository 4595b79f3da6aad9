/*
 * The samples of a ray: clipping against a test of every sample, the seam of two
 * bricks, and the rays of both cameras.
 */
#include "check.h"
#include "ray.h"
#include "scene_fixture.h"

#include <math.h>

#define HALF     (VOXEL / 2)
#define ROUNDING (VOXEL / 512)

/* ---- Clipping ---- */

/* A ray as qv_ray_clip takes it. */
static qv_ray line(const qv_coord place[3], const qv_coord advance[3])
{
    qv_ray ray = {.samples = 0};
    for (unsigned axis = 0; axis < 3; axis++) {
        ray.place[axis] = place[axis];
        ray.advance[axis] = advance[axis];
    }
    return ray;
}

static int in_box(const qv_ray *ray, int64_t k, const uint16_t size[3])
{
    for (unsigned axis = 0; axis < 3; axis++) {
        const qv_coord p = ray->place[axis] + k * ray->advance[axis];
        if (p < 0 || p >= size[axis] * VOXEL)
            return 0;
    }
    return 1;
}

/* Clips a ray and compares it with every sample first .. reach, outside of which none
   lies in the box. */
static void expect_clip(const qv_ray *ray, const uint16_t size[3], int32_t first, int32_t reach)
{
    qv_ray clipped = *ray;
    int32_t start = first;
    uint32_t count = 0;

    fixture_clip(&clipped, size, first);
    while (start <= reach && !in_box(ray, start, size))
        start++;
    while (start + (int32_t)count <= reach && in_box(ray, start + (int32_t)count, size))
        count++;
    assert_int_equal(clipped.samples, count);
    for (unsigned axis = 0; axis < 3 && count != 0; axis++) {
        const qv_coord p = ray->place[axis] + start * ray->advance[axis];
        assert_true(clipped.place[axis] == p - HALF + ROUNDING);
        assert_true(clipped.advance[axis] == ray->advance[axis]);
    }
}

/* From up to 20 voxels away. In steps of anything, or of whole halves of a voxel,
   which meet the faces exactly. Some axes stand still. */
static qv_ray random_ray(uint32_t *seed)
{
    const int exact = random_below(seed, 2) != 0;
    qv_ray ray = {.samples = 0};
    for (unsigned axis = 0; axis < 3; axis++) {
        const int64_t place = random_next(seed), advance = random_next(seed);
        const int64_t sign = random_below(seed, 2) != 0 ? 1 : -1;
        ray.place[axis] = exact ? (place % 80 - 40) * HALF : (place % 40 - 20) * VOXEL + advance;
        ray.advance[axis] = exact ? sign * (advance % 5) * HALF : sign * (VOXEL / 16 + advance);
        if (random_below(seed, 4) == 0)
            ray.advance[axis] = 0;
    }
    return ray;
}

static void random_size(uint16_t size[3], uint32_t *seed)
{
    for (unsigned axis = 0; axis < 3; axis++)
        size[axis] = (uint16_t)(1 + random_below(seed, 20));
}

/* At most 41 voxels in steps of 1/16 at least: 656 samples either way. A ray
   that stands still has all samples of its range or none, and is left out. */
static void every_sample_in_the_box_is_found(void **state)
{
    enum { REACH = 700 };
    uint32_t seed = 7;
    (void)state;

    for (unsigned i = 0; i < 60000; i++) {
        const qv_ray ray = random_ray(&seed);
        uint16_t size[3];
        random_size(size, &seed);
        if (ray.advance[0] == 0 && ray.advance[1] == 0 && ray.advance[2] == 0)
            continue;
        expect_clip(&ray, size, -REACH, REACH);
        expect_clip(&ray, size, 0, REACH);
    }
}

/* A face at 0 belongs to the box, the one at its size does not; from both sides. */
static void the_box_is_half_open(void **state)
{
    static const uint16_t size[3] = {4, 4, 4};
    static const qv_coord faces[2] = {0, 4 * VOXEL};
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2)
            for (unsigned face = 0; face < 2; face++) {
                qv_coord place[3] = {VOXEL, VOXEL, VOXEL}, advance[3] = {0, 0, 0};
                advance[(axis + 1) % 3] = sign * VOXEL;
                place[axis] = faces[face];
                qv_ray grazing = line(place, advance); /* along the face */
                fixture_clip(&grazing, size, -100);
                assert_int_equal(grazing.samples, face == 0 ? 4 : 0);
                advance[axis] = sign * VOXEL;
                advance[(axis + 1) % 3] = 0;
                qv_ray through = line(place, advance); /* a sample on either face */
                fixture_clip(&through, size, -100);
                assert_int_equal(through.samples, 4);
                assert_true(through.place[axis] + HALF - ROUNDING == (sign > 0 ? 0 : 3 * VOXEL));
            }
}

/* One bit inside, on and beyond each face. */
static void one_bit_decides(void **state)
{
    static const uint16_t size[3] = {1, 1, 1};
    static const qv_coord advance[3] = {0, VOXEL, 0};
    static const qv_coord x[4] = {-1, 0, VOXEL - 1, VOXEL};
    static const uint32_t samples[4] = {0, 1, 1, 0};
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        const qv_coord place[3] = {x[i], 0, 0};
        qv_ray ray = line(place, advance);
        fixture_clip(&ray, size, -5);
        assert_int_equal(ray.samples, samples[i]);
    }
}

/* The slowest of rays takes 2^23 samples at most, from -2^22 on. */
static void samples_have_a_limit(void **state)
{
    static const uint16_t size[3] = {QV_AXIS_MAX, QV_AXIS_MAX, QV_AXIS_MAX};
    static const qv_coord middle[3] = {2048 * VOXEL, 2048 * VOXEL, 2048 * VOXEL};
    static const qv_coord still[3] = {0, 0, 0}, slow[3] = {1, -1, 1};
    qv_ray ray = line(middle, still);
    (void)state;

    fixture_clip(&ray, size, -QV_GRID_LIMIT);
    assert_int_equal(ray.samples, 1u << 23);
    ray = line(middle, slow);
    fixture_clip(&ray, size, -QV_GRID_LIMIT);
    assert_int_equal(ray.samples, 1u << 23);
    assert_true(ray.place[0] == middle[0] - QV_GRID_LIMIT - HALF + ROUNDING);
    ray = line(middle, slow);
    fixture_clip(&ray, size, 0);
    assert_int_equal(ray.samples, 1u << 22);
}

/* As far away as a pixel's point can be, running to and from the box, or past the
   end of the grid. */
static void far_rays_do_not_overflow(void **state)
{
    static const uint16_t size[3] = {QV_AXIS_MAX, QV_AXIS_MAX, QV_AXIS_MAX};
    const qv_coord far = VOXEL << 28; /* 2^60 */
    (void)state;

    for (int sign = -1; sign <= 1; sign += 2)
        for (int turn = -1; turn <= 1; turn += 2) {
            const qv_coord place[3] = {sign * far, 5, 5};
            const qv_coord fast[3] = {turn * (VOXEL << 8), 0, 0}, slow[3] = {turn * VOXEL, 0, 0};
            qv_ray ray = line(place, fast);
            fixture_clip(&ray, size, -QV_GRID_LIMIT);
            assert_int_equal(ray.samples, QV_AXIS_MAX >> 8); /* at k = 2^20 */
            ray = line(place, slow);
            fixture_clip(&ray, size, -QV_GRID_LIMIT);
            assert_int_equal(ray.samples, 0); /* would be at 2^28 */
        }
}

/* ---- Bricks ---- */

/* Where a clipped ray starts, in voxel coordinates. */
static qv_coord first_point(const qv_ray *ray, unsigned axis)
{
    return ray->place[axis] + HALF - ROUNDING;
}

/* Cuts the box at `seam` on one axis: the samples of the whole are those of the
   one brick followed by those of the other. */
static void expect_no_seam(const qv_ray *ray, const uint16_t size[3], unsigned axis, uint16_t seam)
{
    uint16_t low_size[3] = {size[0], size[1], size[2]}, high_size[3] = {size[0], size[1], size[2]};
    qv_ray whole = *ray, low = *ray, high = *ray;
    low_size[axis] = seam;
    high_size[axis] = (uint16_t)(size[axis] - seam);
    high.place[axis] -= seam * VOXEL;
    fixture_clip(&whole, size, -1000);
    fixture_clip(&low, low_size, -1000);
    fixture_clip(&high, high_size, -1000);
    high.place[axis] += seam * VOXEL;

    const int upwards = ray->advance[axis] >= 0;
    const qv_ray *first = upwards ? &low : &high, *second = upwards ? &high : &low;
    assert_int_equal(whole.samples, low.samples + high.samples);
    for (unsigned a = 0; a < 3; a++) {
        const qv_coord start = first_point(&whole, a);
        if (first->samples != 0)
            assert_true(first_point(first, a) == start);
        if (second->samples != 0)
            assert_true(first_point(second, a) == start + first->samples * ray->advance[a]);
    }
}

static void neighbouring_bricks_share_every_sample_once(void **state)
{
    uint32_t seed = 11;
    (void)state;

    for (unsigned i = 0; i < 100000; i++) {
        const qv_ray ray = random_ray(&seed);
        const unsigned axis = random_below(&seed, 3);
        uint16_t size[3];
        random_size(size, &seed);
        size[axis]++;
        expect_no_seam(&ray, size, axis, (uint16_t)(1 + random_below(&seed, size[axis] - 1u)));
    }
}

/* ---- Rays of orthographic cameras ---- */

static fixture f;

/* Pixels whose centres lie on the planes 0 .. n: the first n see the box, the
   last does not; the other way round from behind. */
static void rays_along_the_faces(void **state)
{
    qv_view view;
    (void)state;

    for (unsigned turns = 0; turns < 4; turns++) {
        fixture_make(&f, &qv_nearest_rgba8, 1);
        view = fixture_view(turns * QUARTER_TURN, 0, 0);
        view.pitch = QV_ONE_Q16;
        const int32_t across = turns % 2 == 0 ? FIXTURE_NX : FIXTURE_NY;
        view.width = (uint16_t)(across + 1);
        view.height = FIXTURE_NZ + 1;
        assert_int_equal(qv_orthographic(&f.scene.camera, &f.scene.volume, &view), QV_OK);
        const qv_context context = fixture_context(&f);
        for (int32_t y = 0; y <= FIXTURE_NZ; y++)
            for (int32_t x = 0; x <= across; x++) {
                const int inside_x = turns < 2 ? x < across : x > 0;
                qv_ray ray;
                qv_ray_orthographic(&ray, &context, x, y);
                qv_ray_clip(&ray, &context);
                assert_true((ray.samples != 0) == (inside_x && y > 0)); /* z = NZ is row 0 */
            }
    }
}

/* round(v * phase / 2^16), ties upwards. */
static qv_coord part_of(qv_coord v, uint16_t phase)
{
    const qv_coord twice = 2 * v * phase + 65536; /* |v| < 2^40 */
    return twice / 131072 - (twice % 131072 < 0);
}

/* p = origin + x*across + y*down + (k + phase)*along, for random views and
   pixels in and out of the frame. */
static void orthographic_rays_follow_the_formula(void **state)
{
    static const uint16_t phases[5] = {0, 1, 0x8000, 0x5555, 0xFFFF};
    enum { REACH = 700 };
    uint32_t seed = 13;
    (void)state;

    fixture_make(&f, &qv_nearest_rgba8, 1);
    for (unsigned i = 0; i < 20000; i++) {
        const qv_view view = fixture_view(random_next(&seed), random_next(&seed), i << 30);
        const int32_t x = (int32_t)random_below(&seed, 40) - 10;
        const int32_t y = (int32_t)random_below(&seed, 40) - 10;
        const qv_camera *camera = &f.scene.camera;
        qv_ray expected = {.samples = 0}, ray;
        f.scene.phase = phases[i % 5];
        assert_int_equal(qv_orthographic(&f.scene.camera, &f.scene.volume, &view), QV_OK);
        const qv_context context = fixture_context(&f);
        for (unsigned axis = 0; axis < 3; axis++) {
            expected.place[axis] = camera->origin[axis] + x * camera->across[axis] +
                                   y * camera->down[axis] +
                                   part_of(camera->along[axis], f.scene.phase);
            expected.advance[axis] = camera->along[axis];
        }
        qv_ray_orthographic(&ray, &context, x, y);
        qv_ray_clip(&ray, &context);
        fixture_clip(&expected, f.scene.volume.size, -REACH);
        assert_int_equal(ray.samples, expected.samples);
        if (ray.samples != 0)
            assert_memory_equal(ray.place, expected.place, sizeof ray.place);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_sample_in_the_box_is_found),
        cmocka_unit_test(the_box_is_half_open),
        cmocka_unit_test(one_bit_decides),
        cmocka_unit_test(samples_have_a_limit),
        cmocka_unit_test(far_rays_do_not_overflow),
        cmocka_unit_test(neighbouring_bricks_share_every_sample_once),
        cmocka_unit_test(rays_along_the_faces),
        cmocka_unit_test(orthographic_rays_follow_the_formula),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
