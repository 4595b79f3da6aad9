#include "gradient.h"

#include "fx_wide.h"
#include "layout.h"
#include "access.h"
#include "unit_vector.h"

/* sum += n * factor. The caller knows that the sum stays below 2^224. */
static void add_product(uint32_t sum[QV_SQUARE_WORDS], const uint32_t n[QV_SQUARE_WORDS],
                        uint32_t factor)
{
    uint32_t carry = 0;
    for (unsigned i = 0; i < QV_SQUARE_WORDS; i++) {
        /* <= (2^32 - 1)^2 + 2 * (2^32 - 1) = 2^64 - 1 */
        uint64_t digit = fx_wide_product(n[i], factor) + sum[i] + carry;
        sum[i] = (uint32_t)digit;
        carry = (uint32_t)(digit >> 32);
    }
}

/* n *= factor^2 */
static void multiply_twice(uint32_t n[QV_SQUARE_WORDS], uint32_t factor)
{
    for (unsigned i = 0; i < 2; i++) {
        uint32_t product[QV_SQUARE_WORDS] = {0};
        add_product(product, n, factor);
        memcpy(n, product, sizeof product);
    }
}

static int at_least(const uint32_t a[QV_SQUARE_WORDS], const uint32_t b[QV_SQUARE_WORDS])
{
    unsigned i = QV_SQUARE_WORDS - 1;
    while (i > 0 && a[i] == b[i])
        i--;
    return a[i] >= b[i];
}

void qv_gradient_init(qv_gradient *gradient, const uint32_t spacing[3], uint16_t least,
                      uint32_t window)
{
    memset(gradient, 0, sizeof *gradient);
    gradient->least[0] = 1; /* grows to (2^16 * 2^18 * 2^72)^2 = 2^212 at most */
    multiply_twice(gradient->least, least);
    multiply_twice(gradient->least, window);
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t next = qv_spacing(spacing, (axis + 1) % 3); /* <= 2^24 */
        uint32_t after = qv_spacing(spacing, (axis + 2) % 3);

        gradient->scale[axis] = fx_wide_product(next, after);
        gradient->square[axis][0] = 1; /* grows to 2^(96 + 46) at most */
        multiply_twice(gradient->square[axis], next);
        multiply_twice(gradient->square[axis], after);
        multiply_twice(gradient->square[axis], (uint32_t)1 << 23);
        multiply_twice(gradient->least, qv_spacing(spacing, axis));
    }
}

int qv_gradient_normal(int32_t normal[3], const qv_gradient *gradient, const int32_t difference[3])
{
    uint32_t sum[QV_SQUARE_WORDS] = {0}; /* <= 3 * 2^(32 + 142) < 2^176 */
    uint32_t any = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t size = (uint32_t)(difference[axis] < 0 ? -difference[axis] : difference[axis]);
        add_product(sum, gradient->square[axis], size * size); /* <= 65535^2 < 2^32 */
        any |= size;
    }
    if (any == 0 || !at_least(sum, gradient->least))
        return 0;

    const int32_t against[3] = {-difference[0], -difference[1], -difference[2]};
    qv_unit_vector(normal, against, gradient->scale);
    return 1;
}
