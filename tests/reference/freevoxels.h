/*
 * freevoxels.h - FreeVoxels and pictures of splats in double precision.
 *
 * Follows qvol.h and the paper alone, as reference.h does. Three files:
 *
 *   freevoxels.c  depth between a voxel and the outside, from its bytes
 *   voxel_ray.c   the same along a ray, exactly
 *   splat.c       the picture
 *
 * Depth is in base 2. A vector v from a voxel to the viewer or to a lamp is in voxel units,
 * of any length; a step along it moves by one voxel on its longest axis.
 */
#ifndef REFERENCE_FREEVOXELS_H
#define REFERENCE_FREEVOXELS_H

#include "reference.h"

/* ---- freevoxels.c: directions, and what bytes tell ------------------------- */

/* World length of a step along v. */
double ref_step_length(const qv_volume *volume, const double v[3]);

/* The three directions around v, and the share of each in it. */
typedef struct ref_surrounding {
    int direction[3];
    double weight[3];
} ref_surrounding;

void ref_surround(ref_surrounding *found, const double v[3]);

/* The direction of a set at the least angle to v, in world units. */
int ref_nearest_direction(const qv_volume *volume, uint32_t directions, const double v[3]);

/* What a byte of 0 counts as between depths, where other bytes are not 0. */
#define REF_DARK_DEPTH 10

#define REF_LEVELS 13 /* 0 .. 12 */

/* How light is told from bytes: between the three directions of all 26 round it, by what they let
   through or by their depths; or by the nearest of a set. */
typedef enum ref_light { REF_LIGHT_BETWEEN, REF_LIGHT_NEAREST, REF_LIGHT_DEPTHS } ref_light;

/* All 26 bytes of the voxels of each level, x fastest. */
typedef struct ref_bytes {
    const qv_volume *volume; /* level 0 */
    uint8_t (*level[REF_LEVELS])[QV_DIRECTIONS];
    ref_light light;
    uint32_t directions; /* the set */
} ref_bytes;

/* Makes the bytes of level 0 up to `coarsest`, each rounded from its exact value, for
   REF_LIGHT_BETWEEN. False without memory. */
bool ref_bytes_make(ref_bytes *made, const qv_volume *volume, int coarsest);
void ref_bytes_free(ref_bytes *made);

/* ---- Depth between a voxel and the outside -------------------------------- */

/* Along v from a voxel of a level, infinite where all is dark; `in` is the provider's own. */
typedef double ref_depth_along(const void *in, int level, const int32_t at[3], const double v[3]);

/* From ref_bytes. */
ref_depth_along ref_depth_of_bytes;

/* All 26 depths of the voxels of level 0, x fastest, not rounded to bytes. */
typedef struct ref_outside {
    const qv_volume *volume;
    double (*depth)[QV_DIRECTIONS];
} ref_outside;

/* False without memory. */
bool ref_outside_make(ref_outside *made, const qv_volume *volume);
void ref_outside_free(ref_outside *made);

/* From ref_outside, between the light of three directions; of level 0 alone. */
ref_depth_along ref_depth_between;

/* Extinction at the centres of a volume's voxels, depth per world unit, x fastest. */
typedef struct ref_field {
    const qv_volume *volume; /* its unit distance is not 0, unless it stores extinction */
    double *extinction;
} ref_field;

/* False without memory. */
bool ref_field_make(ref_field *made, const qv_volume *volume);
void ref_field_free(ref_field *made);

/*
 * From ref_field: along the ray, from half a step before the voxel to the face of the box,
 * through extinction that is trilinear between centres. Without rounding of any kind.
 */
ref_depth_along ref_depth_of_ray;

/* ---- splat.c: pictures ------------------------------------------------------ */

/* Where depths come from. */
typedef struct ref_depths {
    ref_depth_along *along;
    const void *in;
} ref_depths;

typedef struct ref_splats {
    const qv_splat_scene *scene; /* what it says of angles is not read */
    ref_view view;               /* the angles */
    const qv_volume *levels;     /* from level 0 on */
    int kernel;                  /* its width in voxels: 2 linear, 3 quadratic */
    bool over;                   /* equation 9 instead of 10 */
    bool inside;                 /* the eye lies in voxel `eye` of level 0 */
    int32_t eye[3];
    ref_depths depths;
} ref_splats;

/* What splats are added to: the frame, 4 channels a pixel, colours associated. */
typedef double ref_sums[4];

/* The voxel of level 0 in which the eye lies; false where it lies outside. */
bool ref_splat_eye(int32_t at[3], const ref_splats *splats);

/* A voxel in the picture: pixels to the right and down, and its width in both directions. */
typedef struct ref_footprint {
    double centre[2], width[2];
    double ahead;     /* world units from the eye's plane */
    double toward[3]; /* to the viewer, voxel units */
} ref_footprint;

void ref_splat_footprint(ref_footprint *found, const ref_splats *splats, int level,
                         const int32_t at[3]);

/* Whether a voxel is among those that make up the picture. */
bool ref_splat_is_drawn(const ref_splats *splats, int level, const int32_t at[3]);

/* Adds one voxel, if it is drawn; of all voxels of a level. */
void ref_splat(ref_sums *sums, const ref_splats *splats, int level, const int32_t at[3]);
void ref_splat_level(ref_sums *sums, const ref_splats *splats, int level);

/* Before the first splat. */
void ref_splat_clear(ref_sums *sums, const ref_splats *splats);

/* The background behind what was added; opacity at most 1, colours at most the opacity. */
void ref_splat_read_out(ref_pixel *pixel, const ref_sums sum, const ref_splats *splats);

#endif /* REFERENCE_FREEVOXELS_H */
