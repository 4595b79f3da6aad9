/*
 * one_vertex.c - figures 1 and 4: a ray along an axis through one vertex of extinction
 * tau in empty space, with samples at r + k d. Its opacity should not depend on r.
 *
 * Opacity-based sampling stores opacities for d' = d, as the paper does. Extinction-based
 * sampling stores extinction.
 */
#include "kraus.h"

#include <math.h>
#include <string.h>

enum { depth = 9, vertex = 4, phases = 256 };

static const double taus[] = {1, 2, 4, 8};

/* Steps whose spread is tabled. */
static const double steps[] = {0.125, 0.25, 0.5, 0.6, 0.8, 1, 1.2, 1.6};

typedef enum basis { BY_OPACITY, BY_EXTINCTION } basis;

typedef struct method {
    const char *name;
    const qv_sampling *sampling;
    ref_mode mode;
} method;

static const method methods[] = {
    {"opacity", &qv_corrected_rgba16, REF_CORRECTED},
    {"extinction", &qv_extinction_rgbt16, REF_EXTINCTION},
};

/* ---- Rays -------------------------------------------------------------------- */

/* In double precision, with nothing rounded; `unit` is d'. */
static double exact_opacity(basis by, double tau, double d, double unit, double r)
{
    double transmittance = 1;
    for (int k = (int)floor(-(1 + r) / d); k <= (1 - r) / d; k++) {
        const double weight = fmax(0, 1 - fabs(r + k * d));
        if (by == BY_EXTINCTION) {
            transmittance *= exp(-tau * weight * d);
        } else {
            transmittance *= pow(1 - paper_opacity(tau, unit) * weight, d / unit);
        }
    }
    return 1 - transmittance;
}

typedef struct vertex_ray {
    paper_volume column;
    qv_scene scene;
} vertex_ray;

static void make_ray(vertex_ray *ray, basis by, double tau, double unit)
{
    memset(&ray->scene, 0, sizeof ray->scene);
    paper_volume_make(&ray->column, 1, 1, depth);
    uint16_t *voxel = paper_voxel(&ray->column, 0, 0, vertex);
    voxel[0] = voxel[1] = voxel[2] = PAPER_FULL;
    if (by == BY_EXTINCTION) {
        voxel[3] = PAPER_FULL;
        paper_hold_extinction(&ray->column, tau);
    } else {
        voxel[3] = paper_channel(paper_opacity(tau, unit));
        ray->column.volume.unit_distance = (uint32_t)floor(unit * QV_ONE_Q16 + 0.5);
    }
    ray->scene.volume = ray->column.volume;
    ray->scene.sampling = methods[by].sampling;
}

/* The vertex lies at the centre of its voxel. */
static double render(vertex_ray *ray, double d, double r)
{
    double rgba[4];
    paper_look_along_z(&ray->scene, vertex + 0.5 + r, d);
    paper_render_ray(rgba, &ray->scene);
    return rgba[3];
}

/* ---- Figure 4 ------------------------------------------------------------------- */

/* Largest less smallest opacity over r. */
typedef struct spreads {
    double exact;     /* in double precision */
    double quantised; /* the same for what is stored, at points of 1/256 voxel */
    double ours;
} spreads;

typedef struct range {
    double least, most;
} range;

static void extend(range *of, double value)
{
    of->least = fmin(of->least, value);
    of->most = fmax(of->most, value);
}

static spreads spreads_over_r(basis by, double tau, double d)
{
    range exact = {1, 0}, quantised = {1, 0}, ours = {1, 0};
    vertex_ray ray;
    make_ray(&ray, by, tau, d);
    for (int i = 0; i < phases; i++) {
        const double r = d * i / phases;
        double rgba[4];
        extend(&exact, exact_opacity(by, tau, d, d, r));
        extend(&ours, render(&ray, d, r));
        paper_reference_ray(rgba, &ray.scene, methods[by].mode);
        extend(&quantised, rgba[3]);
    }
    paper_volume_free(&ray.column);
    return (spreads){exact.most - exact.least, quantised.most - quantised.least,
                     ours.most - ours.least};
}

