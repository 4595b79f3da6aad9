/*
 * What is lost by storing light in 26 directions only: views spread evenly over the sphere, with
 * light by the nearest direction, as published, and between three, by their transmittances or by
 * their depths. All against
 *
 *   the same splats with attenuation by casting a ray from each voxel to the viewer, in double
 *   precision, which leaves the error of directions and of bytes alone;
 *   the library's picture of the same volume by extinction-based ray casting, from which splats
 *   also differ by their kernels.
 *
 * Errors are levels of 8 bits, over all channels of the pixels that the ray-cast picture covers.
 * 40 views, or as many as the first argument or QV_VIEWS says; 500 for the published table.
 */
#include "attenuated.h"
#include "fine.h"
#include "freevoxels.h"
#include "scan.h"

#include <math.h>
#include <stdio.h>

#define FACTOR 8  /* by which the scan is reduced */
#define EDGE   24 /* voxels of the others */
#define FRAME  48 /* pixels, of 1 voxel */
#define PIXELS ((size_t)FRAME * FRAME)

static const double pi = 3.14159265358979323846;

static int views = 40;

/* ---- Volumes ---------------------------------------------------------------------- */

typedef struct subject {
    const char *name;
    qv_volume volume;
    uint16_t (*voxels)[4];
    attenuated light;
    qv_volume published; /* the same voxels, with opacities for a step of any direction */
    attenuated published_light;
    ref_field field;
} subject;

typedef void painter(uint16_t rgba[4], const double at[3]);

static uint16_t channel(double fraction)
{
    return (uint16_t)lround(65535 * fmin(fmax(fraction, 0), 1));
}

/* Voxel centres lie at -1 .. 1 on each axis. */
static double radius(const double at[3])
{
    return sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
}

static void paint_fog(uint16_t rgba[4], const double at[3])
{
    for (int i = 0; i < 3; i++) {
        rgba[i] = channel(0.5 + at[i] / 2);
    }
    rgba[3] = channel(0.06);
}

/* A pale shell round a dense red core. */
static void paint_ball(uint16_t rgba[4], const double at[3])
{
    const double r = radius(at);
    const bool core = r < 0.4;
    rgba[0] = channel(0.9);
    rgba[1] = rgba[2] = channel(core ? 0.2 : 0.8);
    rgba[3] = channel(core ? 0.6 : 0.3 * exp(-pow((r - 0.8) / 0.08, 2)));
}

/* Waves that cross each other, clear between their crests. */
static void paint_clouds(uint16_t rgba[4], const double at[3])
{
    double crest = 0;
    for (int i = 0; i < 3; i++) {
        const double wave = sin(6 * at[i] + 3 * at[(i + 1) % 3] + i);
        rgba[i] = channel(0.6 + 0.4 * wave);
        crest += wave / 3;
    }
    rgba[3] = channel(0.5 * crest);
}

static void subject_begin(subject *made, const char *name, const uint16_t size[3])
{
    qv_volume *volume = &made->volume;
    int32_t stride = sizeof made->voxels[0];
    memset(made, 0, sizeof *made);
    made->name = name;
    for (int axis = 0; axis < 3; axis++) {
        volume->size[axis] = size[axis];
        volume->stride[axis] = stride;
        stride *= size[axis];
    }
    made->voxels = malloc((size_t)stride);
    assert_non_null(made->voxels);
    volume->voxels = (qv_address)made->voxels;
    volume->voxels_bytes = (uint64_t)stride;
    volume->storage = QV_STORAGE_RGBA16;
    volume->unit_distance = QV_ONE_Q16;
}

static void subject_end(subject *made)
{
    attenuated_make(&made->light, &made->volume, 0, QV_DIRECTIONS_ALL, NULL);
    made->published = made->volume;
    made->published.unit_distance = 0;
    attenuated_make(&made->published_light, &made->published, 0, QV_DIRECTIONS_ALL, NULL);
    assert_true(ref_field_make(&made->field, &made->volume));
}

static void subject_free(subject *made)
{
    attenuated_free(&made->light);
    attenuated_free(&made->published_light);
    ref_field_free(&made->field);
    free(made->voxels);
}

static void make_painted(subject *made, const char *name, painter *paint)
{
    const uint16_t size[3] = {EDGE, EDGE, EDGE};
    subject_begin(made, name, size);
    for (size_t i = 0; i < (size_t)EDGE * EDGE * EDGE; i++) {
        const size_t place[3] = {i % EDGE, i / EDGE % EDGE, i / EDGE / EDGE};
        double at[3];
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = (2 * (double)place[axis] + 1) / EDGE - 1;
        }
        paint(made->voxels[i], at);
    }
    subject_end(made);
}

static void make_head(subject *made)
{
    uint16_t palette[QV_PALETTE_ENTRIES][4], size[3];
    uint8_t *scan = ref_scan_reduced(size, FACTOR);
    assert_non_null(scan);
    ref_scan_palette(palette);
    subject_begin(made, "head", size);
    for (size_t i = 0; i < (size_t)size[0] * size[1] * size[2]; i++) {
        memcpy(made->voxels[i], palette[scan[i]], sizeof made->voxels[i]);
    }
    free(scan);
    subject_end(made);
}

