/*
 * bearing.h - tests/SPEC.md, section 65: light that comes to a voxel from a direction.
 */
#ifndef BEARING_H
#define BEARING_H

#include "number.h"

enum { DIRECTIONS = 26, SHARES = 3 };

enum interpolation { BETWEEN_LIGHT, NEAREST_DIRECTION, BETWEEN_DEPTHS };

/* What a volume's spacing, none of it 0, comes to. */
typedef struct compass {
    triple spacing, side;
    bool has_unit; /* opacities have a unit distance */
} compass;

compass compass_of(const triple *spacing, bool has_unit);

/* The directions that light along a vector is made of. */
typedef struct bearing {
    enum interpolation kind;
    unsigned count;
    unsigned direction[SHARES];
    number own[SHARES], scale[SHARES];
} bearing;

bearing bearing_of(const compass *c, const triple *vector, enum interpolation kind);

/* u32.32, of the bytes of a voxel in all directions. */
number light_through(const bearing *of, const number byte[]);
number light_from_eye(number of_voxel, number of_eye);

/* The vector of light from a lamp. */
triple lamp_vector(const triple *direction, const triple *spacing);

#endif /* BEARING_H */
