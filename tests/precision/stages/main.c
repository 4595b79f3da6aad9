/*
 * main.c - stages FOLDER: measures every stage; prints the section of the report and writes
 * FOLDER/stages.csv.
 */
#include "stages.h"

#include "papers/paper.h"

#include <string.h>

static const chapter *const chapters[] = {
    &chapter_rays,    &chapter_entries, &chapter_weights,   &chapter_samples,
    &chapter_bspline, &chapter_depth,   &chapter_composite, &chapter_preweighted,
    &chapter_lengths, &chapter_blends,  &chapter_pixels,    &chapter_downsampling,
    &chapter_splats,
};

#define STAGES_MOST 144

/* ---- The section -------------------------------------------------------------------------- */

static void print_summary(const measured *all)
{
    printf(
        "## 1 Stages\n\n"
        "Errors are results less true values of the same input, in the unit of the row. True\n"
        "values are computed with whole numbers, doubles and long doubles, of what the stage is\n"
        "given: where that is what an earlier stage makes, the library has made it.\n"
        "RMS is over all inputs where all were measured, else over 200000 random ones, 3200000 of\n"
        "stages of one number, half of them uniform, half of random magnitude. There the worst\n"
        "was searched for too: by hill climbing from the 48 worst of those, each number of the\n"
        "input moving by powers of 2, to its ends and to random places (`make test-exhaustive`\n"
        "tries all inputs of the functions of one number). Chains were grown greedily, see there.\n"
        "A bound is at most 2 times the worst error that was found, of chains of operations 4\n"
        "times, unless a reason is told. The bounds are derived below the table. Stages with n\n"
        "are of n samples, pieces or voxels.\n\n"
        "Units: light, opacity and transmittance are parts of 1, which is 2^32, 2^31 or 65535 as\n"
        "the format says; 2^-31, 2^-16 of 1 and so on are such parts. \"Of it\" is relative, a\n"
        "part of the true value. A level is 1/255 of full scale; where a row's buffer or pixel "
        "has\n"
        "other bits than 8, its level is 1 / (2^bits - 1), as \"own level\" says too. Of frame\n"
        "buffers with fraction bits, 12.4, 16.8 and 24.16 (bits in all, then of fraction), a unit "
        "is\n"
        "the last bit: 2^-4, 2^-8 and 2^-16 level; of 8.0 it is a level, of 24.24 it is 2^-24 of "
        "1.\n"
        "Depth is to base 2, -log2 of transmittance, so that 1 halves it: 1.44 times optical "
        "depth.\n"
        "Opacity 1 has infinite depth; SPEC defines 64 for it, of which 2^-64 passes, nothing in\n"
        "any format here. It is no rounding, and has no error: true depths take it as given.\n\n"
        "| stage | formats | rounding | unit of errors | bound | worst | RMS | inputs | "
        "the worst one |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    for (size_t c = 0; c < COUNT(chapters); c++) {
        for (size_t i = 0; i < chapters[c]->count; i++, all++) {
            const stage *s = &chapters[c]->stages[i];
            printf("| %s | %s | %s | %s | %.5g | %.5g | %.3g | %s | %s |\n", s->name, s->formats,
                   s->rounding, s->unit, s->bound, all->worst, measured_rms(all), s->inputs,
                   all->input);
        }
    }
}

static void print_chapters(const measured *all)
{
    for (size_t c = 0; c < COUNT(chapters); c++) {
        printf("\n### 1.%zu %s\n\n%s", c + 1, chapters[c]->title, chapters[c]->derivation);
        for (size_t i = 0; i < chapters[c]->count; i++, all++) {
            const stage *s = &chapters[c]->stages[i];
            printf("\n- **%s**: %.5g of at most %.5g (%s).%s%s", s->name, all->worst, s->bound,
                   s->unit, s->reason != NULL ? " " : "", s->reason != NULL ? s->reason : "");
        }
        printf("\n");
    }
}

/* ---- The table ------------------------------------------------------------------------------ */

/* A text in quotes, of which none is in our tables. */
static void write_row(FILE *csv, const stage *s, const measured *m)
{
    fprintf(csv, "%.6g,%.6g,%.4g,%u,%d,\"%s\",\"%s\",\"%s\",\"%s\",\"%s\",\"%s\"\n", s->bound,
            m->worst, measured_rms(m), s->within, s->reason != NULL, s->name, s->formats,
            s->rounding, s->unit, s->inputs, m->input);
}

static void write_table(const char *folder, const measured *all)
{
    FILE *csv = paper_open(folder, "stages.csv");
    fprintf(csv, "bound,worst,rms,within,reason,stage,formats,rounding,unit,inputs,input\n");
    for (size_t c = 0; c < COUNT(chapters); c++)
        for (size_t i = 0; i < chapters[c]->count; i++)
            write_row(csv, &chapters[c]->stages[i], all++);
    paper_close(csv);
}

int main(int count, char **argument)
{
    static measured all[STAGES_MOST];
    measured *m = all;
    paper_require(count == 2, "stages FOLDER");
    for (size_t c = 0; c < COUNT(chapters); c++) {
        for (size_t i = 0; i < chapters[c]->count; i++) {
            paper_require(m < all + STAGES_MOST, "more stages than there is place for");
            chapters[c]->stages[i].measure(m++, chapters[c]->stages[i].parameter);
        }
    }
    print_summary(all);
    print_chapters(all);
    write_table(argument[1], all);
    return 0;
}
