/* kraus FOLDER: writes FOLDER/table.md, and pictures and curves to FOLDER/data. */
#include "kraus.h"

int main(int argc, char **argv)
{
    char folder[FILENAME_MAX];
    paper_require(argc == 2, "usage: kraus FOLDER");
    (void)snprintf(folder, sizeof folder, "%s/data", argv[1]);
    FILE *table = paper_open(argv[1], "table.md");
    fputs("# Kraus and Buerger 2008\n", table);
    equations(table);
    eight_voxels(table);
    one_vertex(table, folder);
    thin_wall(table, folder);
    scattered_voxels(table, folder);
    filters(table, folder);
    pyramids(table, folder);
    paper_close(table);
    return 0;
}
