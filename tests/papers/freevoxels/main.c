/* freevoxels FOLDER: writes FOLDER/table.md, and pictures and curves to FOLDER/data. */
#include "freevoxels.h"

int main(int argc, char **argv)
{
    char folder[FILENAME_MAX];
    paper_require(argc == 2, "usage: freevoxels FOLDER");
    (void)snprintf(folder, sizeof folder, "%s/data", argv[1]);
    FILE *table = paper_open(argv[1], "table.md");
    fputs("# FreeVoxels\n", table);
    uniform_cube(table, folder);
    leak(table, folder);
    store(table);
    means(table);
    directions(table);
    between(folder);
    inside(table, folder);
    hierarchy(table, folder);
    lit_head(table, folder);
    nodes(table, folder);
    paper_close(table);
    return 0;
}
