/* pictures FOLDER: prints the section on pictures; writes tables and curves to FOLDER. */
#include "pictures.h"

static void print_scenes(void)
{
    printf(
        "## 2 Pictures\n\n"
        "How far a finished pixel is off double precision, in levels of 255: RMS, worst and PSNR "
        "over R, G, B\nand A of all pixels that the volume covers, before they are packed to 8 "
        "bits. The scenes, of 32^3\nvoxels in frames of 40 x 40 pixels, one voxel a step:\n\n"
        "| scene | what |\n|---|---|\n"
        "| mist, haze | fogs of opacity 0.001, and of 0 to 0.03 |\n"
        "| thin, film, veil | opacities of 1, 0 to 4, and 1 to 9 whole 255ths |\n"
        "| cloud, shells | opacities up to 0.3, and thin shells round a ball, up to 0.5 |\n"
        "| noise | every channel of every voxel at random |\n"
        "| corner, graze, phase | the opaque boxes of Wittenbrink et al., antialiased |\n"
        "| head | a scan, 30 x 36 x 30, through a palette; the default scene of the budget |\n\n");
}

int main(int argc, char **argv)
{
    static void (*const parts[])(const char *folder) = {
        part_model, part_bits,    part_steps,  part_fogs,  part_slices, part_budget,
        part_paper, part_storage, part_mapper, part_goals, part_modes,
    };
    paper_require(argc == 2, "usage: pictures FOLDER");
    print_scenes();
    for (size_t i = 0; i < COUNT(parts); i++) {
        parts[i](argv[1]);
    }
    return 0;
}
