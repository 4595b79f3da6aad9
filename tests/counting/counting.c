/*
 * Operation counts of whole rendered frames: the shipped kernel, built so that only
 * named operations compile and each is counted. Of weighted and separate samples,
 * Wittenbrink et al., table 1, have 36 multiplications and 47 additions; weights that share
 * their differences save 7 of these. Also that the sums of products equal the trees.
 */
#include <stdio.h>
#include <stdlib.h>

#include "qvol.h"
#include "sample.h"
#include "tree.h"

unsigned long fx_multiplications, fx_additions;

#define SIZE   12
#define FRAME  16
#define TRIALS 20000

static uint16_t voxels[SIZE * SIZE * SIZE * 4];
static uint16_t palette[QV_PALETTE_ENTRIES * 4];
static unsigned tests, failures;

static void report(int good, const char *name)
{
    printf("%sok %u - %s\n", good ? "" : "not ", ++tests, name);
    failures += !good;
}

static uint32_t next_random(void)
{
    static uint32_t state = 20231;
    state = state * 1664525u + 1013904223u;
    return state >> 8;
}

/* Every byte is at least 1, so no cell is without opacity. */
static void fill(void *memory, size_t bytes)
{
    uint8_t *byte = memory;
    for (size_t i = 0; i < bytes; i++)
        byte[i] = (uint8_t)(1u + next_random() % 255u);
}

static qv_scene scene_for(const qv_sampling *sampling)
{
    unsigned bytes = qv_voxel_bytes(sampling->storage);
    int indexed = qv_storage_indexed(sampling->storage);
    qv_scene scene = {0};
    qv_view view = {{{0}}, QV_ONE_Q16, QV_ONE_Q16 / 2u, FRAME, FRAME};
    const void *memory = voxels, *entries = palette;
    scene.sampling = sampling;
    scene.volume.extinction = QV_ONE_Q16 / 256u; /* no ray is to end early */
    scene.volume.voxels = memory;
    scene.volume.voxels_bytes = sizeof voxels;
    scene.volume.storage = sampling->storage;
    scene.volume.palette = indexed ? entries : NULL;
    scene.volume.palette_bytes =
        indexed ? QV_PALETTE_ENTRIES * qv_entry_bytes(sampling->storage) : 0;
    for (unsigned axis = 0; axis < 3; axis++)
        scene.volume.size[axis] = SIZE;
    scene.volume.stride[0] = (int32_t)bytes;
    scene.volume.stride[1] = (int32_t)bytes * SIZE;
    scene.volume.stride[2] = (int32_t)bytes * SIZE * SIZE;
    qv_rotation(view.rotation, 0x12345678u, 0x0ABCDEF0u, 0x23456789u);
    if (qv_orthographic(&scene.camera, &scene.volume, &view) != QV_OK)
        exit(1);
    return scene;
}

static void count_frame(const char *name, const qv_sampling *sampling)
{
    static uint8_t pixels[FRAME * FRAME * 4];
    qv_image image = {pixels, sizeof pixels, FRAME * 4, &qv_format_rgba8888};
    qv_rect rect = {0, 0, FRAME, FRAME};
    qv_progress progress = {0};
    qv_scene scene = scene_for(sampling);
    qv_context context;
    char line[160];
    fx_multiplications = fx_additions = 0;
    int rendered = qv_init(&context, &scene) == QV_OK &&
                   qv_render_some(&image, &progress, &context, &rect, FRAME * FRAME) == QV_OK;
    unsigned long samples = progress.samples;
    snprintf(line, sizeof line,
             "%s: %lu multiplications and %lu additions for %lu samples, 36 and 40 each", name,
             fx_multiplications, fx_additions, samples);
    report(rendered && samples > 1000 && progress.skipped == 0 &&
               fx_multiplications == 36 * samples && fx_additions == 40 * samples,
           line);
}

/* Compares one random cell; the sums may differ by what xyz was rounded: 1/2 of
   2^-16 in each of eight weights. */
static int same_as_tree(uint8_t rgba[8][4])
{
    qv_volume volume = {.voxels = rgba[0], .size = {2, 2, 2}, .stride = {4, 8, 16}};
    qv_ray ray = {.samples = 1};
    uint8_t fraction[3];
    qv_sample sample;
    tree_number tree[4];
    for (unsigned axis = 0; axis < 3; axis++) {
        fraction[axis] = (uint8_t)next_random();
        ray.place[axis] = (qv_coord)fraction[axis] << 24;
    }
    if (!qv_sample_weighted(&sample, &ray, &volume, QV_STORAGE_RGBA8))
        return 0;
    tree_weighted(tree, rgba, fraction);
    int64_t worst = llabs((int64_t)fx_share_bits(sample.opacity) * 256 - tree[3].bits) / 255;
    for (unsigned c = 0; c < 3; c++) {
        int64_t error =
            llabs((int64_t)fx_sum_bits(sample.light[c]) * 256 - tree[c].bits) / 255 / 255;
        worst = error > worst ? error : worst;
    }
    return worst <= 128 * 8;
}

static void compare_with_trees(void)
{
    uint8_t rgba[8][4];
    int same = 1;
    for (unsigned i = 0; i < TRIALS; i++) {
        fill(rgba, sizeof rgba);
        same = same && same_as_tree(rgba);
    }
    report(same, "sums of weighted products equal the trees up to the rounding of xyz");
}

static void count_trees(void)
{
    uint8_t rgba[8][4], fraction[3] = {1, 2, 3};
    tree_number result[4];
    fill(rgba, sizeof rgba);
    fx_multiplications = fx_additions = 0;
    tree_separate(result, rgba, fraction);
    report(fx_multiplications == 28 && fx_additions == 56,
           "separate tree: 28 multiplications, 56 additions");
    fx_multiplications = fx_additions = 0;
    tree_weighted(result, rgba, fraction);
    report(fx_multiplications == 52 && fx_additions == 56,
           "weighted tree: 52 multiplications, 56 additions");
}

int main(void)
{
    fill(voxels, sizeof voxels);
    fill(palette, sizeof palette);
    count_frame("weighted rgba8", &qv_weighted_rgba8);
    count_frame("weighted rgba16", &qv_weighted_rgba16);
    count_frame("weighted indexed8", &qv_weighted_indexed8);
    count_frame("weighted indexed8_16", &qv_weighted_indexed8_16);
    count_frame("corrected rgba8", &qv_corrected_rgba8);
    count_frame("corrected rgba16", &qv_corrected_rgba16);
    count_frame("corrected indexed8", &qv_corrected_indexed8);
    count_frame("corrected indexed8_16", &qv_corrected_indexed8_16);
    count_frame("extinction rgba8", &qv_extinction_rgba8);
    count_frame("extinction rgba16", &qv_extinction_rgba16);
    count_frame("extinction indexed8", &qv_extinction_indexed8);
    count_frame("extinction indexed8_16", &qv_extinction_indexed8_16);
    count_frame("extinction rgbt8", &qv_extinction_rgbt8);
    count_frame("extinction rgbt16", &qv_extinction_rgbt16);
    count_frame("extinction indexed8_t8", &qv_extinction_indexed8_t8);
    count_frame("extinction indexed8_t16", &qv_extinction_indexed8_t16);
    count_frame("separate rgba8", &qv_separate_rgba8);
    count_frame("separate rgba16", &qv_separate_rgba16);
    count_frame("separate indexed8", &qv_separate_indexed8);
    count_frame("separate indexed8_16", &qv_separate_indexed8_16);
    count_trees();
    compare_with_trees();
    return failures != 0;
}
