/*
 * paper.h - what the programs of `make papers` share: volumes, views, pictures
 * with all the bits that the library computes, and tables.
 *
 * The programs end with a message where a scene is refused or a file cannot be
 * written: there is nothing else to do.
 */
#ifndef PAPER_H
#define PAPER_H

#include "reference.h"

#include <stdio.h>

/* The colour of what is 1 in 16 bits, and one voxel of length in a camera. */
#define PAPER_FULL  65535
#define PAPER_VOXEL ((qv_coord)1 << 32)

/* Ends the program with a message unless the condition holds. */
void paper_require(bool condition, const char *what);

/* Memory that is zero at first. */
void *paper_memory(size_t count, size_t bytes);

/* A fraction as a channel of 16 bits, to nearest. */
uint16_t paper_channel(double fraction);

/* ---- Volumes -------------------------------------------------------------- */

/* A volume of 16-bit RGBA voxels, all transparent black at first. */
typedef struct paper_volume {
    qv_volume volume;
    uint16_t (*voxels)[4];
} paper_volume;

void paper_volume_make(paper_volume *made, unsigned nx, unsigned ny, unsigned nz);
void paper_volume_free(paper_volume *made);

/* The channels of a voxel. */
uint16_t *paper_voxel(const paper_volume *of, unsigned x, unsigned y, unsigned z);

/* Lets the fourth channel hold extinction, of which the full value is tau (in base e). */
void paper_hold_extinction(paper_volume *made, double tau);

/* Kraus and Buerger's equation 3: the opacity of tau over a length. */
double paper_opacity(double tau, double length);

/* Called for each voxel to fill it; `from` is the caller's own. */
typedef void paper_fill(uint16_t rgba[4], const unsigned at[3], const void *from);
void paper_volume_fill(const paper_volume *made, paper_fill *fill, const void *from);

/* The voxels of ch2.nii.gz of Debian's mricron-data, x fastest; the caller frees them. */
enum { PAPER_HEAD_X = 181, PAPER_HEAD_Y = 217, PAPER_HEAD_Z = 181 };
uint8_t *paper_head(void);

/* A pyramid of a volume, and its memory. */
typedef struct paper_pyramid {
    qv_pyramid pyramid;
    uint8_t *voxels;
} paper_pyramid;

void paper_pyramid_make(paper_pyramid *made, const qv_volume *volume, const qv_filter *filter,
                        const qv_domain *domain, uint8_t levels);
void paper_pyramid_free(paper_pyramid *made);

/* ---- Views ---------------------------------------------------------------- */

/* Angles in degrees; lengths in world units. */
typedef struct paper_view {
    double azimuth, elevation, pitch, step;
    uint16_t width, height;
} paper_view;

/* The frame of a view. */
void paper_frame(qv_view *frame, const paper_view *view);

/* An orthographic camera for the scene's volume. */
void paper_look(qv_scene *scene, const paper_view *view);

/* The ray of pixel (0, 0) runs along z through the centres of the voxels (0, 0, *),
   with a sample at z = start, in voxels. */
void paper_look_along_z(qv_scene *scene, double start, double step);

/* ---- Pictures --------------------------------------------------------------- */

/* Associated R, G, B and opacity, 0 .. 1, to 2^-24. */
typedef struct paper_picture {
    uint32_t width, height;
    double (*rgba)[4];
} paper_picture;

/* Renders the frame with the library. */
void paper_render(paper_picture *made, const qv_scene *scene, uint32_t width, uint32_t height);

/* The same slice by slice, in a frame buffer. */
void paper_render_slices(paper_picture *made, const qv_scene *scene, const qv_blend *blend,
                         const qv_dither *dither, uint32_t width, uint32_t height);

/* The same by splats: all voxels of one level of the scene's volume, in the frame of its view.
   attenuation may be null where none is read. */
void paper_splat(paper_picture *made, const qv_splat_scene *scene, const qv_volume *level,
                 const qv_attenuation *attenuation);

void paper_picture_make(paper_picture *made, uint32_t width, uint32_t height);
void paper_picture_free(paper_picture *made);

/* Pixel (0, 0) alone, by the library and by the reference. */
void paper_render_ray(double rgba[4], const qv_scene *scene);
void paper_reference_ray(double rgba[4], const qv_scene *scene, ref_mode mode);

/* The pixels of every paper_lattice'th row and column in double precision. */
enum { paper_lattice = 5 };
void paper_render_reference(paper_picture *made, const qv_scene *scene, ref_mode mode,
                            uint32_t width, uint32_t height);

/* The pixels of the same rows and columns. */
void paper_thin_out(paper_picture *made, const paper_picture *from);

/* Difference of two pictures, as colours of an opaque one. */
void paper_difference(paper_picture *made, const paper_picture *a, const paper_picture *b);

/* The brightness of each pixel replaced by its rank: the histogram equalised. */
void paper_equalise(paper_picture *picture);

/* Root of the mean squared difference of colours, in levels of 255, over the pixels
   that are not wholly transparent in a. */
double paper_rms(const paper_picture *a, const paper_picture *b);

/* Writes the picture over black as FOLDER/NAME.ppm. */
void paper_write_picture(const char *folder, const char *name, const paper_picture *picture);

/* ---- Files ------------------------------------------------------------------ */

/* Opens FOLDER/NAME for writing; paper_close checks that all could be written. */
FILE *paper_open(const char *folder, const char *name);
void paper_close(FILE *file);

/* One line of a table: the paper's number as it is printed there, double precision,
   the library's, their difference, and the largest difference that passes. */
typedef struct paper_row {
    const char *what, *paper;
    double exact, ours, allowed;
} paper_row;

/* A title with its level of heading, and the head of a table. */
void paper_table_begin(FILE *table, const char *title);
void paper_table_add(FILE *table, const paper_row *row);

#endif /* PAPER_H */