/* ---- Views ------------------------------------------------------------------------ */

typedef struct look {
    qv_view view;
    ref_view real;
} look;

/* The i-th of `views` points of a spiral round the sphere, turned by the golden angle each. */
static void look_from(look *from, int i)
{
    const double golden = 0.6180339887498949, turn = fmod(i * golden, 1);
    const double elevation = asin(1 - (2 * i + 1.0) / views) / (2 * pi);
    const qv_angle round = (qv_angle)llround(turn * 4294967295.0);
    const qv_angle up = (qv_angle)llround(elevation * 4294967296.0);
    memset(from, 0, sizeof *from);
    from->view.pitch = QV_ONE_Q16;
    from->view.step = QV_ONE_Q16 / 4;
    from->view.width = FRAME;
    from->view.height = FRAME;
    qv_rotation(from->view.rotation, round, up, 0);
    ref_rotation(from->real.rotation, round, up, 0);
    from->real.pitch = 1;
    from->real.width = FRAME;
    from->real.height = FRAME;
}

/* Channels, 1 being 1. */
typedef struct frame {
    ref_sums pixel[PIXELS];
} frame;

/* The library's ways to know light, numbered as in qv_interpolation; and that of the nearest
   direction where the length of steps is not accounted for, as published. */
typedef enum method {
    BETWEEN = QV_BETWEEN_LIGHT,
    NEAREST = QV_NEAREST,
    DEPTHS = QV_BETWEEN_DEPTHS,
    PUBLISHED,
    METHODS
} method;

static void set_scene(qv_splat_scene *scene, const subject *of, const look *from, method way)
{
    memset(scene, 0, sizeof *scene);
    scene->splatting = &qv_splatting_added;
    scene->kernel = &qv_kernel_quadratic;
    scene->domain = attenuated_domain(&of->volume);
    scene->directions = QV_DIRECTIONS_ALL;
    scene->interpolation = (uint8_t)(way == PUBLISHED ? QV_NEAREST : way);
    scene->view = from->view;
    scene->volume = way == PUBLISHED ? of->published : of->volume;
}

/* What the library finished, before a display's format rounds it. */
static void take(frame *drawn, const fine_pixel pixels[PIXELS])
{
    for (size_t i = 0; i < PIXELS * 4; i++) {
        drawn->pixel[i / 4][i % 4] = pixels[i / 4].channel[i % 4] / FINE_ONE;
    }
}

static void draw_splats(frame *drawn, const subject *of, const look *from, method way)
{
    static uint32_t memory[PIXELS * QV_SUM_CHANNELS];
    static fine_pixel pixels[PIXELS];
    static const qv_format format = {store_fine, 8 * sizeof pixels[0], 0};
    const qv_image image = {pixels, sizeof pixels, FRAME * sizeof pixels[0], &format};
    const qv_sums sums = {memory, PIXELS * QV_SUM_CHANNELS, {0, 0, FRAME, FRAME}};
    qv_splat_scene scene;
    qv_splats splats;
    const attenuated *light = way == PUBLISHED ? &of->published_light : &of->light;
    set_scene(&scene, of, from, way);
    assert_int_equal(qv_splat_init(&splats, &scene), QV_OK);
    assert_int_equal(qv_sums_clear(&sums, &splats), QV_OK);
    assert_int_equal(attenuated_splat(&sums, &splats, light, &scene.volume, 0), QV_OK);
    assert_int_equal(qv_sums_read_out(&image, &sums, &splats), QV_OK);
    take(drawn, pixels);
}

/* The reference's splats, each with the opacity towards the viewer, with light from here. */
static void draw_real_splats(frame *drawn, const subject *of, const look *from, ref_depths depths)
{
    static ref_sums sums[PIXELS];
    qv_splat_scene scene;
    const ref_splats splats = {
        .scene = &scene, .view = from->real, .levels = &of->volume, .kernel = 3, .depths = depths};
    set_scene(&scene, of, from, false);
    ref_splat_clear(sums, &splats);
    ref_splat_level(sums, &splats, 0);
    for (size_t i = 0; i < PIXELS; i++) {
        ref_pixel finished;
        ref_splat_read_out(&finished, sums[i], &splats);
        memcpy(drawn->pixel[i], finished.rgba, sizeof finished.rgba);
    }
}

static void cast_rays(frame *drawn, const subject *of, const look *from)
{
    static fine_pixel pixels[PIXELS];
    qv_scene scene;
    memset(&scene, 0, sizeof scene);
    scene.sampling = &qv_extinction_rgba16;
    scene.volume = of->volume;
    assert_int_equal(qv_orthographic(&scene.camera, &of->volume, &from->view), QV_OK);
    assert_int_equal(render_fine_frame(pixels, &scene, FRAME, FRAME), QV_OK);
    take(drawn, pixels);
}

