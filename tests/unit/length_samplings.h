/*
 * length_samplings.h - every sampling mode that weighs by length.
 */
#ifndef LENGTH_SAMPLINGS_H
#define LENGTH_SAMPLINGS_H

#include "qvol.h"

/* Of one mode and storage: front to back, back to front, through a pyramid. */
typedef struct length_sampling {
    const qv_sampling *front, *back, *levels;
} length_sampling;

#define LENGTH_SAMPLING(name)                                                                      \
    {                                                                                              \
        &name, &name##_back_to_front, &name##_levels                                               \
    }
#define OPACITY_SAMPLINGS(mode)                                                                    \
    LENGTH_SAMPLING(mode##_rgba8), LENGTH_SAMPLING(mode##_rgba16),                                 \
        LENGTH_SAMPLING(mode##_indexed8), LENGTH_SAMPLING(mode##_indexed8_16)
#define EXTINCTION_SAMPLINGS(mode)                                                                 \
    LENGTH_SAMPLING(mode##_rgbt8), LENGTH_SAMPLING(mode##_rgbt16),                                 \
        LENGTH_SAMPLING(mode##_indexed8_t8), LENGTH_SAMPLING(mode##_indexed8_t16)

enum { STORAGES = 4, LENGTH_MODES = 6, LENGTH_SAMPLINGS = LENGTH_MODES * STORAGES };

/* Of each mode 8 bits, 16 bits and the same with palettes; first those of storages that
   hold opacity, then those that hold extinction. */
static const length_sampling length_samplings[LENGTH_SAMPLINGS] = {
    OPACITY_SAMPLINGS(qv_corrected),     OPACITY_SAMPLINGS(qv_bspline_weighted),
    OPACITY_SAMPLINGS(qv_extinction),    OPACITY_SAMPLINGS(qv_bspline_extinction),
    EXTINCTION_SAMPLINGS(qv_extinction), EXTINCTION_SAMPLINGS(qv_bspline_extinction),
};

#endif /* LENGTH_SAMPLINGS_H */
