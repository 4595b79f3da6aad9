/* dithering FOLDER: writes FOLDER/numbers.txt, table1.txt, table3.txt and table.md, and curves and
   their index to FOLDER/data. */
#include "dithering.h"

int main(int argc, char **argv)
{
    char folder[FILENAME_MAX];
    paper_require(argc == 2, "usage: dithering FOLDER");
    (void)snprintf(folder, sizeof folder, "%s/data", argv[1]);
    FILE *numbers = paper_open(argv[1], "numbers.txt");
    FILE *index = paper_open(folder, "index");
    fputs("# Williams et al.: alpha dithering\n\n## What the paper says\n\n", numbers);
    fputs("| place | what | paper | computed |\n|---|---|---|---|\n", numbers);
    colour_figure(numbers, index, folder);
    histogram_figures(numbers, folder);
    fog_figures(numbers, index, folder);
    tables(argv[1]);
    techniques_of_section_9(argv[1]);
    paper_close(index);
    paper_close(numbers);
    return 0;
}
