/*
 * The second generator of tests/vectors, written from tests/SPEC.md alone.
 *
 *     from_spec STAGE <STAGE.csv    the same rows with every value computed anew
 *     from_spec --list              the names of the stages
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "csv.h"
#include "stages.h"
#include "tables.h"

typedef struct stage {
    const char *name;
    stage_function *compute;
} stage;

static const stage stages[] = {
    {"cell", stage_cell},
    {"weights", stage_weights},
    {"sample8", stage_sample8},
    {"sample16", stage_sample16},
    {"separate8", stage_separate8},
    {"separate16", stage_separate16},
    {"under", stage_under},
    {"over", stage_over},
    {"readout", stage_readout},
    {"pixel", stage_pixel},
    {"transmittance", stage_transmittance},
    {"transmittance16", stage_transmittance16},
};

enum { STAGES = sizeof stages / sizeof *stages };

static stage_function *find_stage(const char *name)
{
    for (unsigned i = 0; i < STAGES; i++)
        if (strcmp(stages[i].name, name) == 0)
            return stages[i].compute;
    fail("there is no stage %s", name);
    return NULL;
}

static void list_stages(void)
{
    for (unsigned i = 0; i < STAGES; i++)
        puts(stages[i].name);
}

static void compute_all(stage_function *compute)
{
    static csv rows;
    tables_make();
    numbers_keep();
    csv_open(&rows, stdin, stdout);
    while (csv_next(&rows)) {
        compute(&rows);
        csv_write(&rows);
        numbers_forget();
    }
    csv_close(&rows);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: from_spec STAGE <STAGE.csv, or from_spec --list\n");
        return 2;
    }
    if (strcmp(argv[1], "--list") == 0)
        list_stages();
    else
        compute_all(find_stage(argv[1]));
    return EXIT_SUCCESS;
}
