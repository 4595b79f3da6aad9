#include "qvol.h"

#include "fx_wide.h"

/* Whether percentages sum to at most 1; 65535 numbers of 16 bits fit 32 bits. */
static int is_whole(const uint16_t *percentages, uint16_t count)
{
    uint32_t sum = 0;
    for (uint16_t i = 0; i < count; i++)
        sum += percentages[i];
    return sum <= 65535u;
}

/*
 * With percentages that sum to 65535 at most, the extinction stays below 2^48 and light
 * at 65535 times that, so that fx_quotient16 can round their ratio.
 */
qv_status qv_mix(qv_mixture *mixture, const qv_material *materials, const uint16_t *percentages,
                 uint16_t count)
{
    if (!mixture || !materials || !percentages)
        return QV_ERROR_NULL;
    if (!is_whole(percentages, count))
        return QV_ERROR_MIXTURE;

    qv_mixture sum = {0, {0, 0, 0}};
    for (uint16_t i = 0; i < count; i++) {
        const qv_material *material = &materials[i];
        uint32_t part = percentages[i];
        sum.extinction += fx_wide_product(part, material->extinction);
        for (unsigned c = 0; c < 3; c++) /* part * colour <= 65535^2 */
            sum.light[c] += fx_wide_product(part * material->colour[c], material->extinction);
    }
    *mixture = sum;
    return QV_OK;
}

void qv_mixture_to_voxel(uint16_t rgbt[4], const qv_mixture *mixture, uint32_t extinction)
{
    for (unsigned c = 0; c < 3; c++)
        rgbt[c] =
            mixture->extinction != 0 ? fx_quotient16(mixture->light[c], mixture->extinction) : 0;
    rgbt[3] = fx_quotient16(mixture->extinction, extinction);
}
