/*
 * Conversions between opacity and extinction, against double precision: every value of
 * the fourth channel, for lengths and extinctions from the least to the greatest.
 */
#include "check.h"
#include "deviation.h"
#include "qvol.h"

#include <string.h>

#define VALUES       65536u
#define COUNT(array) (sizeof(array) / sizeof(array)[0])

#define MOST_OFF   0.51L
#define DEPTH_OFF  0x1p-27L /* of the depth of an opacity */
#define FULL_DEPTH 64.0L

typedef qv_status converter(void *, size_t, uint8_t, uint32_t, const qv_entries *);

/* A conversion and the 8-bit storage of its two kinds; the next one has 16 bits. */
typedef struct conversion {
    converter *convert;
    uint8_t from, to;
    const char *name;
} conversion;

enum { TO_EXTINCTION, TO_OPACITY, OTHER_UNIT, OTHER_EXTINCTION, CONVERSIONS };

static const conversion conversions[CONVERSIONS] = {
    {qv_opacity_to_extinction, QV_STORAGE_RGBA8, QV_STORAGE_RGBT8, "opacity to extinction"},
    {qv_extinction_to_opacity, QV_STORAGE_RGBT8, QV_STORAGE_RGBA8, "extinction to opacity"},
    {qv_opacity_to_opacity, QV_STORAGE_RGBA8, QV_STORAGE_RGBA8, "another unit distance"},
    {qv_extinction_to_extinction, QV_STORAGE_RGBT8, QV_STORAGE_RGBT8, "another extinction"},
};

/* Unit distances and extinctions, Q16.16: both ends, odd ones, usual ones. */
static const uint32_t numbers[] = {1, 977, 65536, 1114112, 0x80000001, 0xFFFFFFFF};

typedef union entries {
    uint16_t wide[VALUES][4];
    uint8_t narrow[2 * VALUES][4];
} entries;

static entries source, result;

static int is_wide(unsigned storage)
{
    return storage == QV_STORAGE_RGBA16 || storage == QV_STORAGE_RGBT16;
}

static uint32_t values_of(unsigned storage)
{
    return is_wide(storage) ? 65536 : 256;
}

static unsigned fourth(const entries *e, uint32_t i, unsigned storage)
{
    return is_wide(storage) ? e->wide[i][3] : e->narrow[i][3];
}

static void set_entry(entries *e, uint32_t i, unsigned storage, unsigned colour, unsigned value)
{
    for (unsigned c = 0; c < 4; c++)
        if (is_wide(storage))
            e->wide[i][c] = (uint16_t)(c < 3 ? colour + c : value);
        else
            e->narrow[i][c] = (uint8_t)(c < 3 ? colour + c : value);
}

/* Every value of the fourth channel, with other colours at each. */
static qv_entries all_values(unsigned storage, uint32_t number)
{
    const qv_entries all = {source.narrow[0], values_of(storage), number, number, (uint8_t)storage};
    for (uint32_t i = 0; i < all.count; i++)
        set_entry(&source, i, storage, i * 7, i);
    return all;
}

/* The depth of an opacity that is not full. */
static long double depth_of(long double opacity)
{
    return -log1pl(-opacity) / logl(2);
}

static long double opacity_of(long double depth)
{
    return -expm1l(-depth * logl(2));
}

/* What becomes of a stored value, all of 0 .. 1; an opacity's depth is off by `off`. */
static long double exact(unsigned which, long double v, uint32_t from, uint32_t to, long double off)
{
    const long double full = ldexpl(from, -16) * ldexpl(to, -16);
    const long double depth = v == 1 ? FULL_DEPTH : depth_of(v) + (v == 0 ? 0 : off);
    switch (which) {
    case TO_EXTINCTION:
        return fminl(1, depth / full);
    case TO_OPACITY:
        return opacity_of(v * full);
    case OTHER_UNIT:
        return v == 1 ? 1 : opacity_of(depth * to / from);
    default:
        return fminl(1, v * from / to);
    }
}

/* The result's deviation from what a depth within DEPTH_OFF would give. */
static long double deviation_of(unsigned which, long double v, uint32_t from, uint32_t to,
                                long double got, long double full)
{
    const int opacity = conversions[which].from == QV_STORAGE_RGBA8;
    const long double low = exact(which, v, from, to, opacity ? -DEPTH_OFF : 0) * full;
    const long double high = opacity ? exact(which, v, from, to, DEPTH_OFF) * full : low;
    if (got > high)
        return got - high;
    return got < low ? got - low : 0;
}

