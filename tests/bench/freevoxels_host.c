/*
 * freevoxels_host.c - FreeVoxels on this machine: building all 26 directions of a volume beside a
 * memcpy of as many bytes, and a frame of splats beside a frame by rays, each pair in one run, the
 * best of several; then what configurations take in memory. Markdown tables.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "qvol.h"

#define SIZE   128
#define FRAME  256
#define RUNS   3
#define VOXELS ((size_t)SIZE * SIZE * SIZE)
#define BYTES  (VOXELS * QV_DIRECTIONS)
#define COPIED (VOXELS * (QV_DIRECTIONS + 1)) /* the bytes of all directions, and an index */

static uint8_t voxels[VOXELS];
static uint8_t palette[QV_PALETTE_ENTRIES][4];
static uint8_t from[COPIED], to[COPIED];
static uint32_t sums[FRAME * FRAME * QV_SUM_CHANNELS];
static uint8_t pixels[FRAME * FRAME * 4];

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void must(qv_status status)
{
    if (status == QV_OK)
        return;
    fprintf(stderr, "%s\n", qv_status_text(status));
    exit(1);
}

/* ---- Scenes ------------------------------------------------------------------- */

/* Three shells of a ball, soft ones, that fill about half of the box. */
static void fill(qv_volume *volume)
{
    const qv_control_point points[] = {
        {8, {0, 0, 0, 0}}, {40, {20000, 40000, 65535, 600}}, {255, {65535, 50000, 20000, 6000}}};
    qv_transfer table;
    must(qv_transfer_build(&table, points, 3));
    qv_transfer_to_palette8(palette, &table);
    for (size_t i = 0; i < VOXELS; i++) {
        long x = (long)(i % SIZE) - SIZE / 2, y = (long)(i / SIZE % SIZE) - SIZE / 2;
        long z = (long)(i / SIZE / SIZE) - SIZE / 2;
        long square = (x * x + y * y + z * z) * 768 / (SIZE * SIZE / 4);
        voxels[i] = (uint8_t)(square < 768 ? square % 256 : 0);
    }
    *volume = (qv_volume){.voxels = voxels,
                          .voxels_bytes = VOXELS,
                          .palette = palette[0],
                          .palette_bytes = sizeof palette,
                          .size = {SIZE, SIZE, SIZE},
                          .stride = {1, SIZE, SIZE * SIZE},
                          .storage = QV_STORAGE_INDEXED8,
                          .unit_distance = QV_ONE_Q16};
}

static void look(qv_view *view)
{
    *view =
        (qv_view){.pitch = QV_ONE_Q16 * 3 / 4, .step = QV_ONE_Q16, .width = FRAME, .height = FRAME};
    qv_rotation(view->rotation, 0x15555555u, 0x0E38E38Eu, 0);
}

/* ---- What is timed -------------------------------------------------------------- */

static void build(const qv_volume *volume, const qv_attenuation *attenuation)
{
    for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++)
        must(qv_attenuate(to, BYTES, NULL, attenuation, volume, &qv_domain_extinction, direction));
}

static void splat(const qv_volume *volume, const qv_attenuation *attenuation,
                  qv_interpolation interpolation)
{
    static const qv_block whole = {{0, 0, 0}, {SIZE, SIZE, SIZE}};
    const qv_sums all = {sums, sizeof sums / sizeof *sums, {0, 0, FRAME, FRAME}};
    const qv_image image = {pixels, sizeof pixels, FRAME * 4, &qv_format_rgba8888};
    qv_splats splats;
    qv_splat_scene scene = {.splatting = &qv_splatting_added,
                            .kernel = &qv_kernel_quadratic,
                            .domain = &qv_domain_extinction,
                            .directions = attenuation->directions,
                            .interpolation = (uint8_t)interpolation,
                            .volume = *volume};
    look(&scene.view);
    must(qv_splat_init(&splats, &scene));
    must(qv_sums_clear(&all, &splats));
    must(qv_splat_block(&all, &splats, volume, attenuation, 0, &whole));
    must(qv_sums_read_out(&image, &all, &splats));
}

static void cast(const qv_volume *volume)
{
    const qv_image image = {pixels, sizeof pixels, FRAME * 4, &qv_format_rgba8888};
    const qv_rect rect = {0, 0, FRAME, FRAME};
    qv_scene scene = {.sampling = &qv_weighted_indexed8, .volume = *volume};
    qv_context context;
    qv_view view;
    look(&view);
    must(qv_orthographic(&scene.camera, volume, &view));
    must(qv_init(&context, &scene));
    must(qv_render(&image, &context, &rect));
}

