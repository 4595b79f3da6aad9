/*
 * Random pictures of splats against the double-precision reference: all storages, views,
 * kernels, lamps and levels. The bytes of both are their own.
 */
#include "attenuated.h"
#include "seeded_splats.h"
#include "tally.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#define SCENES      120 /* of each storage; half of them conventionally too */
#define MOST_PIXELS ((size_t)SEEDED_MOST_EDGE * SEEDED_MOST_EDGE)

/*
 * Bounds, of pictures of 8 bits: no channel is more than a level off, and so many of all equal the
 * reference. The scenes with the fewest have voxels of some 70 pixels, over which the table of the
 * linear kernel is a staircase of 64 steps.
 */
static const uint32_t worst_of_all = 1;
static const double least_equal = 0.995, least_equal_in_a_scene = 0.93;
static const double farthest = 1.3; /* levels before rounding */

static const char *const storage_names[] = {"",         "rgba8",       "rgba16",
                                            "indexed8", "indexed8_16", "rgbt8",
                                            "rgbt16",   "indexed8_t8", "indexed8_t16"};

typedef struct frame {
    uint32_t sums[MOST_PIXELS * QV_SUM_CHANNELS];
    uint8_t pixels[MOST_PIXELS][4];
    ref_sums real[MOST_PIXELS];
} frame;

/* ---- The library's picture -------------------------------------------------------- */

static qv_status splat_levels(const qv_sums *sums, const qv_splats *splats,
                              const seeded_splats *made, const attenuated *light)
{
    qv_status status = QV_OK;
    for (int level = made->scene.level; status == QV_OK && level <= made->scene.coarsest; level++) {
        status = attenuated_splat(sums, splats, light, &made->level[level], level);
    }
    return status;
}

/* Conventional splats, one by one: of the finest level alone, in the order of memory. */
static qv_status splat_each(const qv_sums *sums, const qv_splats *splats, const seeded_splats *made,
                            const attenuated *light)
{
    const qv_volume *volume = &made->level[0];
    qv_status status = QV_OK;
    uint16_t at[3];
    for (at[2] = 0; at[2] < volume->size[2]; at[2]++) {
        for (at[1] = 0; at[1] < volume->size[1]; at[1]++) {
            for (at[0] = 0; status == QV_OK && at[0] < volume->size[0]; at[0]++) {
                const qv_freevoxel voxel = attenuated_voxel(light, volume, 0, at);
                status = qv_splat(sums, splats, &voxel);
            }
        }
    }
    return status;
}

static qv_status draw(frame *into, const seeded_splats *made, const qv_splat_scene *scene,
                      const attenuated *light)
{
    const size_t row = 4 * (size_t)scene->view.width;
    const qv_image image = {into->pixels, sizeof into->pixels, (ptrdiff_t)row, &qv_format_rgba8888};
    const qv_sums sums = {into->sums,
                          sizeof into->sums / sizeof into->sums[0],
                          {0, 0, scene->view.width, scene->view.height}};
    qv_splats splats;
    const bool over = scene->splatting == &qv_splatting_over;
    const qv_status status = qv_splat_init(&splats, scene);
    if (status != QV_OK) {
        return status;
    }
    assert_int_equal(qv_sums_clear(&sums, &splats), QV_OK);
    assert_int_equal(over ? splat_each(&sums, &splats, made, light)
                          : splat_levels(&sums, &splats, made, light),
                     QV_OK);
    assert_int_equal(qv_sums_read_out(&image, &sums, &splats), QV_OK);
    return QV_OK;
}

/* ---- The reference's, and the difference ------------------------------------------- */

static void draw_real(frame *into, const ref_splats *real)
{
    ref_splat_clear(into->real, real);
    for (int level = real->scene->level; level <= real->scene->coarsest; level++) {
        ref_splat_level(into->real, real, level);
    }
}

static tally compare(const frame *drawn, const ref_splats *real)
{
    const size_t count = (size_t)real->view.width * (size_t)real->view.height;
    tally found = {0};
    for (size_t i = 0; i < count; i++) {
        ref_pixel expected;
        ref_splat_read_out(&expected, drawn->real[i], real);
        if (expected.opacity > 0) {
            tally_pixel(&found, drawn->pixels[i], &expected);
        }
    }
    return found;
}

