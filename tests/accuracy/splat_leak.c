/*
 * The leak of conventional splatting, and its absence where attenuation is stored.
 *
 * A pixel in the middle of four columns of voxels takes a quarter of each: layers of opacity a
 * are blended as four splats of a / 4 (equation 9), which lets more light through than a
 * (equation 8). Voxels are white and nothing lies behind, so that a picture of n layers is
 * 1 - (1 - a)^n; all figures are levels of 8 bits.
 */
#include "attenuated.h"

#include <math.h>
#include <stdio.h>

static const double level = 65536; /* of a sum */

/* ---- Columns of voxels ---------------------------------------------------------- */

/* White voxels seen along y, with bytes towards the viewer alone. Without a unit distance all is
   as published: opacities of a step, and light by the nearest direction. */
typedef struct columns {
    qv_volume volume;
    attenuated light;
    uint8_t *voxels;
    double opacity; /* of a layer, as it is stored */
} columns;

typedef enum kind { RGBA8, RGBA16, RGBT8, RGBT16, KINDS } kind;

static const char *const kind_names[KINDS] = {"rgba8", "rgba16", "rgbt8", "rgbt16"};
static const uint8_t storages[KINDS] = {QV_STORAGE_RGBA8, QV_STORAGE_RGBA16, QV_STORAGE_RGBT8,
                                        QV_STORAGE_RGBT16};

/* Towards the viewer at azimuth and elevation 0. */
static uint8_t to_viewer(void)
{
    return qv_direction(0, -1, 0);
}

static void fill(columns *made, double opacity)
{
    qv_volume *volume = &made->volume;
    const bool holds_extinction = ref_holds_extinction(volume->storage);
    const double channel = holds_extinction ? 1 : opacity;
    const size_t voxels = (size_t)volume->size[0] * volume->size[1] * volume->size[2];
    const uint16_t wide[4] = {0xffff, 0xffff, 0xffff, (uint16_t)lround(channel * 65535)};
    const uint8_t narrow[4] = {255, 255, 255, (uint8_t)lround(channel * 255)};
    const bool is_wide = ref_is_wide(volume->storage);
    const size_t bytes = is_wide ? sizeof wide : sizeof narrow;
    volume->extinction = holds_extinction ? (uint32_t)lround(-log2(1 - opacity) * 65536) : 0;
    for (size_t i = 0; i < voxels; i++) {
        memcpy(made->voxels + i * bytes, is_wide ? (const void *)wide : narrow, bytes);
    }
    made->opacity = holds_extinction ? 1 - exp2(-(double)volume->extinction / 65536)
                    : is_wide        ? wide[3] / 65535.0
                                     : narrow[3] / 255.0;
}

static void columns_make(columns *made, kind of, double opacity, const uint16_t size[3],
                         uint32_t unit_distance)
{
    qv_volume *volume = &made->volume;
    int32_t stride = of == RGBA16 || of == RGBT16 ? 8 : 4;
    memset(made, 0, sizeof *made);
    for (int axis = 0; axis < 3; axis++) {
        volume->size[axis] = size[axis];
        volume->stride[axis] = stride;
        stride *= size[axis];
    }
    volume->storage = storages[of];
    volume->unit_distance = unit_distance;
    volume->voxels_bytes = (uint64_t)stride;
    made->voxels = malloc((size_t)stride);
    assert_non_null(made->voxels);
    volume->voxels = made->voxels;
    fill(made, opacity);
    attenuated_make(&made->light, volume, 0, (uint32_t)1 << to_viewer(), NULL);
}

static void columns_free(columns *made)
{
    attenuated_free(&made->light);
    free(made->voxels);
}

/* ---- One pixel of them ------------------------------------------------------------ */

typedef struct pixel {
    qv_splats splats;
    uint32_t sum[QV_SUM_CHANNELS];
    qv_sums sums;
} pixel;

/* A pixel of this pitch in the middle of the columns. May not move. */
static void pixel_make(pixel *made, const columns *of, const qv_splatting *splatting,
                       uint32_t pitch)
{
    qv_splat_scene scene;
    memset(&scene, 0, sizeof scene);
    scene.splatting = splatting;
    scene.kernel = &qv_kernel_linear;
    scene.domain = attenuated_domain(&of->volume);
    scene.directions = (uint32_t)1 << to_viewer();
    scene.interpolation = of->volume.unit_distance == 0;
    scene.view.pitch = pitch;
    scene.view.step = QV_ONE_Q16;
    scene.view.width = 1;
    scene.view.height = 1;
    scene.volume = of->volume;
    qv_rotation(scene.view.rotation, 0, 0, 0);
    memset(made, 0, sizeof *made);
    assert_int_equal(qv_splat_init(&made->splats, &scene), QV_OK);
    made->sums.sums = made->sum;
    made->sums.count = QV_SUM_CHANNELS;
    made->sums.rect.right = 1;
    made->sums.rect.bottom = 1;
    assert_int_equal(qv_sums_clear(&made->sums, &made->splats), QV_OK);
}

