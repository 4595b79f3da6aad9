/*
 * An eye inside the volume (section 3.3): light from a voxel B reaches it by A_B / A_V, where V is
 * the voxel of the eye. Both are bytes, so the error grows as A_V falls.
 *
 * The eye lies in the middle of voxel (4, 4, 4), with four voxels behind it in every direction
 * that it looks from, whose opacities make A_V; before it, opacities are random. Errors are those
 * of bytes alone: the reference goes between the same directions with exact depths.
 */
#include "attenuated.h"
#include "draw.h"
#include "freevoxels.h"

#include <math.h>
#include <stdio.h>

#define WIDE   9  /* voxels on x and z */
#define DEEP   40 /* on y, into the picture */
#define BEHIND 4
#define FRAME  31 /* pixels, of 1 voxel at the centre */
#define VOXELS ((size_t)WIDE * DEEP * WIDE)
#define PIXELS ((size_t)FRAME * FRAME)
#define SCENES 100 /* of each A_V */
#define WHOLE  8   /* of them with all voxels */

static const qv_angle right_angle = 0x40000000u;
static const double one = ATTENUATED_ONE;

typedef struct interior {
    uint16_t voxels[VOXELS][4];
    qv_volume volume;
    attenuated light;
    ref_outside exact;
    qv_splat_scene scene;
    ref_splats real;
    uint16_t eye[3];
} interior;

/* ---- The scene ------------------------------------------------------------------ */

/* Opacities hold for a step of any direction, so that A_V is the same in all of them. */
static void fill(interior *made, double behind, draws *random)
{
    for (size_t i = 0; i < VOXELS; i++) {
        const size_t y = i / WIDE % DEEP;
        const double before = draw_real(random, 0.02, 0.2);
        for (int channel = 0; channel < 3; channel++) {
            made->voxels[i][channel] = 0xffff;
        }
        made->voxels[i][3] = (uint16_t)lround(65535 * (y < BEHIND ? behind : before));
    }
}

static void describe(qv_volume *volume, const interior *made)
{
    const uint16_t size[3] = {WIDE, DEEP, WIDE};
    int32_t stride = sizeof made->voxels[0];
    for (int axis = 0; axis < 3; axis++) {
        volume->size[axis] = size[axis];
        volume->stride[axis] = stride;
        stride *= size[axis];
    }
    volume->voxels = (qv_address)made->voxels;
    volume->voxels_bytes = sizeof made->voxels;
    volume->storage = QV_STORAGE_RGBA16;
}

/* With a field of 90 degrees the eye lies half the frame's height from the centre. */
static void look(interior *made)
{
    qv_splat_scene *scene = &made->scene;
    scene->splatting = &qv_splatting_added;
    scene->kernel = &qv_kernel_linear;
    scene->domain = attenuated_domain(&made->volume);
    scene->directions = QV_DIRECTIONS_ALL;
    scene->field_of_view = right_angle;
    scene->view.pitch = QV_ONE_Q16;
    scene->view.step = QV_ONE_Q16;
    scene->view.width = FRAME;
    scene->view.height = FRAME;
    scene->volume = made->volume;
    qv_rotation(scene->view.rotation, 0, 0, 0);
}

static void look_exactly(interior *made)
{
    ref_splats *real = &made->real;
    real->scene = &made->scene;
    real->levels = &made->volume;
    real->kernel = 2;
    real->view.pitch = 1;
    real->view.width = FRAME;
    real->view.height = FRAME;
    real->view.field_of_view = acos(0);
    ref_rotation(real->view.rotation, 0, 0, 0);
    real->depths.along = ref_depth_between;
    real->depths.in = &made->exact;
    real->inside = ref_splat_eye(real->eye, real);
}