/* Every value of a storage to another; the results never fall. */
static void compare_all(deviation *worst, unsigned which, unsigned from, unsigned to,
                        const uint32_t number[2])
{
    const conversion *c = &conversions[which];
    const qv_entries all = all_values(from, number[0]);
    unsigned before = 0;
    memset(&result, 0xA5, sizeof result);
    assert_int_equal(c->convert(&result, sizeof result, (uint8_t)to, number[1], &all), QV_OK);
    for (uint32_t i = 0; i < all.count; i++) {
        const unsigned got = fourth(&result, i, to);
        const long double off = deviation_of(which, i / (values_of(from) - 1.0L), number[0],
                                             number[1], got, values_of(to) - 1.0L);
        deviation_add(worst, off, 0);
        if (fabsl(off) > MOST_OFF || got < before)
            fail_msg("%s, %u of storage %u to %u, %u to %u: %u is %.4Lf off", c->name, i, from, to,
                     number[0], number[1], got, off);
        before = got;
    }
    assert_int_equal(fourth(&result, 0, to), 0);
}

static void every_value(unsigned which)
{
    const conversion *c = &conversions[which];
    deviation worst = {0, 0, 0, 0};
    for (size_t i = 0; i < COUNT(numbers); i++)
        for (size_t j = 0; j < COUNT(numbers); j++) {
            const uint32_t number[2] = {numbers[i], numbers[j]};
            for (unsigned width = 0; width < 4; width++)
                compare_all(&worst, which, c->from + (width >> 1), c->to + (width & 1u), number);
        }
    printf("# %s: at most %.4f of the last place off\n", c->name, worst.worst);
}

static void opacity_to_extinction(void **state)
{
    (void)state;
    every_value(TO_EXTINCTION);
}

static void extinction_to_opacity(void **state)
{
    (void)state;
    every_value(TO_OPACITY);
}

static void another_unit_distance(void **state)
{
    (void)state;
    every_value(OTHER_UNIT);
}

static void another_extinction(void **state)
{
    (void)state;
    every_value(OTHER_EXTINCTION);
}

/* Full values: kept but where the text of qvol.h has a number for them. */
static void full_values(void **state)
{
    const uint16_t full[4] = {1, 2, 3, 65535};
    const uint8_t *bytes = (const uint8_t *)full;
    const uint32_t one = QV_ONE_Q16;
    uint16_t to[4];
    qv_entries from = {bytes, 1, one, one, QV_STORAGE_RGBA16};
    (void)state;
    for (uint32_t e = 1; e <= 64; e++) {
        assert_int_equal(qv_opacity_to_extinction(to, 8, QV_STORAGE_RGBT16, e * one, &from), QV_OK);
        assert_int_equal(to[3], 65535);
    }
    assert_int_equal(qv_opacity_to_extinction(to, 8, QV_STORAGE_RGBT16, 256 * one, &from), QV_OK);
    assert_int_equal(to[3], 16384); /* 65535 * 64 / 256 */
    for (size_t i = 0; i < COUNT(numbers); i++) {
        assert_int_equal(qv_opacity_to_opacity(to, 8, QV_STORAGE_RGBA16, numbers[i], &from), QV_OK);
        assert_int_equal(to[3], 65535);
    }
    from.storage = QV_STORAGE_RGBT16;
    for (uint32_t e = 1; e <= 65536; e *= 2) {
        assert_int_equal(qv_extinction_to_extinction(to, 8, QV_STORAGE_RGBT16, e, &from), QV_OK);
        assert_int_equal(to[3], 65535);
    }
    for (uint32_t depth = 1; depth <= 64; depth++) {
        assert_int_equal(qv_extinction_to_opacity(to, 8, QV_STORAGE_RGBA16, depth * one, &from),
                         QV_OK);
        assert_int_equal(to[3] == 65535, depth >= 17);
    }
}

