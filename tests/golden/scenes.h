/*
 * scenes.h - small seeded scenes whose pictures have known checksums on every
 * target, compiler and optimisation level.
 *
 * The scenes cover every sampling mode, and every pixel format, both projections,
 * odd sizes, strides, spacings, steps, phases, backgrounds and terminations at
 * least once; those by slices every blend, sequence and technique; those of FreeVoxels both
 * splattings and kernels, lit voxels, every order and storage, levels, eyes inside. A scene
 * takes less than 13 KB with all its data, so that it runs where RAM is 16 KB. Scenes come in
 * sets, since the code of all modes is more than some devices' flash holds.
 */
#ifndef GOLDEN_SCENES_H
#define GOLDEN_SCENES_H

#include <stdbool.h>
#include <stddef.h>
#include "qvol.h"

/* The modes from GOLDEN_CORRECTED on weigh by length. */
typedef enum golden_family {
    GOLDEN_NEAREST,
    GOLDEN_SEPARATE,
    GOLDEN_WEIGHTED,
    GOLDEN_PREWEIGHTED,
    GOLDEN_CORRECTED,
    GOLDEN_EXTINCTION,
    GOLDEN_BSPLINE_WEIGHTED,
    GOLDEN_BSPLINE_EXTINCTION
} golden_family;

typedef enum golden_order {
    GOLDEN_FRONT_TO_BACK,
    GOLDEN_BACK_TO_FRONT,
    GOLDEN_LEVELS /* front to back through a pyramid */
} golden_order;

/* A sampling mode; its storage stands in the descriptor. */
typedef struct golden_mode {
    const qv_sampling *sampling; /* null: not linked, see set.h */
    golden_family family;
    golden_order order;
} golden_mode;

typedef enum golden_direction { GOLDEN_OVER, GOLDEN_UNDER, GOLDEN_HAND_OUT } golden_direction;

/* A blend of slices. */
typedef struct golden_blend {
    const char *name;
    const qv_blend *blend;
    golden_direction direction;
} golden_blend;

enum { GOLDEN_SEQUENCES = 4, GOLDEN_TECHNIQUES = 5, GOLDEN_FRONTS = 4 };

/* What slices are blended with; the first GOLDEN_FRONTS blends also make chunks. */
typedef struct golden_blends {
    const golden_blend *blend;
    uint32_t count;
    qv_sequence *const *sequence;
    const qv_technique *const *technique;
} golden_blends;

/* What is made of voxels that have bytes of attenuation. */
typedef struct golden_splat {
    const char *name;
    const qv_splatting *splatting; /* null: voxels are lit, and seen by rays */
    const qv_kernel *kernel;
} golden_splat;

enum { GOLDEN_ORDERS = 3 };

typedef struct golden_splats {
    const golden_splat *splat;
    uint32_t count;
    const qv_order *const *order;
} golden_splats;

/* The ways to render one picture; all give the same bytes. Of FreeVoxels pieces are parts of
   the voxels, and voxels come in another order each time. */
typedef enum golden_way { GOLDEN_WHOLE, GOLDEN_STRIPS, GOLDEN_ROWS, GOLDEN_PIECES } golden_way;

enum { GOLDEN_WAYS = 4 };

extern const char *const golden_way_name[GOLDEN_WAYS];

struct golden_memory;
struct golden_scene;

/* Renders a scene and tells the CRC-32 of all of memory->pixels: of the picture,
   the gaps between its rows and what follows it, which nobody may touch. Of splats the CRC begins
   with the sums. */
typedef qv_status golden_render(uint32_t *checksum, struct golden_memory *memory,
                                const struct golden_scene *golden, golden_way way);

/* Ray by ray, slice by slice, and of FreeVoxels. */
golden_render golden_render_rays, golden_render_slices, golden_render_splats;

struct golden_set;

/* Draws what a scene of a set has beside the rest, for the mode with this number. */
typedef void golden_draw(struct golden_scene *golden, const struct golden_set *set, uint32_t mode,
                         uint32_t *state);

