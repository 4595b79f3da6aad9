/*
 * border_rays.c - a ray that leaves air and enters a material (figures 2, 5 and 6).
 * One sample lies between the two, at the phase r, and the next in the material.
 */
#include "wittenbrink.h"

#include <math.h>
#include <string.h>

/* Phases of r in 0 .. 1; positions are read to 1/256 of a voxel. */
enum { phases = 256 };

static const double opacities[] = {0.25, 0.5, 0.75, 1};

/* What 24 bits of read-out and the 16 of a stored opacity leave of a number. */
static const double allowed = 2e-7, allowed_ratio = 2e-5;

/* A ray through air, material and material; the box ends after the sample `last`. */
typedef struct border_ray {
    paper_volume column;
    qv_scene scene;
} border_ray;

static void make_ray(border_ray *ray, double opacity, unsigned depth, double start)
{
    memset(&ray->scene, 0, sizeof ray->scene);
    paper_volume_make(&ray->column, 1, 1, depth);
    for (unsigned z = 1; z < depth; z++) {
        uint16_t *voxel = paper_voxel(&ray->column, 0, 0, z);
        voxel[0] = voxel[1] = voxel[2] = PAPER_FULL;
        voxel[3] = paper_channel(opacity);
    }
    ray->scene.volume = ray->column.volume;
    paper_look_along_z(&ray->scene, start, 1);
}

static void render(double rgba[4], border_ray *ray, const qv_sampling *sampling)
{
    ray->scene.sampling = sampling;
    paper_render_ray(rgba, &ray->scene);
}

/* ---- Sections 2 and 3: samples of opacity 0, 1/2 and 1 ---------------------- */

typedef struct worked_example {
    const char *name;
    const qv_sampling *sampling;
    const char *colour[2], *opacity[2], *result; /* of two and of three samples, as printed */
    double exact[5];                             /* the same */
} worked_example;

static const worked_example examples[] = {
    {"separate",
     &qv_separate_rgba16,
     {"0.25", "0.75"},
     {"0.5", "1"},
     "0.75",
     {0.25, 0.5, 0.75, 1, 0.75}},
    {"weighted", &qv_weighted_rgba16, {"0.5", "1"}, {"0.5", "1"}, "1", {0.5, 0.5, 1, 1, 1}},
};

static void add_row(FILE *table, const worked_example *of, const char *what, const char *paper,
                    double exact, double ours)
{
    char name[64];
    (void)snprintf(name, sizeof name, "%s, %s", of->name, what);
    const paper_row row = {name, paper, exact, ours, allowed};
    paper_table_add(table, &row);
}

/* A box of two voxels ends the ray after the sample between air and material. */
static void three_samples(FILE *table, const worked_example *of)
{
    static const char *const names[2][2] = {{"C~ of two samples", "opacity of two samples"},
                                            {"C~ of three samples", "opacity of three samples"}};
    double rgba[4] = {0};
    for (unsigned i = 0; i < 2; i++) {
        border_ray ray;
        make_ray(&ray, 1, 2 + i, 0);
        render(rgba, &ray, of->sampling);
        add_row(table, of, names[i][0], of->colour[i], of->exact[2 * i], rgba[0]);
        add_row(table, of, names[i][1], of->opacity[i], of->exact[2 * i + 1], rgba[3]);
        paper_volume_free(&ray.column);
    }
    add_row(table, of, "colour of the ray", of->result, of->exact[4], rgba[0] / rgba[3]);
}

/* ---- Section 4: every phase ---------------------------------------------------- */

/* Largest differences over all phases, and the curve's extremes. */
typedef struct curve {
    double separate_off, weighted_off, colour_off;
    double separate_least, weighted_least;
} curve;

/*
 * The air's centre lies at 1/2, the material's first at 3/2: the sample between is at
 * r + 1/2. A box of depth 2 for r < 1/2, of 3 from there on, ends the ray after one
 * sample in the material; one in the air may come first.
 */
static void phase(FILE *data, curve *of, double r, double a)
{
    border_ray ray;
    double separate[4], weighted[4];
    const double separate_exact = a * (1 + r * r - r * a), weighted_exact = a * (1 + r - r * a);
    make_ray(&ray, a, r < 0.5 ? 2 : 3, r + 0.5);
    render(separate, &ray, &qv_separate_rgba16);
    render(weighted, &ray, &qv_weighted_rgba16);
    fprintf(data, "%.8f %.8f %.8f %.8f %.8f %.8f %.8f\n", r, separate[0], separate_exact,
            weighted[0], weighted_exact, separate[0] / separate[3], weighted[0] / weighted[3]);
    of->separate_off = fmax(of->separate_off, fabs(separate[0] - separate_exact));
    of->weighted_off = fmax(of->weighted_off, fabs(weighted[0] - weighted_exact));
    of->colour_off = fmax(of->colour_off, fabs(weighted[0] / weighted[3] - 1));
    of->separate_least = fmin(of->separate_least, separate[0]);
    of->weighted_least = fmin(of->weighted_least, weighted[0]);
    paper_volume_free(&ray.column);
}

/* Opacity as 16 bits hold it: the formulas are compared for what is stored. */
static double stored(double opacity)
{
    return paper_channel(opacity) / (double)PAPER_FULL;
}

static void all_phases(curve *of, const char *folder, double opacity)
{
    char name[64];
    (void)snprintf(name, sizeof name, "phase-%.2f.dat", opacity);
    FILE *data = paper_open(folder, name);
    *of = (curve){0, 0, 0, 1, 1};
    fputs("# r, C~ separate, exact, C~ weighted, exact, C~/alpha separate, weighted\n", data);
    for (int i = 1; i < phases; i++) {
        phase(data, of, i / (double)phases, stored(opacity));
    }
    paper_close(data);
}

static void add_worst(FILE *table, const char *what, double opacity, double off, double most)
{
    char name[128];
    (void)snprintf(name, sizeof name, "opacity %.2f, every phase: %s", opacity, what);
    const paper_row row = {name, "0", 0, off, most};
    paper_table_add(table, &row);
}

void border_rays(FILE *table, const char *folder)
{
    paper_table_begin(table, "\n## Sections 2 to 4: a ray that enters a material");
    for (size_t i = 0; i < sizeof examples / sizeof examples[0]; i++) {
        three_samples(table, &examples[i]);
    }
    for (size_t i = 0; i < sizeof opacities / sizeof opacities[0]; i++) {
        curve of;
        all_phases(&of, folder, opacities[i]);
        add_worst(table, "separate, off 1 + r^2 - r a", opacities[i], of.separate_off, allowed);
        add_worst(table, "weighted, off 1 + r - r a", opacities[i], of.weighted_off, allowed);
        add_worst(table, "weighted C~ / alpha, off 1", opacities[i], of.colour_off, allowed_ratio);
        if (opacities[i] == 1) {
            const paper_row least[] = {
                {"figure 6: least separate", "0.75", 0.75, of.separate_least, allowed},
                {"figure 6: least weighted", "1", 1, of.weighted_least, allowed}};
            paper_table_add(table, &least[0]);
            paper_table_add(table, &least[1]);
        }
    }
}
