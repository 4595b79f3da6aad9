#include "pictures.h"

#include <math.h>

const store store_real = {"real numbers", STORE_REAL, 0, false};

/* binary16: 11 significant bits, the least exponent that of 2^-14. */
double store_half(double value)
{
    int exponent;
    (void)frexp(value, &exponent);
    const double unit = ldexp(1, (exponent < -13 ? -13 : exponent) - 11);
    return nearbyint(value / unit) * unit;
}

double store_unit(const store *by)
{
    return by->kind == STORE_UNORM ? ldexp(1, (int)by->bits) - 1 : 65535;
}

static double stored(const store *by, double channel)
{
    switch (by->kind) {
    case STORE_UNORM:
        return floor(channel * store_unit(by) + 0.5);
    case STORE_HALF:
        return store_half(channel) * store_unit(by);
    default:
        return channel * store_unit(by);
    }
}

stored_voxels store_make(const picture_scene *from, const store *by)
{
    stored_voxels made = paper_memory(from->voxels, sizeof made[0]);
    for (size_t i = 0; i < from->voxels; i++) {
        const double *rgba = from->rgba[i];
        made[i][3] = stored(by, rgba[3]);
        for (int channel = 0; channel < 3; channel++) {
            const double colour = by->associated ? rgba[channel] * rgba[3] : rgba[channel];
            made[i][channel] = stored(by, colour);
        }
    }
    return made;
}