/* Adds the voxels of a layer; 0 is the one next to the viewer. */
static void add_layer(pixel *to, const columns *of, uint16_t layer)
{
    uint16_t at[3] = {0, layer, 0};
    for (at[2] = 0; at[2] < of->volume.size[2]; at[2]++) {
        for (at[0] = 0; at[0] < of->volume.size[0]; at[0]++) {
            const qv_freevoxel voxel = attenuated_voxel(&of->light, &of->volume, 0, at);
            assert_int_equal(qv_splat(&to->sums, &to->splats, &voxel), QV_OK);
        }
    }
}

/* How far each picture is from exact: the worst of 1, 2, .. layers. Each layer that is added is
   one more behind the others, which for equal voxels blends as one more before them. */
typedef struct leak {
    double worst;
    unsigned layers; /* at the worst */
} leak;

static leak worst_of(const columns *of, const qv_splatting *splatting, uint32_t pitch)
{
    leak found = {0, 0};
    pixel at;
    double exact = 1;
    pixel_make(&at, of, splatting, pitch);
    for (uint16_t layer = 0; layer < of->volume.size[1]; layer++) {
        add_layer(&at, of, layer);
        exact *= 1 - of->opacity;
        for (int channel = 0; channel < (int)QV_SUM_CHANNELS; channel++) {
            const double off = fabs(at.sum[channel] / level - 255 * (1 - exact));
            if (off > found.worst) {
                found.worst = off;
                found.layers = layer + 1u;
            }
        }
    }
    return found;
}

/* ---- Closed forms ----------------------------------------------------------------- */

/* Of four quarters a layer, the worst of all depths. */
static double leak_of_quarters(double opacity)
{
    const double conventional = pow(1 - opacity / 4, 4), exact = 1 - opacity;
    double worst = 0;
    for (int layers = 1; layers <= QV_AXIS_MAX; layers++) {
        worst = fmax(worst, 255 * (pow(conventional, layers) - pow(exact, layers)));
    }
    return worst;
}

/* Of two splats of this weight each, once: the product w a w a that the joint blend does not
   have. It is a^2 / 4 where both have all of a pixel between them. */
static double leak_of_two(double opacity, double weight)
{
    return 255 * weight * opacity * weight * opacity;
}

/* What exact bytes would cost a cube that is otherwise drawn without error, the worst of all depths
   up to this one. */
static double cost_of_bytes(double opacity, unsigned layers)
{
    double drawn = 0, passes = 1, worst = 0;
    for (unsigned layer = 0; layer < layers; layer++) {
        drawn += opacity * floor(255 * passes + 0.5);
        passes *= 1 - opacity;
        worst = fmax(worst, fabs(drawn - 255 * (1 - passes)));
    }
    return worst;
}

/* ---- Tests -------------------------------------------------------------------------- */

static const double within = 0.1, half_a_level = 0.5;

/* What the library may add to the error of bytes: a third of what qvol.h lets the 16384 splats of
   the deepest cube do. */
static const double arithmetic = 0.08;

/* Opacities of the uniform cube and what it is known to leak at the worst of all depths. */
static const struct {
    double opacity, leak;
} cubes[] = {{.01, .35}, {.05, 1.81}, {.1, 3.71}, {.25, 10.1}, {.5, 23.9}, {.9, 66.5}};

#define CUBES (sizeof cubes / sizeof cubes[0])

static void check_cube(kind of, double opacity, double known)
{
    const uint16_t size[3] = {2, 1200, 2}; /* all that the faintest shows, to 10^-5 */
    columns cube;
    columns_make(&cube, of, opacity, size, QV_ONE_Q16);
    const leak over = worst_of(&cube, &qv_splatting_over, QV_ONE_Q16);
    const leak added = worst_of(&cube, &qv_splatting_added, QV_ONE_Q16);
    const double closed = leak_of_quarters(cube.opacity), bytes = cost_of_bytes(cube.opacity, 1200);
    printf("# cube, %s, opacity %.5f: conventional leaks %.3f at %u layers (closed form %.3f, "
           "known %.2f), FreeVoxels %.3f at %u (exact bytes %.3f)\n",
           kind_names[of], cube.opacity, over.worst, over.layers, closed, known, added.worst,
           added.layers, bytes);
    assert_true(fabs(over.worst - closed) <= within);
    assert_true(added.worst <= bytes + arithmetic);
    if (of != RGBA8) { /* which does not hold these opacities */
        assert_true(fabs(over.worst - known) <= within);
        assert_true(added.worst <= half_a_level);
    }
    columns_free(&cube);
}

static void test_cube(void **state)
{
    (void)state;
    for (kind of = RGBA8; of < KINDS; of++) {
        for (size_t i = 0; i < CUBES; i++) {
            check_cube(of, cubes[i].opacity, cubes[i].leak);
        }
    }
}

/*
 * Two voxels side by side under a pixel that is as wide as they are. From above and below, the
 * kernel's mean over it is 3/4.
 */
