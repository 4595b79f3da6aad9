/*
 * configuration.h - sampling modes, storages, steps and frame buffers: what they cost on devices
 * and how far they are off, as measured (advise_table.h), and which reach a wanted error.
 */
#ifndef QVOL_HOST_CONFIGURATION_H
#define QVOL_HOST_CONFIGURATION_H

#include "values.h"

#include "qvol.h"

enum { CONFIGURATION_TARGETS = 11, CONFIGURATION_STEPS = 4, CONFIGURATION_MOST = 256 };

/* Targets, numbered from 1. */
extern const choice configuration_targets[CONFIGURATION_TARGETS + 1];

/* What a target counts: "instructions" or "cycles". */
const char *configuration_unit(int target);

/* ---- Rays ------------------------------------------------------------------------ */

/* In 1/100 of a level of 255. */
struct error_figures {
    uint16_t rms, worst;
};

/* A sampling mode of a storage, qv_MODE_STORAGE. */
struct mode_figures {
    const char *storage, *mode;
    const qv_sampling *sampling;
    struct {
        struct error_figures medium;  /* from the medium that the voxels stand for */
        struct error_figures samples; /* from the same samples in double precision */
    } errors[CONFIGURATION_STEPS];
    uint32_t cost[CONFIGURATION_TARGETS]; /* of a sample */
};

/* What is wanted of a ray; 0 where nothing is. */
struct ray_wish {
    int target;
    double worst, rms;    /* levels of 255, at most */
    bool samples;         /* beside the same samples, else beside the medium */
    unsigned voxel_bytes; /* at most; a palette, which all voxels share, does not count */
};

struct ray_configuration {
    const struct mode_figures *of;
    unsigned voxel_bytes;
    double step;       /* voxels */
    double worst, rms; /* levels of 255 */
    unsigned sample;   /* what a sample costs */
    double length;     /* what a voxel's length of a ray costs */
};

/* Whether samples are weighed by length, so that opacities hold for a voxel; else for a step. */
bool ray_by_length(const struct ray_configuration *of);

/* Fills `found` with those that reach all that is wanted, the cheapest first; returns how many. */
unsigned rays_within(struct ray_configuration found[CONFIGURATION_MOST],
                     const struct ray_wish *wish);

/* The one of the smallest worst error, or RMS where only that is wanted, of those of few enough
   bytes. */
void rays_best(struct ray_configuration *best, const struct ray_wish *wish);

/* ---- Frame buffers ----------------------------------------------------------------- */

/* A blend of the library, qv_NAME, and where qv_recommend leads to it. */
struct blend_figures {
    const char *name;
    uint8_t bits, residual;
    uint8_t advice;                       /* a qv_advice */
    uint8_t bytes, beside;                /* of RAM, of a pixel and beside it */
    uint32_t cost[CONFIGURATION_TARGETS]; /* of a pixel of a slice */
};

struct buffer_wish {
    int target;
    double worst;     /* levels of 255, at most; 0: any */
    bool fog;         /* of a constant fog, else of any content */
    unsigned bits;    /* of a channel; 0: any */
    int residual;     /* bits beside; negative: any */
    uint16_t slices;  /* that a pixel meets */
    uint32_t opacity; /* of each at least, Q0.32 */
};

struct buffer_configuration {
    const struct blend_figures *of;
    double worst, worst_fog; /* levels of 255 */
    unsigned pixel;          /* what a pixel of a slice costs */
};

/* As for rays; errors are those of qv_recommend, or what so few slices can round, where that is
   less. A residual goes with 8 bits. */
unsigned buffers_within(struct buffer_configuration found[CONFIGURATION_MOST],
                        const struct buffer_wish *wish);
void buffers_best(struct buffer_configuration *best, const struct buffer_wish *wish);

#endif
