/* freevoxels FOLDER [numbers]: writes FOLDER/table.md, and pictures and curves to FOLDER/data;
   numbers: without the pictures of heads and the work of nodes, which take their time. */
#include "freevoxels.h"

int main(int argc, char **argv)
{
    char folder[FILENAME_MAX];
    paper_require(argc == 2 || argc == 3, "usage: freevoxels FOLDER [numbers]");
    (void)snprintf(folder, sizeof folder, "%s/data", argv[1]);
    FILE *table = paper_open(argv[1], "table.md");
    fputs("# FreeVoxels\n", table);
    uniform_cube(table, folder);
    leak(table, folder);
    store(table);
    means(table);
    directions(table);
    inside(table, folder);
    if (argc == 2) {
        between(folder);
        hierarchy(table, folder);
        lit_head(table, folder);
        nodes(table, folder);
    }
    paper_close(table);
    return 0;
}
