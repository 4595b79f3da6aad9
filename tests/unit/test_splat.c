/*
 * Splats: the same sums in any order, in strips and parts, from memory and from a stream; nothing
 * lost in a homogeneous medium; levels that cover each place once; sums that are full. The
 * pictures themselves are held by tests/accuracy/splat_*.c against a reference.
 */
#include "splat_fixture.h"

#include "splat.h"

#include <math.h>

#include <stdlib.h>

static uint32_t copy[FRAME * FRAME * QV_SUM_CHANNELS];

static void add_voxel(const splat_fixture *f, const qv_splats *splats, unsigned index)
{
    const qv_freevoxel voxel = splat_voxel(f, index);
    assert_int_equal(qv_splat(&f->target, splats, &voxel), QV_OK);
}

/* Something is seen, and f->sums are what was copied. */
static void expect_copy(const splat_fixture *f)
{
    uint64_t all = 0;
    for (unsigned i = 0; i < FRAME * FRAME * QV_SUM_CHANNELS; i++)
        all += f->sums[i];
    assert_true(all > 65536u * 1000u);
    assert_memory_equal(f->sums, copy, sizeof copy);
}

static void any_order(void **state)
{
    static splat_fixture f;
    static const double fields[] = {0, 40};
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        qv_splats splats;
        splat_begin(&f, 51, 90);
        f.scene.field_of_view = splat_degrees(fields[i]);
        splat_init(&splats, &f);
        splat_draw(&f, &splats);
        memcpy(copy, f.sums, sizeof copy);
        for (unsigned step = 5; step < 60; step += 6) { /* without a divisor of the 216 voxels */
            assert_int_equal(qv_sums_clear(&f.target, &splats), QV_OK);
            for (unsigned k = 0; k < VOXELS; k++)
                add_voxel(&f, &splats, k * step % VOXELS);
            expect_copy(&f);
        }
    }
}

static void parts_and_strips(void **state)
{
    static splat_fixture f;
    static uint32_t part[FRAME * FRAME * QV_SUM_CHANNELS];
    qv_splats splats;
    (void)state;
    splat_begin(&f, 52, 255);
    splat_init(&splats, &f);
    splat_draw(&f, &splats);
    memcpy(copy, f.sums, sizeof copy);
    const qv_sums other = {part, f.target.count, f.target.rect};
    assert_int_equal(qv_sums_clear(&f.target, &splats), QV_OK);
    for (unsigned k = 0; k < 5; k++) {
        assert_int_equal(qv_sums_clear(&other, &splats), QV_OK);
        for (unsigned i = k; i < VOXELS; i += 5) {
            const qv_freevoxel voxel = splat_voxel(&f, i);
            assert_int_equal(qv_splat(&other, &splats, &voxel), QV_OK);
        }
        assert_int_equal(qv_sums_add(&f.target, &other), QV_OK);
    }
    expect_copy(&f);
    for (int32_t top = 0; top < FRAME; top += 7) {
        const int32_t bottom = top + 7 < FRAME ? top + 7 : FRAME;
        const qv_sums strip = {f.sums + (size_t)top * FRAME * QV_SUM_CHANNELS,
                               (size_t)(bottom - top) * FRAME * QV_SUM_CHANNELS,
                               {0, top, FRAME, bottom}};
        assert_int_equal(qv_sums_clear(&strip, &splats), QV_OK);
        assert_int_equal(qv_splat_block(&strip, &splats, &f.volume, &f.attenuation, 0, &splat_all),
                         QV_OK);
    }
    expect_copy(&f);
}

typedef struct stream {
    const splat_fixture *fixture;
    unsigned next;
    int last; /* what it ends with */
} stream;

static int next_voxel(void *user, qv_freevoxel *voxel)
{
    stream *s = user;
    if (s->next == VOXELS)
        return s->last;
    *voxel = splat_voxel(s->fixture, s->next++);
    return 1;
}

static void streams(void **state)
{
    static splat_fixture f;
    qv_splats splats;
    (void)state;
    splat_begin(&f, 53, 60);
    splat_init(&splats, &f);
    splat_draw(&f, &splats);
    memcpy(copy, f.sums, sizeof copy);
    for (int last = 0; last >= QV_ERROR_BUFFER; last += QV_ERROR_BUFFER) {
        stream s = {&f, 0, last};
        assert_int_equal(qv_sums_clear(&f.target, &splats), QV_OK);
        assert_int_equal(qv_splat_stream(&f.target, &splats, next_voxel, &s), last);
        expect_copy(&f);
    }
}

