/*
 * lit_head.c - figure 7: a head in red light, which casts shadows: by splats, and by rays through
 * voxels that were lit first. Light is attenuated by the same bytes for both.
 */
#include "freevoxels.h"
#include "head.h"

#include <math.h>
#include <string.h>

enum { edge = 600 /* pixels */ };

/* Before the face, to its right. The scan's x runs to the left of the head, its y to the nose. */
static const paper_view view = {135, 10, 236.0 / edge, 0.5, edge, edge};

/* Red light from above the face, and a little of blue from everywhere. */
static const qv_lighting lighting = {
    .lamps = {{{100, 700, 700}, {65535, 9000, 6000}}},
    .count = 1,
    .ambient = {5000, 7000, 12000},
};

static const uint8_t night[4] = {10, 12, 20, 255};

static double red_of(const paper_picture *of, size_t pixel)
{
    return of->rgba[pixel][0];
}

/* The share of the head's pixels that have less than so much of the red that they have unlit. */
static double share_below(const paper_picture *lit, const paper_picture *unlit, double part)
{
    double below = 0, all = 0;
    for (size_t i = 0; i < (size_t)edge * edge; i++) {
        if (red_of(unlit, i) > 0.5) {
            all++;
            below += red_of(lit, i) < part * red_of(unlit, i);
        }
    }
    return below / all;
}

/* By rays; the volume's voxels are lit in place, if it is to be lit. */
static void cast(paper_picture *made, const paper_volume *head, const qv_attenuation *light)
{
    const uint16_t *size = head->volume.size;
    const qv_block all = {{0, 0, 0}, {size[0], size[1], size[2]}};
    qv_scene scene;
    if (light != NULL) {
        paper_require(qv_illuminate(head->voxels, (size_t)head->volume.voxels_bytes, &head->volume,
                                    light, &lighting, QV_BETWEEN_LIGHT, &all) == QV_OK,
                      "cannot light the head");
    }
    memset(&scene, 0, sizeof scene);
    scene.volume = head->volume;
    scene.sampling = &qv_extinction_rgba16;
    scene.termination = QV_TERMINATION_DEFAULT;
    memcpy(scene.background, night, sizeof night);
    paper_look(&scene, &view);
    paper_render(made, &scene, edge, edge);
}

/* Pictures of one way to draw, unlit and lit. */
typedef struct way {
    paper_picture unlit, lit;
} way;

static void write(const char *folder, const char *name, const way *of)
{
    char file[64];
    (void)snprintf(file, sizeof file, "head-unlit-%s", name);
    paper_write_picture(folder, file, &of->unlit);
    (void)snprintf(file, sizeof file, "head-lit-%s", name);
    paper_write_picture(folder, file, &of->lit);
}

static void draw_both(way *splats, way *rays)
{
    const int16_t *lamp = lighting.lamps[0].direction;
    const double to_lamp[3] = {lamp[0], lamp[1], lamp[2]};
    qv_splat_scene scene;
    paper_volume head;
    qv_transfer skin;
    attenuated light;
    skin_transfer(&skin);
    head_make(&head, &skin, 1);
    splat_scene_make(&scene, &head.volume, &view);
    scene.directions |= directions_around(to_lamp);
    memcpy(scene.background, night, sizeof night);
    attenuated_make(&light, &head.volume, scene.directions, 0);
    paper_splat(&splats->unlit, &scene, &head.volume, light.level);
    cast(&rays->unlit, &head, NULL);
    scene.lighting = lighting;
    paper_splat(&splats->lit, &scene, &head.volume, light.level);
    cast(&rays->lit, &head, light.level);
    attenuated_free(&light);
    paper_volume_free(&head);
}

static void free_pictures(way *of)
{
    paper_picture_free(&of->unlit);
    paper_picture_free(&of->lit);
}

void lit_head(FILE *table, const char *folder)
{
    way splats, rays;
    draw_both(&splats, &rays);
    write(folder, "splats", &splats);
    write(folder, "rays", &rays);
    pairs_begin(table, "\n## Figure 7: a head in red light", "splats", "ray casting");
    pairs_add(table, "share of the head in shadow, red below 1/4",
              share_below(&splats.lit, &splats.unlit, 0.25),
              share_below(&rays.lit, &rays.unlit, 0.25));
    pairs_add(table, "share of the head in light, red above 1/2",
              1 - share_below(&splats.lit, &splats.unlit, 0.5),
              1 - share_below(&rays.lit, &rays.unlit, 0.5));
    pairs_add(table, "RMS of splats from ray casting: unlit, lit",
              paper_rms(&splats.unlit, &rays.unlit), paper_rms(&splats.lit, &rays.lit));
    free_pictures(&splats);
    free_pictures(&rays);
}
