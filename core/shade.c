#include "shade.h"

#include "fx_angle.h"
#include "fx_wide.h"
#include "unit_vector.h"

#define COEFFICIENT_ONE 256u /* Q0.8 */
#define GLOSS_MAX       7u
#define UNORM16_ONE     65535u

/* |light + viewer| below 2^-8 leaves too few bits of the half vector: this is the
   square of half of it, on integers in Q2.30. */
#define LEAST_HALF_SQUARE ((uint64_t)1 << (2 * (30 - 9)))

/* The unit vector along v. */
static void normalise(int32_t unit[3], const int32_t v[3])
{
    uint64_t scale[3];
    for (unsigned axis = 0; axis < 3; axis++)
        scale[axis] = 1;
    qv_unit_vector(unit, v, scale);
}

/* Returns 0 for the zero vector. */
static int direction(int32_t unit[3], const int16_t v[3])
{
    const int32_t wide[3] = {v[0], v[1], v[2]};
    if (v[0] == 0 && v[1] == 0 && v[2] == 0)
        return 0;
    normalise(unit, wide);
    return 1;
}

/* Halfway between two unit vectors; 0 where they are nearly opposite. */
static int halfway(int32_t half[3], const int32_t light[3], const int32_t viewer[3])
{
    int32_t mean[3];
    uint64_t square = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        mean[axis] = light[axis] / 2 + viewer[axis] / 2; /* |mean| <= 2^30 */
        uint32_t size = (uint32_t)(mean[axis] < 0 ? -mean[axis] : mean[axis]);
        square += fx_wide_product(size, size); /* <= 3 * 2^60 */
    }
    if (square < LEAST_HALF_SQUARE)
        return 0;
    normalise(half, mean);
    return 1;
}

static int in_range(const qv_shading *shading)
{
    return shading->ambient <= COEFFICIENT_ONE && shading->diffuse <= COEFFICIENT_ONE &&
           shading->specular <= COEFFICIENT_ONE && shading->gloss <= GLOSS_MAX;
}

qv_status qv_shader_init(qv_shader *shader, const qv_shading *shading, const uint32_t spacing[3],
                         uint32_t window)
{
    int32_t viewer[3];

    if (!in_range(shading) || !direction(shader->light, shading->light))
        return QV_ERROR_LIGHT;
    if (shading->specular != 0 && !direction(viewer, shading->viewer))
        return QV_ERROR_LIGHT;

    shader->ambient = shading->ambient;
    shader->diffuse = shading->diffuse;
    shader->specular = shading->specular;
    shader->gloss = shading->gloss;
    if (shading->specular != 0 && !halfway(shader->half, shader->light, viewer))
        shader->specular = 0;
    qv_gradient_init(&shader->gradient, spacing, shading->least_gradient, window);
    return QV_OK;
}

/* coefficient * v for a coefficient in Q0.8 and v in Q2.30, both at most 1. */
static uint32_t share(uint16_t coefficient, uint32_t v)
{
    return (uint32_t)((fx_wide_product(coefficient, v) + COEFFICIENT_ONE / 2) >> 8);
}

/* v^(2^gloss) for v <= 1 in Q2.30. */
static uint32_t power(uint32_t v, uint8_t gloss)
{
    for (uint8_t i = 0; i < gloss; i++)
        v = (uint32_t)((fx_wide_product(v, v) + (FX_ONE_Q30 >> 1)) >> 30);
    return v;
}

/* The light that a surface reflects in its own colour: at most 2 in Q2.30. */
static uint32_t reflected(const qv_shader *shader, const int32_t normal[3])
{
    uint32_t lambert = qv_unit_cosine(normal, shader->light);
    return share(shader->ambient, FX_ONE_Q30) + share(shader->diffuse, lambert);
}

/* The highlight, white: at most 1 in Q2.30. */
static uint32_t highlight(const qv_shader *shader, const int32_t normal[3])
{
    if (shader->specular == 0)
        return 0;
    return share(shader->specular, power(qv_unit_cosine(normal, shader->half), shader->gloss));
}

void qv_shade(uint16_t rgba[4], const qv_shader *shader, const int32_t difference[3])
{
    int32_t normal[3];
    if (!qv_gradient_normal(normal, &shader->gradient, difference))
        return;

    uint32_t factor = reflected(shader, normal);
    uint64_t offset = fx_wide_product(UNORM16_ONE, highlight(shader, normal));
    for (unsigned channel = 0; channel < 3; channel++) {
        /* <= 65535 * (2^31 + 2^30) < 2^48 */
        uint64_t sum = fx_wide_product(rgba[channel], factor) + offset + (FX_ONE_Q30 >> 1);
        uint32_t level = (uint32_t)(sum >> 30);
        rgba[channel] = (uint16_t)(level > UNORM16_ONE ? UNORM16_ONE : level);
    }
}
