/*
 * The order in which voxels are splatted does not matter, to the bit: permutations of all voxels,
 * partitions between workers whose sums are added, orders of the bytes in memory, blocks and
 * strips. The volume is the head ch2.nii.gz of Debian's mricron-data, reduced.
 */
#include "attenuated.h"
#include "draw.h"
#include "scan.h"

#include <inttypes.h>
#include <stdio.h>

#define FACTOR 6 /* by which the scan is reduced */
#define EDGE   64
#define SUMS   ((size_t)EDGE * EDGE * QV_SUM_CHANNELS)

#define PERMUTATIONS 100
#define PARTITIONS   20
#define MOST_WORKERS 8

typedef uint32_t picture[SUMS];

static uint16_t palette[QV_PALETTE_ENTRIES][4];

/* What all tests draw. */
typedef struct head {
    qv_volume volume;
    uint8_t *voxels;
    uint32_t count; /* of voxels */
    attenuated light;
    qv_splats splats;
    picture expected; /* all voxels in one block */
} head;

/* ---- The picture ------------------------------------------------------------------ */

static void describe(head *made)
{
    qv_volume *volume = &made->volume;
    int32_t stride = 1;
    made->voxels = ref_scan_reduced(volume->size, FACTOR);
    assert_non_null(made->voxels);
    for (int axis = 0; axis < 3; axis++) {
        volume->stride[axis] = stride;
        stride *= volume->size[axis];
    }
    made->count = (uint32_t)stride;
    volume->voxels = made->voxels;
    volume->voxels_bytes = made->count;
    volume->storage = QV_STORAGE_INDEXED8_16;
    volume->palette = (qv_address)palette;
    volume->palette_bytes = sizeof palette;
    volume->unit_distance = QV_ONE_Q16;
}

/* From aside, with a red lamp from above and behind. */
static void look(qv_splat_scene *scene, const head *at, qv_angle field_of_view)
{
    const qv_lamp lamp = {{300, 500, 700}, {0xffff, 0x2000, 0x1000}};
    memset(scene, 0, sizeof *scene);
    scene->splatting = &qv_splatting_added;
    scene->kernel = &qv_kernel_quadratic;
    scene->domain = attenuated_domain(&at->volume);
    scene->directions = QV_DIRECTIONS_ALL;
    scene->field_of_view = field_of_view;
    scene->lighting.lamps[0] = lamp;
    scene->lighting.count = 1;
    for (int channel = 0; channel < 3; channel++) {
        scene->lighting.ambient[channel] = 0x6000;
    }
    scene->view.pitch = QV_ONE_Q16 * 3 / 4;
    scene->view.step = QV_ONE_Q16;
    scene->view.width = EDGE;
    scene->view.height = EDGE;
    scene->volume = at->volume;
    qv_rotation(scene->view.rotation, 0x15555555u, 0x0e38e38eu, 0x03000000u);
}

static qv_sums sums_of(uint32_t *memory, int32_t top, int32_t bottom)
{
    const qv_sums sums = {memory, SUMS, {0, top, EDGE, bottom}};
    return sums;
}

static void clear(picture sums, const head *of)
{
    const qv_sums all = sums_of(sums, 0, EDGE);
    assert_int_equal(qv_sums_clear(&all, &of->splats), QV_OK);
}

static void add_block(picture sums, const head *of, const attenuated *light, const qv_block *block)
{
    const qv_sums all = sums_of(sums, 0, EDGE);
    assert_int_equal(qv_splat_block(&all, &of->splats, &of->volume, &light->level[0], 0, block),
                     QV_OK);
}

static qv_block whole(const head *of)
{
    const uint16_t *size = of->volume.size;
    const qv_block block = {{0, 0, 0}, {size[0], size[1], size[2]}};
    return block;
}

static void head_make(head *made, qv_angle field_of_view)
{
    qv_splat_scene scene;
    memset(made, 0, sizeof *made);
    ref_scan_palette(palette);
    describe(made);
    attenuated_make(&made->light, &made->volume, 0, QV_DIRECTIONS_ALL, NULL);
    look(&scene, made, field_of_view);
    assert_int_equal(qv_splat_init(&made->splats, &scene), QV_OK);
    clear(made->expected, made);
    const qv_block all = whole(made);
    add_block(made->expected, made, &made->light, &all);
}

