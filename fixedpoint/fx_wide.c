#include "fx_wide.h"

/*
 * Both products take a and b apart into 16-bit digits: each partial product is
 * at most 65535^2 < 2^32. `middle` is what lands on bits 16 to 31, with the
 * carry out of the lowest product; it stays below 3 * 2^16.
 */
uint64_t fx_wide_product_narrow(uint32_t a, uint32_t b)
{
    uint16_t al = (uint16_t)a, ah = (uint16_t)(a >> 16);
    uint16_t bl = (uint16_t)b, bh = (uint16_t)(b >> 16);
    uint32_t low = fx_product16(al, bl);
    uint32_t cross1 = fx_product16(al, bh), cross2 = fx_product16(ah, bl);
    uint32_t middle = (low >> 16) + (cross1 & 0xFFFFu) + (cross2 & 0xFFFFu);
    uint32_t high = fx_product16(ah, bh) + (cross1 >> 16) + (cross2 >> 16) + (middle >> 16);
    return (uint64_t)high << 32 | (middle << 16 | (low & 0xFFFFu));
}

uint32_t fx_high_product_narrow(uint32_t a, uint32_t b)
{
    uint64_t product = fx_wide_product_narrow(a, b); /* rounding cannot carry past 2^32 - 2 */
    return (uint32_t)(product >> 32) + ((uint32_t)product >> 31);
}

int64_t fx_multiply(int64_t v, int32_t n)
{
    uint32_t low = (uint32_t)v, high = (uint32_t)((uint64_t)v >> 32), size = (uint32_t)n;
    uint64_t product = fx_wide_product(low, size);
    high *= size;
    if (n < 0)
        high -= low; /* size is n + 2^32 */
    product += (uint64_t)high << 32;
    return (product >> 63) != 0 ? -(int64_t)(~product) - 1 : (int64_t)product;
}

int64_t fx_scale_q30(int64_t v, int32_t factor)
{
    /* v = high * 2^32 + low: high * factor < 2^60, low * factor < 2^63, and dividing
       high * 2^32 by 2^30 leaves no remainder. */
    int64_t high = fx_multiply(fx_shift_floor(v, 32), factor);
    int64_t low = fx_multiply((int64_t)(uint32_t)v, factor);
    return high * 4 + fx_shift_floor(low + 0x20000000, 30);
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

uint16_t fx_quotient16(uint64_t n, uint64_t d)
{
    uint64_t rest = n + (d >> 1);
    if (rest >> 16 >= d)
        return 65535u;
    unsigned bits = 0;
    while (d <= rest >> 1) {
        d <<= 1; /* <= rest */
        bits++;
    }
    uint32_t quotient = 0;
    for (unsigned i = 0; i <= bits; i++) {
        quotient <<= 1;
        if (rest >= d) {
            rest -= d;
            quotient |= 1u;
        }
        d >>= 1;
    }
    return (uint16_t)quotient;
}
