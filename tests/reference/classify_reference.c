#include "classify_reference.h"

#include <math.h>
#include <string.h>

double ref_nearest(double v)
{
    return floor(v + 0.5);
}

void ref_transfer_entry(double rgba[4], const qv_control_point *points, uint16_t count,
                        unsigned index)
{
    const qv_control_point *before = &points[0], *after = &points[count - 1];

    for (uint16_t i = 0; i < count; i++)
        if (points[i].index <= index)
            before = &points[i];
    for (uint16_t i = count; i-- > 0;)
        if (points[i].index >= index)
            after = &points[i];
    /* Outside the points both are the same end, between them a true interval. */
    double length = (double)after->index - before->index;
    double place = index - (double)before->index;
    for (int c = 0; c < 4; c++) {
        double rise = (double)after->rgba[c] - before->rgba[c];
        rgba[c] = before->rgba[c] + (length > 0 ? rise * place / length : 0);
    }
}

static int clamp(int v, int size)
{
    return v < 0 ? 0 : v >= size ? size - 1 : v;
}

double ref_scalar(const qv_scalars *scalars, int x, int y, int z)
{
    const unsigned char *at = scalars->values;
    int16_t negative;
    uint16_t word;

    at += (ptrdiff_t)clamp(x, scalars->size[0]) * scalars->stride[0];
    at += (ptrdiff_t)clamp(y, scalars->size[1]) * scalars->stride[1];
    at += (ptrdiff_t)clamp(z, scalars->size[2]) * scalars->stride[2];
    switch (scalars->type) {
    case QV_SCALAR_U16:
        memcpy(&word, at, sizeof word);
        return word;
    case QV_SCALAR_S16:
        memcpy(&negative, at, sizeof negative);
        return negative;
    default:
        return *at;
    }
}

int ref_table_index(double s, const qv_classifier *classifier)
{
    double window = (double)classifier->high - classifier->low;
    double index = ref_nearest(255 * (s - classifier->low) / window);
    return (int)fmin(fmax(index, 0), 255);
}

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void normalise(double unit[3], const double v[3])
{
    double l = length(v);
    for (int a = 0; a < 3; a++)
        unit[a] = v[a] / l;
}

static double lit(const double a[3], const double b[3])
{
    return fmax(0, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/* n.h, or 0 where light and viewer are opposite. */
static double half_cosine(const double normal[3], const double light[3], const int16_t direction[3])
{
    const double towards[3] = {direction[0], direction[1], direction[2]};
    double viewer[3], half[3];

    normalise(viewer, towards);
    for (int a = 0; a < 3; a++)
        half[a] = light[a] + viewer[a];
    if (length(half) < 1.0 / 256)
        return 0;
    normalise(half, half);
    return lit(normal, half);
}

void ref_shade(double rgba[4], const double gradient[3], const qv_shading *shading, double window)
{
    const double against[3] = {-gradient[0], -gradient[1], -gradient[2]};
    const double towards[3] = {shading->light[0], shading->light[1], shading->light[2]};
    double magnitude = length(gradient), normal[3], light[3], specular = 0;

    if (magnitude == 0 || magnitude * 256 / window < shading->least_gradient)
        return;
    normalise(normal, against);
    normalise(light, towards);
    if (shading->specular > 0)
        specular = shading->specular / 256.0 *
                   pow(half_cosine(normal, light, shading->viewer), ldexp(1, shading->gloss));
    double reflected = shading->ambient / 256.0 + shading->diffuse / 256.0 * lit(normal, light);
    for (int c = 0; c < 3; c++)
        rgba[c] = fmin(65535, rgba[c] * reflected + 65535 * specular);
}

void ref_gradient(double gradient[3], const qv_scalars *scalars, int x, int y, int z)
{
    gradient[0] = ref_scalar(scalars, x + 1, y, z) - ref_scalar(scalars, x - 1, y, z);
    gradient[1] = ref_scalar(scalars, x, y + 1, z) - ref_scalar(scalars, x, y - 1, z);
    gradient[2] = ref_scalar(scalars, x, y, z + 1) - ref_scalar(scalars, x, y, z - 1);
    for (int a = 0; a < 3; a++) {
        double spacing = scalars->spacing[a] ? scalars->spacing[a] / 65536.0 : 1;
        gradient[a] /= 2 * spacing;
    }
}

void ref_classify(double rgba[4], const qv_classifier *classifier, int x, int y, int z)
{
    int index = ref_table_index(ref_scalar(&classifier->scalars, x, y, z), classifier);
    double gradient[3];

    for (int c = 0; c < 4; c++)
        rgba[c] = classifier->transfer->rgba[index][c];
    if (classifier->shading) {
        ref_gradient(gradient, &classifier->scalars, x, y, z);
        ref_shade(rgba, gradient, classifier->shading, (double)classifier->high - classifier->low);
    }
}

double ref_mean(const qv_scalars *scalars, const uint8_t factor[3], int x, int y, int z)
{
    double sum = 0;
    int count = 0;

    for (int k = z * factor[2]; k < (z + 1) * factor[2] && k < scalars->size[2]; k++)
        for (int j = y * factor[1]; j < (y + 1) * factor[1] && j < scalars->size[1]; j++)
            for (int i = x * factor[0]; i < (x + 1) * factor[0] && i < scalars->size[0]; i++) {
                sum += ref_scalar(scalars, i, j, k);
                count++;
            }
    return sum / count;
}
