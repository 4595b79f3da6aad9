/*
 * The worked examples S57 .. S61 and S63 of tests/SPEC.md: samples and their light in the
 * modes that weigh by length. The same inputs and results as there, written out.
 */
#include "check.h"
#include "bspline.h"
#include "correct.h"
#include "march_levels.h"

#define VOXEL INT64_C(0x100000000)

#define expect_vector(v, x, y, z)                                                                  \
    do {                                                                                           \
        assert_int_equal((v)[0], x);                                                               \
        assert_int_equal((v)[1], y);                                                               \
        assert_int_equal((v)[2], z);                                                               \
    } while (0)

/* ---- The medium --------------------------------------------------------------- */

typedef qv_status preparation(qv_medium *medium, const qv_scene *scene, unsigned levels);

/* The medium of a step in S57. */
static qv_medium medium_of(preparation *prepare, uint8_t storage, unsigned levels)
{
    qv_medium medium;
    const qv_scene scene = {
        .volume = {.storage = storage, .unit_distance = 32768, .extinction = 123456},
        .camera = {.step = 49152}};
    assert_int_equal(prepare(&medium, &scene, levels), QV_OK);
    return medium;
}

static void expect_medium(const qv_medium *medium, uint64_t depth, uint32_t light, uint32_t shift)
{
    assert_int_equal(medium->depth, depth);
    assert_int_equal(medium->light, light);
    assert_int_equal(medium->light_shift, shift);
}

/* The medium of a piece of a step. */
static qv_medium scaled(const qv_medium *step, uint32_t length)
{
    qv_medium piece;
    qv_medium_scale(&piece, step, length);
    return piece;
}

static void S57_corrected(void **state)
{
    const qv_medium step = medium_of(qv_medium_corrected, QV_STORAGE_RGBA8, 0);
    const qv_medium levels = medium_of(qv_medium_corrected, QV_STORAGE_RGBA8, 3);
    const qv_medium piece = scaled(&step, 12346);
    (void)state;
    expect_medium(&step, 0x180000000, 0xC0000000, 1);
    expect_medium(&levels, 0x180000000, 0x18000000, 4);
    expect_medium(&piece, 0x48570000, 0x242B8000, 1);
}

static void S57_extinction(void **state)
{
    const qv_medium narrow = medium_of(qv_medium_extinction, QV_STORAGE_RGBT8, 0);
    const qv_medium wide = medium_of(qv_medium_extinction, QV_STORAGE_INDEXED8_T16, 0);
    const qv_medium pieces[2] = {scaled(&narrow, 12346), scaled(&wide, 12346)};
    (void)state;
    expect_medium(&narrow, 0x16B1B1B1B19, 0x7D59F11E, 1);
    expect_medium(&wide, 0x169B169B0, 0x7D59F11E, 1);
    expect_medium(&pieces[0], 0x4467593938, 0x179D4396, 1);
    expect_medium(&pieces[1], 0x44233602, 0x179D4396, 1);
}

static void S57_converted(void **state)
{
    const qv_medium step = medium_of(qv_medium_converted, QV_STORAGE_RGBA16, 0);
    const qv_medium levels = medium_of(qv_medium_converted, QV_STORAGE_RGBA16, 3);
    const qv_medium piece = scaled(&step, 12346);
    (void)state;
    expect_medium(&step, 0xC000001800, 0x851591FA, 7);
    expect_medium(&levels, 0xC000001800, 0x10A2B23F, 10);
    expect_medium(&piece, 0x242B800485, 0x19123241, 7);
}

/* ---- Samples ------------------------------------------------------------------ */

enum { MOST_ENTRIES = 27, X = 85, Y = 170, Z = 3 };

/* Entries side by side, as 8 and as 16 bits. */
typedef struct entries {
    uint8_t narrow[MOST_ENTRIES][4];
    uint16_t wide[MOST_ENTRIES][4];
} entries;

static void set_entry(entries *all, unsigned q, const unsigned rgba[4])
{
    for (unsigned c = 0; c < 4; c++) {
        all->narrow[q][c] = (uint8_t)rgba[c];
        all->wide[q][c] = (uint16_t)(257 * rgba[c] + q);
    }
}

/* The corners of S18 and S19. */
static entries corners(void)
{
    entries all;
    for (unsigned q = 0; q < 8; q++) {
        const unsigned rgba[4] = {10 * q + 1, 255 - 30 * q, 7 * q * q % 256, (37 * q + 5) % 256};
        set_entry(&all, q, rgba);
    }
    return all;
}

