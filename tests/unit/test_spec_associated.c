/*
 * The worked examples S115 .. S119 of tests/SPEC.md: associated colours. The same inputs and results
 * as there, written out.
 */
#include "check.h"
#include "preweighted.h"

#include <string.h>

enum { ENTRIES = 5, SAMPLES = 3, VOXELS = 8 };

#define VOXEL ((qv_coord)1 << 32)

static void S115_associated_entries(void **state)
{
    static const uint8_t narrow[ENTRIES][4] = {
        {200, 100, 50, 128}, {255, 128, 1, 1}, {255, 128, 127, 3}, {17, 255, 0, 255}, {9, 9, 9, 0}};
    static const uint8_t of_narrow[ENTRIES][4] = {
        {100, 50, 25, 128}, {1, 1, 0, 1}, {3, 2, 1, 3}, {17, 255, 0, 255}, {0, 0, 0, 0}};
    static const uint16_t wide[ENTRIES][4] = {{60000, 30000, 1234, 32768},
                                              {65535, 32639, 32640, 386},
                                              {65535, 1, 0, 65535},
                                              {5, 6, 7, 128},
                                              {65535, 65535, 65535, 129}};
    static const uint8_t of_wide[ENTRIES][4] = {
        {117, 58, 2, 128}, {2, 1, 1, 2}, {255, 0, 0, 255}, {0, 0, 0, 0}, {1, 1, 1, 1}};
    const qv_entries of_8_bits = {narrow[0], ENTRIES, 0, 0, QV_STORAGE_RGBA8};
    const qv_entries of_16_bits = {(qv_address)wide, ENTRIES, 0, 0, QV_STORAGE_RGBA16};
    uint8_t result[ENTRIES][4];
    (void)state;
    assert_int_equal(qv_opacity_to_associated(result, sizeof result, &of_8_bits), QV_OK);
    assert_memory_equal(result, of_narrow, sizeof result);
    assert_int_equal(qv_opacity_to_associated(result, sizeof result, &of_16_bits), QV_OK);
    assert_memory_equal(result, of_wide, sizeof result);
}

/* ---- One cell ----------------------------------------------------------------- */

/* The corners of S116, corner q at x, y, z of its bits 0, 1, 2. */
static const union {
    uint8_t rgba[VOXELS][4];
    uint32_t word[VOXELS]; /* aligned */
} corners = {{{100, 50, 25, 128},
              {1, 1, 0, 1},
              {3, 2, 1, 3},
              {17, 255, 0, 255},
              {0, 0, 0, 0},
              {27, 54, 9, 77},
              {255, 255, 255, 255},
              {1, 2, 196, 200}}};

static const uint32_t fractions[SAMPLES][3] = {{85, 170, 3}, {255, 255, 255}, {0, 128, 1}};

/* The one sample of this number. */
static void stand(qv_passage *passage, unsigned number)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        passage->advance[axis] = 0;
        passage->place[axis] = fractions[number][axis] << 24;
        passage->next[axis] = 4 << axis;
    }
    passage->step = 0;
    passage->base = corners.rgba[0];
    passage->samples = 1;
}

static void expect_end_of_rows(const qv_end *end, const uint32_t expected[4])
{
    assert_int_equal(end->red_blue & 0xFFFF, expected[0]);
    assert_int_equal(end->green_opacity & 0xFFFF, expected[1]);
    assert_int_equal(end->red_blue >> 16, expected[2]);
    assert_int_equal(end->green_opacity >> 16, expected[3]);
}

static void S116_ends_of_rows(void **state)
{
    static const uint32_t low[SAMPLES][4] = {
        {9514, 5096, 2803, 11894}, {64773, 64772, 64771, 64773}, {13436, 6909, 3582, 17020}};
    static const uint32_t high[SAMPLES][4] = {
        {2970, 42983, 401, 43402}, {298, 817, 49793, 51132}, {2288, 32515, 196, 32713}};
    (void)state;
    for (unsigned i = 0; i < SAMPLES; i++) {
        qv_passage passage;
        qv_ends ends;
        stand(&passage, i);
        qv_passage_next(&ends, &passage);
        expect_end_of_rows(&ends.low, low[i]);
        expect_end_of_rows(&ends.high, high[i]);
        assert_int_equal(ends.fraction, fractions[i][0]);
    }
}

