/*
 * main.c - finds the command, reads its options, runs it.
 */
#include "commands.h"
#include "error.h"
#include "output.h"
#include "transfer_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define INPUT_DETAILS                                                                              \
    "IN is NIfTI (.nii, .nii.gz), NRRD (raw or gzip, attached or detached) or raw data; - is\n"    \
    "standard input. Raw data need --dims and --type, or a name like "                             \
    "foot_256x256x256_uint8.raw.\n"                                                                \
    "NIfTI and NRRD are turned to right, anterior, superior along the nearest axes.\n"             \
    "Other than 8- and 16-bit values, and scaled ones, become 16 bits over the window;\n"          \
    "the window of 8- and 16-bit values is in whole numbers.\n"

#define TRANSFER_DETAILS                                                                           \
    "A transfer function is text, `#` starts a comment; one control point a line:\n"               \
    "    index red green blue opacity      0..255, 0..255 each, 0..1 for the unit distance\n"      \
    "    shading ambient diffuse specular exponent gradient     for --shade, optional\n"           \
    "Opacities hold for --unit-distance; without it for one step, whatever its length.\n"          \
    "Lengths are in units of the smallest spacing.\n"                                              \
    "Storage rgbt8, rgbt16, and indexed8 with --extinction hold extinction for opacity: depth "    \
    "in\n"                                                                                         \
    "base 2 per unit of length, in parts of the full value's. auto holds all of the transfer\n"    \
    "function; what is more than E becomes E.\n"

#define SAMPLING_DETAILS                                                                           \
    "Sampling: nearest; separate (colour and opacity apart); weighted (by opacity, the "           \
    "default);\n"                                                                                  \
    "preweighted (of storage associated8, whose colours are weighted once: fast, for devices);\n"  \
    "extinction (by extinction: no step changes a homogeneous medium; the default where voxels\n"  \
    "hold it); bspline-weighted and bspline-extinction (the same two, of 27 voxels). Opacities\n"  \
    "are corrected for the length of each sample but by nearest, separate, preweighted, and\n"     \
    "weighted without --unit-distance.\n"

#define LEVEL_DETAILS                                                                              \
    "A level has half the voxels of the one before on each axis. Raw RGBA, RGBT and indexed8\n"    \
    "data may be followed by their levels, as qvol pyramid writes them.\n"

#define SLICE_DETAILS                                                                              \
    "--compositing slices blends slice after slice into a frame buffer of few bits, as devices\n"  \
    "and blending hardware do. --dither none is what hardware does. random, ordered and bump\n"    \
    "dither the opacities that it is given: bump by what a pixel has accumulated, with --slope\n"  \
    "as published. rounding dithers what each blend stores, feedback keeps a residual beside.\n"   \
    "With --slices opacities hold for a voxel, so that a fog is as dense in any number of them.\n" \
    "Bricks share one grid of slices; values are clamped at their faces.\n"

#define LEVEL_OPTION_DETAILS                                                                       \
    "--level takes those, or makes them. auto: a pixel is as wide as a voxel of its level.\n"

#define LIGHT_DETAILS                                                                              \
    "--light AZ,EL,RRGGBB, up to 4 times, is light from outside, with shadows: from where a\n"     \
    "viewer of these angles stands. --light RIGHT,UP is that of --shade.\n"

#define PICTURE_DETAILS                                                                            \
    "\nOUT ends in .png or .pam (what the display would show; alpha is stored straight), or in\n"  \
    ".raw or .bin (the display's own bytes; colour is associated with alpha). - writes PAM.\n"     \
    "Formats: rgb888 (default), rgba8888 (default over a transparent background), bgra8888,\n"     \
    "rgb565le, rgb565be, l8, grey4, mono-horizontal, mono-vertical.\n"                             \
    "At azimuth 0 and elevation 0 the viewer looks along +y, z is up: at the back of a head.\n"

#define ADVISE_DETAILS                                                                             \
    "Rays: errors were measured over a scan, a fog, waves and a ball, before pixels are packed,\n" \
    "and are those of the worst scene. The medium is what double precision shows in steps of\n"    \
    "1/16 voxel with the same reconstruction; nearest, separate and preweighted samples are\n"     \
    "held against weighted ones. From the same samples is what storage and integers add alone.\n"  \
    "The cheapest takes the fewest instructions (on an AVR cycles) for a voxel's length of ray.\n" \
    "Frame buffers: any of their options asks for one; errors are those of qv_recommend.\n"        \
    "Exit status 1: nothing reaches it, and the best there is is told.\n"

