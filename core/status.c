#include "qvol.h"

#include "fx_table.h"

FX_TABLE char version[] = QV_VERSION;

const char *qv_version(void)
{
    return version;
}

/* By falling status, from QV_MORE to the last error, and one for all others. */
FX_TABLE char texts[] =
    "work remains to be done\0"
    "no error\0"
    "a required pointer is null\0"
    "storage unknown, or not the one the sampling mode reads\0"
    "size of an axis out of range\0"
    "strides overlap, are misaligned or leave the memory given\0"
    "palette missing or not of 256 entries\0"
    "voxel spacing out of range\0"
    "step out of range\0"
    "unit distance out of range, or not the step where it must be\0"
    "camera matrix degenerate or out of range\0"
    "frame size, pitch or field of view out of range\0"
    "rectangle empty or out of range\0"
    "output buffer too small, or its rows overlap\0"
    "control points missing or out of order\0"
    "window of values empty or out of range\0"
    "light direction zero or coefficient out of range\0"
    "extinction 0, or too much for one step\0"
    "percentages of materials, or taps of a filter, do not sum to 1\0"
    "pyramid missing, or its levels more than the volume has\0"
    "dither without a sequence or technique, or its period or slope out of range\0"
    "slice out of range, or no slices\0"
    "no direction, an unknown one, or one missing from the set\0"
    "attenuation records too short, or their memory too small\0"
    "eye in the volume where no light gets out of it\0"
    "a sum of splats is full\0"
    "memory that is written is also read\0"
    "voxels could not be read\0"
    "pages too few, too small or not made ready for the volume\0"
    "unknown status";

#define LAST_ERROR QV_ERROR_PAGES

/* The start of the text that follows this one. */
static const char *next_text(const char *text)
{
    while (fx_table8((const uint8_t *)text) != 0)
        text++;
    return text + 1;
}

const char *qv_status_text(qv_status status)
{
    const char *text = texts;
    int known = status <= QV_MORE && status >= LAST_ERROR;
    int before = known ? QV_MORE - status : QV_MORE - LAST_ERROR + 1;
    for (; before != 0; before--)
        text = next_text(text);
    return text;
}
