#include "blend.h"

#define MOST_SLOPE ((uint32_t)16 << 16)

/* Numbers from frame to frame, a power of 2: so frames share no values of a hash, and their mean
   comes nearer to exact blending than by a shift alone. */
#define FRAME_BITS 10

/* ---- Dither values -------------------------------------------------------- */

uint32_t qv_sequence_rounded(uint32_t slice)
{
    (void)slice;
    return FX_NO_DITHER;
}

uint32_t qv_sequence_golden(uint32_t slice)
{
    return fx_dither_golden(slice);
}

uint32_t qv_sequence_hash(uint32_t slice)
{
    return fx_dither_hash(slice);
}

uint32_t qv_sequence_blocks(uint32_t slice)
{
    return fx_dither_blocks(slice);
}

/* ---- Techniques ----------------------------------------------------------- */

static uint32_t rounded(const qv_moment *moment, uint32_t level, uint32_t value, uint32_t colour)
{
    (void)moment;
    (void)value;
    (void)colour;
    return fx_alpha_rounded(level);
}

QV_DESCRIPTOR qv_technique qv_technique_rounded = {rounded, 0, 0};

static uint32_t random(const qv_moment *moment, uint32_t level, uint32_t value, uint32_t colour)
{
    (void)value;
    (void)colour;
    return fx_alpha_random(&moment->alpha, level, moment->u);
}

QV_DESCRIPTOR qv_technique qv_technique_random = {random, 0, 1};

static uint32_t ordered(const qv_moment *moment, uint32_t level, uint32_t value, uint32_t colour)
{
    (void)value;
    (void)colour;
    return fx_alpha_ordered(&moment->alpha, level, moment->phase);
}

QV_DESCRIPTOR qv_technique qv_technique_ordered = {ordered, 0, 1};

/* Bumps are made for colour 255: what counts is how far the value is from the colour. */
static uint32_t value_for_255(uint32_t value, uint32_t colour)
{
    return 255u - (colour > value ? colour - value : value - colour);
}

static uint32_t bumped(const qv_moment *moment, uint32_t level, uint32_t value, uint32_t colour)
{
    return fx_alpha_bumped(&moment->alpha, level, moment->phase, value_for_255(value, colour));
}

QV_DESCRIPTOR qv_technique qv_technique_bumped = {bumped, 1, 1};

static uint32_t bumped_random(const qv_moment *moment, uint32_t level, uint32_t value,
                              uint32_t colour)
{
    return fx_alpha_bumped_random(&moment->alpha, level, moment->u, value_for_255(value, colour));
}

QV_DESCRIPTOR qv_technique qv_technique_bumped_random = {bumped_random, 1, 1};

static uint32_t corrected(const qv_moment *moment, uint32_t level, uint32_t value, uint32_t colour)
{
    return fx_alpha_corrected(level, colour, value, moment->u);
}

QV_DESCRIPTOR qv_technique qv_technique_corrected = {corrected, 1, 0};

void qv_moment_opacity(qv_moment *moment, const qv_blend *blend, const uint8_t *pixel,
                       const qv_fragment *fragment)
{
    /* 2^32 - 1 is 255 * 65536 */
    uint32_t level = fx_high_product(fragment->opacity, (uint32_t)255 << 16);
    uint32_t value = 0, colour = 255;
    if (QV_FIELD(moment->technique, by_value))
        QV_FIELD(blend, look)(&value, &colour, pixel, fragment);
    moment->opacity = QV_FIELD(moment->technique, opacity)(moment, level, value, colour);
}

/* ---- Moments -------------------------------------------------------------- */

static int in_range(const qv_dither *dither)
{
    if (dither->period < 2 || dither->period > 64)
        return 0;
    return dither->slope[0] <= MOST_SLOPE && dither->slope[1] <= MOST_SLOPE;
}

static uint32_t slope_of(uint32_t slope)
{
    return slope == 0 ? QV_ONE_Q16 : slope;
}

qv_status qv_alpha_of(fx_alpha *alpha, const qv_dither *dither)
{
    if (!in_range(dither))
        return QV_ERROR_DITHER;
    alpha->period = fx_period_of(dither->period);
    alpha->slope[0] = slope_of(dither->slope[0]);
    alpha->slope[1] = slope_of(dither->slope[1]);
    alpha->cutoff = dither->cutoff == 0 ? 255u : dither->cutoff;
    return QV_OK;
}

/* What patterns go by. Without a period all phases are 0. */
static void set_pattern(qv_moment *moment, const qv_dither *dither, uint32_t number)
{
    const fx_alpha none = {{0, 0}, {0, 0}, 0};
    moment->alpha = none;
    moment->phase = 0;
    if (moment->technique && QV_FIELD(moment->technique, by_period)) {
        (void)qv_alpha_of(&moment->alpha, dither);
        moment->phase = fx_phase(&moment->alpha.period, number + dither->frame);
    }
}

qv_status qv_moment_of(qv_moment *moment, const qv_dither *dither, const qv_blend *blend,
                       int32_t slice)
{
    if (!dither)
        return QV_ERROR_NULL;
    const qv_technique *technique = QV_FIELD(blend, look) ? dither->technique : 0;
    if (!dither->sequence || (QV_FIELD(blend, look) && !technique))
        return QV_ERROR_DITHER;
    if (technique && QV_FIELD(technique, by_period) && !in_range(dither))
        return QV_ERROR_DITHER;
    if (slice < -QV_GRID_LIMIT || slice >= QV_GRID_LIMIT)
        return QV_ERROR_SLICE;
    uint32_t number = qv_slice_number(slice, QV_FIELD(blend, kind) == QV_UNDER);
    int rounds = dither->sequence == qv_sequence_rounded;
    moment->technique = technique;
    moment->spread = !dither->still && (technique || !rounds);
    moment->u = dither->sequence(number + (dither->frame << FRAME_BITS));
    if (!rounds)
        moment->u = fx_dither_at(moment->u, 0, 0, dither->frame);
    set_pattern(moment, dither, number);
    moment->slice_u = moment->u;
    moment->slice_phase = moment->phase;
    return QV_OK;
}
