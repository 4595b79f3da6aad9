/*
 * What splatting refuses: each status for its reason, and nothing written; but that
 * qv_splat_init may leave zeros.
 */
#include "splat_fixture.h"

#include "kernel.h"

static splat_fixture f, good;

static void restore(void)
{
    memcpy(&f, &good, sizeof f);
}

/* ---- Scenes ----------------------------------------------------------------- */

static void expect_scene(const qv_splat_scene *scene, qv_status expected)
{
    static qv_splats splats, before, nothing;
    memset(&splats, 0x5A, sizeof splats);
    memcpy(&before, &splats, sizeof splats);
    assert_int_equal(qv_splat_init(&splats, scene), expected);
    if (expected != QV_OK && memcmp(&splats, &before, sizeof splats) != 0)
        assert_memory_equal(&splats, &nothing, sizeof splats);
    restore();
}

static void null_pointers(void **state)
{
    qv_splats splats;
    (void)state;
    assert_int_equal(qv_splat_init(NULL, &f.scene), QV_ERROR_NULL);
    assert_int_equal(qv_splat_init(&splats, NULL), QV_ERROR_NULL);
    expect_scene(&f.scene, QV_OK);
    f.scene.splatting = NULL;
    expect_scene(&f.scene, QV_ERROR_NULL);
    f.scene.kernel = NULL;
    expect_scene(&f.scene, QV_ERROR_NULL);
    f.scene.domain = NULL;
    expect_scene(&f.scene, QV_ERROR_NULL);
}

static void volumes(void **state)
{
    (void)state;
    f.scene.volume.storage = 0;
    expect_scene(&f.scene, QV_ERROR_STORAGE);
    f.scene.volume.storage = QV_STORAGE_ASSOCIATED8;
    expect_scene(&f.scene, QV_ERROR_STORAGE);
    f.scene.domain = &qv_domain_stored;
    expect_scene(&f.scene, QV_ERROR_STORAGE);
    f.scene.volume.storage = QV_STORAGE_RGBT8;
    expect_scene(&f.scene, QV_ERROR_STORAGE);
    f.scene.volume.storage = QV_STORAGE_RGBT8;
    f.scene.domain = &qv_domain_stored;
    expect_scene(&f.scene, QV_ERROR_EXTINCTION);
    f.scene.volume.storage = QV_STORAGE_INDEXED8;
    expect_scene(&f.scene, QV_ERROR_PALETTE);
    f.scene.volume.size[1] = 0;
    expect_scene(&f.scene, QV_ERROR_SIZE);
    f.scene.volume.size[2] = QV_AXIS_MAX + 1;
    expect_scene(&f.scene, QV_ERROR_SIZE);
    f.scene.volume.spacing[0] = 4095;
    expect_scene(&f.scene, QV_ERROR_SPACING);
    f.scene.volume.unit_distance = 1;
    expect_scene(&f.scene, QV_ERROR_UNIT);
    f.scene.volume.voxels = NULL; /* not read */
    expect_scene(&f.scene, QV_OK);
}

static void views(void **state)
{
    (void)state;
    f.scene.view.width = 0;
    expect_scene(&f.scene, QV_ERROR_VIEW);
    f.scene.view.pitch = 15;
    expect_scene(&f.scene, QV_ERROR_VIEW);
    f.scene.view.rotation[1][2] = 0;
    f.scene.view.rotation[1][1] = 0;
    expect_scene(&f.scene, QV_ERROR_VIEW);
    f.scene.view.rotation[0][0] = INT32_MIN;
    expect_scene(&f.scene, QV_ERROR_VIEW);
    f.scene.view.pitch = 63 * QV_ONE_Q16; /* a voxel is 1/63 pixel wide */
    expect_scene(&f.scene, QV_OK);
    f.scene.view.pitch = 65 * QV_ONE_Q16;
    expect_scene(&f.scene, QV_ERROR_VIEW);
    f.scene.view.pitch = 65 * QV_ONE_Q16;
    f.scene.level = f.scene.coarsest = 1;
    expect_scene(&f.scene, QV_OK);
    f.scene.view.pitch = QV_ONE_Q16 / 4096;
    f.scene.volume.spacing[0] = f.scene.volume.spacing[1] = f.scene.volume.spacing[2] = 65000;
    expect_scene(&f.scene, QV_OK);
    f.scene.view.pitch = QV_ONE_Q16 / 4096;
    f.scene.volume.spacing[0] = f.scene.volume.spacing[1] = f.scene.volume.spacing[2] = 66000;
    expect_scene(&f.scene, QV_ERROR_VIEW);
    f.scene.field_of_view = splat_degrees(.9);
    expect_scene(&f.scene, QV_ERROR_VIEW);
    f.scene.field_of_view = splat_degrees(151);
    expect_scene(&f.scene, QV_ERROR_VIEW);
    f.scene.view.step = 12345; /* not read */
    expect_scene(&f.scene, QV_OK);
}

