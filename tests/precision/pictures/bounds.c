/*
 * bounds.c - how far a pixel may be off, summed along its ray.
 *
 * Behind transmittance T, and in front of light C of at most 1, a sample whose opacity is off by
 * da and whose associated colour by dc changes the pixel by T |dc - da C|, to first order. Both
 * come of the same voxels: where a weight is off by e, or an opacity A of a colour K by d, that is
 * e A (K - C) or d (K - C), so that the colour counts once, not twice.
 */
#include "pictures.h"

#include <math.h>

/* What qvol.h and SPEC say of one operation. */
static const double weight_linear = 0x1p-17;         /* one product, to nearest: 2^-16 / 2 */
static const double weight_bspline = 2.32 * 0x1p-16; /* 1 for each axis, and 3/4 of those before */
static const double opacity32 = 3 * 0x1p-32;         /* cut */
static const double accumulated = 3 * 0x1p-32;       /* light twice, transmittance once */
static const double corrected_opacity = 0x1p-27, corrected_colour = 0x1p-15;
static const double extinction_colour = 0x1p-16, extinction_piece = 0x1p-29;
static const double extinction_stored = 0x1p-24, extinction_depth = 0x1p-31;
static const double length_off = 0x1p-17;     /* of a step */
static const double read_out = 0x1p-15 / 255; /* two units of 2^-16 level */
static const double stored = 0.5 / 255;       /* a channel of 8 bits */
static const double preweighted_ray = 0x1p-15, preweighted_share = 0x1p-16;

/* ---- The voxels of a sample ------------------------------------------------------------ */

/* Sums and extremes over the voxels that a sample reads. */
typedef struct neighbours {
    double sum, most; /* of opacity or extinction */
    double twist;     /* preweighted: of a face of the cell across x, the most curved channel */
    double slope;     /* and the largest difference along x */
} neighbours;

static void read_cell(double cell[8][4], const qv_volume *volume, const ref_taps taps[3])
{
    for (unsigned q = 0; q < 8; q++) {
        const int32_t at[3] = {taps[0].at[q & 1], taps[1].at[q >> 1 & 1], taps[2].at[q >> 2]};
        ref_voxel(cell[q], volume, at);
    }
}

/* Corners of one face are 0, 2, 4, 6, of the other 1, 3, 5, 7. */
static void add_shape(neighbours *of, const qv_volume *volume, const ref_taps taps[3])
{
    double cell[8][4];
    read_cell(cell, volume, taps);
    for (int c = 0; c < 4; c++) {
        for (unsigned side = 0; side < 2; side++) {
            const double twist =
                cell[side][c] - cell[side + 2][c] - cell[side + 4][c] + cell[side + 6][c];
            of->twist = fmax(of->twist, fabs(twist));
        }
        for (unsigned row = 0; row < 8; row += 2) {
            of->slope = fmax(of->slope, fabs(cell[row][c] - cell[row + 1][c]));
        }
    }
}

static void add_neighbour(neighbours *of, const qv_volume *volume, ref_mode mode,
                          const int32_t at[3])
{
    double voxel[4];
    ref_voxel(voxel, volume, at);
    const double fourth = ref_is_by_extinction(mode) ? ref_extinction(voxel[3], volume) : voxel[3];
    of->sum += fourth;
    of->most = fmax(of->most, fourth);
}

static neighbours look_around(const qv_volume *volume, ref_mode mode, const double point[3])
{
    neighbours of = {0};
    ref_taps taps[3];
    const bool bspline = mode == REF_BSPLINE_WEIGHTED || mode == REF_BSPLINE_EXTINCTION;
    for (int axis = 0; axis < 3; axis++) {
        (bspline ? ref_bspline_taps : ref_linear_taps)(&taps[axis], point[axis],
                                                       volume->size[axis]);
    }
    for (int i = 0; i < taps[0].count * taps[1].count * taps[2].count; i++) {
        const int n = taps[0].count;
        const int32_t at[3] = {taps[0].at[i % n], taps[1].at[i / n % n], taps[2].at[i / n / n]};
        add_neighbour(&of, volume, mode, at);
    }
    if (ref_is_associated(volume->storage)) {
        add_shape(&of, volume, taps);
    }
    return of;
}

/* ---- One sample ------------------------------------------------------------------------- */

/* A sample or a piece, before and after it is weighed by its length. */
typedef struct place {
    const qv_volume *volume;
    ref_mode mode;
    double point[3], length; /* world units */
    double step;
} place;

static double opacity_of(const place *at, double found, double length)
{
    double sample[4] = {0, 0, 0, fmax(found, 0)};
    if (!ref_is_by_extinction(at->mode)) {
        sample[3] = fmin(sample[3], 1);
    }
    if (ref_is_by_length(at->mode)) {
        ref_weigh(sample, at->volume, at->mode, length);
    }
    return sample[3];
}

