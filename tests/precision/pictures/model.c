#include "pictures.h"

#include <math.h>
#include <stdlib.h>

const model model_library = {8, 16, 31, 31, true, true, true, false};
const model model_reference = {model_exact, model_exact, model_exact, model_exact,
                               false,       false,       false,       false};

/* A scene, what its voxels are, and units of SPEC sections 12 to 16. */
typedef struct stage {
    const model *of;
    const qv_volume *volume;
    stored_voxels voxels;
    bool associated;
    double one;      /* a stored 1 */
    int bits;        /* of it */
    double light;    /* what 1 is of L: below 2^32 */
    double read_out; /* to levels with 16 fraction bits */
} stage;

static double rounded(double value, int bits)
{
    return bits == model_exact ? value : ldexp(floor(ldexp(value, bits) + 0.5), -bits);
}

/*
 * round(a * b / unit) * unit, ties upwards: a product of two doubles is two doubles, exactly.
 * What is left of the upper one after rounding is exact too.
 */
static double rounded_product(double a, double b, double unit)
{
    const double high = a * b, low = fma(a, b, -high);
    const double scaled = high / unit + 0.5, whole = floor(scaled);
    const double rest = (high / unit - (whole - 0.5)) + low / unit;
    return (whole + (rest < 0 ? -1 : rest >= 1 ? 1 : 0)) * unit;
}

/* a * b / 2^32 of numbers whose unit has 31 fraction bits, rounded to so many. */
static double high_product(double a, double b, int bits)
{
    const double scaled = ldexp(b, -32); /* exact */
    return bits < 0 ? a * scaled : rounded_product(a, scaled, ldexp(1, 31 - bits));
}

/* ---- Sections 10 and 11: the cell of a point and its weights ------------------------- */

typedef struct cell {
    size_t corner[8];
    double weight[8];
} cell;

static double locate(size_t at[2], double point, uint16_t size, int bits)
{
    const double place = rounded(point - 0.5, bits), lower = floor(place);
    for (int side = 0; side < 2; side++) {
        at[side] = (size_t)fmax(0, fmin(lower + side, size - 1));
    }
    return place - lower;
}

/* Products are rounded, and the rest is differences: weights of few bits may be one unit below
   0, but their sum is 1. */
static void weigh(double w[8], const double f[3], int bits)
{
    const double x = rounded(f[0], bits), y = rounded(f[1], bits), z = rounded(f[2], bits);
    const double xy = rounded(x * y, bits), xz = rounded(x * z, bits), yz = rounded(y * z, bits);
    w[7] = rounded(xy * z, bits);
    w[6] = yz - w[7];
    w[5] = xz - w[7];
    w[3] = xy - w[7];
    w[1] = x - xy - w[5];
    w[2] = y - xy - w[6];
    w[4] = z - xz - w[6];
    w[0] = 1 - x - (y - xy) - w[4];
}

static void find_cell(cell *found, const stage *s, const double point[3])
{
    const uint16_t *size = s->volume->size;
    size_t at[3][2];
    double fraction[3];
    for (int axis = 0; axis < 3; axis++) {
        fraction[axis] = locate(at[axis], point[axis], size[axis], s->of->position);
    }
    for (unsigned q = 0; q < 8; q++) {
        found->corner[q] = at[0][q & 1] + size[0] * (at[1][q >> 1 & 1] + size[1] * at[2][q >> 2]);
    }
    weigh(found->weight, fraction, s->of->weights);
}

/* ---- Section 12: a sample ------------------------------------------------------------- */

/* A term of more than 8 bits a channel is cut to the unit of L; of 8, nothing is left to cut. */
static double term(const stage *s, double share, double colour)
{
    const double product = ldexp(share * colour, 16 - 2 * s->bits);
    return s->of->terms && s->bits > 8 ? floor(product) : product;
}

static void add_weighted(double light[3], const stage *s, double share, const double voxel[4])
{
    for (int channel = 0; channel < 3; channel++) {
        light[channel] += term(s, share, voxel[channel]);
    }
}

/* Associated colours are to be what share and colour would have made, exactly. */
static void add_plain(double light[3], const stage *s, double weight, const double voxel[4])
{
    const double unit = s->associated ? s->light / s->one : 65536;
    for (int channel = 0; channel < 3; channel++) {
        light[channel] += unit * weight * voxel[channel];
    }
}

static void multiply(double light[3], const stage *s, double opacity)
{
    const double unit = ldexp(1, 2 * s->bits);
    for (int channel = 0; channel < 3; channel++) {
        light[channel] = s->of->terms ? rounded_product(light[channel], opacity / unit, 1)
                                      : light[channel] * opacity / unit;
    }
}