/* The same with other opacities. */
static entries corners_of(uint8_t narrow, uint16_t wide, int only)
{
    entries all = corners();
    for (int q = 0; q < 8; q++) {
        all.narrow[q][3] = only < 0 || q == only ? narrow : 0;
        all.wide[q][3] = only < 0 || q == only ? wide : 0;
    }
    return all;
}

static entries cube(void)
{
    entries all;
    for (unsigned q = 0; q < 27; q++) {
        const unsigned rgba[4] = {9 * q + 1, 255 - 9 * q, 7 * q * q % 256, (37 * q + 5) % 256};
        set_entry(&all, q, rgba);
    }
    return all;
}

/* Samples entries as a volume of so many voxels an axis at a place. */
static qv_sample sample_at(qv_mode *mode, unsigned storage, const entries *all, uint16_t side,
                           const qv_ray *ray)
{
    const int32_t entry = (int32_t)qv_entry_bytes(storage);
    const qv_address narrow = all->narrow[0], wide = (qv_address)all->wide;
    const qv_volume volume = {.voxels = storage == QV_STORAGE_RGBA8 ? narrow : wide,
                              .size = {side, side, side},
                              .stride = {entry, side * entry, side * side * entry},
                              .storage = (uint8_t)storage};
    qv_sample sample = {.scale = 0};
    assert_true(mode(&sample, ray, &volume, storage));
    return sample;
}

static qv_sample sample_corners(qv_mode *mode, unsigned storage, const entries *all)
{
    const qv_ray ray = {.place = {X * (VOXEL / 256), Y * (VOXEL / 256), Z * (VOXEL / 256)}};
    return sample_at(mode, storage, all, 2, &ray);
}

static qv_sample sample_cube(qv_mode *mode, unsigned storage, int64_t i, int64_t j)
{
    const entries all = cube();
    const qv_ray ray = {.place = {i * VOXEL - VOXEL / 2 + X * (VOXEL / 256),
                                  j * VOXEL - VOXEL / 2 + Y * (VOXEL / 256),
                                  VOXEL / 2 + Z * (VOXEL / 256)}};
    return sample_at(mode, storage, &all, 3, &ray);
}

static void expect_sample(const qv_sample *sample, uint32_t opacity, uint32_t red, uint32_t green,
                          uint32_t blue)
{
    assert_int_equal(fx_share_bits(sample->opacity), opacity);
    assert_int_equal(fx_sum_bits(sample->light[0]), red);
    assert_int_equal(fx_sum_bits(sample->light[1]), green);
    assert_int_equal(fx_sum_bits(sample->light[2]), blue);
}

static void expect_scaled(const qv_sample *sample, unsigned scale, uint32_t opacity, uint32_t red,
                          uint32_t green, uint32_t blue)
{
    assert_int_equal(sample->scale, scale);
    expect_sample(sample, opacity, red, green, blue);
}

static void expect_row(const fx_weight row[3], uint32_t low, uint32_t middle, uint32_t high)
{
    assert_int_equal(fx_weight_bits(row[0]), low);
    assert_int_equal(fx_weight_bits(row[1]), middle);
    assert_int_equal(fx_weight_bits(row[2]), high);
}

static qv_triple taps_of(uint32_t f)
{
    const qv_triple triple = {.tap = {fx_tap_of_square(256 - f), fx_tap_of_square(f)}};
    return triple;
}

static void S58_weights(void **state)
{
    static const uint32_t expected[3][3] = {{403, 1303, 100}, {5408, 17498, 1336}, {0, 1, 0}};
    const qv_triple x = taps_of(X), y = taps_of(Y), z = taps_of(Z);
    fx_weight slice[3], row[3], voxel[3];
    (void)state;
    qv_part_one(slice, &z);
    for (unsigned v = 0; v < 3; v++) {
        qv_part(row, slice[v], &y);
        qv_part(voxel, row[v], &x);
        expect_row(voxel, expected[v][0], expected[v][1], expected[v][2]);
    }
}

static void S58_samples(void **state)
{
    const qv_sample samples[4] = {sample_cube(qv_bspline_weighted, QV_STORAGE_RGBA8, 1, 1),
                                  sample_cube(qv_bspline_weighted, QV_STORAGE_RGBA16, 1, 1),
                                  sample_cube(qv_bspline_weighted, QV_STORAGE_RGBA8, 0, 2),
                                  sample_cube(qv_bspline_weighted, QV_STORAGE_RGBA16, 0, 2)};
    (void)state;
    expect_sample(&samples[0], 9756160, 840743962, 1656832998, 1403998212);
    expect_sample(&samples[1], 2507918336, 847926630, 1670512607, 1415642967);
    expect_sample(&samples[2], 8656286, 620389922, 1595619294, 1790298216);
    expect_sample(&samples[3], 2225353060, 625818203, 1608760976, 1804843210);
}