/* Rows of which one lies in the plane of the others: a corner of twice the frame is at the eye. */
static void corner_at_the_eye(void **state)
{
    static const int32_t flat[3][3] = {
        {0x40000000, 0, 0}, {0, 0x40000000, 0}, {0x26666666, 0x33333333, 0}};
    (void)state;
    memcpy(f.scene.view.rotation, flat, sizeof flat);
    f.scene.view.width = 12;
    f.scene.view.height = 20;           /* and the kernel 12, so that the corner is at (24, 32) */
    f.scene.field_of_view = 0x13F66E52; /* half of it has the cotangent 4 */
    f.scene.volume.size[2] = 1;
    expect_scene(&f.scene, QV_ERROR_VIEW);
}

static void levels_and_lights(void **state)
{
    (void)state;
    f.scene.level = 2;
    f.scene.coarsest = 1;
    expect_scene(&f.scene, QV_ERROR_LEVEL);
    f.scene.coarsest = 4; /* 6 voxels an axis have 3 coarser levels */
    expect_scene(&f.scene, QV_ERROR_LEVEL);
    f.scene.coarsest = 3;
    expect_scene(&f.scene, QV_OK);
    f.scene.lighting.count = QV_LAMPS_MAX + 1;
    expect_scene(&f.scene, QV_ERROR_LIGHT);
    f.scene.lighting.count = 1;
    expect_scene(&f.scene, QV_ERROR_LIGHT);
}

static void directions(void **state)
{
    (void)state;
    f.scene.directions = 0;
    expect_scene(&f.scene, QV_ERROR_DIRECTION);
    f.scene.directions = QV_DIRECTIONS_ALL + 1u;
    expect_scene(&f.scene, QV_ERROR_DIRECTION);
    f.scene.directions = QV_DIRECTIONS_FACES; /* the viewer is between faces */
    expect_scene(&f.scene, QV_ERROR_DIRECTION);
    f.scene.directions = QV_DIRECTIONS_FACES;
    f.scene.interpolation = 1;
    expect_scene(&f.scene, QV_OK);
    f.scene.directions = QV_DIRECTIONS_FACES;
    f.scene.splatting = &qv_splatting_over; /* which reads none */
    expect_scene(&f.scene, QV_OK);
    f.scene.directions = (uint32_t)1 << qv_direction(0, 1, 0); /* from behind */
    f.scene.interpolation = 1;
    expect_scene(&f.scene, QV_ERROR_DIRECTION);
    f.scene.directions = QV_DIRECTIONS_FACES;
    f.scene.splatting = &qv_splatting_over;
    f.scene.lighting.count = 1;
    f.scene.lighting.lamps[0].direction[0] = 3;
    f.scene.lighting.lamps[0].direction[2] = 2;
    expect_scene(&f.scene, QV_ERROR_DIRECTION);
    f.scene.field_of_view = splat_degrees(100);
    f.scene.directions = QV_DIRECTIONS_ALL & ~((uint32_t)1 << qv_direction(0, -1, 0));
    expect_scene(&f.scene, QV_ERROR_DIRECTION);
}

