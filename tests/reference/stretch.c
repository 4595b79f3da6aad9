#include "reference.h"

#include <math.h>

ref_piece ref_first_piece(const ref_ray *ray)
{
    return (ref_piece){ray->enter, ray->enter};
}

double ref_grid(const ref_ray *ray, double steps)
{
    return steps + ((double)ray->index + 0.5);
}

bool ref_next_piece(ref_piece *piece, const ref_ray *ray, double stretch, double end)
{
    const double number = floor(ref_grid(ray, piece->end) / stretch);
    const double border = fmin((number + 1) * stretch, end);
    piece->begin = piece->end;
    piece->end = fmin(border - ref_grid(ray, 0), ray->leave);
    return piece->begin < piece->end;
}
