#include "march_levels.h"

void qv_blend_samples(qv_sample *finer, const qv_sample *coarser, uint32_t share)
{
    unsigned scale = finer->scale < coarser->scale ? finer->scale : coarser->scale;
    unsigned down = finer->scale - scale, coarser_down = coarser->scale - scale;
    finer->scale = scale;
    finer->opacity =
        fx_share_of(qv_blend_sums(fx_share_bits(finer->opacity) >> down,
                                  fx_share_bits(coarser->opacity) >> coarser_down, share));
    for (unsigned c = 0; c < 3; c++)
        finer->light[c] =
            fx_sum_of(qv_blend_sums(fx_sum_bits(finer->light[c]) >> down,
                                    fx_sum_bits(coarser->light[c]) >> coarser_down, share));
}