/* Light and transmittance. */
typedef struct light {
    uint32_t colour[3], transmittance;
} light;

static void expect_light(void (*composite)(qv_passage *), const light expected[SAMPLES])
{
    qv_passage passage = {.transmittance = 0xFF010000u, .enough = 65536};
    for (unsigned i = 0; i < SAMPLES; i++) {
        stand(&passage, i);
        composite(&passage);
        for (unsigned c = 0; c < 3; c++)
            assert_int_equal(passage.light[c], expected[i].colour[c]);
        assert_int_equal(passage.transmittance, expected[i].transmittance);
        assert_int_equal(passage.samples, 0);
        assert_int_equal(passage.skipped, 0);
    }
}

static void S117_under(void **state)
{
    static const light expected[SAMPLES] = {{{481112064, 1158392576, 131429888}, 2813156352u},
                                            {{504849755, 1204407135, 2279641126u}, 607470879},
                                            {{629871735, 1268695380, 2312971636u}, 449099779}};
    (void)state;
    expect_light(qv_passage_under, expected);
}

static void S118_over(void **state)
{
    static const light expected[SAMPLES] = {{{481099776, 1158348800, 131399680}, 2813198336u},
                                            {{139896775, 319983536, 3295450596u}, 607483131},
                                            {{983981631, 689356740, 2671030948u}, 449112031}};
    (void)state;
    expect_light(qv_passage_over, expected);
}

/* ---- The end of a ray ----------------------------------------------------------- */

/* The scene of S25, over associated voxels. */
static qv_scene column_scene(const uint32_t voxels[VOXELS])
{
    const qv_scene scene = {
        .sampling = &qv_preweighted_associated8,
        .volume = {.voxels = (qv_address)voxels,
                   .voxels_bytes = 4 * VOXELS,
                   .stride = {4, 4, 4},
                   .size = {1, 1, VOXELS},
                   .storage = QV_STORAGE_ASSOCIATED8},
        .camera = {.projection = &qv_projection_orthographic,
                   .step = 65536,
                   .origin = {VOXEL / 2, VOXEL / 2, VOXEL / 2},
                   .across = {VOXEL, 0, 0},
                   .down = {0, VOXEL, 0},
                   .along = {0, 0, VOXEL}},
    };
    return scene;
}

static void expect_end(uint8_t opacity, uint16_t termination, uint32_t samples, uint32_t terminated)
{
    static const qv_rect one_pixel = {0, 0, 1, 1};
    uint32_t voxels[VOXELS];
    uint8_t pixel[4];
    for (unsigned i = 0; i < VOXELS; i++) {
        const uint8_t rgba[4] = {opacity, 0, 0, opacity};
        memcpy(&voxels[i], rgba, sizeof rgba);
    }
    qv_scene scene = column_scene(voxels);
    scene.termination = termination;
    const qv_image image = {pixel, sizeof pixel, sizeof pixel, &qv_format_rgba8888};
    qv_progress progress = {0, 0, 0, 0, 0};
    qv_context context;
    assert_int_equal(qv_init(&context, &scene), QV_OK);
    assert_int_equal(qv_render_some(&image, &progress, &context, &one_pixel, 1), QV_OK);
    assert_int_equal(progress.samples, samples);
    assert_int_equal(progress.terminated, terminated);
    assert_int_equal(pixel[0], pixel[3]);
    if (opacity == 255)
        assert_int_equal(pixel[3], 255);
}

static void S119_end_of_a_ray(void **state)
{
    (void)state;
    expect_end(128, 6554, 4, 1);
    expect_end(128, 0, 8, 0);
    expect_end(255, 0, 1, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S115_associated_entries),
        cmocka_unit_test(S116_ends_of_rows),
        cmocka_unit_test(S117_under),
        cmocka_unit_test(S118_over),
        cmocka_unit_test(S119_end_of_a_ray),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
