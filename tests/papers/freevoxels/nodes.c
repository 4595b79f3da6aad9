/*
 * nodes.c - figure 8: the speed-up of many nodes, simulated as in the paper. Blocks of a level
 * are dealt out in turn, once; a node's work for a view is what the library does for its blocks:
 * voxels drawn and pixels written. All nodes wait for the one with the most.
 *
 * A block of the paper is a voxel of a level. Larger blocks, as a file is read and sent in, are
 * fewer, so that some node gets more of the head than others.
 */
#include "freevoxels.h"
#include "draw.h"
#include "head.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { edge = 256 /* pixels */, views = 24, factor = 2 /* by which the scan is reduced */ };
enum { coarsest = 3 };

static const double pi = 3.14159265358979323846;

static const unsigned nodes_counts[] = {8, 16, 32, 64, 96, 128};
static const unsigned block_sides[] = {1, 4, 8, 16};
enum { counts = 6, sides = 4, most_nodes = 128 };

/* ---- Work of a voxel ------------------------------------------------------------- */

/* Pixels that splats have written since it was set to 0. */
static uint64_t pixels_written;

static void count_row(uint32_t *sums, const uint16_t *weights, unsigned count,
                      const uint32_t light[4])
{
    pixels_written += count;
    qv_splatting_added.row(sums, weights, count, light);
}

static const qv_splatting counted = {count_row, 1};

/* Voxels drawn and pixels written. */
static uint64_t work_of(const qv_sums *sums, const qv_splats *splats, const qv_freevoxel *voxel)
{
    pixels_written = 0;
    paper_require(qv_splat(sums, splats, voxel) == QV_OK, "cannot splat a voxel");
    return pixels_written > 0 ? 1 + pixels_written : 0;
}

/* ---- Work of nodes ----------------------------------------------------------------- */

/* Of one view: for each size of block and number of nodes. */
typedef struct load {
    uint64_t work[sides][counts][most_nodes];
    uint64_t all;
} load;

/* The number of a voxel's block on its level. */
static size_t block_of(const qv_freevoxel *voxel, const uint16_t size[3], unsigned side)
{
    size_t number = 0;
    for (int axis = 2; axis >= 0; axis--) {
        number = number * ((size[axis] + side - 1u) / side) + voxel->position[axis] / side;
    }
    return number;
}

static void add_work(load *to, const qv_freevoxel *voxel, const uint16_t size[3], uint64_t work)
{
    to->all += work;
    for (int side = 0; side < sides; side++) {
        const size_t block = block_of(voxel, size, block_sides[side]);
        for (int count = 0; count < counts; count++) {
            to->work[side][count][block % nodes_counts[count]] += work;
        }
    }
}

static double speed_up(const load *of, int side, int count)
{
    uint64_t most = 0;
    for (unsigned node = 0; node < nodes_counts[count]; node++) {
        const uint64_t work = of->work[side][count][node];
        most = work > most ? work : most;
    }
    return (double)of->all / (double)most;
}

/* ---- Views ---------------------------------------------------------------------------- */

/* The head with all of its levels. */
typedef struct levels {
    paper_volume made;
    paper_pyramid pyramid;
    attenuated light;
} levels;

static void levels_make(levels *made)
{
    qv_transfer glass;
    glass_transfer(&glass);
    head_make(&made->made, &glass, factor);
    paper_pyramid_make(&made->pyramid, &made->made.volume, &qv_filter_box2, &qv_domain_extinction,
                       coarsest);
    attenuated_make(&made->light, &made->made.volume, QV_DIRECTIONS_ALL, coarsest);
}

static void levels_free(levels *of)
{
    attenuated_free(&of->light);
    paper_pyramid_free(&of->pyramid);
    paper_volume_free(&of->made);
}

/* Draws all voxels of a level. */
static void draw_level(load *to, const levels *of, const qv_sums *sums, const qv_splats *splats,
                       uint8_t number)
{
    qv_volume level;
    qv_freevoxel voxel = {NULL, NULL, {0, 0, 0}, number};
    uint16_t *const at = voxel.position;
    paper_require(qv_pyramid_level(&level, &of->made.volume, &of->pyramid.pyramid, number) == QV_OK,
                  "cannot describe a level");
    voxel.voxel = level.voxels;
    for (at[2] = 0; at[2] < level.size[2]; at[2]++) {
        for (at[1] = 0; at[1] < level.size[1]; at[1]++) {
            for (at[0] = 0; at[0] < level.size[0]; at[0]++) {
                voxel.attenuation = qv_attenuation_at(&of->light.level[number], at);
                add_work(to, &voxel, level.size, work_of(sums, splats, &voxel));
                voxel.voxel += level.stride[0];
            }
        }
    }
}

