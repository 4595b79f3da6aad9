/*
 * report_slices.c - how slices were blended, as JSON.
 */
#include "report_slices.h"
#include "settings_slices.h"

/* Bytes of the whole frame, as a device would keep it. */
static void report_framebuffer(struct json *json, const struct slicing *slicing,
                               const struct frame *frame, const struct settings *settings)
{
    uint64_t pixels = (uint64_t)frame->width * frame->height;
    const qv_blend *blend = slicing->blend;
    json_object(json, "framebuffer");
    json_text(json, "bits", choice_name(framebuffer_names, settings_framebuffer(settings)));
    json_unsigned(json, "pixel_bytes", blend->bytes);
    json_unsigned(json, "bytes", pixels * blend->bytes);
    json_unsigned(json, "bytes_beside", pixels * blend->beside);
    json_close(json);
}

static void report_dither(struct json *json, const struct slicing *slicing)
{
    const qv_dither *dither = &slicing->dither;
    bool by_period = slicing->kind == DITHER_RANDOM || slicing->kind == DITHER_ORDERED ||
                     dither->technique == &qv_technique_bumped;
    json_object(json, "dither");
    json_text(json, "kind", choice_name(dither_names, slicing->kind));
    if (slicing->sequence != SEQUENCE_ROUNDED) {
        json_text(json, "sequence", choice_name(sequence_names, slicing->sequence));
    }
    if (by_period) {
        const int64_t slopes[2] = {dither->slope[0], dither->slope[1]};
        json_unsigned(json, "period", dither->period);
        json_integers(json, "slope_q16", slopes, 2);
        json_unsigned(json, "cutoff", dither->cutoff);
    }
    json_unsigned(json, "frame", dither->frame);
    json_boolean(json, "still", dither->still != 0);
    json_close(json);
}

/* Errors in 1/100 of an 8-bit level. */
static void report_advice(struct json *json, const struct advice *advice)
{
    const qv_recommendation *recommendation = &advice->recommendation;
    if (!advice->given) {
        json_null(json, "recommended");
        return;
    }
    json_object(json, "recommended");
    json_unsigned(json, "slices", advice->slices);
    json_unsigned(json, "least_opacity_q32", advice->opacity);
    json_text(json, "dither", choice_name(dither_names, advice_dither(advice)));
    json_unsigned(json, "worst_of_fog_x100", recommendation->worst_fog);
    json_unsigned(json, "worst_x100", recommendation->worst);
    json_close(json);
}

void report_slices(struct json *json, const struct slicing *slicing, const struct frame *frame,
                   const struct settings *settings)
{
    const uint32_t *bricks = slicing->bricks;
    json_object(json, "slices");
    json_integer(json, "first", frame->slices.first);
    json_integer(json, "end", frame->slices.end);
    json_unsigned(json, "chunk", slicing->chunk);
    if (slicing->in_bricks) {
        json_triple(json, "bricks", bricks[0], bricks[1], bricks[2]);
    } else {
        json_null(json, "bricks");
    }
    report_framebuffer(json, slicing, frame, settings);
    report_dither(json, slicing);
    report_advice(json, &slicing->advice);
    json_close(json);
}