/* Returns the opacity O; 65536 stored ones are 1. */
static double sample(double light[3], const stage *s, const double point[3])
{
    cell at;
    double opacity = 0;
    find_cell(&at, s, point);
    light[0] = light[1] = light[2] = 0;
    for (unsigned q = 0; q < 8; q++) {
        const double *voxel = s->voxels[at.corner[q]];
        const double share = 65536 * at.weight[q] * voxel[3];
        opacity += share;
        if (s->of->separate || s->associated) {
            add_plain(light, s, at.weight[q], voxel);
        } else {
            add_weighted(light, s, share, voxel);
        }
    }
    if (s->of->separate) {
        multiply(light, s, opacity);
    }
    return opacity;
}

/* ---- Sections 13 to 16 ------------------------------------------------------------------ */

/* As Q0.32: 1 / (2^n - 1) is 2^-n + 2^-2n + ..., each term cut. O is below 2^32: nothing is left
   of it beyond a shift of 16 + 32. */
static double opacity32(const stage *s, double opacity)
{
    double sum = 0;
    if (!s->of->opacity) {
        return opacity * 65536 / s->one;
    }
    for (int shift = s->bits; shift <= 48; shift += s->bits) {
        sum += floor(ldexp(opacity, 16 - shift));
    }
    return sum;
}

static double in_half(double value)
{
    return ldexp(store_half(ldexp(value, -31)), 31);
}

/* As it is kept: only halves are rounded after the sum. */
static double kept(double light, int bits)
{
    return bits == model_half ? in_half(light) : light;
}

static double kept_transmittance(double transmittance, int bits)
{
    const double one = ldexp(1, 31);
    return bits == model_half ? one - in_half(one - transmittance) : transmittance;
}

static void march(double light[4], const stage *s, const ref_ray *ray)
{
    double transmittance = ldexp(1, 31), point[3], of_sample[3];
    light[0] = light[1] = light[2] = 0;
    for (int64_t k = 0; k < ray->count && transmittance > 0; k++) {
        ref_point(point, ray, (double)k);
        const double opacity = opacity32(s, sample(of_sample, s, point));
        for (int channel = 0; channel < 3; channel++) {
            const double more = high_product(of_sample[channel], transmittance, s->of->light);
            light[channel] = kept(light[channel] + more, s->of->light);
        }
        transmittance -= high_product(opacity, transmittance, s->of->transmittance);
        transmittance = kept_transmittance(transmittance, s->of->transmittance);
    }
    light[3] = transmittance;
}

/* Levels with 16 fraction bits, 1 being 255 * 2^16. */
static void read_out(double rgba[4], const stage *s, const double light[4])
{
    const double full = 255 * 65536.0;
    if (s->of->read_out) {
        rgba[3] = full - rounded(ldexp(light[3] * 255, -15), 0);
        for (int channel = 0; channel < 3; channel++) {
            const double level = rounded_product(light[channel], ldexp(s->read_out, -32), 1);
            rgba[channel] = fmin(rgba[3], level) / full;
        }
        rgba[3] /= full;
        return;
    }
    rgba[3] = 1 - ldexp(light[3], -31);
    for (int channel = 0; channel < 3; channel++) {
        rgba[channel] = 2 * light[channel] / s->light;
    }
}

void model_render(paper_picture *made, const model *of, const picture_scene *scene, const store *by,
                  stored_voxels voxels)
{
    const double one = store_unit(by);
    const int bits = by->kind == STORE_UNORM ? (int)by->bits : 16;
    const double light = ldexp(one * one, 32 - 2 * bits);
    const stage s = {of,     &scene->scene.volume,
                     voxels, by->associated,
                     one,    bits,
                     light,  floor(ldexp(255 / light, 49) + 0.5)};
    paper_picture_make(made, scene->edge, scene->edge);
    for (int32_t y = 0; y < scene->edge; y++) {
        for (int32_t x = 0; x < scene->edge; x++) {
            ref_ray ray;
            double light_of_ray[4];
            ref_stored_ray(&ray, &scene->scene, x, y);
            march(light_of_ray, &s, &ray);
            read_out(made->rgba[y * scene->edge + x], &s, light_of_ray);
        }
    }
}

void model_picture(paper_picture *made, const model *of, const picture_scene *scene,
                   const store *by)
{
    stored_voxels voxels = store_make(scene, by);
    model_render(made, of, scene, by, voxels);
    free(voxels);
}

void truth_picture(paper_picture *made, const picture_scene *scene)
{
    model_picture(made, &model_reference, scene, &store_real);
}