typedef struct results {
    tally all;
    double least; /* share equal of the worst scene */
    unsigned scenes, refused, inside;
} results;

static void report(const seeded_splats *made, uint32_t seed, const tally *found)
{
    const qv_splat_scene *scene = &made->scene;
    printf("# seed %" PRIu32 ", %s: %s%s%s, kernel %d, levels %u to %u, %u lamps, unit %" PRIu32
           ": worst %" PRIu32 ", %.4f %% equal, farthest %.3f\n",
           seed, storage_names[scene->volume.storage],
           scene->field_of_view == 0 ? "orthographic" : "perspective",
           made->real.inside ? ", inside" : "", scene->interpolation ? ", nearest" : "",
           made->real.kernel, scene->level, scene->coarsest, scene->lighting.count,
           scene->volume.unit_distance, found->worst, 100 * tally_share(found), found->farthest);
}

static void compare_scene(results *into, seeded_splats *made, uint32_t seed)
{
    static frame drawn;
    attenuated light;
    ref_bytes bytes;
    attenuated_make(&light, &made->level[0], made->levels, made->scene.directions, NULL);
    assert_true(ref_bytes_make(&bytes, &made->level[0], made->levels));
    bytes.light = (ref_light)made->scene.interpolation;
    bytes.directions = made->scene.directions;
    made->real.depths.along = ref_depth_of_bytes;
    made->real.depths.in = &bytes;
    if (made->real.inside) {
        uint16_t eye[3];
        assert_int_equal(qv_splat_eye(eye, &made->scene), 1);
        made->scene.inside = qv_attenuation_at(&light.level[0], eye);
    }
    const qv_status status = draw(&drawn, made, &made->scene, &light);
    assert_true(status == QV_OK || (made->real.inside && status == QV_ERROR_INSIDE));
    if (status == QV_OK) {
        draw_real(&drawn, &made->real);
        const tally found = compare(&drawn, &made->real);
        if (found.worst > worst_of_all || tally_share(&found) < least_equal_in_a_scene) {
            report(made, seed, &found);
        }
        tally_add(&into->all, &found);
        into->least = fmin(into->least, tally_share(&found));
        into->inside += made->real.inside;
    }
    into->refused += status != QV_OK;
    into->scenes++;
    attenuated_free(&light);
    ref_bytes_free(&bytes);
}

static void run(results *into, qv_storage storage, bool over)
{
    const results none = {.least = 1};
    *into = none;
    for (uint32_t seed = 1; seed <= SCENES; seed += over ? 2 : 1) {
        seeded_splats made;
        assert_int_equal(seeded_splats_make(&made, seed, storage), QV_OK);
        made.scene.splatting = over ? &qv_splatting_over : &qv_splatting_added;
        made.real.over = over;
        if (over) {
            made.scene.level = made.scene.coarsest = 0;
        }
        compare_scene(into, &made, seed);
        seeded_splats_free(&made);
    }
    tally_print(storage_names[storage], &into->all);
    printf("#   %u scenes, %u of them with the eye inside, %u more refused; worst scene %.4f %% "
           "equal\n",
           into->scenes, into->inside, into->refused, 100 * into->least);
}

static void test_all(bool over)
{
    for (qv_storage storage = QV_STORAGE_RGBA8; storage <= QV_STORAGE_INDEXED8_T16; storage++) {
        results found;
        run(&found, storage, over);
        assert_true(found.all.worst <= worst_of_all);
        assert_true(found.all.farthest <= farthest);
        assert_true(tally_share(&found.all) >= least_equal);
        assert_true(found.least >= least_equal_in_a_scene);
        assert_true(found.refused * 10 <= found.scenes);
    }
}

static void test_added(void **state)
{
    (void)state;
    test_all(false);
}

static void test_over(void **state)
{
    (void)state;
    test_all(true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_added),
        cmocka_unit_test(test_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
