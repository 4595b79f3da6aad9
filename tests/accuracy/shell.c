/*
 * A thin shell through five levels of a pyramid: a sphere one voxel thick, opaque or of
 * opacity 1/2, stays as opaque where means are of extinction, and fades where they are of
 * opacity. What is compared is the mean opacity of the pixels that show any of the shell on
 * level 0, beside that of the same shell in double precision.
 *
 * The volume holds a quarter of the sphere, about the edge x = y = 0. Its faces mirror the
 * rest: so qv_downsample reads beyond them, and clamping to the outermost voxel comes to
 * the same. The radius is five voxels of level 5; below three and a half, exact
 * arithmetic too loses more than 1 % of opacity 1/2, which the blur takes outside.
 */
#include "check.h"
#include "fine.h"
#include "levels.h"

#include <math.h>
#include <stdio.h>

#define EDGE   192 /* voxels of a radius of the box */
#define RADIUS 168
#define PITCH  2 /* voxels from pixel to pixel */
#define SIDE   (EDGE / PITCH)
#define LEVELS 5

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* By level: the sum of opacities inside the silhouette of level 0, and outside, both by
   that inside on level 0. */
typedef struct kept {
    double inside[LEVELS + 1], spill[LEVELS + 1];
} kept;

/* Opacities of a quarter of the picture, one row after the other. */
typedef double picture[SIDE * SIDE];

/* ---- Ways to average and to sample --------------------------------------------------- */

typedef enum kernel { LINEAR, BSPLINE } kernel;

typedef struct way {
    const char *name;
    const qv_filter *filter;
    double tap[4];
    kernel by;
} way;

static const way box4 = {"box4, trilinear", &qv_filter_box4, {0.25, 0.25, 0.25, 0.25}, LINEAR};
static const way box2 = {"box2, trilinear", &qv_filter_box2, {0, 0.5, 0.5, 0}, LINEAR};
static const way quad4 = {
    "quad4, B-spline", &qv_filter_quad4, {13. / 64, 19. / 64, 19. / 64, 13. / 64}, BSPLINE};

/* At level 5 an opacity of 1/2 is some 6 of 255 for a length of one voxel, too few for 99 % by
   B-splines; for a length of four it is four times as many. */
typedef struct method {
    const char *name;
    const qv_sampling *sampling[2]; /* by kernel */
    const qv_domain *domain;
    int unit_distance; /* of stored opacities, in voxels */
    double least[2];   /* of what is kept, by kernel; 0: it is only printed */
    double off;        /* at most, from double precision */
} method;

static const method methods[] = {
    {"rgbt16",
     {&qv_extinction_rgbt16_levels, &qv_bspline_extinction_rgbt16_levels},
     &qv_domain_stored,
     1,
     {0.99, 0.99},
     0.0005},
    {"rgbt8",
     {&qv_extinction_rgbt8_levels, &qv_bspline_extinction_rgbt8_levels},
     &qv_domain_stored,
     1,
     {0.99, 0.99},
     0.02},
    {"rgba16",
     {&qv_extinction_rgba16_levels, &qv_bspline_extinction_rgba16_levels},
     &qv_domain_extinction,
     1,
     {0.99, 0.99},
     0.0005},
    {"rgba8 for 4 voxels",
     {&qv_extinction_rgba8_levels, &qv_bspline_extinction_rgba8_levels},
     &qv_domain_extinction,
     4,
     {0.99, 0.99},
     0.005},
    {"rgba8 for 1 voxel",
     {&qv_extinction_rgba8_levels, &qv_bspline_extinction_rgba8_levels},
     &qv_domain_extinction,
     1,
     {0.99, 0.96},
     0.04},
    {"opacities, rgba16",
     {&qv_corrected_rgba16_levels, &qv_bspline_weighted_rgba16_levels},
     &qv_domain_stored,
     1,
     {0, 0},
     0.0005},
};

static bool by_extinction(const method *m)
{
    return m->least[LINEAR] != 0;
}

/* ---- The shell ------------------------------------------------------------------------ */