/* Depths of 2^32 and more: the ratio times the depth of 65534 passes 2^64 here. */
static void enormous_ratios(void **state)
{
    const uint16_t most[4] = {1, 2, 3, 65534};
    const qv_entries from = {(const uint8_t *)most, 1, 1, 1, QV_STORAGE_RGBA16};
    uint16_t to[4];
    (void)state;
    for (uint32_t ratio = 1u << 28; ratio < (1u << 28) + 1000; ratio++) {
        assert_int_equal(qv_opacity_to_opacity(to, 8, QV_STORAGE_RGBA16, ratio, &from), QV_OK);
        assert_int_equal(to[3], 65535);
    }
}

/* With the same number, conversions within a kind only change the width. */
static void same_number_keeps_the_value(void **state)
{
    (void)state;
    for (unsigned which = OTHER_UNIT; which <= OTHER_EXTINCTION; which++)
        for (size_t i = 0; i < COUNT(numbers); i++) {
            const unsigned wide = conversions[which].to + 1u;
            const qv_entries all = all_values(wide, numbers[i]);
            assert_int_equal(
                conversions[which].convert(&result, sizeof result, (uint8_t)wide, numbers[i], &all),
                QV_OK);
            assert_memory_equal(&result, &source, sizeof source);
        }
}

/* a / n to nearest; n is odd, a at most 65535^2. */
static unsigned nearest(unsigned a, unsigned n)
{
    return (a + n / 2) / n;
}

static void colours_are_rounded(void **state)
{
    (void)state;
    for (unsigned which = 0; which < CONVERSIONS; which++)
        for (unsigned width = 0; width < 4; width++) {
            const conversion *c = &conversions[which];
            const unsigned from = c->from + (width >> 1), to = c->to + (width & 1u);
            const qv_entries all = all_values(from, QV_ONE_Q16);
            assert_int_equal(c->convert(&result, sizeof result, (uint8_t)to, 65536, &all), QV_OK);
            for (uint32_t i = 0; i < 3 * all.count; i++) {
                const unsigned at = i / 3, channel = i % 3;
                const unsigned was =
                    is_wide(from) ? source.wide[at][channel] : source.narrow[at][channel];
                const unsigned is =
                    is_wide(to) ? result.wide[at][channel] : result.narrow[at][channel];
                assert_int_equal(is, nearest(was * (values_of(to) - 1), values_of(from) - 1));
            }
        }
}

/* Over the source, and at an odd address, where the target is no wider. */
static void in_place_and_unaligned(void **state)
{
    static const uint8_t widths[][2] = {{0, 0}, {1, 1}, {1, 0}};
    static uint8_t odd[sizeof(entries) + 1];
    (void)state;
    for (unsigned which = 0; which < CONVERSIONS; which++)
        for (size_t w = 0; w < COUNT(widths); w++) {
            const conversion *c = &conversions[which];
            const uint8_t to = (uint8_t)(c->to + widths[w][1]);
            const qv_entries all = all_values(c->from + widths[w][0], 65536);
            const size_t bytes = all.count * (is_wide(to) ? 8u : 4u);
            assert_int_equal(c->convert(&result, bytes, to, 98304, &all), QV_OK);
            assert_int_equal(c->convert(odd + 1, bytes, to, 98304, &all), QV_OK);
            assert_memory_equal(odd + 1, &result, bytes);
            assert_int_equal(c->convert(&source, bytes, to, 98304, &all), QV_OK);
            assert_memory_equal(&source, &result, bytes);
        }
}

/* There and back: the greatest difference of an opacity from what it was. */
static unsigned there_and_back(unsigned opacity, unsigned extinction, uint32_t full, uint32_t end)
{
    static entries back;
    const qv_entries all = all_values(opacity, QV_ONE_Q16);
    const qv_entries converted = {result.narrow[0], end, full, full, (uint8_t)extinction};
    unsigned most = 0;
    assert_int_equal(
        qv_opacity_to_extinction(&result, sizeof result, (uint8_t)extinction, full, &all), QV_OK);
    assert_int_equal(
        qv_extinction_to_opacity(&back, sizeof back, (uint8_t)opacity, QV_ONE_Q16, &converted),
        QV_OK);
    for (uint32_t i = 0; i < end; i++) {
        const unsigned now = fourth(&back, i, opacity);
        const unsigned off = now > i ? now - i : i - now;
        most = off > most ? off : most;
    }
    return most;
}

