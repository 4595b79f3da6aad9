#include "fx_wide.h"

int64_t fx_scale_q30(int64_t v, int32_t factor)
{
    uint64_t size = v < 0 ? 0u - (uint64_t)v : (uint64_t)v;
    uint32_t scale = factor < 0 ? 0u - (uint32_t)factor : (uint32_t)factor;
    /* |v| * factor = high * 2^32 + low with high < 2^60, low < 2^62; dividing
       high by 2^30 leaves no remainder. */
    uint64_t high = fx_wide_product((uint32_t)(size >> 32), scale);
    uint64_t low = fx_wide_product((uint32_t)size, scale);
    uint64_t result = (high << 2) + ((low + 0x20000000u) >> 30); /* <= |v| + 1/2 < 2^63 */
    return (v < 0) != (factor < 0) ? -(int64_t)result : (int64_t)result;
}

uint64_t fx_divide(uint64_t n, uint32_t d)
{
    uint32_t rest = 0;
    for (unsigned i = 0; i < 64; i++) {
        rest = rest << 1 | (uint32_t)(n >> 63); /* rest < d before, so < 2^32 after */
        n <<= 1;
        if (rest >= d) {
            rest -= d;
            n |= 1u;
        }
    }
    return n;
}
