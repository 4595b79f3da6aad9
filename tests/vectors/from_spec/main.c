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
    {"product", stage_product},
    {"scale", stage_scale},
    {"quotient", stage_quotient},
    {"sine", stage_sine},
    {"root", stage_root},
    {"unorm", stage_unorm},
    {"ray_orthographic", stage_ray_orthographic},
    {"ray_perspective", stage_ray_perspective},
    {"clip", stage_clip},
    {"cell", stage_cell},
    {"weights", stage_weights},
    {"sample8", stage_sample8},
    {"sample16", stage_sample16},
    {"separate8", stage_separate8},
    {"separate16", stage_separate16},
    {"nearest", stage_nearest},
    {"under", stage_under},
    {"over", stage_over},
    {"readout", stage_readout},
    {"pixel", stage_pixel},
    {"transfer", stage_transfer},
    {"index", stage_index},
    {"gradient", stage_gradient},
    {"shade", stage_shade},
    {"reduce", stage_reduce},
    {"transmittance", stage_transmittance},
    {"transmittance16", stage_transmittance16},
    {"depth", stage_depth},
    {"extinction", stage_extinction},
    {"reciprocal", stage_reciprocal},
    {"phi", stage_phi},
    {"correct", stage_correct},
    {"recode", stage_recode},
    {"least_extinction", stage_least_extinction},
    {"mixture", stage_mixture},
    {"downsample", stage_downsample},
    {"way", stage_way},
    {"piece", stage_piece},
    {"medium", stage_medium},
    {"bspline", stage_bspline},
    {"bspline_sample", stage_bspline_sample},
    {"converted8", stage_converted8},
    {"converted16", stage_converted16},
    {"corrected", stage_corrected},
    {"extinction_under", stage_extinction_under},
    {"extinction_over", stage_extinction_over},
    {"level_blend", stage_level_blend},
    {"dither", stage_dither},
    {"hits", stage_hits},
    {"plateau", stage_plateau},
    {"alpha", stage_alpha},
    {"slices", stage_slices},
    {"light", stage_light},
    {"blend_plain", stage_blend_plain},
    {"blend_dithered", stage_blend_dithered},
    {"blend24", stage_blend24},
    {"blend_front", stage_blend_front},
    {"residual", stage_residual},
    {"replay", stage_replay},
    {"slice_dither", stage_slice_dither},
    {"pixel_blend", stage_pixel_blend},
    {"pixel_show", stage_pixel_show},
    {"order", stage_order},
    {"attenuation", stage_attenuation},
    {"attenuate", stage_attenuate},
    {"length", stage_length},
    {"scaled", stage_scaled},
    {"footprint", stage_footprint},
    {"splat_added", stage_splat_added},
    {"splat_over", stage_splat_over},
    {"lamp", stage_lamp},
    {"associate", stage_associate},
    {"preweighted_under", stage_preweighted_under},
    {"preweighted_over", stage_preweighted_over},
    {"picture", stage_picture},
    {"line", stage_line},
    {"palette", stage_palette},
    {"coarser", stage_coarser},
    {"associated", stage_associated},
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