/* Whether it holds the voxel that begins here, from its centre. */
static bool in_shell(int x, int y, int z)
{
    const double at[3] = {x + 0.5, y + 0.5, z + 0.5};
    return fabs(sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]) - RADIUS) <= 0.5;
}

/* For full opacity, and a voxel: the least that lets nothing through in 16 bits. More would
   leave less of 8 bits to thinner parts. */
#define OPAQUE_DEPTH 17

/* A voxel of the shell, white. Extinction of the full value is the least that holds it. */
static void make_entry(uint16_t entry[4], levels *made, double opacity, int unit_distance)
{
    const bool wide = ref_is_wide(made->volume.storage);
    const uint32_t most = wide ? 65535 : 255;
    const uint8_t opacities = wide ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
    const qv_entries from = {(qv_address)entry, 1, QV_ONE_Q16, 0, opacities};
    uint8_t *const narrow = (uint8_t *)entry;
    for (int channel = 0; channel < 4; channel++) {
        const double value = channel == 3 ? 1 - pow(1 - opacity, unit_distance) : 1;
        if (wide) {
            entry[channel] = (uint16_t)ref_level(value, most);
        } else {
            narrow[channel] = (uint8_t)ref_level(value, most);
        }
    }
    made->volume.unit_distance = (uint32_t)unit_distance * QV_ONE_Q16;
    if (ref_holds_extinction(made->volume.storage)) {
        uint32_t *const full = &made->volume.extinction;
        assert_int_equal(qv_extinction_of(full, &from, OPAQUE_DEPTH * QV_ONE_Q16), QV_OK);
        assert_int_equal(qv_opacity_to_extinction(entry, 8, made->volume.storage, *full, &from),
                         QV_OK);
    }
}

static void make_shell(levels *made, const method *m, const way *w, double opacity)
{
    const uint16_t size[3] = {EDGE, EDGE, 2 * EDGE};
    levels_begin(made, m->sampling[w->by]->storage, size);
    const size_t bytes = (size_t)made->volume.stride[0];
    uint16_t entry[4];
    uint8_t *at = made->voxels;
    make_entry(entry, made, opacity, m->unit_distance);
    for (int z = -EDGE; z < EDGE; z++) {
        for (int y = 0; y < EDGE; y++) {
            for (int x = 0; x < EDGE; x++, at += bytes) {
                if (in_shell(x, y, z)) {
                    memcpy(at, entry, bytes);
                }
            }
        }
    }
    levels_make(made, w->filter, m->domain, LEVELS);
}

/* ---- Pictures --------------------------------------------------------------------------- */

/* Along z. Pixel centres see the corners of four voxels, samples the centres of their
   slices. */
static void render_level(picture made, const levels *of, const qv_sampling *sampling, int level)
{
    static fine_pixel pixels[SIDE * SIDE];
    qv_scene scene;
    qv_view view;
    memset(&scene, 0, sizeof scene);
    scene.volume = of->volume;
    scene.pyramid = &of->pyramid;
    scene.sampling = sampling;
    scene.phase = 0x8000;
    scene.level = (uint16_t)(level * 256);
    qv_rotation(view.rotation, 0, 0xc0000000u, 0);
    view.pitch = PITCH * QV_ONE_Q16;
    view.step = QV_ONE_Q16;
    view.width = SIDE;
    view.height = SIDE;
    assert_int_equal(qv_orthographic(&scene.camera, &scene.volume, &view), QV_OK);
    assert_int_equal(render_fine_frame(pixels, &scene, SIDE, SIDE), QV_OK);
    for (int i = 0; i < SIDE * SIDE; i++) {
        made[i] = pixels[i].channel[3] / FINE_ONE;
    }
}

static void compare(kept *found, int level, const picture of, const picture first)
{
    double all = 0, inside = 0, outside = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        all += first[i];
        if (first[i] > 0) {
            inside += of[i];
        } else {
            outside += of[i];
        }
    }
    found->inside[level] = inside / all;
    found->spill[level] = outside / all;
}