/* The best of each in several runs, in turn. */
enum { COPY, BUILD, BETWEEN, NEAREST, RAYS, TASKS };

static void run(int task, const qv_volume *volume, const qv_attenuation *attenuation)
{
    switch (task) {
    case COPY:
        memcpy(to, from, COPIED);
        break;
    case BUILD:
        build(volume, attenuation);
        break;
    case RAYS:
        cast(volume);
        break;
    default:
        splat(volume, attenuation, task == NEAREST ? QV_NEAREST : QV_BETWEEN_LIGHT);
    }
}

static void time_all(double best[TASKS], const qv_volume *volume)
{
    const qv_attenuation attenuation = {
        .records = to, .bytes = BYTES, .directions = QV_DIRECTIONS_ALL, .size = {SIZE, SIZE, SIZE}};
    for (int task = 0; task < TASKS; task++)
        best[task] = 1e9;
    for (int i = 0; i < RUNS; i++)
        for (int task = 0; task < TASKS; task++) {
            double start = seconds();
            run(task, volume, &attenuation);
            double time = seconds() - start;
            best[task] = time < best[task] ? time : best[task];
        }
}

static void print_times(const double best[TASKS])
{
    static const char *const names[TASKS] = {
        [COPY] = "memcpy of 27 bytes a voxel",  [BUILD] = "`qv_attenuate`, all 26 directions",
        [BETWEEN] = "frame of splats, between", [NEAREST] = "frame of splats, nearest",
        [RAYS] = "frame by rays, weighted",
    };
    puts("| 128x128x128 voxels, 256x256 pixels | ms | ns a voxel | ratio |\n|---|---|---|---|");
    for (int task = 0; task < TASKS; task++) {
        int beside = task == COPY || task == BUILD ? COPY : RAYS;
        printf("| %s | %.1f | %.2f | %.2f of %s |\n", names[task], 1e3 * best[task],
               1e9 * best[task] / (double)VOXELS, best[task] / best[beside],
               beside == COPY ? "memcpy" : "rays");
    }
}

/* ---- Memory ----------------------------------------------------------------------- */

/* Bytes of a direction set for all levels of a volume, or for the first alone. */
static double attenuation_bytes(uint32_t directions, uint8_t levels)
{
    double bytes = 0;
    for (unsigned l = 0; l <= levels; l++) {
        uint16_t side = (uint16_t)((SIZE + (1u << l) - 1u) >> l);
        const qv_attenuation level = {.directions = directions, .size = {side, side, side}};
        bytes += (double)qv_attenuation_bytes(&level);
    }
    return bytes;
}

static double voxel_bytes(uint8_t storage, unsigned bytes, uint8_t levels)
{
    static const uint16_t size[3] = {SIZE, SIZE, SIZE};
    double coarser = levels == 0 ? 0 : (double)qv_pyramid_bytes(size, storage, levels);
    return (double)(VOXELS * bytes) + coarser;
}

static void print_memory(void)
{
    static const struct {
        const char *name;
        uint8_t storage, bytes;
    } storages[] = {{"indexed8", QV_STORAGE_INDEXED8, 1},
                    {"RGBA8", QV_STORAGE_RGBA8, 4},
                    {"RGBA16", QV_STORAGE_RGBA16, 8}};
    static const uint32_t sets[] = {1, QV_DIRECTIONS_FACES, QV_DIRECTIONS_ALL};
    static const uint16_t size[3] = {SIZE, SIZE, SIZE};
    uint8_t levels = qv_pyramid_levels(size);
    puts(
        "\n| bytes a voxel, without / with all levels | 1 direction | 6 | 26 |\n|---|---|---|---|");
    for (unsigned i = 0; i < sizeof storages / sizeof *storages; i++) {
        printf("| %s |", storages[i].name);
        for (unsigned s = 0; s < sizeof sets / sizeof *sets; s++) {
            double alone = voxel_bytes(storages[i].storage, storages[i].bytes, 0) +
                           attenuation_bytes(sets[s], 0);
            double all = voxel_bytes(storages[i].storage, storages[i].bytes, levels) +
                         attenuation_bytes(sets[s], levels);
            printf(" %.0f / %.2f |", alone / (double)VOXELS, all / (double)VOXELS);
        }
        puts("");
    }
}

int main(void)
{
    double best[TASKS];
    qv_volume volume;
    fill(&volume);
    memset(from, 1, sizeof from);
    time_all(best, &volume);
    print_times(best);
    print_memory();
    return 0;
}
