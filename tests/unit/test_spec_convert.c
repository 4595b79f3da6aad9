/*
 * The worked examples S45 .. S50 of tests/SPEC.md: entries with extinction. The same
 * inputs and results as there, written out.
 */
#include "check.h"
#include "qvol.h"

#define RGBA8  QV_STORAGE_RGBA8
#define RGBA16 QV_STORAGE_RGBA16
#define RGBT8  QV_STORAGE_RGBT8
#define RGBT16 QV_STORAGE_RGBT16

typedef qv_status converter(void *, size_t, uint8_t, uint32_t, const qv_entries *);

/* One value of the fourth channel and what becomes of it. */
typedef struct example {
    uint8_t from, to;
    uint16_t value;
    uint32_t number, other;
    uint16_t result;
} example;

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static void expect_examples(converter *convert, const example *examples, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const example *e = &examples[i];
        uint16_t wide[4] = {0, 0, 0, e->value}, result[4];
        uint8_t narrow[4] = {0, 0, 0, (uint8_t)e->value};
        const int is_wide = e->from == RGBA16 || e->from == RGBT16;
        const int to_wide = e->to == RGBA16 || e->to == RGBT16;
        const qv_entries entry = {is_wide ? (const uint8_t *)wide : narrow, 1, e->number, e->number,
                                  e->from};
        assert_int_equal(convert(result, sizeof result, e->to, e->other, &entry), QV_OK);
        assert_int_equal(to_wide ? result[3] : ((const uint8_t *)result)[3], e->result);
    }
}

static void S45_opacity_to_extinction(void **state)
{
    static const example examples[] = {{RGBA16, RGBT16, 12345, 65536, 1114112, 1161},
                                       {RGBA16, RGBT16, 12345, 98304, 30001, 28738},
                                       {RGBA16, RGBT16, 1, 98304, 30001, 2},
                                       {RGBA16, RGBT16, 65534, 65536, 1114112, 61680},
                                       {RGBA16, RGBT16, 65535, 65536, 1114112, 65535},
                                       {RGBA16, RGBT16, 65535, 65536, 16777216, 16384},
                                       {RGBA16, RGBT16, 1, 3, 1000000, 2065},
                                       {RGBA8, RGBT8, 128, 65536, 589824, 28},
                                       {RGBA8, RGBT16, 128, 65536, 589824, 7323}};
    (void)state;
    expect_examples(qv_opacity_to_extinction, examples, COUNT(examples));
}

static void S46_extinction_to_opacity(void **state)
{
    static const example examples[] = {{RGBT16, RGBA16, 1, 65536, 589824, 6},
                                       {RGBT16, RGBA16, 12345, 65536, 589824, 45299},
                                       {RGBT16, RGBA16, 65535, 65536, 589824, 65407},
                                       {RGBT16, RGBA16, 1, 30001, 98304, 0},
                                       {RGBT16, RGBA16, 12345, 30001, 98304, 5620},
                                       {RGBT16, RGBA16, 65535, 30001, 98304, 24819},
                                       {RGBT16, RGBA16, 1, 0xFFFFFFFF, 0xFFFFFFFF, 65535},
                                       {RGBT8, RGBA8, 128, 65536, 65536, 75}};
    (void)state;
    expect_examples(qv_extinction_to_opacity, examples, COUNT(examples));
}

static void S47_opacity_to_opacity(void **state)
{
    static const example examples[] = {{RGBA16, RGBA16, 1, 196608, 65536, 0},
                                       {RGBA16, RGBA16, 12345, 196608, 65536, 4404},
                                       {RGBA16, RGBA16, 65534, 196608, 65536, 63910},
                                       {RGBA16, RGBA16, 65535, 196608, 65536, 65535},
                                       {RGBA16, RGBA16, 1, 0x80000001, 0xFFFFFFFF, 2},
                                       {RGBA16, RGBA16, 12345, 0x80000001, 0xFFFFFFFF, 22365},
                                       {RGBA16, RGBA16, 65534, 0x80000001, 0xFFFFFFFF, 65535},
                                       {RGBA16, RGBA16, 65535, 0x80000001, 0xFFFFFFFF, 65535},
                                       {RGBA16, RGBA16, 1, 1, 0xFFFFFFFF, 65535}};
    (void)state;
    expect_examples(qv_opacity_to_opacity, examples, COUNT(examples));
}