static void head_free(head *made)
{
    attenuated_free(&made->light);
    free(made->voxels);
}

/* FNV-1a, of the bytes from the lowest on: one number for a picture. */
static uint32_t checksum(const picture sums)
{
    uint32_t sum = 0x811c9dc5u;
    for (size_t i = 0; i < SUMS; i++) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            sum = (sum ^ (sums[i] >> shift & 255u)) * 0x01000193u;
        }
    }
    return sum;
}

static void expect(const head *of, const picture sums)
{
    assert_int_equal(checksum(sums), checksum(of->expected));
    assert_memory_equal(sums, of->expected, sizeof of->expected);
}

/* ---- Orders ------------------------------------------------------------------------- */

static void shuffle(uint32_t *indices, uint32_t count, draws *random)
{
    for (uint32_t i = count; i > 1; i--) {
        const uint32_t other = draw_below(random, i), held = indices[i - 1];
        indices[i - 1] = indices[other];
        indices[other] = held;
    }
}

static uint32_t *all_indices(const head *of)
{
    uint32_t *indices = malloc(of->count * sizeof *indices);
    assert_non_null(indices);
    for (uint32_t i = 0; i < of->count; i++) {
        indices[i] = i;
    }
    return indices;
}

static qv_freevoxel voxel_at(const head *of, const attenuated *light, uint32_t index)
{
    const uint16_t *size = of->volume.size;
    const uint16_t at[3] = {(uint16_t)(index % size[0]), (uint16_t)(index / size[0] % size[1]),
                            (uint16_t)(index / size[0] / size[1])};
    return attenuated_voxel(light, &of->volume, 0, at);
}

static void test_permutations(const head *of)
{
    draws random = draw_seeded(5);
    uint32_t *indices = all_indices(of);
    picture sums;
    const qv_sums all = sums_of(sums, 0, EDGE);
    for (int permutation = 0; permutation < PERMUTATIONS; permutation++) {
        clear(sums, of);
        shuffle(indices, of->count, &random);
        for (uint32_t i = 0; i < of->count; i++) {
            const qv_freevoxel voxel = voxel_at(of, &of->light, indices[i]);
            assert_int_equal(qv_splat(&all, &of->splats, &voxel), QV_OK);
        }
        expect(of, sums);
    }
    printf("# %d permutations of %" PRIu32 " voxels: checksum %08" PRIx32 "\n", PERMUTATIONS,
           of->count, checksum(sums));
    free(indices);
}

static void test_orthographic(void **state)
{
    head at;
    (void)state;
    head_make(&at, 0);
    test_permutations(&at);
    head_free(&at);
}

static void test_perspective(void **state)
{
    head at;
    (void)state;
    head_make(&at, 0x15555555u);
    test_permutations(&at);
    head_free(&at);
}

/* Each voxel goes to one of several workers; their sums are added in any order. */
static void partition(const head *of, draws *random)
{
    static picture parts[MOST_WORKERS];
    const uint32_t workers = 2 + draw_below(random, MOST_WORKERS - 1);
    uint32_t turns[MOST_WORKERS], *indices = all_indices(of);
    picture sums;
    const qv_sums all = sums_of(sums, 0, EDGE);
    for (uint32_t worker = 0; worker < workers; worker++) {
        turns[worker] = worker;
        clear(parts[worker], of);
    }
    shuffle(indices, of->count, random);
    shuffle(turns, workers, random);
    for (uint32_t i = 0; i < of->count; i++) {
        const qv_sums part = sums_of(parts[draw_below(random, workers)], 0, EDGE);
        const qv_freevoxel voxel = voxel_at(of, &of->light, indices[i]);
        assert_int_equal(qv_splat(&part, &of->splats, &voxel), QV_OK);
    }
    clear(sums, of);
    for (uint32_t worker = 0; worker < workers; worker++) {
        const qv_sums part = sums_of(parts[turns[worker]], 0, EDGE);
        assert_int_equal(qv_sums_add(&all, &part), QV_OK);
    }
    expect(of, sums);
    free(indices);
}

static void test_partitions(void **state)
{
    draws random = draw_seeded(6);
    head at;
    (void)state;
    head_make(&at, 0);
    for (int i = 0; i < PARTITIONS; i++) {
        partition(&at, &random);
    }
    head_free(&at);
}

