/*
 * filters.c - section 4.2: how far downsampling and sampling together are from a
 * convolution, by the two errors of Kraus 2008 (quasi-convolution pyramidal blurring).
 *
 * An impulse at p makes a voxel k of a coarse level A(p - k), and sampling that level
 * with the kernel S gives psi(x; p) = sum over k of A(p - k) S(x - k). The nearest
 * convolution is phi(t), the mean of psi(p + t; p) over p. Then, with coarse voxels of
 * length 1,
 *   epsilon^2 = mean over p of the integral of (psi(p + t; p) - phi(t))^2 over t
 *   epsilon_0 = standard deviation of psi(p; p) over p
 *
 * The library's psi is a level of a pyramid that qv_downsample makes, sampled by rays
 * across the volume. In double precision the pyramid has two levels more: from there on
 * the errors change by less than 5e-5.
 */
#include "kraus.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Levels below the coarse one, and coarse voxels along the volume. */
enum { levels_ours = 6, levels_exact = 8, coarse = 16 };

typedef struct pair {
    const char *name;
    const qv_filter *filter;
    double taps[4];
    const qv_sampling *sampling;
    int kernel; /* 1 linear, 2 quadratic B-spline */
    const char *paper[2];
} pair;

static const pair pairs[] = {
    {"box2-linear", &qv_filter_box2, {0, 0.5, 0.5, 0}, &qv_extinction_rgbt16, 1, {"0.34", "0.14"}},
    {"box4-linear",
     &qv_filter_box4,
     {0.25, 0.25, 0.25, 0.25},
     &qv_extinction_rgbt16,
     1,
     {"0.057", "0.0093"}},
    {"quad4-bspline",
     &qv_filter_quad4,
     {13.0 / 64, 19.0 / 64, 19.0 / 64, 13.0 / 64},
     &qv_bspline_extinction_rgbt16,
     2,
     {"0.0276", "0.0027"}},
};

/* psi of every impulse in the middle coarse voxel, `steps` of them, at the centres of all
   fine voxels: row p, column x. */
typedef struct response {
    unsigned steps; /* fine voxels in a coarse one */
    double *psi;
} response;

static void response_make(response *made, int levels)
{
    made->steps = 1u << levels;
    made->psi = paper_memory((size_t)made->steps * made->steps * coarse, sizeof made->psi[0]);
}

/* Fine voxels to the left of the impulses, and within reach of t on either side of one. */
static size_t before(const response *of)
{
    return (size_t)of->steps * coarse / 2;
}

static size_t reach(const response *of)
{
    return (size_t)of->steps * (coarse / 2 - 1);
}

/* psi(p + t; p), t in fine voxels from -reach to reach. */
static double at(const response *of, size_t p, size_t t_and_reach)
{
    return of->psi[p * of->steps * coarse + before(of) + p + t_and_reach - reach(of)];
}

static double phi(const response *of, size_t t_and_reach)
{
    double sum = 0;
    for (size_t p = 0; p < of->steps; p++) {
        sum += at(of, p, t_and_reach);
    }
    return sum / of->steps;
}

/* ---- Double precision -------------------------------------------------------------- */

static double kernel(int of, double t)
{
    const double off = fabs(t);
    if (of == 1) {
        return fmax(0, 1 - off);
    }
    return off < 0.5 ? 0.75 - off * off : off < 1.5 ? 0.5 * (1.5 - off) * (1.5 - off) : 0;
}

/* The next coarser level, mirrored at its ends, in place. */
static void halve(double *values, size_t size, const double taps[4])
{
    for (size_t i = 0; i < size / 2; i++) {
        const double left = values[i == 0 ? 0 : 2 * i - 1];
        const double right = values[2 * i + 2 < size ? 2 * i + 2 : size - 1];
        const double sum = taps[0] * left + taps[1] * values[2 * i] + taps[2] * values[2 * i + 1] +
                           taps[3] * right;
        values[i] = sum;
    }
}

static void compute_impulse(double *psi, const pair *of, const response *in, size_t p)
{
    const size_t length = (size_t)in->steps * coarse;
    double *values = paper_memory(length, sizeof values[0]);
    values[before(in) + p] = in->steps; /* an integral of 1 */
    for (size_t size = length; size > coarse; size /= 2) {
        halve(values, size, of->taps);
    }
    for (uint32_t x = 0; x < length; x++) {
        for (uint32_t k = 0; k < coarse; k++) {
            psi[x] += values[k] * kernel(of->kernel, (x + 0.5) / in->steps - (k + 0.5));
        }
    }
    free(values);
}

/* ---- The library ---------------------------------------------------------------------- */

/* A ray across each fine voxel's place in the coarse level; of a length of 1, so that its
   depth in base 2 is the extinction. */
static void look_across(qv_scene *scene, unsigned steps)
{
    paper_look_along_z(scene, 0.5, 1);
    scene->camera.origin[0] = PAPER_VOXEL / (2 * (qv_coord)steps);
    scene->camera.across[0] = PAPER_VOXEL / (qv_coord)steps;
}