/* One that may not move; `passes` is A_V. */
static void interior_make(interior *made, double passes, uint32_t seed)
{
    draws random = draw_seeded(seed);
    memset(made, 0, sizeof *made);
    fill(made, 1 - pow(passes, 1.0 / BEHIND), &random);
    describe(&made->volume, made);
    attenuated_make(&made->light, &made->volume, 0, QV_DIRECTIONS_ALL, NULL);
    assert_true(ref_outside_make(&made->exact, &made->volume));
    look(made);
    look_exactly(made);
    assert_int_equal(qv_splat_eye(made->eye, &made->scene), 1);
    made->scene.inside = qv_attenuation_at(&made->light.level[0], made->eye);
}

static void interior_free(interior *made)
{
    attenuated_free(&made->light);
    ref_outside_free(&made->exact);
}

/* ---- Errors --------------------------------------------------------------------- */

static double clear_depth(const void *in, int level, const int32_t at[3], const double v[3])
{
    (void)in;
    (void)level;
    (void)at;
    (void)v;
    return 0;
}

/* The brightest pixel of one voxel that nothing hides; none if it is too faint to judge light by. */
static size_t brightest(double *bright, const interior *of, const int32_t at[3])
{
    static ref_sums sums[PIXELS];
    ref_splats bare = of->real;
    size_t found = PIXELS;
    bare.depths.along = clear_depth;
    ref_splat_clear(sums, &bare);
    ref_splat(sums, &bare, 0, at);
    *bright = 0.01;
    for (size_t i = 0; i < PIXELS; i++) {
        if (sums[i][3] > *bright) {
            *bright = sums[i][3];
            found = i;
        }
    }
    return found;
}

/* How far the light from one voxel is off, in levels of all light. */
static double error_of_voxel(const interior *of, const qv_splats *splats, const int32_t at[3])
{
    static uint32_t memory[PIXELS * QV_SUM_CHANNELS];
    static ref_sums exact[PIXELS];
    const qv_sums sums = {memory, PIXELS * QV_SUM_CHANNELS, {0, 0, FRAME, FRAME}};
    const uint16_t place[3] = {(uint16_t)at[0], (uint16_t)at[1], (uint16_t)at[2]};
    const qv_freevoxel voxel = attenuated_voxel(&of->light, &of->volume, 0, place);
    double bright;
    const size_t pixel = brightest(&bright, of, at);
    if (pixel == PIXELS) {
        return 0;
    }
    assert_int_equal(qv_sums_clear(&sums, splats), QV_OK);
    assert_int_equal(qv_splat(&sums, splats, &voxel), QV_OK);
    ref_splat_clear(exact, &of->real);
    ref_splat(exact, &of->real, 0, at);
    return 255 * fabs(memory[pixel * QV_SUM_CHANNELS + 3] / one - exact[pixel][3]) / bright;
}

/* Of the voxels straight ahead, whose light comes by one direction, or of all. */
static double worst_of_voxels(const interior *of, bool all)
{
    const int32_t first = all ? 0 : BEHIND, end = all ? WIDE : BEHIND + 1;
    qv_splats splats;
    double worst = 0;
    int32_t at[3];
    assert_int_equal(qv_splat_init(&splats, &of->scene), QV_OK);
    for (at[2] = first; at[2] < end; at[2]++) {
        for (at[1] = BEHIND; at[1] < DEEP; at[1]++) {
            for (at[0] = first; at[0] < end; at[0]++) {
                worst = fmax(worst, error_of_voxel(of, &splats, at));
            }
        }
    }
    return worst;
}

/* Of all voxels together, as they are read out: an opacity is at most 1. */
static double worst_of_picture(const interior *of)
{
    static uint32_t memory[PIXELS * QV_SUM_CHANNELS];
    static ref_sums exact[PIXELS];
    const qv_sums sums = {memory, PIXELS * QV_SUM_CHANNELS, {0, 0, FRAME, FRAME}};
    qv_splats splats;
    double worst = 0;
    assert_int_equal(qv_splat_init(&splats, &of->scene), QV_OK);
    assert_int_equal(qv_sums_clear(&sums, &splats), QV_OK);
    assert_int_equal(attenuated_splat(&sums, &splats, &of->light, &of->volume, 0), QV_OK);
    ref_splat_clear(exact, &of->real);
    ref_splat_level(exact, &of->real, 0);
    for (size_t i = 0; i < PIXELS; i++) {
        const double drawn = fmin(memory[i * QV_SUM_CHANNELS + 3] / one, 1);
        worst = fmax(worst, 255 * fabs(drawn - fmin(exact[i][3], 1)));
    }
    return worst;
}