/* The change of opacity where what was found is off. */
static double opacity_off(const place *at, double found, double off)
{
    const double opacity = opacity_of(at, found, at->length);
    return fmax(opacity_of(at, found + off, at->length) - opacity,
                opacity - opacity_of(at, found - off, at->length));
}

/* Of stored extinction and opacity: conversion, and products that are rounded. */
static double found_off(const place *at, const neighbours *of)
{
    const bool bspline = at->mode == REF_BSPLINE_WEIGHTED || at->mode == REF_BSPLINE_EXTINCTION;
    const double off = (bspline ? weight_bspline : weight_linear) * of->sum;
    if (!ref_is_by_extinction(at->mode)) {
        return off;
    }
    return off + extinction_stored + (bspline ? 27 : 8) * 0x1p-31 * of->most;
}

/* What a mode adds to opacity and colour. */
static double mode_off(const place *at, const neighbours *of, double opacity)
{
    switch (at->mode) {
    case REF_SEPARATE:
        return 8 * weight_linear * opacity;
    case REF_CORRECTED:
    case REF_BSPLINE_WEIGHTED:
        return corrected_opacity + corrected_colour * opacity;
    case REF_EXTINCTION:
    case REF_BSPLINE_EXTINCTION:
        return extinction_depth + extinction_colour * opacity + extinction_piece;
    default:
        return of->twist / 256 + of->slope * 2 * preweighted_share;
    }
}

/* A piece of a part of a step has a length that is not known better. */
static double piece_off(const place *at, double found)
{
    if (!ref_is_by_length(at->mode) || at->length == at->step) {
        return 0;
    }
    return opacity_of(at, found, at->length + length_off * at->step) -
           opacity_of(at, found, at->length);
}

/* Of the arithmetic. */
static double sample_off(const place *at, double found)
{
    const neighbours of = look_around(at->volume, at->mode, at->point);
    const double opacity = opacity_of(at, found, at->length);
    const double off =
        at->mode == REF_NEAREST || ref_is_associated(at->volume->storage) ? 0 : found_off(at, &of);
    const double colour = found > 0 && ref_is_by_length(at->mode) ? opacity / found * off : 0;
    return opacity_off(at, found, off) + colour + mode_off(at, &of, opacity) +
           piece_off(at, found) + opacity32;
}

/* Of storage in 8 bits: voxels off by 1/2 of 255, and the 16 bits that they are compared with. */
static double storage_off(const place *at, double found)
{
    const double off = stored + 0.5 / 65535;
    const double opacity = opacity_of(at, found + off, at->length);
    const bool associated = ref_is_associated(at->volume->storage);
    return opacity_off(at, found, off) + off * (associated ? 1 : opacity);
}

/* ---- A ray -------------------------------------------------------------------------------- */

typedef struct passage {
    pixel_bound bound;
    double through, through_stored; /* transmittance, and at most that of other voxels */
} passage;

static void pass(passage *on, const place *at)
{
    double sample[4];
    ref_reconstruct(sample, at->volume, at->mode, at->point);
    on->bound.arithmetic += on->through * sample_off(at, sample[3]) + accumulated;
    on->bound.storage += on->through_stored * storage_off(at, sample[3]);
    on->through *= 1 - opacity_of(at, sample[3], at->length);
    on->through_stored *= 1 - opacity_of(at, sample[3] - stored - 0.5 / 65535, at->length);
}

static void pass_at(passage *on, place *at, const ref_ray *ray, double steps, double length)
{
    ref_point(at->point, ray, steps);
    ref_round_point(at->point);
    at->length = length;
    pass(on, at);
}

pixel_bound pixel_bound_of(const qv_scene *scene, ref_mode mode, int32_t x, int32_t y)
{
    passage on = {{read_out, 0}, 1, 1};
    place at = {&scene->volume, mode, {0, 0, 0}, 0, scene->camera.step / 65536.0};
    ref_ray ray;
    ref_stored_ray(&ray, scene, x, y);
    if (ref_is_by_length(mode)) {
        ref_piece piece = ref_first_piece(&ray);
        while (ref_next_piece(&piece, &ray, 1, HUGE_VAL)) {
            pass_at(&on, &at, &ray, (piece.begin + piece.end) / 2,
                    (piece.end - piece.begin) * at.step);
        }
    } else {
        for (int64_t k = 0; k < ray.count; k++) {
            pass_at(&on, &at, &ray, (double)k, at.step);
        }
    }
    on.bound.arithmetic += ref_is_associated(scene->volume.storage) ? 2 * preweighted_ray : 0;
    return on.bound;
}
