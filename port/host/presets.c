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
     "0    255 190 150   0\n"
     "# skin, and the rim of the skull\n"
     "8    255 190 150   0\n"
     "22   255 196 156   0.024\n"
     "42   250 165 120   0.008\n"
     "# fluid, grey matter, white matter\n"
     "60   200  60  50   0.0003\n"
     "78   200  70  60   0.008\n"
     "92   240 150 125   0.036\n"
     "104  255 236 220   0.085\n"
     "114  255 250 240   0.105\n"
     "121  255 250 240   0.075\n"
     "# fat of the scalp\n"
     "128  255 225 190   0.004\n"
     "140  250 205 165   0.0004\n"
     "255  250 205 170   0.0002\n"
     "shading 0.38 0.95 0.3 16 0.004\n"},
    {"skin", "MRI: what surrounds the organ of --mask, like glass",
     "0    255 180 135   0\n"
     "8    255 180 135   0\n"
     "20   255 190 145   0.055\n"
     "40   255 170 125   0.016\n"
     "60   250 165 120   0.007\n"
     "255  255 205 165   0.004\n"
     "shading 0.45 1.0 0.45 16 0.01\n"},
    {"brain", "MRI: for --mask-tf, a brain that was cut out",
     "0    190  80  75   0\n"
     "50   190  80  75   0\n"
     "66   210 100  92   0.06\n"
     "84   240 155 145   0.32\n"
     "108  255 222 212   0.50\n"
     "255  255 240 232   0.50\n"
     "shading 0.28 0.95 0.35 16 0.01\n"},
    {"artefact", "labels empty space red: shows colour and opacity interpolated apart",
     "0    255  30  20   0\n"
     "29   255  30  20   0\n"
     "30   255 246 232   0.9\n"
     "255  255 246 232   0.9\n"
     "shading 0.3 0.8 0.2 16 0.02\n"},
    {"oled", "a head in few levels of grey, thin enough for coarse voxels",
     "0    255 255 255   0\n"
     "12   255 255 255   0\n"
     "30   200 200 200   0.012\n"
     "60   120 120 120   0.006\n"
     "90   200 200 200   0.03\n"
     "112  255 255 255   0.10\n"
     "124  255 255 255   0.06\n"
     "140  255 255 255   0.01\n"
     "255  255 255 255   0.01\n"},
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