static void S48_extinction_to_extinction(void **state)
{
    static const example examples[] = {{RGBT16, RGBT16, 1, 98304, 65536, 2},
                                       {RGBT16, RGBT16, 12345, 98304, 65536, 18518},
                                       {RGBT16, RGBT16, 65534, 98304, 65536, 65535},
                                       {RGBT16, RGBT16, 1, 0x80000001, 0xFFFFFFFF, 1},
                                       {RGBT16, RGBT16, 12345, 0x80000001, 0xFFFFFFFF, 6173},
                                       {RGBT16, RGBT16, 65534, 0x80000001, 0xFFFFFFFF, 32767},
                                       {RGBT16, RGBT16, 3, 65536, 131072, 2},
                                       {RGBT16, RGBT16, 32767, 65536, 131072, 16384},
                                       {RGBT16, RGBT16, 1, 0xFFFFFFFF, 1, 65535},
                                       {RGBT16, RGBT8, 33025, 65536, 65536, 129}};
    (void)state;
    expect_examples(qv_extinction_to_extinction, examples, COUNT(examples));
}

static void S49_least_extinction(void **state)
{
    static const uint16_t opacities[3][4] = {{0, 0, 0, 12345}, {0, 0, 0, 65534}, {0, 0, 0, 65535}};
    static const struct {
        uint32_t unit, n, opaque, result;
    } examples[] = {{65536, 0, 0, 1},       {65536, 1, 0, 19734},   {65536, 2, 0, 1048575},
                    {65536, 3, 0, 4194304}, {98304, 0, 0, 1},       {98304, 1, 0, 13156},
                    {98304, 2, 0, 699050},  {98304, 3, 0, 2796203}, {98304, 3, 589824, 699050},
                    {3, 0, 0, 1},           {3, 1, 0, 431086686},   {3, 2, 0, 4294967295},
                    {3, 3, 0, 4294967295}};
    (void)state;
    for (size_t i = 0; i < COUNT(examples); i++) {
        const qv_entries entries = {(const uint8_t *)opacities, examples[i].n, examples[i].unit, 0,
                                    RGBA16};
        uint32_t extinction = 0;
        assert_int_equal(qv_extinction_of(&extinction, &entries, examples[i].opaque), QV_OK);
        assert_int_equal(extinction, examples[i].result);
    }
}

static void S50_mixture(void **state)
{
    static const qv_material materials[] = {{{65535, 0, 1000}, 262144}, {{0, 40000, 65535}, 98304}};
    static const uint16_t percentages[] = {10000, 20000}, voxel[] = {37449, 17143, 28658, 17500};
    static const uint64_t light[] = {171796070400000, 78643200000000, 131468492800000};
    qv_mixture mixture;
    uint16_t result[4];
    (void)state;
    assert_int_equal(qv_mix(&mixture, materials, percentages, 2), QV_OK);
    assert_true(mixture.extinction == 4587520000);
    assert_memory_equal(mixture.light, light, sizeof light);
    qv_mixture_to_voxel(result, &mixture, 262144);
    assert_memory_equal(result, voxel, sizeof voxel);
    qv_mixture_to_voxel(result, &mixture, 65536);
    assert_int_equal(result[3], 65535);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S45_opacity_to_extinction), cmocka_unit_test(S46_extinction_to_opacity),
        cmocka_unit_test(S47_opacity_to_opacity),    cmocka_unit_test(S48_extinction_to_extinction),
        cmocka_unit_test(S49_least_extinction),      cmocka_unit_test(S50_mixture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