static const struct command commands[] = {
    {"qvol render", "IN -o OUT [options]", "Renders a volume to a picture or to a display's bytes.",
     INPUT_DETAILS "\n" TRANSFER_DETAILS "\n" SAMPLING_DETAILS "\n" SLICE_DETAILS
                   "\n" LEVEL_DETAILS LEVEL_OPTION_DETAILS LIGHT_DETAILS PICTURE_DETAILS,
     GROUP_INPUT | GROUP_CLASSIFY | GROUP_VIEW | GROUP_FRAME | GROUP_PICTURE | GROUP_LIGHTING |
         GROUP_OUTPUT | GROUP_REPORT | GROUP_THREADS | GROUP_COMMON | GROUP_LEVELS,
     1, command_render},
    {"qvol info", "IN [options]", "Tells size, type, spacing, orientation, range and histogram.",
     INPUT_DETAILS, GROUP_INPUT | GROUP_REPORT | GROUP_COMMON, 1, command_info},
    {"qvol compare", "A B [options]",
     "Compares two pictures (PNG or PAM). Exit status 0: equal, 1: different.",
     "With -o the picture of absolute differences times the gain is written.\n",
     GROUP_COMPARE | GROUP_OUTPUT | GROUP_REPORT | GROUP_COMMON, 2, command_compare},
    {"qvol classify", "IN -o OUT [options]", "Classifies a volume for later, or for a device.",
     INPUT_DETAILS
     "\n" TRANSFER_DETAILS "\nOUT ends in .c or .h (constant arrays and a qv_volume for flash), "
     "else it gets the voxels,\n"
     "x fastest, and OUT.palette the palette of indexed8. C arrays are in the compiler's own byte\n"
     "order and take no --endian. --azimuth, --elevation and --roll place the light of --shade.\n"
     "--dither-table adds a qv_dither_table of dithered opacities, alone or after the colour that\n"
     "they weight, for slices whose opacities are those of the transfer function.\n",
     GROUP_INPUT | GROUP_CLASSIFY | GROUP_VIEW | GROUP_REDUCE | GROUP_EXPORT | GROUP_OUTPUT |
         GROUP_REPORT | GROUP_THREADS | GROUP_COMMON | GROUP_TABLE,
     1, command_classify},
    {"qvol pyramid", "IN -o OUT [options]", "Makes coarser levels of a volume, down to one voxel.",
     INPUT_DETAILS
     "\n" TRANSFER_DETAILS "\n" LEVEL_DETAILS
     "\nOUT ends in .c or .h (constant arrays, a qv_volume and a qv_pyramid for flash), else it\n"
     "gets the voxels and then the levels, each x fastest, and OUT.palette the palette of\n"
     "indexed8, whose levels are RGBA or RGBT. The report tells size, spacing and offset of each,\n"
     "and the options with which `qvol render` reads the file: it is raw data of --dims and "
     "--type\n"
     "of the volume, and --level 2 draws level 2. --skip and --dims of a level read it alone.\n",
     GROUP_INPUT | GROUP_CLASSIFY | GROUP_VIEW | GROUP_LEVELS | GROUP_EXPORT | GROUP_OUTPUT |
         GROUP_REPORT | GROUP_THREADS | GROUP_COMMON,
     1, command_pyramid},
    {"qvol freevoxel", "IN -o OUT [options]",
     "Keeps with each voxel how much light passes to it, for qvol splat.",
     INPUT_DETAILS
     "\n" TRANSFER_DETAILS "\nOUT is mapped into memory, so it is a file. A voxel takes a byte for "
     "each direction beside\n"
     "its own: 27 of indexed8, the default here, with all directions. Opacities hold for 1 unless\n"
     "--unit-distance or --uncorrected says otherwise. Levels have voxels by --filter box2 here.\n"
     "All 26 directions draw any view. A view or a light needs the three about it: an axis, an\n"
     "edge and a corner of the cube of neighbours, as +x,+x+z,+x+y+z.\n",
     GROUP_INPUT | GROUP_CLASSIFY | GROUP_VIEW | GROUP_LEVELS | GROUP_FREEVOXEL | GROUP_OUTPUT |
         GROUP_REPORT | GROUP_THREADS | GROUP_COMMON,
     1, command_freevoxel},
    {"qvol splat", "FILE -o OUT [options]", "Draws a file of qvol freevoxel, voxel by voxel.",
     "Voxels are added in the file's order, whatever it is: sums of integers do not depend on it.\n"
     "--splatting over blends them back to front, as hardware does, and reads no light but\n"
     "that of --light: where splats overlap, it leaks.\n" PICTURE_DETAILS,
     GROUP_VIEW | GROUP_FRAME | GROUP_SPLAT | GROUP_LIGHTING | GROUP_OUTPUT | GROUP_REPORT |
         GROUP_THREADS | GROUP_COMMON,
     1, command_splat},
    {"qvol advise", "--target NAME --error E [options]",
     "Tells the cheapest way for a device to be as exact as is wanted.", ADVISE_DETAILS,
     GROUP_ADVISE | GROUP_REPORT | GROUP_COMMON, 0, command_advise},
    {"qvol vectors check", "STAGE FILE [options]",
     "Compares results of your own with the test vectors of a stage.",
     "FILE, - for standard input, is CSV: a line of names, of which one is id, then a row a line,\n"
     "numbers decimal or, after 0x, hexadecimal. It may have any of the rows and columns of\n"
     "STAGE.csv; the first field that differs is told. Exit status 0: all equal, 1: different.\n",
     GROUP_VECTORS | GROUP_REPORT | GROUP_COMMON, 2, command_vectors_check},
    {"qvol vectors show", "ID [options]", "Explains one test vector step by step.",
     "ID is a row of a stage, as weights-00017. Formulas are those of tests/SPEC.md.\n",
     GROUP_VECTORS, 1, command_vectors_show},
};