/*
 * What survives. A place of extinction is full / 65535 of depth, and opacity rises by at
 * most ln 2 of it: 16-bit opacities survive where the full value's depth is at most 1.44
 * = 1 / ln 2 less a little (opacities up to .62). 8-bit ones survive in 16 bits with
 * every full depth up to 64, and the full one with 9 or more, where 1 - 2^-9 rounds to 1.
 */
static void round_trips(void **state)
{
    (void)state;
    for (uint32_t full = QV_ONE_Q16 / 8; full <= QV_ONE_Q16 * 7 / 5; full += QV_ONE_Q16 / 8) {
        const uint32_t end = (uint32_t)(65535 * opacity_of(full / 65536.0L));
        assert_int_equal(there_and_back(QV_STORAGE_RGBA16, QV_STORAGE_RGBT16, full, end), 0);
    }
    for (uint32_t full = 9; full <= 64; full++)
        assert_int_equal(
            there_and_back(QV_STORAGE_RGBA8, QV_STORAGE_RGBT16, full * QV_ONE_Q16, 256), 0);
    for (uint32_t full = 8; full <= 64; full *= 2)
        printf("# there and back with a full depth of %u: 16 bits %u of 65535, 8 bits %u of 255\n",
               full, there_and_back(QV_STORAGE_RGBA16, QV_STORAGE_RGBT16, full * QV_ONE_Q16, 65279),
               there_and_back(QV_STORAGE_RGBA8, QV_STORAGE_RGBT8, full * QV_ONE_Q16, 255));
}

/* Nothing may be written; the target is full of 0xA5. */
static void refused(unsigned which, qv_status error, const qv_entries *from, size_t bytes,
                    unsigned to, uint32_t number)
{
    uint8_t target[64], untouched[64];
    memset(target, 0xA5, sizeof target);
    memset(untouched, 0xA5, sizeof untouched);
    assert_int_equal(conversions[which].convert(target, bytes, (uint8_t)to, number, from), error);
    assert_memory_equal(target, untouched, sizeof target);
}

static void errors(void **state)
{
    (void)state;
    for (unsigned which = 0; which < CONVERSIONS; which++) {
        const conversion *c = &conversions[which];
        const int from_opacity = c->from == QV_STORAGE_RGBA8,
                  to_opacity = c->to == QV_STORAGE_RGBA8;
        const qv_entries good = {source.narrow[0], 3, 1, 1, (uint8_t)(c->from + 1)};
        qv_entries bad = good;
        assert_int_equal(c->convert(NULL, 24, c->to, 1, &good), QV_ERROR_NULL);
        refused(which, QV_ERROR_NULL, NULL, 24, c->to, 1);
        bad.entries = NULL;
        refused(which, QV_ERROR_NULL, &bad, 24, c->to, 1);
        bad.entries = source.narrow[0] + 1;
        refused(which, QV_ERROR_STRIDE, &bad, 24, c->to, 1);
        for (unsigned storage = 0; storage < 12; storage++) {
            bad = good;
            bad.storage = (uint8_t)storage;
            if (storage - c->from > 1)
                refused(which, QV_ERROR_STORAGE, &bad, 24, c->to, 1);
            if (storage - c->to > 1)
                refused(which, QV_ERROR_STORAGE, &good, 24, storage, 1);
        }
        bad = good;
        *(from_opacity ? &bad.unit_distance : &bad.extinction) = 0;
        refused(which, from_opacity ? QV_ERROR_UNIT : QV_ERROR_EXTINCTION, &bad, 24, c->to, 1);
        refused(which, to_opacity ? QV_ERROR_UNIT : QV_ERROR_EXTINCTION, &good, 24, c->to, 0);
        refused(which, QV_ERROR_BUFFER, &good, 11, c->to, 1);
        refused(which, QV_ERROR_BUFFER, &good, 23, c->to + 1u, 1);
        bad = good;
        bad.count = 0x20000001; /* 8 bytes of each are 2^32 + 8 */
        refused(which, QV_ERROR_BUFFER, &bad, 64, c->to + 1u, 1);
        bad.count = 0;
        refused(which, QV_OK, &bad, 0, c->to + 1u, 1);
    }
}

