/*
 * size.h - programs whose flash, RAM and stack `make size` reports. Each names what a device
 * may want of the library, one capability beside the other, over a small volume in program memory:
 * one storage (indexed8), one pixel format (RGB565).
 *
 * Every call of the library is one region of what is measured (port/measure.h).
 */
#ifndef SIZE_H
#define SIZE_H

#include "volume.h"
#include "measure.h"

enum { SIZE_WIDTH = 16, SIZE_HEIGHT = 8 };

/* Measures a call where all before it have gone well. */
#define SIZE_CALL(status, call)                                                                    \
    do {                                                                                           \
        if ((status) == QV_OK) {                                                                   \
            measure_begin();                                                                       \
            (status) = (call);                                                                     \
            measure_end();                                                                         \
        }                                                                                          \
    } while (0)

/* What a program uses, in this order, up to a null pointer. Each returns its first error. */
typedef qv_status size_use(void);

extern size_use *const size_uses[];

qv_status use_orthographic(void); /* one weighted mode, front to back */
qv_status use_perspective(void);
qv_status use_classification(void); /* scalars to indices and a palette */
qv_status use_progress(void);       /* a few pixels a call */
qv_status use_extinction(void);
qv_status use_dithering(void);  /* slices into a frame buffer of 8 bits that stays */
qv_status use_pyramid(void);    /* levels made, chosen and sampled by extinction */
qv_status use_freevoxels(void); /* attenuation made, splats drawn, lit by a lamp */

/* Tells what a use wants of the caller's memory: bytes that live as long as a scene, and bytes
   to work in that uses may share. */
void size_context_bytes(size_t bytes);
void size_scratch_bytes(size_t bytes);

/* ---- Shared between them --------------------------------------------------- */

/* Memory that they use in turn: pixels, or what is made of voxels. */
enum { SIZE_MEMORY = 3072 };
extern uint8_t size_memory[SIZE_MEMORY];
extern qv_context size_context;

extern const qv_rect size_frame;

/* The volume in the frame, by this mode. */
void size_scene(qv_scene *scene, qv_view *view, const qv_sampling *sampling);

/* Prepares and renders it as seen by the scene's camera. */
qv_status size_render(const qv_scene *scene);

#endif /* SIZE_H */
