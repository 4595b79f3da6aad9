/* wittenbrink FOLDER: writes FOLDER/table.md, and pictures and curves to FOLDER/data. */
#include "wittenbrink.h"

int main(int argc, char **argv)
{
    char folder[FILENAME_MAX];
    paper_require(argc == 2, "usage: wittenbrink FOLDER");
    (void)snprintf(folder, sizeof folder, "%s/data", argv[1]);
    FILE *table = paper_open(argv[1], "table.md");
    fputs("# Wittenbrink, Malzbender, Goss 1998\n", table);
    border_rays(table, folder);
    border_scenes(table, folder);
    torus(table, folder);
    preweighted(table);
    paper_close(table);
    return 0;
}