/* The other kind's number is not read, and 8-bit entries may lie anywhere. */
static void what_is_not_read(void **state)
{
    uint8_t memory[9] = {0, 10, 20, 30, 128}, to[4];
    const qv_entries opacity = {memory + 1, 1, 65536, 0, QV_STORAGE_RGBA8};
    const qv_entries extinction = {memory + 1, 1, 0, 65536, QV_STORAGE_RGBT8};
    (void)state;
    assert_int_equal(qv_opacity_to_extinction(to, 4, QV_STORAGE_RGBT8, 131072, &opacity), QV_OK);
    assert_int_equal(to[3], 128); /* 255 * 1.0057 / 2 */
    assert_int_equal(qv_extinction_to_opacity(to, 4, QV_STORAGE_RGBA8, 65536, &extinction), QV_OK);
    assert_int_equal(to[3], 75); /* 255 * (1 - 2^-.502) */
}

/* The extinction of one entry in place of the largest opacity. */
static uint32_t extinction_of(unsigned storage, unsigned opacity, uint32_t unit, uint32_t opaque)
{
    const qv_entries one = {source.narrow[0], 2, unit, 0, (uint8_t)storage};
    uint32_t extinction = 0;
    set_entry(&source, 0, storage, 9, opacity);
    set_entry(&source, 1, storage, 9, opacity / 2);
    assert_int_equal(qv_extinction_of(&extinction, &one, opaque), QV_OK);
    return extinction;
}

static void check_extinction(unsigned storage, unsigned opacity, uint32_t unit)
{
    const long double depth = depth_of(opacity / (values_of(storage) - 1.0L));
    const long double off = opacity == 0 ? 0 : DEPTH_OFF;
    const long double low = ceill(ldexpl(depth - off, 32) / unit);
    const long double high = ceill(ldexpl(depth + off, 32) / unit);
    const uint32_t got = extinction_of(storage, opacity, unit, 0);
    if (got < fminl(low, 0xFFFFFFFF) || got > fmaxl(1, fminl(high, 0xFFFFFFFF)))
        fail_msg("%u of storage %u, unit %u: %u, not %.0Lf .. %.0Lf", opacity, storage, unit, got,
                 low, high);
}

static void least_extinction(void **state)
{
    (void)state;
    for (size_t i = 0; i < COUNT(numbers); i++) {
        for (unsigned opacity = 0; opacity < 65535; opacity += 1 + opacity % 7)
            check_extinction(QV_STORAGE_RGBA16, opacity, numbers[i]);
        for (unsigned opacity = 0; opacity < 255; opacity++)
            check_extinction(QV_STORAGE_RGBA8, opacity, numbers[i]);
    }
}

/* The greatest opacity becomes the full value, less at most the rounding of extinction. */
static void least_extinction_is_used_up(void **state)
{
    (void)state;
    for (unsigned opacity = 1; opacity < 65535; opacity += 13) {
        const uint32_t e = extinction_of(QV_STORAGE_RGBA16, opacity, QV_ONE_Q16, 0);
        const qv_entries one = {source.narrow[0], 1, QV_ONE_Q16, 0, QV_STORAGE_RGBA16};
        assert_int_equal(qv_opacity_to_extinction(&result, 8, QV_STORAGE_RGBT16, e, &one), QV_OK);
        assert_in_range(result.wide[0][3], 65534 - 65535 / e, 65535);
    }
}

static void extinction_of_full_opacity(void **state)
{
    const uint8_t rgba8 = QV_STORAGE_RGBA8, rgba16 = QV_STORAGE_RGBA16;
    const uint32_t one = QV_ONE_Q16;
    (void)state;
    assert_int_equal(extinction_of(rgba8, 255, one, 0), 64 * one);
    assert_int_equal(extinction_of(rgba16, 65535, 2 * one, 0), 32 * one);
    assert_int_equal(extinction_of(rgba16, 65535, 3, 0), 0xFFFFFFFF); /* 64 * 2^32 / 3 */
    assert_int_equal(extinction_of(rgba8, 255, one, 9 * one), 9 * one);
    assert_int_equal(extinction_of(rgba8, 255, one, 1), extinction_of(rgba8, 127, one, 0));
    assert_int_equal(extinction_of(rgba8, 254, one, 9 * one), extinction_of(rgba8, 254, one, 0));
}

