#include "qvol.h"

#include "fx_wide.h"
#include "access.h"
#include "scalars.h"

#define FACTOR_MAX 64u

/* A box of values: at most 64 an axis. */
typedef struct box {
    uint16_t first[3];
    uint16_t end[3];
} box;

/* Values of the reduced volume along an axis. */
static uint16_t reduced_size(const qv_scalars *scalars, const uint8_t factor[3], unsigned axis)
{
    return (uint16_t)((scalars->size[axis] + (uint32_t)factor[axis] - 1u) / factor[axis]);
}

/* The values that one result is the mean of: never none, since position lies in
   the reduced volume. */
static box source_box(const qv_scalars *scalars, const uint8_t factor[3],
                      const uint16_t position[3])
{
    box b;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t first = (uint32_t)position[axis] * factor[axis]; /* < size */
        uint32_t end = first + factor[axis];
        b.first[axis] = (uint16_t)first;
        b.end[axis] = (uint16_t)(end < scalars->size[axis] ? end : scalars->size[axis]);
    }
    return b;
}

/* Sum over one slice of a box, above the least value of the type: at most
   64 * 64 * 65535 < 2^28. */
static uint32_t slice_sum(const qv_scalars *scalars, const box *b, uint16_t z)
{
    int32_t least = qv_scalar_least(scalars->type);
    uint32_t sum = 0;
    uint16_t at[3];
    at[2] = z;
    for (at[1] = b->first[1]; at[1] < b->end[1]; at[1]++)
        for (at[0] = b->first[0]; at[0] < b->end[0]; at[0]++)
            sum += (uint32_t)(qv_scalar(qv_scalars_at(scalars, at), scalars->type) - least);
    return sum;
}

/*
 * The mean of a box above the least value of the type, to nearest, ties upwards:
 * 0 .. 65535. The sum of a box may pass 2^32, so every slice is divided by the
 * count as it comes, and the remainders are kept: 64 of them stay below 2^24.
 */
static uint32_t mean(const qv_scalars *scalars, const box *b)
{
    uint32_t count = 1; /* <= 2^18 */
    for (unsigned axis = 0; axis < 3; axis++)
        count *= (uint32_t)b->end[axis] - b->first[axis];

    uint32_t quotient = 0, remainder = 0;
    for (uint16_t z = b->first[2]; z < b->end[2]; z++) {
        uint32_t sum = slice_sum(scalars, b, z);
        quotient += sum / count;
        remainder += sum % count;
    }
    return quotient + (2u * remainder + count) / (2u * count);
}

/* Stores a mean as its type; the output needs no alignment. */
static void store(uint8_t *at, uint8_t type, uint32_t above_least)
{
    if (type == QV_SCALAR_U8) {
        *at = (uint8_t)above_least;
    } else {
        /* A negative value wraps to its two's complement. */
        uint16_t bits = (uint16_t)(above_least + (uint32_t)qv_scalar_least(type));
        memcpy(at, &bits, sizeof bits);
    }
}

static qv_status check_reduction(const qv_scalars *scalars, const uint8_t factor[3],
                                 uint16_t first_z, uint16_t end_z)
{
    qv_status status = qv_scalars_check(scalars);
    if (status != QV_OK)
        return status;
    for (unsigned axis = 0; axis < 3; axis++)
        if (factor[axis] == 0 || factor[axis] > FACTOR_MAX)
            return QV_ERROR_SIZE;
    return first_z < end_z && end_z <= reduced_size(scalars, factor, 2) ? QV_OK : QV_ERROR_SIZE;
}

qv_status qv_reduce(void *values, size_t bytes, const qv_scalars *scalars, const uint8_t factor[3],
                    uint16_t first_z, uint16_t end_z)
{
    if (!values || !scalars || !factor)
        return QV_ERROR_NULL;
    qv_status status = check_reduction(scalars, factor, first_z, end_z);
    if (status != QV_OK)
        return status;

    uint32_t value_bytes = qv_scalar_bytes(scalars->type);
    uint32_t width = reduced_size(scalars, factor, 0), height = reduced_size(scalars, factor, 1);
    /* <= 4096^3 * 2 = 2^37 */
    if (bytes < fx_wide_product(width * height, (uint32_t)(end_z - first_z) * value_bytes))
        return QV_ERROR_BUFFER;

    uint8_t *out = (uint8_t *)values;
    uint16_t at[3];
    for (at[2] = first_z; at[2] < end_z; at[2]++)
        for (at[1] = 0; at[1] < height; at[1]++)
            for (at[0] = 0; at[0] < width; at[0]++) {
                const box b = source_box(scalars, factor, at);
                store(out, scalars->type, mean(scalars, &b));
                out += value_bytes;
            }
    return QV_OK;
}
