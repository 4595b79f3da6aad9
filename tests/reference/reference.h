/*
 * reference.h - the picture of a scene in double precision.
 *
 * An independent renderer that follows the conventions stated in qvol.h. It
 * shares no code, table or rounding with the library and knows only its public
 * header. One module per stage:
 *
 *   angle.c        directions of a view from binary angles
 *   ray.c          samples of a ray: of the stored camera, or of the ideal one
 *   voxel.c        voxels as real colours
 *   reconstruct.c  nearest, separate and weighted reconstruction
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

/* The point of sample j. */
void ref_point(double point[3], const ref_ray *ray, int64_t j);

/* A point rounded to 1/256 voxel on each axis, ties upwards. */
void ref_round_point(double point[3]);

/* ---- voxel.c ------------------------------------------------------------ */

/* Colour (unweighted) and opacity of a voxel as the storage holds them. */
void ref_voxel(double rgba[4], const qv_volume *volume, const int32_t at[3]);

/* ---- reconstruct.c: associated colour and opacity at a point -------------- */

typedef enum ref_mode { REF_NEAREST, REF_SEPARATE, REF_WEIGHTED } ref_mode;

/* The eight trilinear weights of a fraction; bit 0 of the index is x, bit 2 z. */
void ref_weights(double weight[8], const double fraction[3]);

void ref_reconstruct(double sample[4], const qv_volume *volume, ref_mode mode,
                     const double point[3]);

/* ---- composite.c: associated colours ------------------------------------ */

/* Puts a sample behind the light collected so far (equations 5 and 8). */
void ref_under(double light[4], const double sample[4]);

/* Puts a sample in front of it (equation 7). */
void ref_over(double light[4], const double sample[4]);

/* ---- render.c ----------------------------------------------------------- */

typedef struct ref_pixel {
    double rgba[4]; /* associated, with the background */
    double opacity; /* of the volume alone */
    int64_t samples;
} ref_pixel;

/* A pixel by the stored camera, every sample composited. */
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
