/*
 * part_slices.c - the error of pictures by slices: what the frame buffer keeps, and dithering.
 */
#include "pictures.h"

typedef struct slicing {
    const char *name, *how;
    const qv_blend *blend;
    qv_dither dither;
} slicing;

static const slicing ways[] = {
    {"over_rgba8888", "rounded", &qv_over_rgba8888, {.sequence = qv_sequence_rounded}},
    {"over_rgba8888", "golden ratio", &qv_over_rgba8888, {.sequence = qv_sequence_golden}},
    {"over_rgba8888", "hash", &qv_over_rgba8888, {.sequence = qv_sequence_hash}},
    {"over_rgba8888", "blocks", &qv_over_rgba8888, {.sequence = qv_sequence_blocks}},
    {"hardware_rgba8888",
     "rounded",
     &qv_hardware_rgba8888,
     {.sequence = qv_sequence_blocks, .technique = &qv_technique_rounded}},
    {"hardware_rgba8888",
     "ordered",
     &qv_hardware_rgba8888,
     {.sequence = qv_sequence_blocks, .technique = &qv_technique_ordered, .period = 16}},
    {"over_rgba12", "rounded", &qv_over_rgba12, {.sequence = qv_sequence_rounded}},
    {"over_rgba12", "blocks", &qv_over_rgba12, {.sequence = qv_sequence_blocks}},
    {"over_rgba16", "rounded", &qv_over_rgba16, {.sequence = qv_sequence_rounded}},
    {"over_rgba16", "blocks", &qv_over_rgba16, {.sequence = qv_sequence_blocks}},
    {"under_rgb16", "blocks", &qv_under_rgb16, {.sequence = qv_sequence_blocks}},
    {"over_rgba24", "rounded", &qv_over_rgba24, {.sequence = qv_sequence_rounded}},
    {"under_rgb24", "rounded", &qv_under_rgb24, {.sequence = qv_sequence_rounded}},
};

static const our_mode rgba16 = {"RGBA16", QV_STORAGE_RGBA16, &qv_weighted_rgba16, REF_WEIGHTED};

/* The mist alone, where dithering matters most, and all scenes. */
typedef struct by_way {
    picture_error all, mist;
} by_way;

static void add_scene(by_way found[COUNT(ways)], unsigned number)
{
    const store stored = {"RGBA16", STORE_UNORM, 16, false};
    model as = model_reference;
    picture_scene scene;
    paper_picture truth;
    ours_volume volume;
    as.position = model_library.position;
    picture_scene_make(&scene, number);
    model_picture(&truth, &as, &scene, &stored);
    ours_make(&volume, &scene, &rgba16);
    for (size_t i = 0; i < COUNT(ways); i++) {
        paper_picture got;
        paper_render_slices(&got, &volume.scene, ways[i].blend, &ways[i].dither, scene.edge,
                            scene.edge);
        if (number == 0) {
            error_add(&found[i].mist, &got, &truth);
        }
        error_take(&found[i].all, &got, &truth);
    }
    ours_free(&volume);
    paper_picture_free(&truth);
    picture_scene_free(&scene);
}

void part_slices(const char *folder)
{
    static by_way found[COUNT(ways)];
    table t;
    printf("### 2.5 Frame buffers and dithering\n\n"
           "The scenes slice by slice, RGBA16, against double precision of the same voxels and "
           "points,\nbefore packing to 8 bits. What 1000 slices do is in the table of "
           "`qv_recommend`.\n\n");
    for (unsigned number = 0; number < picture_scenes; number++) {
        add_scene(found, number);
    }
    table_begin(&t, folder, "pictures_slices",
                "frame buffer|dither|all scenes: RMS|worst|PSNR|mist: RMS|worst|PSNR");
    for (size_t i = 0; i < COUNT(ways); i++) {
        table_text(&t, ways[i].name);
        table_text(&t, ways[i].how);
        table_error(&t, &found[i].all);
        table_error(&t, &found[i].mist);
    }
    table_end(&t);
}
