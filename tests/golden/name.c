/*
 * name.c - the words of a golden scene's name; devices do without.
 */
#include "scenes.h"

void golden_name(const char *word[GOLDEN_WORDS], const golden_scene *golden)
{
    static const char *const families[] = {
        "nearest",   "separate",   "weighted",         "preweighted",
        "corrected", "extinction", "bspline_weighted", "bspline_extinction",
    };
    static const char *const storages[] = {
        "rgba8",  "rgba16",      "indexed8",     "indexed8_16", "rgbt8",
        "rgbt16", "indexed8_t8", "indexed8_t16", "associated8",
    };
    static const char *const orders[] = {"front to back", "back to front", "levels"};
    static const char *const formats[] = {
        "rgba8888", "bgra8888", "rgb888",          "rgb565_le",     "rgb565_be",
        "l8",       "grey4",    "mono_horizontal", "mono_vertical",
    };
    const golden_splat *splat = golden->splats.how;
    word[0] = splat ? "freevoxels" : families[golden->mode->family];
    word[1] = storages[QV_FIELD(golden->mode->sampling, storage) - QV_STORAGE_RGBA8];
    word[2] = splat                  ? splat->name
              : golden->slices.blend ? golden->slices.blend->name
                                     : orders[golden->mode->order];
    word[3] = golden->field_of_view == 0 ? "orthographic" : "perspective";
    word[4] = formats[golden->format];
}
