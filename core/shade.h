/*
 * shade.h - light on a voxel: Lambert and Blinn-Phong.
 */
#ifndef QV_SHADE_H
#define QV_SHADE_H

#include "gradient.h"
#include "qvol.h"

/* A checked qv_shading: its vectors normalised, its lengths in place. */
typedef struct qv_shader {
    qv_gradient gradient;
    int32_t light[3]; /* unit vectors, Q2.30 */
    int32_t half[3];  /* only where specular is not 0 */
    uint16_t ambient, diffuse, specular;
    uint8_t gloss;
} qv_shader;

/*
 * For checked spacings and 0 < window < 2^18. Light and viewer that are opposite
 * to within 1/256 of a radian give no highlight. QV_OK or QV_ERROR_LIGHT.
 */
qv_status qv_shader_init(qv_shader *shader, const qv_shading *shading, const uint32_t spacing[3],
                         uint32_t window);

/*
 * Shades a colour whose voxel has these differences of values along the axes,
 * each within -65535 .. 65535. Rounded once, to nearest: within .75 of 65535 of
 * real arithmetic. Opacity stays.
 */
void qv_shade(uint16_t rgba[4], const qv_shader *shader, const int32_t difference[3]);

#endif /* QV_SHADE_H */