/* A cube of one colour and opacity, seen along its axes: what composites to 1 - (1 - a)^n. Above
   opacities of .5 the roundings of few bytes count, with more weight each. */
static void homogeneous_cubes(void **state)
{
    static splat_fixture f;
    static const double sides[][2] = {{0, 0}, {90, 0}, {180, 0}, {270, 0}, {0, 90}, {0, -90}};
    (void)state;
    for (unsigned i = 0; i < sizeof sides / sizeof *sides; i++)
        for (unsigned opacity = 1; opacity < 256; opacity += 23) {
            qv_splats splats;
            splat_begin(&f, 54, 0);
            for (unsigned v = 0; v < VOXELS; v++)
                memset(f.voxels + 4 * v, (int)opacity, 4);
            splat_attenuate(&f);
            qv_rotation(f.scene.view.rotation, splat_degrees(sides[i][0]),
                        splat_degrees(sides[i][1]), 0);
            f.scene.kernel = i % 2 == 0 ? &qv_kernel_linear : &qv_kernel_quadratic;
            splat_init(&splats, &f);
            splat_draw(&f, &splats);
            const double exact = 255 * (1 - pow(1 - opacity / 255., SIDE));
            const uint32_t *sum = f.sums + (FRAME / 2 * FRAME + FRAME / 2) * QV_SUM_CHANNELS;
            const double most = opacity <= 128 ? .51 : 1;
            assert_true(fabs(sum[3] / 65536. - exact) <= most);
            assert_true(fabs(sum[0] / 65536. - exact * opacity / 255) <= most);
        }
}

/* Sums of opacity where a rolled picture shows the inner part of an opaque layer. */
static void opaque_layer(double least_most[2], splat_fixture *f, const qv_kernel *kernel,
                         double roll)
{
    qv_splats splats;
    splat_begin(f, 59, 0);
    for (unsigned v = 0; v < VOXELS; v++)
        memset(f->voxels + 4 * v, v / SIDE % SIDE == 0 ? 255 : 0, 4);
    splat_attenuate(f);
    qv_rotation(f->scene.view.rotation, 0, 0, splat_degrees(roll));
    f->scene.kernel = kernel;
    f->scene.view.pitch = QV_ONE_Q16 / 16;
    splat_init(&splats, f);
    splat_draw(f, &splats);
    least_most[0] = 1e9;
    least_most[1] = 0;
    for (unsigned y = FRAME / 3; y < 2 * FRAME / 3; y++)
        for (unsigned x = FRAME / 3; x < 2 * FRAME / 3; x++) {
            const double sum = f->sums[(y * FRAME + x) * QV_SUM_CHANNELS + 3] / 65536. / 255;
            least_most[0] = fmin(least_most[0], sum);
            least_most[1] = fmax(least_most[1], sum);
        }
}

/* The weights of a layer sum to 1 where its axes are the picture's; else on average, as qv_splat
   declares. */
static void layers_of_voxels(void **state)
{
    static splat_fixture f;
    double range[2];
    (void)state;
    for (int roll = 0; roll <= 90; roll += 5) {
        const int straight = roll % 90 == 0;
        opaque_layer(range, &f, &qv_kernel_quadratic, roll);
        assert_true(range[0] >= (straight ? .998 : .95) && range[1] <= (straight ? 1.002 : 1.05));
        opaque_layer(range, &f, &qv_kernel_linear, roll);
        assert_true(range[0] >= (straight ? .998 : .82) && range[1] <= (straight ? 1.002 : 1.35));
    }
    assert_true(range[0] > .998 && range[1] < 1.002);
}

