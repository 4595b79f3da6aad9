/*
 * part_steps.c - the error of the picture by the step: of arithmetic, and of sampling itself.
 */
#include "pictures.h"

#include <math.h>

enum { finest = -4, coarsest = 2 /* powers of 2 of a voxel */, steps = coarsest - finest + 1 };

static const our_mode modes[] = {
    {"corrected", QV_STORAGE_RGBA16, &qv_corrected_rgba16, REF_CORRECTED},
    {"extinction", QV_STORAGE_RGBA16, &qv_extinction_rgba16, REF_EXTINCTION},
};

/* The views have a step of one voxel. */
static void set_step(qv_scene *scene, int power)
{
    qv_camera *camera = &scene->camera;
    camera->step = (uint32_t)ldexp(QV_ONE_Q16, power);
    for (int axis = 0; axis < 3; axis++) {
        camera->along[axis] = (qv_coord)floor(ldexp((double)camera->along[axis], power) + 0.5);
    }
}

/* Renders a scene at a step by the library and by the reference. */
static void render(paper_picture *got, paper_picture *exact, const ours_volume *volume,
                   const our_mode *by, uint16_t edge, int power)
{
    qv_scene scene = volume->scene;
    paper_picture all;
    set_step(&scene, power);
    scene.volume.unit_distance = QV_ONE_Q16;
    paper_render(&all, &scene, edge, edge);
    paper_thin_out(got, &all);
    paper_render_reference(exact, &scene, by->mode, edge, edge);
    paper_picture_free(&all);
}

typedef struct by_step {
    picture_error arithmetic, sampling;
} by_step;

static void add_scene(by_step into[steps], const our_mode *by, unsigned number)
{
    picture_scene scene;
    ours_volume volume;
    paper_picture truth = {0};
    picture_scene_make(&scene, number);
    ours_make(&volume, &scene, by);
    for (int i = 0; i < steps; i++) {
        paper_picture got, exact;
        render(&got, &exact, &volume, by, scene.edge, finest + i);
        error_take(&into[i].arithmetic, &got, &exact);
        if (i == 0) {
            truth = exact;
        } else {
            error_take(&into[i].sampling, &exact, &truth);
        }
    }
    paper_picture_free(&truth);
    ours_free(&volume);
    picture_scene_free(&scene);
}

void part_steps(const char *folder)
{
    table t;
    printf("### 2.3 Step\n\n"
           "RGBA16; every fifth row and column of every scene. Arithmetic: the library against "
           "double precision\nat the same step. Sampling: double precision against itself at "
           "1/16 voxel.\n\n");
    table_begin(&t, folder, "pictures_steps",
                "mode|step in voxels|arithmetic: RMS|worst|PSNR|sampling: RMS|worst|PSNR");
    for (size_t i = 0; i < COUNT(modes); i++) {
        by_step found[steps] = {{.arithmetic = {0}}};
        for (unsigned number = 0; number < picture_scenes; number++) {
            add_scene(found, &modes[i], number);
        }
        for (int power = finest; power <= coarsest; power++) {
            table_text(&t, modes[i].name);
            table_number(&t, "%g", ldexp(1, power));
            table_error(&t, &found[power - finest].arithmetic);
            table_error(&t, &found[power - finest].sampling);
        }
    }
    table_end(&t);
}
