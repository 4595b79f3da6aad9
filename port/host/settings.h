/*
 * settings.h - what the command line says, checked as far as it can be without
 * the data.
 */
#ifndef QVOL_HOST_SETTINGS_H
#define QVOL_HOST_SETTINGS_H

#include "input.h"

/* The library's largest factor of a reduction. */
#define FACTOR_MOST 64

/* The library's range of steps, in units of the smallest spacing. */
#define STEP_LEAST (1.0 / 16)
#define STEP_MOST  16

/* By storage: extinction where voxels hold it, preweighted where colours are, else weighted. */
enum sampling_mode {
    SAMPLING_BY_STORAGE,
    SAMPLING_NEAREST,
    SAMPLING_SEPARATE,
    SAMPLING_WEIGHTED,
    SAMPLING_PREWEIGHTED,
    SAMPLING_EXTINCTION,
    SAMPLING_BSPLINE_WEIGHTED,
    SAMPLING_BSPLINE_EXTINCTION,
    SAMPLING_MODES
};
/* By sampling: what suits its reconstruction. */
enum filter_kind { FILTER_BY_SAMPLING, FILTER_BOX2, FILTER_BOX4, FILTER_QUAD4 };
enum domain_kind { DOMAIN_BY_DEFAULT, DOMAIN_EXTINCTION, DOMAIN_OPACITY };
enum order { ORDER_BY_COMPOSITING, ORDER_FRONT_TO_BACK, ORDER_BACK_TO_FRONT };
/* By frame buffer: rounding, but for 24 bits. Auto: what the library recommends. */
enum dither_kind {
    DITHER_BY_FRAMEBUFFER,
    DITHER_NONE,
    DITHER_RANDOM,
    DITHER_ORDERED,
    DITHER_BUMP,
    DITHER_ROUNDING,
    DITHER_FEEDBACK,
    DITHER_AUTO
};
enum sequence_kind {
    SEQUENCE_BY_DITHER,
    SEQUENCE_ROUNDED,
    SEQUENCE_GOLDEN,
    SEQUENCE_HASH,
    SEQUENCE_BLOCKS
};
/* Bytes of an entry. */
enum table_kind { TABLE_NONE = 0, TABLE_OPACITY = 1, TABLE_COLOUR = 4 };
enum container { CONTAINER_BY_ENDING, CONTAINER_PNG, CONTAINER_PAM, CONTAINER_RAW };
enum splatting_kind { SPLATTING_ADDED, SPLATTING_OVER };
enum kernel_kind { KERNEL_QUADRATIC, KERNEL_LINEAR };

/* Slices and the frame buffer that they are blended into. 0: not given. */
struct slice_settings {
    bool wanted;       /* else rays */
    uint32_t count;    /* slices through the box */
    int framebuffer;   /* bits a channel, or 565 */
    int dither;        /* enum dither_kind */
    int sequence;      /* enum sequence_kind */
    unsigned residual; /* bits a channel */
    unsigned period;   /* slices */
    unsigned slopes;   /* how many were given */
    double slope[2];
    unsigned cutoff; /* levels of 255 */
    bool frame_given;
    uint32_t frame;
    bool still;
    uint32_t chunk;     /* slices */
    uint32_t bricks[3]; /* parts of each axis */
};

/* Pages that voxels come through. */
struct cache_settings {
    uint32_t pages;   /* 0: voxels lie in memory */
    uint32_t page[3]; /* voxels of a brick on an axis, powers of 2 */
    bool page_given;
};

/* A FreeVoxel file that is made. */
struct freevoxel_settings {
    uint32_t directions; /* a set; 0: all */
    int order;           /* enum freevoxel_order */
    bool hierarchy_given;
    int hierarchy; /* enum freevoxel_hierarchy, where there are levels */
    bool levels_given;
    unsigned levels;  /* coarser ones; not given: as many as the size has */
    bool uncorrected; /* opacities hold for a step of any direction */
};

/* A FreeVoxel file that is drawn. */
struct splat_settings {
    int splatting;     /* enum splatting_kind */
    int kernel;        /* enum kernel_kind */
    int interpolation; /* a qv_interpolation */
    unsigned level;    /* the finest */
    bool levels;       /* coarser ones too, where their voxels are narrow enough */
    bool detail_given;
    double detail;  /* pixels */
    uint32_t part;  /* of the voxels, counted from 1 */
    uint32_t parts; /* 0: all of them */
};

/* Light from outside. */
struct lamp_settings {
    double angles[2]; /* degrees: azimuth, elevation */
    uint8_t colour[3];
};