/* Voxels as wide as the frame, and levels of any detail: an eye sees the fog as it is. */
static void wide_voxels_in_perspective(void **state)
{
    static splat_fixture f;
    (void)state;
    for (unsigned i = 0; i < 3; i++) {
        qv_splats splats;
        splat_begin(&f, 60, 0);
        memset(f.voxels, 26, sizeof f.voxels);
        splat_attenuate(&f);
        qv_rotation(f.scene.view.rotation, 0, 0, 0);
        f.scene.field_of_view = splat_degrees(3);
        f.scene.view.pitch = QV_ONE_Q16 >> (4 + i); /* a voxel is 16, 32, 64 of 48 pixels wide */
        splat_init(&splats, &f);
        splat_draw(&f, &splats);
        const double exact = 1 - pow(1 - 26 / 255., SIDE);
        for (unsigned p = 0; p < FRAME * FRAME; p += 7)
            assert_true(fabs(f.sums[p * QV_SUM_CHANNELS + 3] / 65536. / 255 - exact) < .02);
    }
}

/* Each voxel of level 0 lies in just one voxel of what is drawn. */
static void levels_cover_each_place_once(void **state)
{
    static splat_fixture f;
    unsigned coarser = 0;
    (void)state;
    for (unsigned i = 0; i < 200; i++) {
        qv_splats splats;
        splat_begin(&f, 55, 0);
        f.scene.volume.size[0] = (uint16_t)(3 + i % 40);
        f.scene.volume.size[1] = (uint16_t)(8 + i % 7);
        f.scene.volume.size[2] = 16;
        f.scene.coarsest = 3;
        f.scene.level = (uint8_t)(i % 3);
        f.scene.detail = (uint16_t)(37 * i);
        f.scene.field_of_view = i % 4 == 0 ? 0 : splat_degrees(10 + i % 100);
        f.scene.view.pitch = QV_ONE_Q16 / (1 + i % 5);
        f.scene.splatting = &qv_splatting_over; /* an eye inside needs no bytes */
        if (qv_splat_init(&splats, &f.scene) != QV_OK)
            continue;
        for (uint32_t v = 0; v < 2048; v++) {
            const uint16_t at[3] = {(uint16_t)(v % f.scene.volume.size[0]),
                                    (uint16_t)(v / 7 % f.scene.volume.size[1]),
                                    (uint16_t)(v / 90 % f.scene.volume.size[2])};
            unsigned drawn = 0;
            for (unsigned level = 0; level <= 4; level++) {
                const uint16_t whole[3] = {(uint16_t)(at[0] >> level), (uint16_t)(at[1] >> level),
                                           (uint16_t)(at[2] >> level)};
                const int belongs = qv_splat_belongs(&splats, whole, level);
                drawn += belongs != 0;
                coarser += belongs && level > f.scene.level;
                assert_false(belongs && (level < f.scene.level || level > 3));
            }
            assert_int_equal(drawn, 1);
        }
    }
    assert_true(coarser > 1000);
}

/* Whether a voxel is drawn where it belongs to the picture. */
static int is_seen(const qv_splats *splats, const uint16_t at[3], unsigned level)
{
    qv_sight sight;
    return qv_sight_of(&sight, splats, at, level);
}

/* An eye among the voxels: what it sees of them is not lost in coarser ones that it is too near
   to. */
static void levels_round_an_eye(void **state)
{
    static splat_fixture f;
    unsigned coarser = 0;
    (void)state;
    for (unsigned i = 0; i < 40; i++) {
        qv_splats splats;
        splat_begin(&f, 63, 0);
        f.scene.volume.size[0] = f.scene.volume.size[1] = f.scene.volume.size[2] = 16;
        f.scene.coarsest = 4;
        f.scene.detail = 0xFFFF;
        f.scene.field_of_view = splat_degrees(90);
        f.scene.view.pitch = QV_ONE_Q16 * (i + 1u) / 64u;
        f.scene.splatting = &qv_splatting_over; /* an eye inside needs no bytes */
        qv_rotation(f.scene.view.rotation, splat_degrees(9 * i), splat_degrees(5 * i), 0);
        splat_init(&splats, &f);
        for (unsigned v = 0; v < 4096; v += 3) {
            const uint16_t at[3] = {v % 16, v / 16 % 16, (uint16_t)(v / 256)};
            for (unsigned level = 1; is_seen(&splats, at, 0) && level <= 4; level++) {
                const uint16_t whole[3] = {(uint16_t)(at[0] >> level), (uint16_t)(at[1] >> level),
                                           (uint16_t)(at[2] >> level)};
                if (!qv_splat_belongs(&splats, whole, level))
                    continue;
                assert_true(is_seen(&splats, whole, level));
                coarser++;
            }
        }
    }
    assert_true(coarser > 1000);
}

