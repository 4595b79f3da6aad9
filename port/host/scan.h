/*
 * scan.h - a volume as a file gives it, in the machine's byte order, and its
 * way into the library's descriptors.
 */
#ifndef QVOL_HOST_SCAN_H
#define QVOL_HOST_SCAN_H

#include "values.h"
#include "qvol.h"

typedef enum element {
    ELEMENT_NONE = 0,
    ELEMENT_U8,
    ELEMENT_S8,
    ELEMENT_U16,
    ELEMENT_S16,
    ELEMENT_U32,
    ELEMENT_S32,
    ELEMENT_F32,
    ELEMENT_F64,
    /* classified already */
    ELEMENT_RGBA8,
    ELEMENT_RGBA16,
    ELEMENT_RGBT8, /* with extinction for opacity */
    ELEMENT_RGBT16,
    ELEMENT_ASSOCIATED8, /* with colours weighted by opacity */
    ELEMENT_INDEXED8
} element;

extern const choice element_names[];

/* Bytes of one voxel, and of the words whose byte order may differ. */
unsigned element_bytes(element type);
unsigned element_word_bytes(element type);
bool element_is_classified(element type);

/*
 * Which way the stored axes lead. World axis w (0 right, 1 anterior, 2 superior)
 * is stored axis axis[w]; reversed[w] where the stored axis leads the other way.
 */
struct orientation {
    uint8_t axis[3];
    bool reversed[3];
};

struct scan {
    const char *file;
    const char *format;
    void *values;
    uint64_t bytes;
    void *levels; /* coarser ones that follow classified voxels; else null */
    uint64_t level_bytes;
    element type;
    uint32_t size[3];        /* as stored, x fastest */
    double spacing[3];       /* of the stored axes */
    struct orientation turn; /* from stored axes to the world's */
    bool oriented;           /* the file says where the axes lead */
    double slope, offset;    /* value = slope * stored + offset */
};

/* Frees values and levels. */
void scan_free(struct scan *scan);

/* A scan of that geometry without values: cubic voxels, axes as they come. */
void scan_clear(struct scan *scan, const char *file, const char *format);

/*
 * Voxels times their bytes, after the checks that every format shares: each size
 * 1 .. QV_AXIS_MAX, each spacing finite and not 0. Cannot overflow: 2^36 * 8.
 */
uint64_t scan_data_bytes(const struct scan *scan);

/* Takes the values out of a file that holds at most `available` more bytes. */
void scan_allocate(struct scan *scan, uint64_t available);

/*
 * Sets spacing and orientation from the world directions of the stored axes:
 * column a is the step from voxel to voxel along axis a. Oblique axes go to the
 * nearest permutation. False unless the columns are finite and independent.
 */
bool scan_orient(struct scan *scan, double direction[3][3]);

/* Three letters, where the stored axes lead: "RAS", "LPI". */
void scan_orientation_text(const struct scan *scan, char text[4]);

/* The coarser levels that level_bytes hold, where their voxels are of that storage; 0 if
   they hold none. */
uint8_t scan_levels(const struct scan *scan, qv_storage storage);

/* Exchanges the bytes of each word; for files of the other byte order. */
void swap_words(void *values, uint64_t bytes, unsigned word_bytes);

/* The value of the voxel at that place in memory, scaled. */
double scan_value(const struct scan *scan, uint64_t place);

/* Lowest and highest finite value; false if there is none. */
bool scan_range(const struct scan *scan, double *low, double *high);

/* The library takes spacings up to 16, and the smallest is 1. */
#define SPACING_RATIO_MOST 16

/* The geometry in world order: size, spacing in units of the smallest one
   (Q16.16), strides, and the bytes from the start of memory to voxel (0,0,0). */
struct layout {
    uint16_t size[3];
    uint32_t spacing[3];
    int32_t stride[3];
    uint64_t first;
    double world_unit; /* smallest spacing, in the file's unit */
};

void scan_layout(struct layout *layout, const struct scan *scan, unsigned voxel_bytes);

#endif
