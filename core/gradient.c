#include "gradient.h"

#include "fx_inline.h"
#include "fx_wide.h"
#include "layout.h"
#include "access.h"
#include "unit_vector.h"

/* Words of a number below 2^224. */
#define WIDE_WORDS 7u

/* Bits that a least square is longer by, before it is compared: 2 * 23, since a gradient of d over
   two voxels is d * 2^15 / S, and is measured in 1/256. */
#define EXCESS 46u

/* sum += n * factor. The caller knows that the sum does not overflow. */
static void add_product(uint32_t *sum, unsigned sum_words, const uint32_t *n, unsigned words,
                        uint32_t factor)
{
    uint32_t carry = 0;
    for (unsigned i = 0; i < sum_words; i++) {
        /* <= (2^32 - 1)^2 + 2 * (2^32 - 1) = 2^64 - 1 */
        uint64_t digit = fx_wide_product(i < words ? n[i] : 0, factor) + sum[i] + carry;
        sum[i] = (uint32_t)digit;
        carry = (uint32_t)(digit >> 32);
    }
}

/* n *= factor^2 */
static void multiply_twice(uint32_t *n, unsigned words, uint32_t factor)
{
    for (unsigned i = 0; i < 2; i++) {
        uint32_t product[WIDE_WORDS] = {0};
        add_product(product, words, n, words, factor);
        memcpy(n, product, words * sizeof n[0]);
    }
}

static int at_least(const uint32_t a[QV_LEAST_WORDS], const uint32_t b[QV_LEAST_WORDS])
{
    unsigned i = QV_LEAST_WORDS - 1;
    while (i > 0 && a[i] == b[i])
        i--;
    return a[i] >= b[i];
}

/* The least square / 2^46, rounded up; what is too long becomes the most that there is room for. */
static void set_least(uint32_t least[QV_LEAST_WORDS], const uint32_t square[WIDE_WORDS])
{
    const unsigned bits = EXCESS - 32u;
    int too_long = square[QV_LEAST_WORDS + 1] >> bits != 0;
    uint32_t carry = square[0] != 0 || square[1] << (32u - bits) != 0;
    for (unsigned i = 0; i < QV_LEAST_WORDS; i++) {
        uint32_t word = square[i + 1] >> bits | square[i + 2] << (32u - bits);
        least[i] = too_long ? 0xFFFFFFFFu : word + carry;
        carry = carry && word == 0xFFFFFFFFu;
    }
}

static FX_NOINLINE void find_least(qv_gradient *gradient, const uint32_t spacing[3], uint16_t least,
                                   uint32_t window)
{
    uint32_t square[WIDE_WORDS] = {1}; /* grows to (2^16 * 2^18 * 2^72)^2 = 2^212 at most */
    multiply_twice(square, WIDE_WORDS, least);
    multiply_twice(square, WIDE_WORDS, window);
    for (unsigned axis = 0; axis < 3; axis++)
        multiply_twice(square, WIDE_WORDS, qv_spacing(spacing, axis));
    set_least(gradient->least, square);
}

void qv_gradient_init(qv_gradient *gradient, const uint32_t spacing[3], uint16_t least,
                      uint32_t window)
{
    memset(gradient, 0, sizeof *gradient);
    find_least(gradient, spacing, least, window);
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t next = qv_spacing(spacing, (axis + 1) % 3); /* <= 2^24 */
        uint32_t after = qv_spacing(spacing, (axis + 2) % 3);
        gradient->scale[axis] = fx_wide_product(next, after);
        gradient->square[axis][0] = 1; /* grows to 2^96 at most */
        multiply_twice(gradient->square[axis], QV_SQUARE_WORDS, next);
        multiply_twice(gradient->square[axis], QV_SQUARE_WORDS, after);
    }
}

/* Whether a gradient is there and long enough. */
static FX_NOINLINE int is_long(const qv_gradient *gradient, const int32_t difference[3])
{
    uint32_t sum[QV_LEAST_WORDS] = {0}; /* <= 3 * 2^(32 + 96) < 2^130 */
    uint32_t any = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t size = (uint32_t)(difference[axis] < 0 ? -difference[axis] : difference[axis]);
        add_product(sum, QV_LEAST_WORDS, gradient->square[axis], QV_SQUARE_WORDS,
                    size * size); /* <= 65535^2 < 2^32 */
        any |= size;
    }
    return any != 0 && at_least(sum, gradient->least);
}

int qv_gradient_normal(int32_t normal[3], const qv_gradient *gradient, const int32_t difference[3])
{
    if (!is_long(gradient, difference))
        return 0;
    const int32_t against[3] = {-difference[0], -difference[1], -difference[2]};
    qv_unit_vector(normal, against, gradient->scale);
    return 1;
}