/* An eye in the middle of the volume, looking along +y: what it sees comes along -y. */
static void look_from_inside(void)
{
    qv_rotation(f.scene.view.rotation, 0, 0, 0);
    f.scene.field_of_view = splat_degrees(30);
    f.scene.view.pitch = QV_ONE_Q16 / 128; /* 0.7 voxels before the centre */
}

static void eyes_inside(void **state)
{
    uint8_t bytes[QV_DIRECTIONS];
    uint16_t at[3] = {9, 9, 9};
    (void)state;
    memset(bytes, 100, sizeof bytes);
    assert_int_equal(qv_splat_eye(at, &f.scene), 0);
    look_from_inside();
    f.scene.view.pitch = QV_ONE_Q16 / 2;
    assert_int_equal(qv_splat_eye(at, &f.scene), 0);
    assert_true(at[0] == 9 && at[1] == 9 && at[2] == 9);
    assert_int_equal(qv_splat_eye(NULL, &f.scene), 0);
    assert_int_equal(qv_splat_eye(at, NULL), 0);
    look_from_inside();
    assert_int_equal(qv_splat_eye(at, &f.scene), 1);
    assert_true(at[0] == 3 && at[1] == 2 && at[2] == 3);
    expect_scene(&f.scene, QV_ERROR_NULL);
    look_from_inside();
    f.scene.inside = bytes;
    expect_scene(&f.scene, QV_OK);
    look_from_inside();
    f.scene.inside = bytes;
    bytes[qv_direction(0, -1, 0)] = 0;
    expect_scene(&f.scene, QV_ERROR_INSIDE);
    look_from_inside();
    f.scene.inside = bytes;
    bytes[qv_direction(0, -1, 0)] = 1;
    bytes[qv_direction(0, 1, 0)] = bytes[qv_direction(1, 1, 0)] = 0; /* never wanted */
    expect_scene(&f.scene, QV_OK);
}

/* By the nearest direction any may be taken that goes some of the way. */
static void eyes_inside_and_nearest(void **state)
{
    uint8_t bytes[QV_DIRECTIONS];
    (void)state;
    memset(bytes, 100, sizeof bytes);
    for (unsigned i = 0; i < 3; i++) {
        look_from_inside();
        f.scene.inside = bytes;
        f.scene.interpolation = QV_NEAREST;
        bytes[qv_direction(0, -1, 0)] = i == 0 ? 0 : 100;
        bytes[qv_direction(1, -1, 1)] = i == 1 ? 0 : 100;
        bytes[qv_direction(0, 1, 0)] = 0; /* never taken */
        expect_scene(&f.scene, i == 2 ? QV_OK : QV_ERROR_INSIDE);
    }
}

/* ---- Voxels and sums -------------------------------------------------------- */

static qv_splats splats;

static void expect_voxel(const qv_freevoxel *voxel, qv_status expected)
{
    memset(f.sums, 0x33, sizeof f.sums);
    assert_int_equal(qv_splat(&f.target, &splats, voxel), expected);
    for (unsigned i = 0; i < f.target.count; i++)
        assert_int_equal(f.sums[i], 0x33333333u);
    restore();
}

static void voxels(void **state)
{
    qv_freevoxel voxel = splat_voxel(&f, 1), same = voxel;
    (void)state;
    splat_init(&splats, &f);
    assert_int_equal(qv_splat(&f.target, NULL, &voxel), QV_ERROR_NULL);
    assert_int_equal(qv_splat(NULL, &splats, &voxel), QV_ERROR_NULL);
    assert_int_equal(qv_splat(&f.target, &splats, NULL), QV_ERROR_NULL);
    voxel.voxel = NULL;
    expect_voxel(&voxel, QV_ERROR_NULL);
    voxel = same;
    voxel.attenuation = NULL;
    expect_voxel(&voxel, QV_ERROR_NULL);
    voxel = same;
    voxel.position[2] = SIDE;
    expect_voxel(&voxel, QV_ERROR_SIZE);
    voxel = same;
    voxel.level = 1;
    voxel.position[0] = 3; /* of 3 */
    expect_voxel(&voxel, QV_ERROR_SIZE);
    voxel.level = 4;
    voxel.position[0] = 0;
    expect_voxel(&voxel, QV_ERROR_LEVEL);
    f.scene.volume.storage = QV_STORAGE_RGBA16;
    splat_init(&splats, &f);
    voxel = same;
    voxel.voxel = f.voxels + 1;
    expect_voxel(&voxel, QV_ERROR_STRIDE);
}