/* Voxels one after another along an order, whose bytes lie in that order. */
typedef struct walk {
    const head *of;
    const attenuated *light;
    const qv_order *order;
    uint32_t next;
} walk;

static int next_voxel(void *user, qv_freevoxel *voxel)
{
    walk *along = user;
    uint16_t at[3];
    if (along->next == along->of->count) {
        return 0;
    }
    const qv_status status =
        qv_order_position(at, along->order, along->of->volume.size, along->next++);
    *voxel = attenuated_voxel(along->light, &along->of->volume, 0, at);
    return status == QV_OK ? 1 : (int)status;
}

static void test_orders(void **state)
{
    static const qv_order *const orders[] = {&qv_order_linear, &qv_order_morton, &qv_order_hilbert};
    head at;
    picture sums;
    const qv_sums all = sums_of(sums, 0, EDGE);
    (void)state;
    head_make(&at, 0);
    for (size_t i = 0; i < sizeof orders / sizeof orders[0]; i++) {
        attenuated light;
        attenuated_make(&light, &at.volume, 0, QV_DIRECTIONS_ALL, orders[i]);
        walk along = {&at, &light, orders[i], 0};
        clear(sums, &at);
        assert_int_equal(qv_splat_stream(&all, &at.splats, next_voxel, &along), QV_OK);
        expect(&at, sums);
        const qv_block block = whole(&at);
        clear(sums, &at);
        add_block(sums, &at, &light, &block);
        expect(&at, sums);
        attenuated_free(&light);
    }
    head_free(&at);
}

/* The volume cut in two again and again, at random. */
static void add_parts(picture sums, const head *of, const qv_block *block, draws *random)
{
    uint32_t axis = draw_below(random, 3);
    const uint32_t length = block->end[axis] - block->first[axis];
    const uint32_t short_enough = 5;
    if (length < short_enough) {
        add_block(sums, of, &of->light, block);
        return;
    }
    qv_block lower = *block, upper = *block;
    lower.end[axis] = (uint16_t)(block->first[axis] + 1 + draw_below(random, length - 1));
    upper.first[axis] = lower.end[axis];
    add_parts(sums, of, &upper, random);
    add_parts(sums, of, &lower, random);
}

static void test_blocks(void **state)
{
    draws random = draw_seeded(7);
    head at;
    picture sums;
    (void)state;
    head_make(&at, 0);
    for (int i = 0; i < PARTITIONS; i++) {
        const qv_block all = whole(&at);
        clear(sums, &at);
        add_parts(sums, &at, &all, &random);
        expect(&at, sums);
    }
    head_free(&at);
}

/* Strips of 1, 2, .. rows, each with memory of its own that is full of something else. */
static void test_strips(void **state)
{
    head at;
    picture sums;
    (void)state;
    head_make(&at, 0);
    for (int32_t top = 0, rows = 1; top < EDGE; top += rows, rows++) {
        const int32_t bottom = top + rows < EDGE ? top + rows : EDGE;
        const size_t row = (size_t)EDGE * QV_SUM_CHANNELS;
        const qv_sums strip = sums_of(sums + (size_t)top * row, top, bottom);
        memset(strip.sums, 0xa5, (size_t)(bottom - top) * row * sizeof *strip.sums);
        assert_int_equal(qv_sums_clear(&strip, &at.splats), QV_OK);
        assert_int_equal(attenuated_splat(&strip, &at.splats, &at.light, &at.volume, 0), QV_OK);
    }
    expect(&at, sums);
    head_free(&at);
}

/* Sums of what was drawn, so that none of the tests compares nothing. */
static void test_something_is_drawn(void **state)
{
    head at;
    size_t bright = 0;
    (void)state;
    head_make(&at, 0);
    for (size_t i = 0; i < SUMS; i++) {
        bright += at.expected[i] > ATTENUATED_ONE / 10;
    }
    printf("# %zu of %zu sums are above 1/10\n", bright, SUMS);
    assert_true(bright > SUMS / 8);
    head_free(&at);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_something_is_drawn),
        cmocka_unit_test(test_orthographic),
        cmocka_unit_test(test_perspective),
        cmocka_unit_test(test_partitions),
        cmocka_unit_test(test_orders),
        cmocka_unit_test(test_blocks),
        cmocka_unit_test(test_strips),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