static void errors_of_the_least_extinction(void **state)
{
    const qv_entries good = {source.narrow[0], 1, 1, 0, QV_STORAGE_RGBA16};
    qv_entries bad = good;
    uint32_t extinction = 12345;
    (void)state;
    assert_int_equal(qv_extinction_of(NULL, &good, 0), QV_ERROR_NULL);
    assert_int_equal(qv_extinction_of(&extinction, NULL, 0), QV_ERROR_NULL);
    bad.entries = NULL;
    assert_int_equal(qv_extinction_of(&extinction, &bad, 0), QV_ERROR_NULL);
    bad.entries = source.narrow[0] + 1;
    assert_int_equal(qv_extinction_of(&extinction, &bad, 0), QV_ERROR_STRIDE);
    bad = good;
    bad.unit_distance = 0;
    assert_int_equal(qv_extinction_of(&extinction, &bad, 0), QV_ERROR_UNIT);
    for (unsigned storage = 0; storage < 12; storage++) {
        bad = good;
        bad.storage = (uint8_t)storage;
        if (storage != QV_STORAGE_RGBA8 && storage != QV_STORAGE_RGBA16)
            assert_int_equal(qv_extinction_of(&extinction, &bad, 0), QV_ERROR_STORAGE);
    }
    assert_int_equal(extinction, 12345);
    bad = good;
    bad.count = 0;
    assert_int_equal(qv_extinction_of(&extinction, &bad, 0), QV_OK);
    assert_int_equal(extinction, 1);
}

/*
 * Kraus and Buerger 2008, figures 2 and 3: four of eight voxels with tau 4, four clear,
 * become one voxel of twice the width. The mean of the extinctions keeps the opacity,
 * the mean of the opacities does not.
 */
static void figures_2_and_3(void **state)
{
    const long double opaque = 1 - expl(-4);
    uint16_t voxel[4] = {0, 0, 0, (uint16_t)lroundl(65535 * opaque)}, coarse[4];
    const uint32_t one = QV_ONE_Q16, extinction = 8 * one;
    qv_entries from = {(const uint8_t *)voxel, 1, one, extinction, QV_STORAGE_RGBA16};
    (void)state;

    coarse[3] = (uint16_t)((4 * voxel[3] + 4) / 8);
    from.entries = (const uint8_t *)coarse;
    assert_int_equal(qv_opacity_to_opacity(coarse, 8, QV_STORAGE_RGBA16, 2 * one, &from), QV_OK);
    printf("# figure 3: %.5f\n", coarse[3] / 65535.0);
    assert_true(fabs(coarse[3] / 65535.0 - 0.74076) < 0.00002);

    from.entries = (const uint8_t *)voxel;
    assert_int_equal(qv_opacity_to_extinction(coarse, 8, QV_STORAGE_RGBT16, extinction, &from),
                     QV_OK);
    coarse[3] = (uint16_t)((4 * coarse[3] + 4) / 8);
    from.entries = (const uint8_t *)coarse;
    from.storage = QV_STORAGE_RGBT16;
    assert_int_equal(qv_extinction_to_opacity(coarse, 8, QV_STORAGE_RGBA16, 2 * one, &from), QV_OK);
    printf("# figure 2: %.5f\n", coarse[3] / 65535.0);
    assert_true(fabs(coarse[3] / 65535.0 - 0.98168) < 0.00002);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(opacity_to_extinction),
        cmocka_unit_test(extinction_to_opacity),
        cmocka_unit_test(another_unit_distance),
        cmocka_unit_test(another_extinction),
        cmocka_unit_test(full_values),
        cmocka_unit_test(enormous_ratios),
        cmocka_unit_test(same_number_keeps_the_value),
        cmocka_unit_test(colours_are_rounded),
        cmocka_unit_test(in_place_and_unaligned),
        cmocka_unit_test(round_trips),
        cmocka_unit_test(errors),
        cmocka_unit_test(what_is_not_read),
        cmocka_unit_test(least_extinction),
        cmocka_unit_test(least_extinction_is_used_up),
        cmocka_unit_test(extinction_of_full_opacity),
        cmocka_unit_test(errors_of_the_least_extinction),
        cmocka_unit_test(figures_2_and_3),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