static void sums_out_of_bounds(void **state)
{
    const qv_freevoxel voxel = splat_voxel(&f, 1);
    (void)state;
    splat_init(&splats, &f);
    f.target.sums = NULL;
    assert_int_equal(qv_splat(&f.target, &splats, &voxel), QV_ERROR_NULL);
    restore();
    f.target.count--;
    expect_voxel(&voxel, QV_ERROR_BUFFER);
    f.target.rect.right = 0;
    expect_voxel(&voxel, QV_ERROR_RECT);
    f.target.rect.bottom = QV_PIXEL_MAX + 1;
    expect_voxel(&voxel, QV_ERROR_RECT);
    f.target.rect.left = -1;
    expect_voxel(&voxel, QV_ERROR_BUFFER);
    f.target.count = (size_t)-1; /* more than bytes can tell is enough */
    assert_int_equal(qv_splat(&f.target, &splats, &voxel), QV_OK);
    restore();
    f.target.count--;
    assert_int_equal(qv_sums_clear(&f.target, &splats), QV_ERROR_BUFFER);
    assert_int_equal(qv_sums_read_out(&f.image, &f.target, &splats), QV_ERROR_BUFFER);
    assert_int_equal(qv_sums_add(&f.target, &good.target), QV_ERROR_BUFFER);
    restore();
    assert_int_equal(qv_sums_clear(&f.target, NULL), QV_ERROR_NULL);
    assert_int_equal(qv_sums_read_out(&f.image, &f.target, NULL), QV_ERROR_NULL);
    f.image.bytes--;
    assert_int_equal(qv_sums_read_out(&f.image, &f.target, &splats), QV_ERROR_BUFFER);
    restore();
    f.image.pixels = (uint8_t *)f.sums + sizeof f.sums - 1;
    assert_int_equal(qv_sums_read_out(&f.image, &f.target, &splats), QV_ERROR_OVERLAP);
    f.image.stride = -f.image.stride; /* rows below the first */
    f.image.pixels = (uint8_t *)f.sums + sizeof f.sums + 4 * FRAME * (FRAME - 1) - 1;
    assert_int_equal(qv_sums_read_out(&f.image, &f.target, &splats), QV_ERROR_OVERLAP);
    restore();
}

static void sums_of_others(void **state)
{
    static uint32_t memory[FRAME * FRAME * QV_SUM_CHANNELS];
    qv_sums other = {memory, f.target.count, {0, 0, FRAME, FRAME}};
    (void)state;
    assert_int_equal(qv_sums_add(&f.target, &other), QV_OK);
    assert_int_equal(qv_sums_add(&f.target, NULL), QV_ERROR_NULL);
    other.rect.right--;
    assert_int_equal(qv_sums_add(&f.target, &other), QV_ERROR_RECT);
    other.rect.right++;
    other.sums = f.sums;
    assert_int_equal(qv_sums_add(&f.target, &other), QV_ERROR_OVERLAP);
    restore();
}

/* ---- Blocks ----------------------------------------------------------------- */

static void expect_block(const qv_block *block, uint8_t number, qv_status expected)
{
    memset(f.sums, 0x33, sizeof f.sums);
    assert_int_equal(qv_splat_block(&f.target, &splats, &f.volume, &f.attenuation, number, block),
                     expected);
    for (unsigned i = 0; i < f.target.count; i++)
        assert_int_equal(f.sums[i], 0x33333333u);
    restore();
}