/* 257 times white is too much; what is full stays full, and no picture is made of it. */
static void full_sums(void **state)
{
    static splat_fixture f;
    qv_splats splats;
    (void)state;
    splat_begin(&f, 56, 0);
    memset(f.voxels, 255, sizeof f.voxels);
    memset(f.bytes, 255, sizeof f.bytes);
    f.scene.view.pitch = QV_ONE_Q16 / 64;
    f.scene.kernel = &qv_kernel_linear;
    qv_rotation(f.scene.view.rotation, 0, 0, 0);
    splat_init(&splats, &f);
    assert_int_equal(qv_sums_clear(&f.target, &splats), QV_OK);
    for (unsigned i = 0; i < 256; i++)
        add_voxel(&f, &splats, VOXELS / 2 + SIDE / 2);
    memset(f.pixels, 0, sizeof f.pixels);
    assert_int_equal(qv_sums_read_out(&f.image, &f.target, &splats), QV_OK);
    assert_int_equal(f.pixels[0] | f.pixels[FRAME * 4 * FRAME - 1], 255);
    for (unsigned i = 0; i < 300; i++)
        add_voxel(&f, &splats, VOXELS / 2 + SIDE / 2);
    memset(f.pixels, 7, sizeof f.pixels);
    assert_int_equal(qv_sums_read_out(&f.image, &f.target, &splats), QV_ERROR_SUMS);
    for (unsigned i = 0; i < sizeof f.pixels; i++)
        assert_int_equal(f.pixels[i], 7);
    memcpy(copy, f.sums, sizeof copy);
    const qv_sums same = {copy, f.target.count, f.target.rect};
    assert_int_equal(qv_sums_add(&same, &f.target), QV_OK);
    uint32_t most = 0;
    for (unsigned i = 0; i < FRAME * FRAME * QV_SUM_CHANNELS; i++)
        most = copy[i] > most ? copy[i] : most;
    assert_int_equal(most, 0xFFFFFFFFu);
}

static void background(void **state)
{
    static splat_fixture f;
    static const qv_splatting *const splattings[] = {&qv_splatting_added, &qv_splatting_over};
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        qv_splats splats;
        splat_begin(&f, 57, 0); /* nothing is seen but the background */
        f.scene.splatting = splattings[i];
        memcpy(f.scene.background, "\xFF\x80\x10\x60", 4);
        splat_init(&splats, &f);
        splat_draw(&f, &splats);
        assert_int_equal(qv_sums_read_out(&f.image, &f.target, &splats), QV_OK);
        for (unsigned p = 0; p < FRAME * FRAME; p++)
            assert_memory_equal(f.pixels + 4 * p, "\x60\x30\x06\x60", 4);
    }
}

/* Sums may have more colour than opacity, and more of both than 1; pixels have not. */
static void pixels_of_any_sums(void **state)
{
    static splat_fixture f;
    static const uint8_t expected[3][4] = {{100, 100, 20, 100}, {255, 255, 3, 255}, {0, 0, 0, 0}};
    static const uint32_t sums[3][4] = {{200u << 16, 100u << 16, 20u << 16, 100u << 16},
                                        {900u << 16, 255u << 16, 3u << 16, 300u << 16},
                                        {77u << 16, 5u << 16, 1u << 16, 0}};
    qv_splats splats;
    (void)state;
    splat_begin(&f, 62, 0);
    splat_init(&splats, &f);
    assert_int_equal(qv_sums_clear(&f.target, &splats), QV_OK);
    memcpy(f.sums, sums, sizeof sums);
    assert_int_equal(qv_sums_read_out(&f.image, &f.target, &splats), QV_OK);
    assert_memory_equal(f.pixels, expected, sizeof expected);
}

