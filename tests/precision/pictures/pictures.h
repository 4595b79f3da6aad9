/*
 * pictures.h - the error of the finished picture: scenes, a model of the renderer whose numbers
 * may have any bits, voxels as others store them, errors of pictures, and tables.
 *
 * Pictures are paper_picture: associated colours and opacity before packing, 1 being full scale.
 * Errors are in levels of 255.
 */
#ifndef PICTURES_H
#define PICTURES_H

#include "papers/paper.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* ---- scenes.c: scenes of real numbers -------------------------------------------- */

typedef struct picture_scene {
    const char *name;
    bool low;          /* opacities of a few 255ths, whole ones */
    qv_scene scene;    /* camera, and a volume without voxels */
    double (*rgba)[4]; /* unweighted colours and opacities, 0 .. 1, x fastest */
    size_t voxels;
    uint16_t edge; /* pixels of the square frame */
} picture_scene;

/* The scenes by number, and how many there are. */
enum { picture_scenes = 12, scene_haze = 1, scene_thin = 2, scene_shells = 6, scene_head = 11 };
void picture_scene_make(picture_scene *made, unsigned number);
void picture_scene_free(picture_scene *made);

/* A uniform volume of one colour and opacity, seen along z by one pixel. */
void picture_fog_make(picture_scene *made, const double rgba[4], unsigned samples);

/* ---- store.c: real voxels in what holds them ------------------------------------- */

typedef enum store_kind { STORE_REAL, STORE_UNORM, STORE_HALF } store_kind;

typedef struct store {
    const char *name;
    store_kind kind;
    unsigned bits;   /* of unorm: 1 .. 16 */
    bool associated; /* colours are weighted before they are stored */
} store;

/* The number of binary16 next to a value of 0 .. 1, ties to even. */
double store_half(double value);

/* Voxels as stored, in the unit of store_unit. */
typedef double (*stored_voxels)[4];
stored_voxels store_make(const picture_scene *from, const store *by);

/* What 1 is: 2^bits - 1, or 65535 of real numbers and halves. */
double store_unit(const store *by);

/* ---- model.c: the pipeline of weighted and separate sampling --------------------- */

/*
 * Numbers are doubles in the units of tests/SPEC.md, and each stage rounds as it does there, to
 * as many fraction bits as the model says, or not at all. With the library's bits a picture
 * equals the library's, bit for bit; with none it is the reference's to 1e-12.
 */
enum { model_exact = -1, model_half = -2 /* binary16, as blending in float16 targets */ };

typedef struct model {
    int position;      /* fraction bits of a point; the library's: 8 */
    int weights;       /* of products of fractions; 16 */
    int transmittance; /* 31; halves keep its complement, the opacity */
    int light;         /* 31 */
    bool terms;        /* terms of 16-bit storage are cut, those of separate sampling rounded */
    bool opacity;      /* a sample's opacity is cut to 32 bits */
    bool read_out;     /* channels are rounded to 16 fraction bits of a level */
    bool separate;     /* colour and opacity are interpolated apart */
} model;

/* All stages as the library has them, or all exact. */
extern const model model_library, model_reference;

/* Renders a scene front to back. Orthographic cameras only: their points are exact in doubles. */
void model_render(paper_picture *made, const model *of, const picture_scene *scene, const store *by,
                  stored_voxels voxels);

/* The same with voxels that are stored for this alone. */
void model_picture(paper_picture *made, const model *of, const picture_scene *scene,
                   const store *by);

/* Real voxels. */
extern const store store_real;

/* What double precision makes of the real voxels, at unrounded points. */
void truth_picture(paper_picture *made, const picture_scene *scene);

/* ---- mapper.c ---------------------------------------------------------------------- */

/* The same picture by 15-bit numbers throughout, as VTK's fixed-point mapper computes. */
void mapper_picture(paper_picture *made, const picture_scene *scene, bool associated);

/* ---- ours.c: the library ----------------------------------------------------------- */

/* A storage and a mode of the library. */
typedef struct our_mode {
    const char *name;
    qv_storage storage;
    const qv_sampling *sampling;
    ref_mode mode;
} our_mode;

/* A volume of the scene's voxels in a storage, each channel to nearest. */
typedef struct ours_volume {
    qv_scene scene;
    uint8_t *voxels;
} ours_volume;

void ours_make(ours_volume *made, const picture_scene *from, const our_mode *by);
void ours_free(ours_volume *made);

/* Makes, renders, frees. */
void ours_picture(paper_picture *made, const picture_scene *from, const our_mode *by);

/* ---- error.c ------------------------------------------------------------------------ */

typedef struct picture_error {
    double channels, equal, beyond; /* after packing to 8 bits: equal, more than 1 level off */
    double squares, sum, worst;     /* before it */
} picture_error;

/* Adds a pixel. */
void error_add_pixel(picture_error *into, const double got[4], const double truth[4]);

/* Adds the pixels that are not wholly transparent in the truth. */
void error_add(picture_error *into, const paper_picture *got, const paper_picture *truth);

/* The same of pictures that are not wanted any more: frees the first. */
void error_take(picture_error *into, paper_picture *got, const paper_picture *truth);

double error_rms(const picture_error *of);
double error_psnr(const picture_error *of);  /* in dB; HUGE_VAL where nothing is off */
double error_equal(const picture_error *of); /* per cent */

/* ---- bounds.c ----------------------------------------------------------------------- */

/* At most what a channel of a pixel is off, 1 being full scale: for 8-bit storage, by the
   library's arithmetic, and by the rounding of voxels to 8 bits. */
typedef struct pixel_bound {
    double arithmetic, storage;
} pixel_bound;

/* The volume's unit distance must not be 0. */
pixel_bound pixel_bound_of(const qv_scene *scene, ref_mode mode, int32_t x, int32_t y);

/* ---- table.c: Markdown on standard output, CSV in the folder ------------------------ */

typedef struct table {
    FILE *csv;
    unsigned columns, filled;
} table;

/* Columns are split by '|'. */
void table_begin(table *made, const char *folder, const char *name, const char *columns);
void table_text(table *to, const char *text);
void table_number(table *to, const char *format, double number); /* HUGE_VAL is "exact" */
void table_error(table *to, const picture_error *error);         /* RMS, worst, PSNR */
void table_end(table *of);

/* A goal: a line of a list, which tests/static/precision.sh reads. */
void goal(bool reached, const char *format, ...);
void goals_end(void);

/* ---- Parts of the section ----------------------------------------------------------- */

void part_model(const char *folder);
void part_bits(const char *folder);
void part_steps(const char *folder);
void part_fogs(const char *folder);
void part_slices(const char *folder);
void part_budget(const char *folder);
void part_paper(const char *folder);
void part_storage(const char *folder);
void part_mapper(const char *folder);
void part_goals(const char *folder);
void part_modes(const char *folder);

#endif /* PICTURES_H */
