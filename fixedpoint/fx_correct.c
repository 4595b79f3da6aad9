#include "fx_correct.h"

#include "fx_log.h"
#include "fx_phi.h"
#include "fx_wide.h"

#define ONE_Q27 0x08000000u

fx_depth fx_depth_scale(fx_depth depth, uint32_t ratio)
{
    uint64_t whole = fx_wide_product((uint32_t)(depth >> 32),
                                     ratio); /* below 2^48, as the product is below 2^32 */
    uint64_t fraction = fx_wide_product((uint32_t)depth, ratio);
    return (whole << 16) + (fraction >> 16);
}

fx_depth fx_depth_times(fx_depth depth, uint64_t ratio)
{
    uint32_t whole = (uint32_t)(depth >> 32), fraction = (uint32_t)depth;
    uint64_t low = fx_wide_product(fraction, (uint32_t)ratio) >> 32;
    uint64_t middle = fx_wide_product(fraction, (uint32_t)(ratio >> 32));
    if (whole != 0) /* products below 2^64, since the whole one is */
        middle += (fx_wide_product(whole, (uint32_t)(ratio >> 32)) << 32) +
                  fx_wide_product(whole, (uint32_t)ratio);
    return middle + low;
}

/* In it nothing is small: phi(depth) > 1/16. */
uint32_t fx_phi_share(fx_depth depth, fx_depth scaled)
{
    uint32_t reciprocal = fx_reciprocal(fx_phi(depth));      /* Q5.27, below 16 */
    return fx_high_product(reciprocal << 1, fx_phi(scaled)); /* phi is Q1.31 */
}

fx_unorm16 fx_correct_opacity(fx_unorm16 opacity, uint32_t ratio)
{
    if (opacity == 65535u)
        return opacity;
    return fx_unorm16_of_q31(fx_opacity(fx_depth_scale(fx_depth_of_unorm16(opacity), ratio)));
}

/* opacity = x ln 2 phi(x) for the depth x, so the factor is ratio * phi(ratio * x) /
   phi(x), in which nothing is small: phi(x) > 1/12 for x < 16. */
uint32_t fx_correct_colour(fx_unorm16 opacity, uint32_t ratio)
{
    if (opacity == 65535u)
        return ONE_Q27;
    fx_depth depth = fx_depth_of_unorm16(opacity);
    /* phi(r x) / phi(x) <= 12 and times r <= 16: Q5.27 * Q16.16 */
    uint32_t share = fx_phi_share(depth, fx_depth_scale(depth, ratio));
    return (uint32_t)(fx_wide_product(share, ratio) >> 16);
}

uint32_t fx_correct_slices(uint32_t opacity, uint32_t slices, uint32_t wanted)
{
    if (opacity == 0xFFFFFFFFu || slices == wanted)
        return opacity;
    uint64_t ratio = fx_divide((uint64_t)slices << 32, wanted);
    uint32_t thinner = fx_opacity(fx_depth_times(fx_depth_of_opacity(opacity), ratio));
    return 2u * thinner - (thinner >> 31); /* Q1.31 to Q0.32: 1 is 2^32 - 1 */
}