/* A viewer in front sees the front: opaque layers of two colours. */
static void what_lies_in_front(void **state)
{
    static splat_fixture f;
    static const qv_splatting *const splattings[] = {&qv_splatting_added, &qv_splatting_over};
    (void)state;
    for (unsigned i = 0; i < 8; i++) {
        qv_splats splats;
        splat_begin(&f, 58, 0);
        for (unsigned v = 0; v < VOXELS; v++) {
            const int front = v / SIDE % SIDE < SIDE / 2; /* low y: before azimuth 0 */
            memcpy(f.voxels + 4 * v, front ? "\xFF\x00\x00\xFF" : "\x00\xFF\x00\xFF", 4);
        }
        splat_attenuate(&f);
        qv_rotation(f.scene.view.rotation, i / 2 % 2 == 0 ? 0 : splat_degrees(180), 0, 0);
        f.scene.field_of_view = i < 4 ? splat_degrees(20) : 0;
        f.scene.splatting = splattings[i % 2];
        splat_init(&splats, &f);
        splat_draw(&f, &splats);
        const uint32_t *sum = f.sums + (FRAME / 2 * FRAME + FRAME / 2) * QV_SUM_CHANNELS;
        const unsigned seen = i / 2 % 2 == 0 ? 0 : 1;
        if (i % 2 == 0)
            assert_true(sum[seen] > 254u << 16 && sum[1 - seen] < 1u << 12);
        else /* a fifth leaks through three layers */
            assert_true(sum[seen] > 190u << 16 && sum[1 - seen] < 60u << 16);
    }
}

/* The eye's bytes are not read where there is no eye, or where it lies outside of the volume. */
static void inside_without_an_eye_inside(void **state)
{
    static splat_fixture f;
    static const double fields[] = {0, 40};
    uint8_t bytes[QV_DIRECTIONS];
    (void)state;
    memset(bytes, 100, sizeof bytes);
    for (unsigned i = 0; i < 2; i++) {
        qv_splats splats;
        splat_begin(&f, 59, 90);
        f.scene.field_of_view = splat_degrees(fields[i]);
        splat_init(&splats, &f);
        splat_draw(&f, &splats);
        memcpy(copy, f.sums, sizeof copy);
        f.scene.inside = bytes;
        splat_init(&splats, &f);
        splat_draw(&f, &splats);
        expect_copy(&f);
    }
}

/* A view whose rows are short by 2^-10, so that the eye is nearer to a voxel than it seems: in its
   centre. */
static void voxel_at_the_eye(void **state)
{
    static splat_fixture f;
    static const int32_t rows[3][3] = {{0x40000000, 0, 0}, {0, 0, -0x40000000}, {0, 0x3FF00001, 0}};
    static const uint8_t voxel[4] = {255, 255, 255, 255};
    uint8_t bytes[QV_DIRECTIONS];
    uint16_t eye[3];
    qv_splats splats;
    (void)state;
    splat_begin(&f, 60, 0);
    memset(bytes, 255, sizeof bytes);
    memcpy(f.scene.view.rotation, rows, sizeof rows);
    f.scene.view.pitch = QV_ONE_Q16;
    f.scene.view.width = f.scene.view.height = 1000;
    f.scene.field_of_view = 0x2D0D4D4E;
    f.scene.inside = bytes;
    f.scene.volume.size[0] = f.scene.volume.size[2] = 1;
    f.scene.volume.size[1] = QV_AXIS_MAX;
    splat_init(&splats, &f);
    assert_int_equal(qv_splat_eye(eye, &f.scene), 1);
    const qv_freevoxel at_eye = {voxel, bytes, {0, eye[1], 0}, 0};
    assert_int_equal(splats.eye[1], (2 * eye[1] + 1 - (int)QV_AXIS_MAX) * 65536);
    assert_int_equal(qv_sums_clear(&f.target, &splats), QV_OK);
    assert_int_equal(qv_splat(&f.target, &splats, &at_eye), QV_OK);
    for (unsigned i = 0; i < FRAME * FRAME * QV_SUM_CHANNELS; i++)
        assert_int_equal(f.sums[i], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_order),
        cmocka_unit_test(parts_and_strips),
        cmocka_unit_test(streams),
        cmocka_unit_test(homogeneous_cubes),
        cmocka_unit_test(layers_of_voxels),
        cmocka_unit_test(wide_voxels_in_perspective),
        cmocka_unit_test(levels_cover_each_place_once),
        cmocka_unit_test(levels_round_an_eye),
        cmocka_unit_test(full_sums),
        cmocka_unit_test(background),
        cmocka_unit_test(pixels_of_any_sums),
        cmocka_unit_test(what_lies_in_front),
        cmocka_unit_test(inside_without_an_eye_inside),
        cmocka_unit_test(voxel_at_the_eye),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
