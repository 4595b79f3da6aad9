/*
 * eye.h - where the eye of a perspective view lies.
 */
#ifndef QV_EYE_H
#define QV_EYE_H

#include "fx_angle.h"
#include "fx_inline.h"
#include "fx_wide.h"
#include "qvol.h"

#define QV_LEAST_FIELD 0x00B60B61u /* 1 degree: 2^32 / 360, rounded up */
#define QV_MOST_FIELD  0x6AAAAAAAu /* 150 degrees */

/*
 * Distance from the eye to the volume's centre in world units, Q31.32: half the
 * frame's height by the tangent of half the field. height_q16 is Q16.16; the
 * cotangent is at most 115 < 2^7, so the result is below 2^55.
 */
static inline qv_coord qv_eye_distance(uint32_t height_q16, int32_t sine, int32_t cosine)
{
    uint64_t cotangent = fx_divide((uint64_t)(uint32_t)cosine << 32, (uint32_t)sine); /* Q32 */
    uint64_t low = fx_wide_product(height_q16, (uint32_t)cotangent);
    uint64_t high = fx_wide_product(height_q16, (uint32_t)(cotangent >> 32));
    return (qv_coord)((low >> 17) + (high << 15)); /* height * cotangent * 2^48 / 2^17 */
}

/* That of a view that was checked. QV_OK, QV_ERROR_VIEW (field of view, height of the frame). */
FX_INLINE qv_status qv_eye_of(qv_coord *distance, const qv_view *view, qv_angle field_of_view)
{
    uint64_t height = fx_wide_product(view->pitch, view->height);
    if (field_of_view < QV_LEAST_FIELD || field_of_view > QV_MOST_FIELD || height > 0xFFFFFFFFu)
        return QV_ERROR_VIEW;
    int32_t sine, cosine;
    fx_sine_cosine(&sine, &cosine, field_of_view / 2u);
    *distance = qv_eye_distance((uint32_t)height, sine, cosine);
    return QV_OK;
}

#endif /* QV_EYE_H */
