#include "reference.h"

#include <math.h>

ref_piece ref_first_piece(const ref_ray *ray)
{
    return (ref_piece){ray->enter, ray->enter};
}

bool ref_next_piece(ref_piece *piece, const ref_ray *ray, double stretch)
{
    const double first = (double)ray->index + 0.5; /* half a step behind: borders are multiples */
    const double number = floor((piece->end + first) / stretch);
    const double border = (number + 1) * stretch - first;
    piece->begin = piece->end;
    piece->end = fmin(border, ray->leave);
    return piece->begin < piece->end;
}