static void render_shell(kept *found, const method *m, const way *w, double opacity)
{
    static picture first, coarser;
    levels made;
    make_shell(&made, m, w, opacity);
    render_level(first, &made, m->sampling[w->by], 0);
    compare(found, 0, first, first);
    for (int level = 1; level <= LEVELS; level++) {
        render_level(coarser, &made, m->sampling[w->by], level);
        compare(found, level, coarser, first);
    }
    levels_free(&made);
}

/* ---- In double precision ------------------------------------------------------------------ */

/* An eighth of the shell, which the faces mirror: depths or opacities of a voxel's width. */
typedef struct eighth {
    double *voxels;
    int size;
} eighth;

static double *voxel_of(const eighth *of, int x, int y, int z)
{
    return &of->voxels[x + of->size * (y + (ptrdiff_t)of->size * z)];
}

static void make_eighth(eighth *made, double value)
{
    made->size = EDGE;
    made->voxels = malloc(sizeof(double) * EDGE * EDGE * EDGE);
    assert_true(made->voxels != NULL);
    for (int i = 0; i < EDGE * EDGE * EDGE; i++) {
        const int x = i % EDGE, y = i / EDGE % EDGE, z = i / (EDGE * EDGE);
        made->voxels[i] = in_shell(x, y, z) ? value : 0;
    }
}

static int mirrored(int at, int size)
{
    return at < 0 ? -1 - at : at >= size ? 2 * size - 1 - at : at;
}

/* A voxel of the next level. */
static double filtered(const eighth *finer, const double tap[4], int x, int y, int z)
{
    const int corner[3] = {2 * x - 1, 2 * y - 1, 2 * z - 1}, size = finer->size;
    double sum = 0;
    for (int i = 0; i < 64; i++) {
        const int a = i % 4, b = i / 4 % 4, c = i / 16;
        const double share = tap[a] * tap[b] * tap[c];
        if (share != 0) {
            sum += share * *voxel_of(finer, mirrored(corner[0] + a, size),
                                     mirrored(corner[1] + b, size), mirrored(corner[2] + c, size));
        }
    }
    return sum;
}

static void coarsen(eighth *of, const double tap[4])
{
    const int size = of->size / 2;
    eighth coarser = {malloc(sizeof(double) * (size_t)size * (size_t)size * (size_t)size), size};
    assert_true(coarser.voxels != NULL);
    for (int i = 0; i < size * size * size; i++) {
        const int x = i % size, y = i / size % size, z = i / (size * size);
        coarser.voxels[i] = filtered(of, tap, x, y, z);
    }
    free(of->voxels);
    *of = coarser;
}

static void locate(ref_taps *taps, double point, int size, kernel by)
{
    if (by == LINEAR) {
        ref_linear_taps(taps, point, size);
    } else {
        ref_bspline_taps(taps, point, size);
    }
}

static double value_at(const eighth *of, const ref_taps taps[3])
{
    double sum = 0;
    for (int k = 0; k < taps[2].count; k++) {
        for (int j = 0; j < taps[1].count; j++) {
            for (int i = 0; i < taps[0].count; i++) {
                const double weight = taps[0].weight[i] * taps[1].weight[j] * taps[2].weight[k];
                sum += weight * *voxel_of(of, taps[0].at[i], taps[1].at[j], taps[2].at[k]);
            }
        }
    }
    return sum;
}

/* What is modelled: means of opacity or of extinction, of the front half of the shell or of
   both halves. */
typedef struct model {
    const way *way;
    double opacity;
    bool extinction;
    int halves;
} model;

/* The opacity of a ray along z, of samples as long as a voxel of the level is wide. */
static double opacity_along(const eighth *of, double x, double y, const model *m)
{
    const kernel by = m->way->by;
    const double width = EDGE / of->size;
    double depth = 0;
    ref_taps taps[3];
    locate(&taps[0], x / width, of->size, by);
    locate(&taps[1], y / width, of->size, by);
    for (int z = 0; z < of->size; z++) {
        locate(&taps[2], z + 0.5, of->size, by);
        const double value = value_at(of, taps);
        depth += m->halves * width * (m->extinction ? value : -log2(1 - value));
    }
    return 1 - exp2(-depth);
}