/* Scenes whose modes one program of a device can hold: they take them in turn, and blends
   or splats too. */
typedef struct golden_set {
    golden_render *render;
    const golden_mode *modes;
    uint32_t mode_count;
    const golden_blends *blends; /* null: not by slices */
    const golden_splats *splats; /* null: not of FreeVoxels */
    golden_draw *draw;           /* null: nothing */
    uint32_t first, end;         /* numbers of its scenes */
} golden_set;

golden_draw golden_draw_splats;

enum {
    GOLDEN_FIRST_LENGTHS = 48,
    GOLDEN_FIRST_BSPLINES = 120,
    GOLDEN_FIRST_SLICES = 192,
    GOLDEN_FIRST_SPLATS = 252,
    GOLDEN_FIRST_PREWEIGHTED = 288,
    GOLDEN_SCENES = 304
};

/* Modes that know no lengths, trilinear ones that weigh by length, B-splines, some of
   each by slices, FreeVoxels, and associated colours. */
extern const golden_set golden_steps, golden_lengths, golden_bsplines, golden_slices,
    golden_freevoxels, golden_preweighted;

typedef enum golden_format {
    GOLDEN_RGBA8888,
    GOLDEN_BGRA8888,
    GOLDEN_RGB888,
    GOLDEN_RGB565_LE,
    GOLDEN_RGB565_BE,
    GOLDEN_L8,
    GOLDEN_GREY4,
    GOLDEN_MONO_HORIZONTAL,
    GOLDEN_MONO_VERTICAL,
    GOLDEN_FORMATS
} golden_format;

/* What fills the volume. */
typedef enum golden_content {
    GOLDEN_NOISE,      /* every voxel any colour and opacity, some of them transparent */
    GOLDEN_SHELL,      /* an ellipsoid's skin of noise; nothing outside, nothing inside */
    GOLDEN_THIN,       /* any colour, opacities at the lower end of the storage */
    GOLDEN_BALL,       /* an ellipsoid of nearly opaque voxels */
    GOLDEN_CLASSIFIED, /* scalars, 16 bits, through table, shading and qv_classify */
    GOLDEN_CONTENTS
} golden_content;

/* How the voxels lie in memory. */
typedef enum golden_layout {
    GOLDEN_PACKED,     /* x fastest, then y, then z */
    GOLDEN_PADDED,     /* a gap after each row and each slice */
    GOLDEN_MIRRORED,   /* y and z run downwards in memory */
    GOLDEN_TRANSPOSED, /* z fastest, then y, then x */
    GOLDEN_LAYOUTS
} golden_layout;

/* How a scene is rendered by slices. */
typedef struct golden_slicing {
    const golden_blend *blend; /* null: ray by ray */
    const golden_blend *front; /* of chunks; null: there are none */
    uint16_t chunk;            /* slices in a chunk */
    qv_dither dither;
} golden_slicing;

/* What a scene of FreeVoxels has beside the rest. */
typedef struct golden_splatting {
    const golden_splat *how;     /* null: not of FreeVoxels */
    const golden_mode *lit_mode; /* which samples the volume once it is lit */
    const qv_order *order;
    uint32_t directions; /* a set; 0: as few as the scene needs */
    uint8_t gap;         /* bytes between the records of voxels */
    uint8_t interpolation;
    bool rebuilt; /* bytes of levels are made of the levels' own voxels */
    uint8_t level, coarsest;
    uint16_t detail;
    uint8_t parts; /* of the voxels, where they are divided */
    qv_lighting lighting;
} golden_splatting;

