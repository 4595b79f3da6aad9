#include "reference.h"

#include <math.h>

static const double ln2 = 0.69314718055994530942;

/* Of full opacity; by the convention of qvol.h. */
static const double most_depth = 64;

double ref_depth(double opacity)
{
    return opacity < 1 ? fmin(-log1p(-opacity) / ln2, most_depth) : most_depth;
}

double ref_extinction(double channel, const qv_volume *volume)
{
    if (ref_holds_extinction(volume->storage)) {
        return channel * (volume->extinction / 65536.0);
    }
    return ref_depth(channel) / (volume->unit_distance / 65536.0);
}

/* 1 - 2^-depth. */
static double opacity_of_depth(double depth)
{
    return -expm1(-depth * ln2);
}

double ref_correct(double opacity, double ratio)
{
    return ratio == 1 ? opacity : opacity_of_depth(ref_depth(opacity) * ratio);
}

void ref_weigh(double sample[4], const qv_volume *volume, ref_mode mode, double length)
{
    const double found = sample[3];
    const double opacity = ref_is_by_extinction(mode)
                               ? opacity_of_depth(found * length)
                               : ref_correct(found, length / (volume->unit_distance / 65536.0));
    for (int channel = 0; channel < 3; channel++) {
        sample[channel] *= found > 0 ? opacity / found : 0;
    }
    sample[3] = opacity;
}