static void expect_converted(const entries *all, const uint32_t narrow[5], const uint32_t wide[5])
{
    const qv_sample of8 = sample_corners(qv_sample_converted, QV_STORAGE_RGBA8, all);
    const qv_sample of16 = sample_corners(qv_sample_converted, QV_STORAGE_RGBA16, all);
    expect_scaled(&of8, narrow[0], narrow[1], narrow[2], narrow[3], narrow[4]);
    expect_scaled(&of16, wide[0], wide[1], wide[2], wide[3], wide[4]);
}

static void S59_extinction_of_opacity(void **state)
{
    static const uint32_t expected[3][2][5] = {{{4, 259292564, 26218535, 183683441, 50138242},
                                                {4, 259327511, 26232347, 183716597, 50156986}},
                                               {{13, 339552197, 41278264, 219706892, 83888086},
                                                {21, 337260096, 41015059, 218239229, 83337249}},
                                               {{0, 2147483647, 152176894, 1716184317, 242817710},
                                                {0, 2147483647, 152232831, 1716240254, 242873647}}};
    const entries all[3] = {corners(), corners_of(1, 1, 3), corners_of(255, 65535, -1)};
    (void)state;
    for (unsigned i = 0; i < 3; i++)
        expect_converted(&all[i], expected[i][0], expected[i][1]);
}

static void S59_by_bspline(void **state)
{
    const qv_sample narrow = sample_cube(qv_bspline_converted, QV_STORAGE_RGBA8, 1, 1);
    const qv_sample wide = sample_cube(qv_bspline_converted, QV_STORAGE_RGBA16, 1, 1);
    (void)state;
    expect_scaled(&narrow, 4, 903113737, 328307249, 578334255, 541295217);
    expect_scaled(&wide, 4, 903684383, 328694611, 578800798, 541786005);
}

/* ---- Light -------------------------------------------------------------------- */

static void expect_corrected(const qv_sample *sample, unsigned storage, uint32_t length,
                             const uint32_t expected[4])
{
    const qv_medium step = medium_of(qv_medium_corrected, (uint8_t)storage, 0);
    const qv_medium piece = scaled(&step, length);
    uint32_t colour[3];
    assert_int_equal(qv_correct(colour, sample, &piece, storage), expected[0]);
    expect_vector(colour, expected[1], expected[2], expected[3]);
}

static void S60_corrected(void **state)
{
    static const uint32_t narrow[3][4] = {{1586949590, 152365934, 1136002207, 272846001},
                                          {357429200, 34317431, 255862168, 61453198},
                                          {1136888286, 109154728, 813830287, 195466468}};
    static const uint32_t wide[2][4] = {{1587093484, 153630488, 1145053861, 275065057},
                                        {357468616, 34602925, 257905926, 61954210}};
    const entries all = corners();
    const qv_sample of8 = sample_corners(qv_sample_weighted, QV_STORAGE_RGBA8, &all);
    const qv_sample of16 = sample_corners(qv_sample_weighted, QV_STORAGE_RGBA16, &all);
    (void)state;
    expect_corrected(&of8, QV_STORAGE_RGBA8, 65536, narrow[0]);
    expect_corrected(&of8, QV_STORAGE_RGBA8, 12346, narrow[1]);
    expect_corrected(&of8, QV_STORAGE_RGBA8, 43690, narrow[2]);
    expect_corrected(&of16, QV_STORAGE_RGBA16, 65536, wide[0]);
    expect_corrected(&of16, QV_STORAGE_RGBA16, 12346, wide[1]);
}

static void S60_nearly_opaque(void **state)
{
    static const uint32_t expected[4] = {4247781048u, 4247715737u, 2123857868, 0};
    const qv_sample sample = {
        .opacity = fx_share_of(4294901260u),
        .light = {fx_sum_of(4294901260u), fx_sum_of(2147450630), fx_sum_of(1)}};
    (void)state;
    expect_corrected(&sample, QV_STORAGE_RGBA16, 12346, expected);
}