/* From anywhere, and from near to far: part of the head fills the frame, or all of it a part. */
static void look(qv_splat_scene *scene, const qv_volume *volume, draws *random)
{
    const double turn = draw_real(random, 0, 360);
    const double up = asin(draw_real(random, -1, 1)) * 180 / pi, zoom = draw_scale(random, 0.4, 3);
    const paper_view view = {turn, up, 236 / (zoom * edge), 1, edge, edge};
    splat_scene_make(scene, volume, &view);
    scene->splatting = &counted;
    scene->directions = QV_DIRECTIONS_ALL;
    scene->field_of_view = 0x15555555u; /* 30 degrees */
    scene->coarsest = coarsest;
    scene->detail = 2 << 8;
}

static void draw_view(load *to, const levels *of, draws *random)
{
    const size_t count = (size_t)edge * edge * QV_SUM_CHANNELS;
    const qv_sums sums = {paper_memory(count, sizeof(uint32_t)), count, {0, 0, edge, edge}};
    qv_splat_scene scene;
    qv_splats splats;
    look(&scene, &of->made.volume, random);
    const qv_status status = qv_splat_init(&splats, &scene);
    paper_require(status == QV_OK, qv_status_text(status));
    memset(to, 0, sizeof *to);
    for (uint8_t number = 0; number <= coarsest; number++) {
        draw_level(to, of, &sums, &splats, number);
    }
    free(sums.sums);
}

/* ---- The figure --------------------------------------------------------------------------- */

/* Of all views: speed-ups, and the work of each of the most nodes as part of an equal share. */
typedef struct figure {
    double sum[sides][counts], least[sides][counts];
    double share[sides][most_nodes];
} figure;

static void add_view(figure *to, const load *of)
{
    for (int side = 0; side < sides; side++) {
        for (int count = 0; count < counts; count++) {
            const double found = speed_up(of, side, count);
            to->sum[side][count] += found;
            to->least[side][count] =
                to->least[side][count] > 0 ? fmin(to->least[side][count], found) : found;
        }
        for (int node = 0; node < most_nodes; node++) {
            to->share[side][node] +=
                most_nodes * (double)of->work[side][counts - 1][node] / (double)of->all / views;
        }
    }
}

static void write_shares(const char *folder, const figure *of)
{
    FILE *data = paper_open(folder, "shares.dat");
    for (int node = 0; node < most_nodes; node++) {
        fprintf(data, "%d", node);
        for (int side = 0; side < sides; side++) {
            fprintf(data, " %.4f", of->share[side][node]);
        }
        fputc('\n', data);
    }
    paper_close(data);
}

static void write_speed_ups(FILE *table, const char *folder, const figure *of)
{
    FILE *data = paper_open(folder, "nodes.dat");
    char what[96];
    for (int count = 0; count < counts; count++) {
        fprintf(data, "%u", nodes_counts[count]);
        for (int side = 0; side < sides; side++) {
            const double mean = of->sum[side][count] / views, least = of->least[side][count];
            (void)snprintf(what, sizeof what, "%u nodes, blocks of %u voxels an axis",
                           nodes_counts[count], block_sides[side]);
            pairs_add(table, what, mean, least);
            fprintf(data, " %.3f %.3f", mean, least);
        }
        fputc('\n', data);
    }
    paper_close(data);
}

void nodes(FILE *table, const char *folder)
{
    static load of_view;
    figure all;
    levels head;
    draws random = draw_seeded(8);
    memset(&all, 0, sizeof all);
    levels_make(&head);
    for (int i = 0; i < views; i++) {
        draw_view(&of_view, &head, &random);
        add_view(&all, &of_view);
    }
    levels_free(&head);
    pairs_begin(table,
                "\n## Figure 8: speed-up, SIMULATED: all work by that of the busiest node, "
                "24 random views of the head at half its resolution",
                "mean of views", "worst view");
    write_speed_ups(table, folder, &all);
    write_shares(folder, &all);
}