/* ---- Errors ------------------------------------------------------------------------ */

typedef struct error {
    double square, worst;
    size_t count; /* of channels */
} error;

static void measure(error *into, const frame *drawn, const frame *wanted, const frame *cover)
{
    for (size_t i = 0; i < PIXELS; i++) {
        for (int c = 0; cover->pixel[i][3] > 0 && c < 4; c++) {
            const double off = 255 * fabs(drawn->pixel[i][c] - wanted->pixel[i][c]);
            into->square += off * off;
            into->worst = fmax(into->worst, off);
            into->count++;
        }
    }
}

static double rms(const error *of)
{
    return sqrt(of->square / (double)of->count);
}

typedef struct errors {
    error splats[METHODS], rays[METHODS];
    error kernel; /* of the exact splats against rays: what no attenuation mends */
} errors;

/* Of all volumes so far. */
static errors all;

static void print(const char *name, const char *against, const error by[METHODS])
{
    printf("# %-6s | %-12s |", name, against);
    static const method columns[METHODS] = {PUBLISHED, NEAREST, DEPTHS, BETWEEN};
    for (int i = 0; i < METHODS; i++) {
        printf(" %7.3f %6.1f |", rms(&by[columns[i]]), by[columns[i]].worst);
    }
    for (int i = 0; i < METHODS - 1; i++) {
        printf(" %.2f", rms(&by[columns[i]]) / rms(&by[BETWEEN]));
    }
    printf("\n");
}

static void print_all(const char *name, const errors *of)
{
    print(name, "exact splats", of->splats);
    print(name, "ray casting", of->rays);
    printf("# %-6s | exact splats against ray casting: %.3f %.1f\n", name, rms(&of->kernel),
           of->kernel.worst);
}

static void measure_view(errors *found, const subject *of, int view)
{
    static frame drawn[METHODS], exact, rays;
    const ref_depths by_ray = {ref_depth_of_ray, &of->field};
    look from;
    look_from(&from, view);
    for (method way = BETWEEN; way < METHODS; way++) {
        draw_splats(&drawn[way], of, &from, way);
    }
    draw_real_splats(&exact, of, &from, by_ray);
    cast_rays(&rays, of, &from);
    for (method way = BETWEEN; way < METHODS; way++) {
        measure(&found->splats[way], &drawn[way], &exact, &rays);
        measure(&found->rays[way], &drawn[way], &rays, &rays);
    }
    measure(&found->kernel, &exact, &rays, &rays);
}

static void join(error *into, const error *from)
{
    into->square += from->square;
    into->worst = fmax(into->worst, from->worst);
    into->count += from->count;
}

static void measure_all(errors *found, const subject *of)
{
    memset(found, 0, sizeof *found);
    for (int view = 0; view < views; view++) {
        measure_view(found, of, view);
    }
    for (method way = BETWEEN; way < METHODS; way++) {
        join(&all.splats[way], &found->splats[way]);
        join(&all.rays[way], &found->rays[way]);
    }
    join(&all.kernel, &found->kernel);
    print_all(of->name, found);
}

/* ---- Tests ------------------------------------------------------------------------ */

/* Whatever the volume, splats between the light of three directions are nearer to those with exact
   light than by any other way. */
static void expect_better(subject *of)
{
    errors found;
    measure_all(&found, of);
    for (method way = NEAREST; way < METHODS; way++) {
        assert_true(rms(&found.splats[BETWEEN]) < rms(&found.splats[way]));
    }
    subject_free(of);
}

static void test_head(void **state)
{
    subject head;
    (void)state;
    make_head(&head);
    expect_better(&head);
}

static void test_fog(void **state)
{
    subject fog;
    (void)state;
    make_painted(&fog, "fog", paint_fog);
    expect_better(&fog);
}

static void test_ball(void **state)
{
    subject ball;
    (void)state;
    make_painted(&ball, "ball", paint_ball);
    expect_better(&ball);
}

static void test_clouds(void **state)
{
    subject clouds;
    (void)state;
    make_painted(&clouds, "clouds", paint_clouds);
    expect_better(&clouds);
}

/* A scene that is all 0 but for its pointers goes between the light of directions: on the whole
   the best way, against ray casting as well. */
static void test_default(void **state)
{
    (void)state;
    print_all("all", &all);
    for (method way = NEAREST; way < METHODS; way++) {
        assert_true(rms(&all.rays[BETWEEN]) < rms(&all.rays[way]));
    }
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_head),   cmocka_unit_test(test_fog),     cmocka_unit_test(test_ball),
        cmocka_unit_test(test_clouds), cmocka_unit_test(test_default),
    };
    const char *wanted = argc > 1 ? argv[1] : getenv("QV_VIEWS");
    if (wanted != NULL) {
        views = (int)strtol(wanted, NULL, 10);
    }
    printf("# %d views; RMS and worst error in levels; last, how many times the RMS of the others "
           "is that between light\n"
           "# volume | against      |   published    |    nearest     | between depths | between "
           "light  |\n",
           views);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
