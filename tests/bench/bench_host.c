/*
 * Samples per second on this machine, and the ratio to the plain float renderer
 * of the same picture, in one run. The best of several frames each, in turn.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "float_renderer.h"
#include "qvol.h"

#define SIZE   128
#define FRAME  256
#define FRAMES 5
#define VOXELS ((size_t)SIZE * SIZE * SIZE)

static uint8_t rgba8[VOXELS][4];
static uint16_t rgba16[VOXELS][4];
static uint8_t indexed[VOXELS];
static uint8_t palette8[QV_PALETTE_ENTRIES][4];
static qv_transfer palette16;

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Three shells of a ball, soft ones, in each of the storages. */
static void fill(void)
{
    const qv_control_point points[] = {
        {8, {0, 0, 0, 0}}, {40, {20000, 40000, 65535, 600}}, {255, {65535, 50000, 20000, 6000}}};
    qv_transfer_build(&palette16, points, 3);
    qv_transfer_to_palette8(palette8, &palette16);
    for (size_t i = 0; i < VOXELS; i++) {
        long x = (long)(i % SIZE) - SIZE / 2, y = (long)(i / SIZE % SIZE) - SIZE / 2;
        long z = (long)(i / SIZE / SIZE) - SIZE / 2;
        long square = (x * x + y * y + z * z) * 768 / (SIZE * SIZE / 4);
        indexed[i] = (uint8_t)(square < 768 ? square % 256 : 0);
        memcpy(rgba8[i], palette8[indexed[i]], sizeof rgba8[i]);
        memcpy(rgba16[i], palette16.rgba[indexed[i]], sizeof rgba16[i]);
    }
}

static qv_scene scene_for(const qv_sampling *sampling, const void *voxels, unsigned bytes)
{
    qv_scene scene = {0};
    qv_view view = {{{0}}, QV_ONE_Q16 * 3 / 4, QV_ONE_Q16, FRAME, FRAME};
    scene.sampling = sampling;
    scene.volume.voxels = voxels;
    scene.volume.voxels_bytes = VOXELS * bytes;
    scene.volume.storage = sampling->storage;
    int32_t stride = (int32_t)bytes;
    for (unsigned axis = 0; axis < 3; axis++, stride *= SIZE) {
        scene.volume.size[axis] = SIZE;
        scene.volume.stride[axis] = stride;
    }
    qv_rotation(view.rotation, 0x15555555u, 0x0E38E38Eu, 0);
    if (qv_orthographic(&scene.camera, &scene.volume, &view) != QV_OK)
        exit(1);
    return scene;
}

static double time_library(uint8_t *pixels, qv_progress *progress, const qv_scene *scene)
{
    qv_image image = {pixels, FRAME * FRAME * 4, FRAME * 4, &qv_format_rgba8888};
    qv_rect rect = {0, 0, FRAME, FRAME};
    qv_context context;
    memset(progress, 0, sizeof *progress);
    double start = seconds();
    if (qv_init(&context, scene) != QV_OK ||
        qv_render_some(&image, progress, &context, &rect, FRAME * FRAME) != QV_OK)
        exit(1);
    return seconds() - start;
}

/* The float renderer weights colours, so only these modes make its picture. */
static int is_weighted(const qv_scene *scene)
{
    const qv_sampling *sampling = scene->sampling;
    return sampling != &qv_separate_rgba8 && sampling != &qv_nearest_rgba8;
}

static void compare(const char *name, const qv_scene *scene, const qv_scene *float_scene)
{
    static uint8_t ours[FRAME * FRAME * 4], theirs[FRAME * FRAME * 4];
    double best = 1e9, float_best = 1e9;
    unsigned long float_samples = 0;
    qv_progress progress;
    int worst = 0;
    for (int i = 0; i < FRAMES; i++) {
        double t = time_library(ours, &progress, scene), start = seconds();
        best = t < best ? t : best;
        float_samples = float_render(theirs, float_scene, FRAME, FRAME);
        t = seconds() - start;
        float_best = t < float_best ? t : float_best;
    }
    for (size_t i = 0; i < sizeof ours; i++)
        worst = abs(ours[i] - theirs[i]) > worst ? abs(ours[i] - theirs[i]) : worst;
    double rate = progress.samples / best, float_rate = (double)float_samples / float_best;
    printf("| %s | %.1f | %.1f | %.2f | ", name, rate / 1e6, float_rate / 1e6, rate / float_rate);
    printf(is_weighted(scene) ? "%d |\n" : "another picture |\n", worst);
}

int main(void)
{
    fill();
    qv_scene plain = scene_for(&qv_weighted_rgba8, rgba8, 4);
    qv_scene wide = scene_for(&qv_weighted_rgba16, rgba16, 8);
    qv_scene with8 = scene_for(&qv_weighted_indexed8, indexed, 1);
    qv_scene with16 = scene_for(&qv_weighted_indexed8_16, indexed, 1);
    qv_scene separate = scene_for(&qv_separate_rgba8, rgba8, 4);
    qv_scene nearest = scene_for(&qv_nearest_rgba8, rgba8, 4);
    with8.volume.palette = palette8[0];
    with8.volume.palette_bytes = sizeof palette8;
    const void *entries = &palette16;
    with16.volume.palette = entries;
    with16.volume.palette_bytes = sizeof palette16;
    puts("| mode, storage | Msamples/s | float, RGBA8 | ratio | largest difference of 255 |");
    puts("|---|---|---|---|---|");
    compare("weighted RGBA8", &plain, &plain);
    compare("weighted RGBA16", &wide, &plain);
    compare("weighted indexed8", &with8, &plain);
    compare("weighted indexed8, 16-bit palette", &with16, &plain);
    compare("separate RGBA8", &separate, &plain);
    compare("nearest RGBA8", &nearest, &plain);
    return 0;
}