#define COMMANDS ((int)(sizeof commands / sizeof commands[0]))
/* Past "qvol ". */
#define NAME_OFFSET 5

#define COMMAND_NAMES                                                                              \
    "render, info, compare, classify, pyramid, freevoxel, splat, advise or vectors"

static void print_overview(void)
{
    printf("Usage: qvol COMMAND ...\nAn integer-only volume renderer.\n\n");
    for (int i = 0; i < COMMANDS; i++) {
        printf("  %-13s %s\n", commands[i].name + NAME_OFFSET, commands[i].summary);
    }
    printf("\nTransfer functions for --tf:\n");
    for (const struct preset *p = presets; p->name != NULL; p++) {
        printf("  %-13s %s\n", p->name, p->summary);
    }
    printf("\nqvol COMMAND --help tells the options. Exit status: 0, 1 (data) or 2 (usage).\n");
    finish_output();
}

/* How many of the words name the command: one, or two that a blank parts in its name; 0 where they
   name another. */
static int words_of(const struct command *command, int count, char **words)
{
    const char *name = command->name + NAME_OFFSET, *second = strchr(name, ' ');
    size_t length = second != NULL ? (size_t)(second - name) : strlen(name);
    if (strncmp(words[0], name, length) != 0 || words[0][length] != '\0') {
        return 0;
    }
    if (second == NULL) {
        return 1;
    }
    return count > 1 && strcmp(words[1], second + 1) == 0 ? 2 : 0;
}

static const struct command *find_command(int *used, int count, char **words)
{
    for (int i = 0; i < COMMANDS; i++) {
        *used = words_of(&commands[i], count, words);
        if (*used != 0) {
            return &commands[i];
        }
    }
    if (strcmp(words[0], "vectors") == 0) {
        usage_error(words[0], "needs check or show behind it");
    }
    usage_error(words[0], "unknown command, use " COMMAND_NAMES);
}

int main(int argc, char **argv)
{
    struct settings settings;
    const struct command *command;
    int used;
    claim_standard_streams();
    if (argc < 2) {
        usage_error("command", "none given, use " COMMAND_NAMES);
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        print_overview();
    }
    if (strcmp(argv[1], "--version") == 0) {
        print_version();
    }
    command = find_command(&used, argc - 1, argv + 1);
    error_set_command(command->name);
    options_read(&settings, command, argc - used, argv + used);
    return command->run(&settings);
}