typedef struct golden_scene {
    uint32_t seed;
    golden_render *render;
    const golden_mode *mode;
    golden_content content;
    golden_layout layout;
    uint16_t size[3];
    uint32_t spacing[3];                /* Q16.16 */
    uint32_t unit_distance, extinction; /* Q16.16 */

    const qv_filter *filter; /* of the pyramid */
    uint16_t level;
    uint32_t level_distance;

    qv_angle azimuth, elevation, roll;
    qv_angle field_of_view; /* 0: orthographic */
    uint32_t pitch, step;   /* Q16.16 */
    uint16_t phase;
    uint16_t termination;
    uint8_t background[4];

    uint16_t width, height; /* of the whole frame */
    qv_rect rect;           /* the part of it, or beyond it, that is rendered */
    golden_format format;
    int32_t padding; /* bytes between rows */
    bool bottom_up;  /* rows run downwards in memory */
    uint16_t strip;  /* rows of bytes in a strip; by slices, of pixels */
    uint16_t piece;  /* pixels in a piece; by slices, columns */

    golden_slicing slices;
    golden_splatting splats;
} golden_scene;

/* Makes a scene of a set. */
void golden_describe(golden_scene *golden, const golden_set *set, uint32_t number);

/* The words of a scene's name, such as "weighted", "indexed8", "back to front". */
enum { GOLDEN_WORDS = 5 };
void golden_name(const char *word[GOLDEN_WORDS], const golden_scene *golden);

enum { GOLDEN_VOXEL_BYTES = 4608, GOLDEN_SCALARS = 512, GOLDEN_PIXEL_BYTES = 2560 };

/* Most pixels of a picture of splats, and the sums that they take: of all, and of a part. */
enum { GOLDEN_SPLAT_PIXELS = 36, GOLDEN_SUMS = GOLDEN_SPLAT_PIXELS * QV_SUM_CHANNELS };

/* Something that is done with a scene once it is made. */
typedef qv_status golden_change(qv_scene *scene, struct golden_memory *memory);

/* All that a scene's data needs. */
typedef struct golden_memory {
    qv_transfer table;
    uint8_t palette[QV_PALETTE_ENTRIES][4];
    uint16_t scalars[GOLDEN_SCALARS];        /* once they are classified, the coarser levels */
    uint16_t voxels[GOLDEN_VOXEL_BYTES / 2]; /* then lit ones, and bytes of attenuation */
    uint32_t sums[2][GOLDEN_SUMS];           /* before the first splat, of blocks */
    uint8_t pixels[GOLDEN_PIXEL_BYTES];
    qv_pyramid pyramid;
    golden_change *change; /* null: nothing */
} golden_memory;

/* Fills the memory from the seed and describes the volume. A negative status
   when the library refuses the data, QV_ERROR_BUFFER when the memory is small. */
qv_status golden_volume(qv_volume *volume, golden_memory *memory, const golden_scene *golden);

/* Makes all coarser levels of a volume. Errors as above. */
qv_status golden_pyramid(golden_memory *memory, const qv_volume *volume,
                         const golden_scene *golden);

/* Both, and the scene that sees them. */
qv_status golden_make(qv_scene *scene, golden_memory *memory, const golden_scene *golden);

/* What a scene's camera sees. */
void golden_view(qv_view *view, const golden_scene *golden);

/* Draws a rectangle of the picture. */
typedef qv_status golden_part(void *user, const qv_image *image, const qv_rect *rect);

/* Draws the picture in parts of so many rows of bytes; 0: as one. */
qv_status golden_draw_parts(golden_memory *memory, const golden_scene *golden, int32_t height,
                            golden_part *draw, void *user);

/* Renders a scene that is ready, ray by ray; then as golden_render. */
qv_status golden_render_scene(uint32_t *checksum, golden_memory *memory, const golden_scene *golden,
                              const qv_scene *scene, golden_way way);

/* Fills memory->pixels with what no picture is likely to leave, and its checksum. */
void golden_untouch(golden_memory *memory);
uint32_t golden_checksum(const golden_memory *memory);

/* The format that a scene's picture has. */
const qv_format *golden_find_format(const golden_scene *golden);

#endif /* GOLDEN_SCENES_H */
