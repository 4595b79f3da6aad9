/*
 * reference.h - the picture of a scene in double precision.
 *
 * An independent renderer that follows the conventions stated in qvol.h. It
 * shares no code, table or rounding with the library and knows only its public
 * header. One module per stage:
 *
 *   angle.c        directions of a view from binary angles
 *   ray.c          samples of a ray: of the stored camera, or of the ideal one
 *   stretch.c      the pieces of a ray for modes that weigh by length
 *   voxel.c        voxels as real colours
 *   pyramid.c      levels of a pyramid as volumes
 *   reconstruct.c  reconstruction between voxels
 *   medium.c       depth, opacity and length
 *   composite.c    over and under
 *   render.c       one pixel from all of them
 *   quantise.c     real channels to the levels of a display
 *
 * Two cameras. The stored one takes the integers of qv_camera as the header
 * defines them and rounds each point to 1/256 voxel, so that only arithmetic
 * after the position separates library and reference. The ideal one computes
 * with real numbers from angles and rounds nothing.
 *
 * A colour is four doubles R, G, B, A in 0 .. 1.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "qvol.h"

#include <stdbool.h>

/* ---- angle.c: directions ------------------------------------------------ */

/* Sine of a binary angle, exact at multiples of 90 degrees. */
double ref_sine(qv_angle angle);
double ref_cosine(qv_angle angle);

/* Rows right, down and forward in world axes, as qv_rotation describes them. */
void ref_rotation(double rotation[3][3], qv_angle azimuth, qv_angle elevation, qv_angle roll);

/* ---- ray.c: the samples of a ray ---------------------------------------- */

/* The samples that lie in the box, front first: first + j * step, 0 <= j < count. */
typedef struct ref_ray {
    double first[3]; /* voxel coordinates */
    double step[3];
    int64_t index; /* k of the first sample on the grid s = (k + phase) * step */
    int64_t count;
    double enter, leave; /* its way through the box, in steps from the first sample; the two are
                            equal where it misses */
} ref_ray;

/* A view in real numbers: what qv_view and the camera functions are told. */
typedef struct ref_view {
    double rotation[3][3];
    double pitch;         /* world units */
    double step;          /* world units */
    double field_of_view; /* radians from top to bottom; 0: orthographic */
    double width, height; /* pixels */
} ref_view;

/* The ray of a pixel through a scene's integer camera. */
void ref_stored_ray(ref_ray *ray, const qv_scene *scene, int32_t x, int32_t y);

/* The same ray for the view that the camera was made of, not rounded at all. */
void ref_ideal_ray(ref_ray *ray, const qv_scene *scene, const ref_view *view, int32_t x, int32_t y);

/* The point so many steps behind the first sample. */
void ref_point(double point[3], const ref_ray *ray, double steps);

/* A point rounded to 1/256 voxel on each axis, ties upwards. */
void ref_round_point(double point[3]);

/* ---- stretch.c: pieces of a ray's way through the box ---------------------- */

/* From where to where, in steps from the ray's first sample. */
typedef struct ref_piece {
    double begin, end;
} ref_piece;

/* An empty piece where the ray enters the box. */
ref_piece ref_first_piece(const ref_ray *ray);

/* A position on a ray in steps from the border before sample k = 0, half a step in front of
   it. */
double ref_grid(const ref_ray *ray, double steps);

/*
 * The piece behind this one: up to the next border between stretches of so many steps,
 * a power of 2, or to `end` on the grid, or to where the ray leaves. Borders are the
 * multiples of the stretch on the grid. False where nothing is left.
 */
bool ref_next_piece(ref_piece *piece, const ref_ray *ray, double stretch, double end);

/* ---- voxel.c ------------------------------------------------------------ */

/* What a qv_storage is: 16 bits a channel, read through a palette, extinction for opacity. */
bool ref_is_wide(uint8_t storage);
bool ref_is_indexed(uint8_t storage);
bool ref_holds_extinction(uint8_t storage);

/* Whether colours are stored weighted by opacity. */
bool ref_is_associated(uint8_t storage);

/* The channels of a voxel as the storage holds them. */
void ref_voxel(double rgba[4], const qv_volume *volume, const int32_t at[3]);