static void test_two_splats(void **state)
{
    static const double opacities[] = {.001, .01, .1, .5, .9};
    const double high = .75, weight = high / 2;
    const uint16_t size[3] = {2, 1, 1};
    (void)state;
    for (kind of = RGBA8; of < KINDS; of++) {
        for (size_t i = 0; i < sizeof opacities / sizeof opacities[0]; i++) {
            columns pair;
            pixel over, added;
            columns_make(&pair, of, opacities[i], size, QV_ONE_Q16);
            pixel_make(&over, &pair, &qv_splatting_over, QV_ONE_Q16);
            pixel_make(&added, &pair, &qv_splatting_added, QV_ONE_Q16);
            add_layer(&over, &pair, 0);
            add_layer(&added, &pair, 0);
            const double exact = 255 * high * pair.opacity;
            const double lost = exact - over.sum[3] / level, off = added.sum[3] / level - exact;
            printf("# two splats, %s, opacity %.5f: conventional leaks %.3f (closed form %.3f), "
                   "FreeVoxels %.3f\n",
                   kind_names[of], pair.opacity, lost, leak_of_two(pair.opacity, weight), off);
            assert_true(fabs(lost - leak_of_two(pair.opacity, weight)) <= within);
            assert_true(fabs(off) <= half_a_level);
            columns_free(&pair);
        }
    }
}

/* At the centre of a voxel its neighbours have next to no weight, so next to nothing leaks: what
   leaks between voxels is seen as a grid. */
static void test_grid(void **state)
{
    const double opacity = .25, least_contrast = 20;
    const uint16_t size[3] = {3, 100, 3};
    columns cube;
    (void)state;
    columns_make(&cube, RGBA16, opacity, size, QV_ONE_Q16);
    const leak centre = worst_of(&cube, &qv_splatting_over, QV_ONE_Q16 / 64);
    printf("# grid: conventional leaks %.3f at the centre of a voxel, %.3f between four\n",
           centre.worst, leak_of_quarters(opacity));
    assert_true(centre.worst * least_contrast <= leak_of_quarters(opacity));
    columns_free(&cube);
}

/* ---- What bytes cost ---------------------------------------------------------------- */

/* Of pictures of every depth of up to 4096 layers. */
static double store_of(kind of, double *opacity, uint32_t unit_distance)
{
    const uint16_t size[3] = {2, QV_AXIS_MAX, 2};
    columns cube;
    columns_make(&cube, of, *opacity, size, unit_distance);
    const leak added = worst_of(&cube, &qv_splatting_added, QV_ONE_Q16);
    *opacity = cube.opacity;
    columns_free(&cube);
    return added.worst;
}

static void test_store(void **state)
{
    static const double opacities[] = {.001, .01, .05, .1, .25, .5};
    (void)state;
    for (kind of = RGBA16; of < KINDS; of++) {
        double worst = 0;
        for (size_t i = 0; i < sizeof opacities / sizeof opacities[0]; i++) {
            double opacity = opacities[i];
            const double found = store_of(of, &opacity, QV_ONE_Q16);
            printf("# store, %s, opacity %.5f: %.4f of a level, every depth\n", kind_names[of],
                   opacity, found);
            worst = fmax(worst, found);
        }
        assert_true(worst <= half_a_level);
    }
}

/*
 * Opacities between those are not all that kind: the errors of the first bytes add up to almost 2
 * levels at the worst. That is what bytes cost that are rounded from exact ones; the library is to
 * add nothing.
 */
static void test_any_opacity(void **state)
{
    const double ratio = 1.02;
    (void)state;
    for (kind of = RGBA8; of < KINDS; of++) {
        double worst = 0, most_added = 0, at = 0;
        int beyond = 0, count = 0;
        for (double opacity = of == RGBA8 ? 1.0 / 255 : .001; opacity <= .5; opacity *= ratio) {
            double stored = opacity;
            const double found = store_of(of, &stored, QV_ONE_Q16);
            at = found > worst ? stored : at;
            worst = fmax(worst, found);
            most_added = fmax(most_added, fabs(found - cost_of_bytes(stored, QV_AXIS_MAX)));
            beyond += found > half_a_level;
            count++;
        }
        printf("# any opacity to .5, %s: at most %.4f of a level, at %.5f; above .5 for %d of %d; "
               "at most %.4f off what exact bytes cost\n",
               kind_names[of], worst, at, beyond, count, most_added);
        assert_true(most_added <= arithmetic);
        assert_true(worst <= 2);
    }
}

/* Opacities of a step, and light by the nearest direction. */
static void test_published(void **state)
{
    (void)state;
    for (kind of = RGBA8; of <= RGBA16; of++) {
        for (size_t i = 0; i < CUBES; i++) {
            double opacity = cubes[i].opacity;
            const double worst = store_of(of, &opacity, 0);
            printf("# as published, %s, opacity %.5f: %.4f of a level, every depth\n",
                   kind_names[of], opacity, worst);
            assert_true(worst <= 1);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cube),        cmocka_unit_test(test_two_splats),
        cmocka_unit_test(test_grid),        cmocka_unit_test(test_store),
        cmocka_unit_test(test_any_opacity), cmocka_unit_test(test_published),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