static void model_level(picture made, const eighth *of, const model *m)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double x = (i % SIDE + 0.5) * PITCH, y = (i / SIDE + 0.5) * PITCH;
        made[i] = opacity_along(of, x, y, m);
    }
}

static void model_shell(kept *found, const model *m)
{
    static picture first, coarser;
    const double depth = m->opacity == 1 ? OPAQUE_DEPTH : -log2(1 - m->opacity);
    eighth of;
    make_eighth(&of, m->extinction ? depth : m->opacity);
    model_level(first, &of, m);
    compare(found, 0, first, first);
    for (int level = 1; level <= LEVELS; level++) {
        coarsen(&of, m->way->tap);
        model_level(coarser, &of, m);
        compare(found, level, coarser, first);
    }
    free(of.voxels);
}

/* ---- Tests ---------------------------------------------------------------------------------- */

static void print_kept(const kept *found, const char *name)
{
    printf("# %-19s kept", name);
    for (int level = 1; level <= LEVELS; level++) {
        printf(" %.4f", found->inside[level]);
    }
    printf(", spill");
    for (int level = 1; level <= LEVELS; level++) {
        printf(" %.3f", found->spill[level]);
    }
    printf("\n");
}

/* How many levels keep too little, or are too far from double precision. */
static int count_bad(const kept *found, const kept *exact, const method *m, kernel by)
{
    int bad = 0;
    for (int level = 1; level <= LEVELS; level++) {
        const double inside = found->inside[level];
        if (inside < m->least[by] || fabs(inside - exact->inside[level]) > m->off) {
            printf("# %s: level %d keeps too little, or not what it should\n", m->name, level);
            bad++;
        }
    }
    return bad;
}

/* Also where a ray meets the shell once: there means of opacity lose most. */
static void print_front_half(const way *w, double opacity)
{
    kept found;
    for (int extinction = 0; extinction < 2; extinction++) {
        const model front = {w, opacity, extinction == 1, 1};
        model_shell(&found, &front);
        print_kept(&found, extinction ? "exact, front" : "exact, opac., front");
    }
}

static void test_shell(const way *w, double opacity)
{
    const model by_opacities = {w, opacity, false, 2}, by_extinctions = {w, opacity, true, 2};
    kept exact[2], found;
    int bad = 0;
    printf("# opacity %.1f, %s: by level 1 .. %d\n", opacity, w->name, LEVELS);
    print_front_half(w, opacity);
    model_shell(&exact[false], &by_opacities);
    model_shell(&exact[true], &by_extinctions);
    print_kept(&exact[false], "exact, opacities");
    print_kept(&exact[true], "exact");
    for (size_t i = 0; i < COUNT(methods); i++) {
        render_shell(&found, &methods[i], w, opacity);
        print_kept(&found, methods[i].name);
        bad += count_bad(&found, &exact[by_extinction(&methods[i])], &methods[i], w->by);
    }
    assert_int_equal(bad, 0);
    assert_true(exact[false].inside[LEVELS] < exact[true].inside[LEVELS] - 0.02);
}

#define TEST(name, way, opacity)                                                                   \
    static void test_##name(void **state)                                                          \
    {                                                                                              \
        (void)state;                                                                               \
        test_shell(&way, opacity);                                                                 \
    }

TEST(opaque_box4, box4, 1)
TEST(opaque_box2, box2, 1)
TEST(opaque_quad4, quad4, 1)
TEST(half_box4, box4, 0.5)
TEST(half_box2, box2, 0.5)
TEST(half_quad4, quad4, 0.5)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_opaque_box4),  cmocka_unit_test(test_opaque_box2),
        cmocka_unit_test(test_opaque_quad4), cmocka_unit_test(test_half_box4),
        cmocka_unit_test(test_half_box2),    cmocka_unit_test(test_half_quad4),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
