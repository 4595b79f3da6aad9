#include "qvol.h"

const char *qv_version(void)
{
    return QV_VERSION;
}

const char *qv_status_text(qv_status status)
{
    switch (status) {
    case QV_OK:
        return "no error";
    case QV_MORE:
        return "work remains to be done";
    case QV_ERROR_NULL:
        return "a required pointer is null";
    case QV_ERROR_STORAGE:
        return "storage unknown, or not the one the sampling mode reads";
    case QV_ERROR_SIZE:
        return "size of an axis out of range";
    case QV_ERROR_STRIDE:
        return "strides overlap, are misaligned or leave the memory given";
    case QV_ERROR_PALETTE:
        return "palette missing or not of 256 entries";
    case QV_ERROR_SPACING:
        return "voxel spacing out of range";
    case QV_ERROR_STEP:
        return "step out of range";
    case QV_ERROR_UNIT:
        return "unit distance out of range, or not the step where it must be";
    case QV_ERROR_CAMERA:
        return "camera matrix degenerate or out of range";
    case QV_ERROR_VIEW:
        return "frame size, pitch or field of view out of range";
    case QV_ERROR_RECT:
        return "rectangle empty or out of range";
    case QV_ERROR_BUFFER:
        return "output buffer too small, or its rows overlap";
    case QV_ERROR_TRANSFER:
        return "control points missing or out of order";
    case QV_ERROR_WINDOW:
        return "window of values empty or out of range";
    case QV_ERROR_LIGHT:
        return "light direction zero or coefficient out of range";
    case QV_ERROR_EXTINCTION:
        return "extinction 0, or too much for one step";
    case QV_ERROR_MIXTURE:
        return "percentages of materials, or taps of a filter, do not sum to 1";
    case QV_ERROR_LEVEL:
        return "pyramid missing, or its levels more than the volume has";
    case QV_ERROR_DITHER:
        return "dither without a sequence or technique, or its period or slope out of range";
    case QV_ERROR_SLICE:
        return "slice out of range, or no slices";
    case QV_ERROR_DIRECTION:
        return "no direction, an unknown one, or one missing from the set";
    case QV_ERROR_ATTENUATION:
        return "attenuation records too short, or their memory too small";
    case QV_ERROR_INSIDE:
        return "eye in the volume where no light gets out of it";
    case QV_ERROR_SUMS:
        return "a sum of splats is full";
    case QV_ERROR_OVERLAP:
        return "memory that is written is also read";
    case QV_ERROR_READ:
        return "voxels could not be read";
    case QV_ERROR_PAGES:
        return "pages too few, too small or not made ready for the volume";
    }
    return "unknown status";
}
