/*
 * medium.h - what a step's length means for the modes that weigh by length.
 *
 * A context keeps a qv_medium for one step of the volume; a run of pieces has one of
 * its own, scaled by their length.
 *
 *   depth  Q32.32. Of corrected modes the ratio of the length to the unit distance. Of
 *          extinction modes, what 2^32 units of a sample's extinction sum are worth.
 *   light  Q(a).(32-a), where a is light_shift: what turns a sample's colour into light.
 *          Of corrected modes that ratio. Of extinction modes ln 2 times the full value's
 *          depth: the factor of equation 23 is that times phi.
 *
 * Source: Kraus and Buerger 2008, equations 16, 17, 22 and 23.
 */
#ifndef QV_MEDIUM_H
#define QV_MEDIUM_H

#include "fx_correct.h"
#include "fx_inline.h"
#include "fx_wide.h"
#include "qvol.h"

/*
 * Media of corrected opacity, of stored extinction, and of the extinction of stored
 * opacity, for pieces of so many levels; and what modes that read no pyramid prepare.
 * Nothing is written on error. QV_OK, QV_ERROR_UNIT, QV_ERROR_EXTINCTION.
 */
qv_status qv_medium_corrected(qv_medium *medium, const qv_scene *scene, unsigned levels);
qv_status qv_medium_extinction(qv_medium *medium, const qv_scene *scene, unsigned levels);
qv_status qv_medium_converted(qv_medium *medium, const qv_scene *scene, unsigned levels);
qv_status qv_prepare_corrected(qv_context *context, const qv_scene *scene);
qv_status qv_prepare_extinction(qv_context *context, const qv_scene *scene);
qv_status qv_prepare_converted(qv_context *context, const qv_scene *scene);

/* The medium of a length in steps, Q16.16, at most the 2^levels that the medium was made
   for: depth stays below 2^62 and light below 2^32, as they do for that length. */
FX_INLINE void qv_medium_scale(qv_medium *scaled, const qv_medium *step, uint32_t length)
{
    *scaled = *step;
    if (length == QV_ONE_Q16)
        return;
    scaled->depth = fx_depth_scale(step->depth, length);
    scaled->light = (uint32_t)(fx_wide_product(step->light, length) >> 16);
}

#endif /* QV_MEDIUM_H */