/* Composites three pieces of one sample, then compares colours, transmittance and depth. */
static void expect_gathered(const qv_sample *sample, const qv_medium *step, int back,
                            const uint64_t expected[5])
{
    static const uint32_t lengths[3] = {12346, 65536, 30000};
    qv_light light = {.transmittance = QV_CLEAR};
    qv_gathered gathered = {.depth = 0};
    for (unsigned i = 0; i < 3; i++) {
        const qv_medium piece = scaled(step, lengths[i]);
        if (back)
            qv_extinction_over(&light, &gathered, sample, &piece, 0);
        else
            qv_extinction_under(&light, &gathered, sample, &piece, 0);
    }
    if (!back)
        qv_gathered_light(&light, &gathered, step);
    expect_vector(light.colour, expected[0], expected[1], expected[2]);
    assert_int_equal(light.transmittance, expected[3]);
    assert_int_equal(gathered.depth, expected[4]);
}

static void S61_stored_extinction(void **state)
{
    static const uint64_t narrow[2][5] = {{71619873, 533979822, 128251739, 1401535279, 0x9D9A85EE},
                                          {71619873, 533979824, 128251739, 1401535279, 0x9D9A85EE}};
    static const uint64_t wide[2][5] = {{72213428, 538228223, 129293286, 1401476428, 0x9D9E7E4C},
                                        {72213428, 538228224, 129293286, 1401476428, 0x9D9E7E4C}};
    const entries all = corners();
    const qv_sample of8 = sample_corners(qv_sample_weighted, QV_STORAGE_RGBA8, &all);
    const qv_sample of16 = sample_corners(qv_sample_weighted, QV_STORAGE_RGBA16, &all);
    const qv_medium step8 = medium_of(qv_medium_extinction, QV_STORAGE_RGBT8, 0);
    const qv_medium step16 = medium_of(qv_medium_extinction, QV_STORAGE_RGBT16, 0);
    (void)state;
    for (int back = 0; back < 2; back++) {
        expect_gathered(&of8, &step8, back, narrow[back]);
        expect_gathered(&of16, &step16, back, wide[back]);
    }
}

static void S61_stored_opacity(void **state)
{
    static const uint64_t narrow[2][5] = {{61069030, 427841207, 116783559, 939579020, 0x1314BA929},
                                          {61069028, 427841204, 116783557, 939579020, 0x1314BA929}};
    static const uint64_t wide[2][5] = {{61098261, 427897843, 116821596, 939474346, 0x1315631C9},
                                        {61098259, 427897839, 116821594, 939474346, 0x1315631C9}};
    const entries all = corners();
    const qv_sample of8 = sample_corners(qv_sample_converted, QV_STORAGE_RGBA8, &all);
    const qv_sample of16 = sample_corners(qv_sample_converted, QV_STORAGE_RGBA16, &all);
    const qv_medium step = medium_of(qv_medium_converted, QV_STORAGE_RGBA8, 0);
    (void)state;
    for (int back = 0; back < 2; back++) {
        expect_gathered(&of8, &step, back, narrow[back]);
        expect_gathered(&of16, &step, back, wide[back]);
    }
}

/* ---- Levels ------------------------------------------------------------------- */

static void S63_blended_samples(void **state)
{
    const entries all = corners(), one = corners_of(1, 1, 3);
    qv_sample weighted = sample_corners(qv_sample_weighted, QV_STORAGE_RGBA8, &all);
    const qv_sample nearest = sample_corners(qv_sample_nearest, QV_STORAGE_RGBA8, &all);
    qv_sample converted = sample_corners(qv_sample_converted, QV_STORAGE_RGBA8, &all);
    const qv_sample thin = sample_corners(qv_sample_converted, QV_STORAGE_RGBA8, &one);
    qv_sample nothing;
    (void)state;
    qv_clear_sample(&nothing);
    qv_blend_samples(&weighted, &nearest, 0x12345678);
    expect_sample(&weighted, 4477274, 109125445, 827760329, 191877679);
    qv_blend_samples(&converted, &thin, 0x12345678);
    expect_scaled(&converted, 4, 240901142, 24359839, 170652022, 46584507);
    qv_blend_samples(&nothing, &thin, 0x80000000u);
    expect_scaled(&nothing, 13, 169776099, 20639132, 109853446, 41944043);
    assert_int_equal(qv_blend_sums(65536 * 255, 65536 * 255, 32768),
                     16711680); /* both products tie */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S57_corrected),      cmocka_unit_test(S57_extinction),
        cmocka_unit_test(S57_converted),      cmocka_unit_test(S58_weights),
        cmocka_unit_test(S58_samples),        cmocka_unit_test(S59_extinction_of_opacity),
        cmocka_unit_test(S59_by_bspline),     cmocka_unit_test(S60_corrected),
        cmocka_unit_test(S60_nearly_opaque),  cmocka_unit_test(S61_stored_extinction),
        cmocka_unit_test(S61_stored_opacity), cmocka_unit_test(S63_blended_samples),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
