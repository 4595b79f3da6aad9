/*
 * composite.h - tests/SPEC.md, sections 14 and 15: the light of a ray.
 */
#ifndef COMPOSITE_H
#define COMPOSITE_H

#include "number.h"

typedef struct light {
    triple E;
    number T;
} light;

light light_at_start(void);
light under(const light *before, const triple *L, number a32);
light over(const light *before, const triple *L, number a32);

/* Whether a ray, front to back, ends after a sample that was not skipped. */
bool is_end(number T, number threshold);

#endif /* COMPOSITE_H */
