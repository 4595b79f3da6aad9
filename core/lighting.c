#include "lighting.h"

#include "fx_wide.h"

#define FULL 65535u

qv_status qv_lighting_check(const qv_lighting *lighting)
{
    if (lighting->count > QV_LAMPS_MAX)
        return QV_ERROR_LIGHT;
    for (unsigned i = 0; i < lighting->count; i++) {
        const int16_t *to = lighting->lamps[i].direction;
        if (to[0] == 0 && to[1] == 0 && to[2] == 0)
            return QV_ERROR_LIGHT;
    }
    return QV_OK;
}

/* The way to a lamp, in voxels of this spacing. */
static FX_NOINLINE void way_to(int32_t way[3], const qv_lamp *lamp, const uint32_t spacing[3])
{
    int64_t world[3], v[3];
    for (unsigned axis = 0; axis < 3; axis++) /* at most 2^55, and in voxels 2^43 */
        world[axis] = lamp->direction[axis] * ((int64_t)1 << 40);
    qv_bearing_voxels(v, world, spacing);
    (void)qv_bearing_scale(way, v);
}

qv_status qv_lighting_bearings(qv_bearing lamp[QV_LAMPS_MAX], const qv_lighting *lighting,
                               const qv_compass *compass, const uint32_t spacing[3])
{
    qv_status status = QV_OK;
    for (unsigned i = 0; status == QV_OK && i < lighting->count; i++) {
        int32_t way[3];
        uint32_t length;
        way_to(way, &lighting->lamps[i], spacing);
        status = qv_bearing_of(&lamp[i], &length, compass, way);
    }
    return status;
}

/* Whether nothing is said of light, so that colours stay as they are. */
static int is_dark(const qv_lighting *lighting)
{
    const uint16_t *ambient = lighting->ambient;
    return lighting->count == 0 && ambient[0] == 0 && ambient[1] == 0 && ambient[2] == 0;
}

void qv_lighting_colour(fx_unorm16 colour[3], const qv_lighting *lighting,
                        const qv_bearing lamp[QV_LAMPS_MAX], qv_address bytes)
{
    uint64_t light[3]; /* with 32 fraction bits more, and rounded once: <= 5 * FULL * 2^32 */
    if (is_dark(lighting))
        return;
    for (unsigned c = 0; c < 3; c++)
        light[c] = (uint64_t)lighting->ambient[c] << 32;
    for (unsigned i = 0; i < lighting->count; i++) {
        uint32_t clear = qv_bearing_transmittance(&lamp[i], bytes, 0);
        for (unsigned c = 0; c < 3; c++)
            light[c] += fx_wide_product(clear, lighting->lamps[i].colour[c]);
    }
    for (unsigned c = 0; c < 3; c++) {
        uint32_t sum = (uint32_t)((light[c] + 0x80000000u) >> 32);
        colour[c] = fx_unorm16_mul(colour[c], (fx_unorm16)(sum < FULL ? sum : FULL));
    }
}