static void blocks(void **state)
{
    static const qv_block empty = {{0, 3, 0}, {SIDE, 3, SIDE}};
    static const qv_block long_block = {{0, 0, 0}, {SIDE, SIDE, SIDE + 1}};
    (void)state;
    splat_init(&splats, &f);
    assert_int_equal(qv_splat_block(&f.target, &splats, NULL, &f.attenuation, 0, &splat_all),
                     QV_ERROR_NULL);
    assert_int_equal(qv_splat_block(&f.target, &splats, &f.volume, NULL, 0, &splat_all),
                     QV_ERROR_NULL);
    assert_int_equal(qv_splat_block(&f.target, &splats, &f.volume, &f.attenuation, 0, NULL),
                     QV_ERROR_NULL);
    expect_block(&empty, 0, QV_ERROR_SIZE);
    expect_block(&long_block, 0, QV_ERROR_SIZE);
    expect_block(&splat_all, 1, QV_ERROR_SIZE);
    expect_block(&splat_all, 4, QV_ERROR_LEVEL);
    f.volume.storage = QV_STORAGE_RGBT8;
    expect_block(&splat_all, 0, QV_ERROR_STORAGE);
    f.volume.stride[1] = 3;
    expect_block(&splat_all, 0, QV_ERROR_STRIDE);
    f.attenuation.directions = QV_DIRECTIONS_FACES;
    expect_block(&splat_all, 0, QV_ERROR_DIRECTION);
    f.attenuation.size[0]--;
    expect_block(&splat_all, 0, QV_ERROR_SIZE);
    f.attenuation.bytes--;
    expect_block(&splat_all, 0, QV_ERROR_ATTENUATION);
    f.attenuation.record = 25;
    expect_block(&splat_all, 0, QV_ERROR_ATTENUATION);
    f.attenuation.records = NULL;
    expect_block(&splat_all, 0, QV_ERROR_NULL);
    f.volume.voxels = (const uint8_t *)f.sums + sizeof f.sums - 1;
    expect_block(&splat_all, 0, QV_ERROR_OVERLAP);
    f.attenuation.records = (const uint8_t *)f.sums;
    expect_block(&splat_all, 0, QV_ERROR_OVERLAP);
    f.scene.volume.storage = f.volume.storage = QV_STORAGE_INDEXED8; /* a palette in the sums */
    f.scene.volume.palette_bytes = f.volume.palette_bytes = QV_PALETTE8_BYTES;
    f.scene.volume.palette = f.volume.palette = (const uint8_t *)f.sums;
    splat_init(&splats, &f);
    expect_block(&splat_all, 0, QV_ERROR_OVERLAP);
}

static int no_voxel(void *user, qv_freevoxel *voxel)
{
    *voxel = splat_voxel(&f, 2);
    voxel->position[0] = SIDE;
    return ++*(int *)user;
}

static void streams(void **state)
{
    int calls = 0;
    (void)state;
    splat_init(&splats, &f);
    assert_int_equal(qv_splat_stream(&f.target, &splats, no_voxel, &calls), QV_ERROR_SIZE);
    assert_int_equal(calls, 1);
    assert_int_equal(qv_splat_stream(&f.target, &splats, NULL, &calls), QV_ERROR_NULL);
    assert_int_equal(qv_splat_stream(&f.target, NULL, no_voxel, &calls), QV_ERROR_NULL);
    f.target.count = 0;
    assert_int_equal(qv_splat_stream(&f.target, &splats, no_voxel, &calls), QV_ERROR_BUFFER);
    assert_int_equal(calls, 1);
    restore();
}

static int begin(void **state)
{
    (void)state;
    splat_begin(&f, 61, 120);
    memcpy(&good, &f, sizeof good);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(null_pointers),
        cmocka_unit_test(volumes),
        cmocka_unit_test(views),
        cmocka_unit_test(corner_at_the_eye),
        cmocka_unit_test(levels_and_lights),
        cmocka_unit_test(directions),
        cmocka_unit_test(eyes_inside),
        cmocka_unit_test(eyes_inside_and_nearest),
        cmocka_unit_test(voxels),
        cmocka_unit_test(sums_out_of_bounds),
        cmocka_unit_test(sums_of_others),
        cmocka_unit_test(blocks),
        cmocka_unit_test(streams),
    };
    return cmocka_run_group_tests(tests, begin, NULL);
}