static void render_impulse(double *psi, const pair *of, const response *in, size_t p)
{
    const uint32_t length = in->steps * coarse;
    paper_volume made;
    paper_pyramid pyramid;
    paper_picture picture;
    qv_scene scene;
    memset(&scene, 0, sizeof scene);
    paper_volume_make(&made, length, 1, 1);
    paper_hold_extinction(&made, in->steps * log(2)); /* an integral of 1, in base 2 */
    paper_voxel(&made, (unsigned)(before(in) + p), 0, 0)[3] = PAPER_FULL;
    paper_pyramid_make(&pyramid, &made.volume, of->filter, &qv_domain_stored, levels_ours);
    paper_require(qv_pyramid_level(&scene.volume, &made.volume, &pyramid.pyramid, levels_ours) ==
                      QV_OK,
                  "cannot describe a level");
    memset(scene.volume.spacing, 0, sizeof scene.volume.spacing); /* coarse voxels of length 1 */
    scene.sampling = of->sampling;
    look_across(&scene, in->steps);
    paper_render(&picture, &scene, length, 1);
    for (size_t x = 0; x < length; x++) {
        psi[x] = -log2(1 - picture.rgba[x][3]);
    }
    paper_picture_free(&picture);
    paper_pyramid_free(&pyramid);
    paper_volume_free(&made);
}

/* ---- Errors ------------------------------------------------------------------------------ */

typedef struct errors {
    double all, centre;               /* epsilon and epsilon_0 */
    double tensor_all, tensor_centre; /* of the filter in two dimensions */
} errors;

/*
 * With P the mean over p of the integral of psi^2, and F the integral of phi^2, epsilon^2
 * is P - F, and in two dimensions P^2 - F^2; epsilon_0^2 likewise of the moments of
 * psi(p; p).
 */
static errors errors_of(const response *of)
{
    double squares = 0, phi_squares = 0, centre = 0, centre_squares = 0;
    for (size_t t = 0; t <= 2 * reach(of); t++) {
        phi_squares += pow(phi(of, t), 2) / of->steps;
        for (size_t p = 0; p < of->steps; p++) {
            squares += pow(at(of, p, t), 2) / of->steps / of->steps;
        }
    }
    for (size_t p = 0; p < of->steps; p++) {
        centre += at(of, p, reach(of)) / of->steps;
        centre_squares += pow(at(of, p, reach(of)), 2) / of->steps;
    }
    return (errors){sqrt(squares - phi_squares), sqrt(centre_squares - pow(centre, 2)),
                    sqrt(pow(squares, 2) - pow(phi_squares, 2)),
                    sqrt(pow(centre_squares, 2) - pow(centre, 4))};
}

static void add(FILE *table, const pair *of, const char *what, const char *paper, double exact,
                double ours)
{
    char name[96];
    (void)snprintf(name, sizeof name, "%s, %s", of->name, what);
    const paper_row row = {name, paper, exact, ours, 5e-4};
    paper_table_add(table, &row);
}

/* Curves over t: phi, and psi of some impulses. */
static void write_curves(const char *folder, const pair *of, const response *ours)
{
    enum { curves = 8 };
    char name[64];
    (void)snprintf(name, sizeof name, "filter-%s.dat", of->name);
    FILE *data = paper_open(folder, name);
    fputs("# t, phi, psi of impulses spread over a coarse voxel\n", data);
    for (size_t t = 0; t <= 2 * reach(ours); t++) {
        fprintf(data, "%.6f %.6f", ((double)t - (double)reach(ours)) / ours->steps, phi(ours, t));
        for (size_t i = 0; i < curves; i++) {
            fprintf(data, " %.6f", at(ours, i * ours->steps / curves, t));
        }
        fputc('\n', data);
    }
    paper_close(data);
}

static void compare(FILE *table, const char *folder, const pair *of)
{
    response exact, ours;
    response_make(&exact, levels_exact);
    response_make(&ours, levels_ours);
    for (size_t p = 0; p < exact.steps; p++) {
        compute_impulse(exact.psi + p * exact.steps * coarse, of, &exact, p);
    }
    for (size_t p = 0; p < ours.steps; p++) {
        render_impulse(ours.psi + p * ours.steps * coarse, of, &ours, p);
    }
    const errors a = errors_of(&exact), b = errors_of(&ours);
    add(table, of, "epsilon", of->paper[0], a.all, b.all);
    add(table, of, "epsilon_0", of->paper[1], a.centre, b.centre);
    add(table, of, "epsilon in 2-D", "-", a.tensor_all, b.tensor_all);
    add(table, of, "epsilon_0 in 2-D", "-", a.tensor_centre, b.tensor_centre);
    write_curves(folder, of, &ours);
    free(exact.psi);
    free(ours.psi);
}

void filters(FILE *table, const char *folder)
{
    paper_table_begin(table,
                      "\n## Section 4.2: how far filters are from a convolution\n\n"
                      "The paper's errors of (13 19 19 13)/64 with B-splines are nearer to those "
                      "of the filter in\ntwo dimensions than in one.");
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        compare(table, folder, &pairs[i]);
    }
}
