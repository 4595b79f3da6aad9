/*
 * advice.h - what the library recommends for a scene's slices.
 */
#ifndef QVOL_HOST_ADVICE_H
#define QVOL_HOST_ADVICE_H

#include "scene.h"

struct advice {
    bool given;       /* else there is none; its figures were measured back to front */
    uint16_t slices;  /* through the box */
    uint32_t opacity; /* no slice that is not empty has less, Q0.32 */
    qv_recommendation recommendation;
};

void advice_ask(struct advice *advice, const qv_scene *scene, const struct settings *settings);

/* The enum dither_kind that the library names. */
int advice_dither(const struct advice *advice);

#endif
