/*
 * presets.c - transfer functions that come with the command, as text that a
 * user may copy into a file. transfer_text.h tells the format.
 */
#include "transfer_text.h"

#include <stddef.h>

const struct preset presets[] = {
    {"grey", "the value is grey and opacity",
     "0      0   0   0   0\n"
     "255  255 255 255   0.25\n"},
    {"fog", "thin: 512 samples stay transparent",
     "0    255 255 255   0\n"
     "8    255 255 255   0\n"
     "255  255 255 255   0.02\n"},
    {"surface", "opaque above a quarter of the window",
     "0    235 225 210   0\n"
     "50   235 225 210   0\n"
     "70   235 225 210   0.8\n"
     "255  255 250 240   0.8\n"
     "shading 0.25 0.75 0.25 16 0.01\n"},
    {"head", "MRI of a head: skin like glass over the brain",
     "# air\n"
     "0    235 180 150   0\n"
     "14   235 180 150   0\n"
     "# skin and the rim of the skull\n"
     "28   240 190 160   0.035\n"
     "50   235 175 145   0.012\n"
     "60   200 120 110   0\n"
     "# grey matter, white matter\n"
     "72   225 140 120   0.02\n"
     "88   235 165 145   0.30\n"
     "104  250 225 205   0.55\n"
     "125  255 240 225   0.55\n"
     "# fat of the scalp\n"
     "140  240 200 160   0.01\n"
     "255  250 225 190   0.01\n"
     "shading 0.25 0.85 0.35 16 0.02\n"},
    {"bone", "CT: soft tissue faint, bone opaque",
     "0    190 110  90   0\n"
     "60   190 110  90   0\n"
     "80   200 120 100   0.004\n"
     "110  215 150 120   0.006\n"
     "130  240 225 200   0.20\n"
     "180  250 245 230   0.60\n"
     "255  255 255 250   0.90\n"
     "shading 0.2 0.8 0.4 32 0.02\n"},
    {"rainbow", "blue to red, for fields of numbers",
     "0      0   0 140   0\n"
     "64     0 140 255   0.02\n"
     "128   60 220  80   0.05\n"
     "192  255 220   0   0.10\n"
     "255  230  20   0   0.30\n"},
    {NULL, NULL, NULL},
};