static void add_spread(FILE *table, basis by, double tau, double d)
{
    const double most = 2.0 / PAPER_FULL; /* where the phase must not matter at all */
    const double share = 0.04; /* else: points are rounded to 1/256 voxel, where opacity is steep */
    const bool constant = by == BY_EXTINCTION && floor(1 / d) == 1 / d;
    const spreads found = spreads_over_r(by, tau, d);
    char what[96];
    (void)snprintf(what, sizeof what, "spread, %s, tau %g, d %g", methods[by].name, tau, d);
    const paper_row raw = {what, "-", found.exact, found.ours,
                           constant ? most : share * found.exact};
    paper_table_add(table, &raw);
    (void)snprintf(what, sizeof what, "same, points and voxels as stored");
    const paper_row stored = {what, "-", found.quantised, found.ours, constant ? most : 1e-6};
    paper_table_add(table, &stored);
}

/* Surfaces over (d, r): gnuplot wants an empty line behind each d. */
static void write_surface(const char *folder, basis by, double tau)
{
    const int across = 40;
    char name[64];
    (void)snprintf(name, sizeof name, "figure4-%s-%g.dat", methods[by].name, tau);
    FILE *data = paper_open(folder, name);
    fputs("# d, r, opacity by the library, in double precision\n", data);
    for (int j = 1; j <= across; j++) {
        const double d = 2.0 * j / across;
        vertex_ray ray;
        make_ray(&ray, by, tau, d);
        for (int i = 0; i <= across; i++) {
            const double r = i / (double)across;
            fprintf(data, "%.4f %.4f %.8f %.8f\n", d, r, render(&ray, d, r),
                    exact_opacity(by, tau, d, d, r));
        }
        fputc('\n', data);
        paper_volume_free(&ray.column);
    }
    paper_close(data);
}

static void figure4(FILE *table, const char *folder, basis by)
{
    for (size_t t = 0; t < sizeof taus / sizeof taus[0]; t++) {
        write_surface(folder, by, taus[t]);
        for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
            add_spread(table, by, taus[t], steps[i]);
        }
    }
}

/* ---- Where it breaks ------------------------------------------------------------------ */

/* The first step whose opacity varies by 1/20: by what is exact, or by ours. */
static double breaks_at(double tau, bool exactly)
{
    const double first = 1.02, apart = 0.02, last = 2, broken = 0.05;
    double d = first;
    for (; d < last; d += apart) {
        const spreads found = spreads_over_r(BY_EXTINCTION, tau, d);
        if ((exactly ? found.exact : found.ours) >= broken) {
            break;
        }
    }
    return d;
}

/* Allowed is one step of d beside. */
static void add_breaks(FILE *table)
{
    static const double walls[] = {2, 4, 8, 16};
    for (size_t i = 0; i < sizeof walls / sizeof walls[0]; i++) {
        char what[96];
        (void)snprintf(what, sizeof what, "extinction, tau %g: breaks at d", walls[i]);
        const paper_row row = {what, "-", breaks_at(walls[i], true), breaks_at(walls[i], false),
                               0.021};
        paper_table_add(table, &row);
    }
}

/* ---- Section 3.5: d' = 1 and d towards 0 ------------------------------------------- */

/* What equation 16 tends to: the integral of -ln(1 - opacity) along the ray. */
static double limit(double tau)
{
    const int parts = 4096;
    double tau_of_ray = 0;
    for (int i = 0; i < parts; i++) {
        tau_of_ray -= 2 * log(1 - paper_opacity(tau, 1) * (i + 0.5) / parts) / parts;
    }
    return paper_opacity(tau_of_ray, 1);
}

static void add_limit(FILE *table, basis by, double tau, double exact, double allowed)
{
    const double small = 1.0 / 256;
    char what[96];
    vertex_ray ray;
    make_ray(&ray, by, tau, 1);
    (void)snprintf(what, sizeof what, "d' = 1, d 1/256, %s, tau %g", methods[by].name, tau);
    const paper_row row = {what, "-", exact, render(&ray, small, 0), allowed};
    paper_table_add(table, &row);
    paper_volume_free(&ray.column);
}

void one_vertex(FILE *table, const char *folder)
{
    paper_table_begin(table, "\n## Figure 4: spread over r of a ray's opacity");
    figure4(table, folder, BY_OPACITY);
    figure4(table, folder, BY_EXTINCTION);
    add_breaks(table);
    paper_table_begin(table, "\n## Section 3.5: small steps do not help opacities for d' = 1");
    for (size_t t = 0; t < sizeof taus / sizeof taus[0]; t++) {
        add_limit(table, BY_OPACITY, taus[t], limit(taus[t]), 0.001);
        add_limit(table, BY_EXTINCTION, taus[t], paper_opacity(taus[t], 1), 2e-5);
    }
}