struct lighting_settings {
    struct lamp_settings lamps[QV_LAMPS_MAX];
    unsigned count;
    bool ambient_given;
    uint8_t ambient[3];
};

/* What advice is asked for. 0: not given. */
struct advise_settings {
    int target; /* of configuration_targets */
    double error, rms;
    bool against_given;
    bool samples;         /* errors from the same samples, else from the medium */
    unsigned voxel_bytes; /* at most */
    double opacity;       /* of slices */
    bool content_given;
    bool fog;
};

struct settings {
    const char *operands[2];
    int operand_count;
    const char *output; /* null: not given */
    const char *json;   /* null: no report */
    bool quiet;
    unsigned threads;

    raw_options raw;
    const char *palette;
    bool endian_given;
    bool big_endian; /* of 16-bit data written, and of a 16-bit palette read */

    int storage; /* a qv_storage without the palette's width; 0: by default */
    unsigned palette_bits;
    bool extinction_given;
    double extinction;         /* depth of the full value per world unit; 0: as voxels need it */
    double unit_distance;      /* world units for which opacities hold; 0: the step */
    const char *transfer;      /* null: the default */
    const char *mask;          /* a second scan; null: none */
    const char *mask_transfer; /* its transfer function */
    bool window_given;
    double window[2];
    bool shade;
    bool light_given;
    double light[2]; /* degrees from the viewer: to the right, up */

    int sampling; /* enum sampling_mode */
    int order;    /* enum order */
    bool level_given;
    bool level_auto;
    double level;
    int filter; /* enum filter_kind */
    int domain; /* enum domain_kind */
    uint32_t size[2];
    double angles[3]; /* degrees: azimuth, elevation, roll */
    double zoom;
    double perspective; /* degrees; 0: orthographic */
    bool step_given;
    double step;
    bool phase_given;
    double phase;
    double termination; /* negative: the library's default */
    uint8_t background[4];
    const char *format; /* null: rgb888, or rgba8888 over a transparent background */
    int container;      /* enum container */
    uint32_t strip;     /* rows rendered at a time; 0: by default */

    struct cache_settings cache;
    struct slice_settings slices;
    struct freevoxel_settings freevoxel;
    struct splat_settings splat;
    struct lighting_settings lighting;
    struct advise_settings advise;

    uint32_t reduce[3]; /* 0: not given */
    uint64_t fit;       /* bytes; 0: not given */
    int dither_table;   /* enum table_kind */
    const char *name;   /* of the C array; null: from the output */
    const char *from;   /* folder of test vectors; null: that of the installation */
    double tolerance;
    bool gain_given;
    double gain;
};

/* Groups of options; each command takes some. */
enum option_group {
    GROUP_INPUT = 1,
    GROUP_CLASSIFY = 2,
    GROUP_VIEW = 4,
    GROUP_PICTURE = 8,
    GROUP_EXPORT = 16,
    GROUP_COMPARE = 32,
    GROUP_REPORT = 64,
    GROUP_THREADS = 128,
    GROUP_OUTPUT = 256,
    GROUP_COMMON = 512,
    GROUP_REDUCE = 1024,
    GROUP_LEVELS = 2048,
    GROUP_TABLE = 4096,
    GROUP_FRAME = 8192,
    GROUP_FREEVOXEL = 16384,
    GROUP_SPLAT = 32768,
    GROUP_LIGHTING = 65536,
    GROUP_ADVISE = 131072,
    GROUP_VECTORS = 262144
};

struct option_spec {
    const char *name;
    char letter;          /* 0: long form only */
    const char *argument; /* null: none; in brackets: optional */
    const char *help;
    void (*set)(struct settings *settings, const char *option, const char *value);
    int group;
};

/* Ends with a null name. */
extern const struct option_spec option_specs[];

/* Names of the values, for reports as well. */
extern const choice storage_names[];
extern const choice sampling_names[];
extern const choice filter_names[];
extern const choice domain_names[];

/* Of --order, or the one that suits --compositing. */
bool settings_back_to_front(const struct settings *settings);

/* An option that would change nothing, or could not be heeded, without another. */
struct option_need {
    const char *option;
    bool given, met;
    const char *need;
};

/* A usage error for the first of them that is given and not met. */
void settings_refuse(const struct option_need *needs, unsigned count);

/* Refuses options that would change nothing without another; `groups` are those of
   the command. */
void settings_check_needs(const struct settings *settings, int groups);

/* True if the output is C source: its name ends in .c or .h. */
bool settings_want_array(const struct settings *settings);

/* The storage that --storage, --palette-bits, --extinction and --sampling ask for together. */
qv_storage settings_storage(const struct settings *settings, qv_storage by_default);

#endif