/* ---- pyramid.c ------------------------------------------------------------ */

/* A level of a scene as a volume of its own; level 0 is the volume. */
void ref_pyramid_level(qv_volume *level, const qv_scene *scene, int number);

/* A part of a ray that sees a level, and perhaps the next coarser one, on the grid. */
typedef struct ref_span {
    int level;
    double begin, end;
    double first, last; /* share of the coarser level at both, linear in between */
} ref_span;

/*
 * The span of a position on the grid. The scene's level everywhere, or, where it rises with
 * the distance, its whole part up to the level distance and one level more each time that the
 * distance doubles, until the coarsest.
 */
void ref_span_at(ref_span *span, const qv_scene *scene, double position);

/* The share of the coarser level at a position of the span. */
double ref_share(const ref_span *span, double position);

/* ---- reconstruct.c: colour and opacity at a point -------------------------- */

/* The modes from REF_CORRECTED on weigh by length. */
typedef enum ref_mode {
    REF_NEAREST,
    REF_SEPARATE,
    REF_WEIGHTED,
    REF_CORRECTED,
    REF_EXTINCTION,
    REF_BSPLINE_WEIGHTED,
    REF_BSPLINE_EXTINCTION
} ref_mode;

bool ref_is_by_length(ref_mode mode);
bool ref_is_by_extinction(ref_mode mode);

/* The voxels that a point on one axis reads, and their weights. */
typedef struct ref_taps {
    int count; /* 2 linear, 3 quadratic B-spline */
    int32_t at[3];
    double weight[3];
} ref_taps;

void ref_linear_taps(ref_taps *taps, double point, int32_t size);
void ref_bspline_taps(ref_taps *taps, double point, int32_t size);

/*
 * Associated colour and opacity. By extinction the fourth channel is depth per world
 * unit, and colours are weighted by it; the volume's unit distance must not be 0.
 */
void ref_reconstruct(double sample[4], const qv_volume *volume, ref_mode mode,
                     const double point[3]);

/* ---- medium.c: depth is in base 2 ------------------------------------------ */

/* Depth of an opacity; 64 for 1. */
double ref_depth(double opacity);

/* Depth per world unit of a voxel's fourth channel. */
double ref_extinction(double channel, const qv_volume *volume);

/* Opacity for another distance, so many times the stored one (equation 16). */
double ref_correct(double opacity, double ratio);

/* Makes of what ref_reconstruct found the colour and opacity of a piece of this length in
   world units (equations 16 and 17, or 22 and 23). */
void ref_weigh(double sample[4], const qv_volume *volume, ref_mode mode, double length);

/* ---- composite.c: associated colours ------------------------------------ */

/* Puts a sample behind the light collected so far (equations 5 and 8). */
void ref_under(double light[4], const double sample[4]);

/* Puts a sample in front of it (equation 7). */
void ref_over(double light[4], const double sample[4]);

/* ---- render.c ----------------------------------------------------------- */

typedef struct ref_pixel {
    double rgba[4];  /* associated, with the background */
    double opacity;  /* of the volume alone */
    int64_t samples; /* or pieces */
} ref_pixel;

/* A pixel by the stored camera, every sample composited. A scene's pyramid is read where the
   mode weighs by length. */
void ref_render(ref_pixel *pixel, const qv_scene *scene, ref_mode mode, int32_t x, int32_t y);

/* A pixel by the ideal camera. */
void ref_render_ideal(ref_pixel *pixel, const qv_scene *scene, const ref_view *view, ref_mode mode,
                      int32_t x, int32_t y);

/* ---- quantise.c --------------------------------------------------------- */

/* A channel as one of the levels 0 .. highest, to nearest with ties upwards. */
uint32_t ref_level(double channel, uint32_t highest);

/* The same with the ordered dither of the display formats, at an absolute pixel position. */
uint32_t ref_dithered_level(double channel, uint32_t highest, int32_t x, int32_t y);

/* Grey of a colour, as qvol.h weighs the channels. */
double ref_grey(const double rgba[4]);

#endif /* REFERENCE_H */
