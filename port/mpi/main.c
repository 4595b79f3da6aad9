/*
 * main.c - qvol-mpi: what of qvol runs on a cluster. The options, the file, the scene and the
 * picture are those of the command qvol.
 */
#include "error.h"
#include "options.h"
#include "output.h"
#include "ranks.h"
#include "splat_ranks.h"

#include <string.h>

static const struct command splat = {
    "qvol-mpi splat",
    "FILE -o OUT [options]",
    "Draws a file of qvol freevoxel on the ranks of mpirun: mpirun -n N qvol-mpi splat ...",
    "Each rank maps the file, which all must reach by that name, and draws the voxels whose place\n"
    "in their level is its own number modulo N. Nothing is exchanged until the sums of all are\n"
    "added up; rank 0 writes the picture. It is that of qvol splat, to the byte, for every N.\n"
    "The report tells the voxels that each rank has drawn. qvol splat --help tells of pictures.\n",
    GROUP_VIEW | GROUP_FRAME | GROUP_SPLAT | GROUP_LIGHTING | GROUP_OUTPUT | GROUP_REPORT |
        GROUP_COMMON,
    1,
    splat_on_ranks,
};

int main(int argc, char **argv)
{
    struct settings settings;
    claim_standard_streams();
    error_set_command("qvol-mpi");
    ranks_begin(&argc, &argv);
    if (argc < 2) {
        usage_error("command", "none given, use splat");
    }
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        print_help(&splat);
    }
    if (strcmp(argv[1], "--version") == 0) {
        print_version();
    }
    if (strcmp(argv[1], "splat") != 0) {
        usage_error(argv[1], "unknown command, use splat");
    }
    error_set_command(splat.name);
    options_read(&settings, &splat, argc - 1, argv + 1);
    settings.threads = 1; /* a rank is one, and mpirun -n tells how many there are */
    return splat.run(&settings);
}