/* ---- Tests ------------------------------------------------------------------------ */

/* What light by A_B / A_V is known not to be off by. Of a picture half of it is allowed: errors of
   voxels one behind the other cancel. */
static const struct {
    double passes, known;
} bounds[] = {{1, 1.0}, {.25, 3.9}, {.1, 9.7}, {.05, 20.3}};

/* Worst errors of light from voxels ahead, from all voxels, and of the whole picture. */
typedef struct found {
    double ahead, aside, picture;
} found;

static void measure(found *into, double passes, uint32_t scene)
{
    static interior made;
    interior_make(&made, passes, scene);
    into->ahead = fmax(into->ahead, worst_of_voxels(&made, false));
    if (scene < WHOLE) {
        into->aside = fmax(into->aside, worst_of_voxels(&made, true));
        into->picture = fmax(into->picture, worst_of_picture(&made));
    }
    interior_free(&made);
}

static void test_error_grows(void **state)
{
    double before = 0;
    (void)state;
    for (size_t i = 0; i < sizeof bounds / sizeof bounds[0]; i++) {
        const double passes = bounds[i].passes, known = bounds[i].known;
        found worst = {0, 0, 0};
        for (uint32_t scene = 0; scene < SCENES; scene++) {
            /* up to a tenth above: bytes of A_V are rounded either way */
            const double above = 0.1 * (scene % WHOLE) / WHOLE;
            measure(&worst, fmin(passes * (1 + above), 1), scene);
        }
        printf("# A_V %.2f: light straight ahead is off by at most %.2f levels (known %.1f), from "
               "anywhere by %.2f, the picture by %.2f\n",
               passes, worst.ahead, known, worst.aside, worst.picture);
        assert_true(worst.ahead <= known);
        assert_true(worst.aside <= known);
        assert_true(worst.picture <= known / 2);
        assert_true(worst.ahead > before); /* it does grow */
        before = worst.ahead;
    }
}

static qv_status init(double passes)
{
    static interior made;
    qv_splats splats;
    interior_make(&made, passes, 1);
    const qv_status status = qv_splat_init(&splats, &made.scene);
    interior_free(&made);
    return status;
}

/* Half a byte's step is the least that does not round to 0. */
static void test_no_light(void **state)
{
    const double half_a_step = 0.5 / 255;
    (void)state;
    assert_int_equal(init(0), QV_ERROR_INSIDE);
    assert_int_equal(init(half_a_step * 0.95), QV_ERROR_INSIDE);
    assert_int_equal(init(half_a_step * 1.05), QV_OK);
}

/* Without the bytes of its voxel an eye in the volume cannot be drawn for. */
static void test_no_bytes(void **state)
{
    static interior made;
    qv_splats splats;
    (void)state;
    interior_make(&made, 1, 1);
    made.scene.inside = NULL;
    assert_int_equal(qv_splat_init(&splats, &made.scene), QV_ERROR_NULL);
    interior_free(&made);
}

static void test_eye(void **state)
{
    static interior made;
    (void)state;
    interior_make(&made, 1, 1);
    for (int axis = 0; axis < 3; axis++) {
        assert_int_equal(made.eye[axis], BEHIND);
        assert_int_equal(made.real.eye[axis], BEHIND);
    }
    interior_free(&made);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_eye),
        cmocka_unit_test(test_error_grows),
        cmocka_unit_test(test_no_light),
        cmocka_unit_test(test_no_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
