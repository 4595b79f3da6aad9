/*
 * model.h - a volume that can be rendered or exported: scalars with their
 * transfer table, or voxels that were classified before.
 */
#ifndef QVOL_HOST_MODEL_H
#define QVOL_HOST_MODEL_H

#include "scalar_view.h"
#include "transfer_text.h"
#include "voxel_storage.h"

struct model {
    struct scan scan;
    bool classified_before; /* then no scalars, no transfer function */
    struct scalar_view view;
    struct transfer transfer;
    qv_transfer table;  /* of opacity, or of extinction once model_hold_extinction has been */
    qv_shading shading; /* with directions, where the settings ask for shading */
    bool shaded;
    qv_classifier classifier;
    qv_storage storage;
    uint32_t unit_distance; /* world units for which opacities hold, Q16.16; 0: the step */
    uint32_t extinction;    /* of the full value, Q16.16; 0 where the storage holds opacity */
    void *voxels;           /* that model_volume classified; else null */
    void *palette;          /* of indexed storage; else null */
    uint32_t palette_bytes;
    uint8_t reduction[3];
    double world_unit;  /* in the file's unit */
    struct model *mask; /* stands in where its scalars are above 0; may be null */
};

/* Reads the input and all that its classification needs. */
void model_read(struct model *model, const struct settings *settings, const char *name,
                qv_storage default_storage);

void model_free(struct model *model);

/* Replaces the scalars by means over boxes. */
void model_reduce(struct model *model, const uint8_t factor[3]);

/* Where the storage holds extinction, turns the transfer table into one of extinction, which
   is chosen so that it holds every entry unless the settings say. Before any voxel is
   classified, after the model was reduced. */
void model_hold_extinction(struct model *model, const struct settings *settings);

/* Turns the transfer table, of opacity for the model's unit distance, into one for a step, Q16.16:
   for sampling that knows no lengths. */
void model_hold_steps(struct model *model, uint32_t step);

/* The descriptor of the classified volume, all but the voxels' address. */
void model_describe(qv_volume *volume, const struct model *model);

/* Classifies everything (on the settings' threads), or takes the voxels of the file, and fills the
   descriptor. The voxels live as long as the model. */
void model_volume(qv_volume *volume, struct model *model, const struct settings *settings);

/* Classifies slices first <= z < end into tightly packed voxels; bytes is their size. */
void model_classify(void *voxels, size_t bytes, const struct model *model, uint32_t first,
                    uint32_t end);

/* A length or extinction of the settings as Q16.16, at least 1. */
uint32_t to_q16(double number);

/* Degrees, whatever turns they make. */
qv_angle binary_angle(double degrees);

/* The camera's directions that --azimuth, --elevation and --roll make. */
void settings_rotation(int32_t rotation[3][3], const struct settings *settings);

/* Ends the command if the library refuses what was made from the input. */
void check_status(qv_status status, const struct model *model, const char *field);

#endif
