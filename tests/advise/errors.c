/*
 * errors.c - how far each sampling mode, storage and step is from double precision, over the
 * scenes of scenes.h. Prints lines "error STORAGE MODE STEP RMS WORST RMS WORST": in 1/100 of a
 * level of 255, rounded up, first from the medium, then from the same samples.
 *
 * Exact is what double precision makes of entries of 16 bits, by a camera that rounds nothing. The
 * medium is what steps of 1/16 show, with the mode's own kind of reconstruction: by opacity or by
 * extinction, trilinear or by B-splines. The same samples are those of the mode at that step.
 * Nearest, separate and preweighted ones are held against weighted ones. Pixels are compared
 * before they are packed, colours and opacity; RMS is that of the scene where it is largest.
 */
#include "access.h"
#include "bench/bench_modes.h"
#include "papers/paper.h"
#include "scenes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FRAME = 48 /* pixels of the square frame */ };

static const double steps[] = {.25, .5, 1, 2};
static const double finest = 1 / 16.0;
enum { STEPS = sizeof steps / sizeof steps[0] };
enum { EXACT_MODES = REF_BSPLINE_EXTINCTION + 1 };

/* ---- Modes --------------------------------------------------------------------- */

/* What the samples of a mode are in double precision: weighted ones for each that is not by
   length. */
static ref_mode samples_of(const char *name, bool by_length)
{
    const bool extinction = strstr(name, "extinction") != NULL;
    if (!by_length)
        return REF_WEIGHTED;
    if (strncmp(name, "bspline_", strlen("bspline_")) == 0)
        return extinction ? REF_BSPLINE_EXTINCTION : REF_BSPLINE_WEIGHTED;
    return extinction ? REF_EXTINCTION : REF_CORRECTED;
}

/* The mode by length that shows the medium. */
static ref_mode medium_of(ref_mode mode)
{
    return mode == REF_WEIGHTED ? REF_CORRECTED : mode;
}

/* ---- Pictures ------------------------------------------------------------------ */

/* All of the scene is in the frame. */
static paper_view view_of(const advise_scene *of, double step)
{
    double square = 0;
    for (int axis = 0; axis < 3; axis++)
        square += of->size[axis] * of->size[axis];
    return (paper_view){32, 24, sqrt(square) / FRAME, step, FRAME, FRAME};
}

static uint32_t q16(double length)
{
    return (uint32_t)floor(length * QV_ONE_Q16 + .5);
}

/* A scene of one storage, and its voxels. Modes by length are told the length for which
   opacities hold; for others opacities are made to hold for the step. */
static void make_scene(qv_scene *scene, advise_volume *stored, const advise_scene *of,
                       qv_storage storage, bool by_length, const paper_view *view)
{
    advise_volume_make(stored, of, storage, by_length ? QV_ONE_Q16 : 0, q16(view->step));
    memset(scene, 0, sizeof *scene);
    scene->volume = stored->volume;
    paper_look(scene, view);
}

/* The view that the library's camera is made of, as real numbers. */
static void real_view(ref_view *real, const paper_view *view)
{
    qv_view frame;
    paper_frame(&frame, view);
    memset(real, 0, sizeof *real);
    real->pitch = frame.pitch / (double)QV_ONE_Q16;
    real->step = frame.step / (double)QV_ONE_Q16;
    real->width = real->height = FRAME;
    for (int i = 0; i < 9; i++)
        real->rotation[i / 3][i % 3] = ldexp(frame.rotation[i / 3][i % 3], -30);
}

static void render_exact(paper_picture *made, const advise_scene *of, ref_mode mode, double step)
{
    const paper_view view = view_of(of, step);
    advise_volume stored;
    qv_scene scene;
    ref_view real;
    make_scene(&scene, &stored, of, QV_STORAGE_INDEXED8_16, ref_is_by_length(mode), &view);
    real_view(&real, &view);
    paper_picture_make(made, FRAME, FRAME);
    for (int32_t i = 0; i < FRAME * FRAME; i++) {
        ref_pixel pixel;
        ref_render_ideal(&pixel, &scene, &real, mode, i % FRAME, i / FRAME);
        memcpy(made->rgba[i], pixel.rgba, sizeof pixel.rgba);
    }
    advise_volume_free(&stored);
}

static void render(paper_picture *made, const advise_scene *of, const qv_sampling *sampling,
                   double step)
{
    const paper_view view = view_of(of, step);
    const qv_storage storage = (qv_storage)QV_FIELD(sampling, storage);
    advise_volume stored;
    qv_scene scene;
    make_scene(&scene, &stored, of, storage, QV_FIELD(sampling, by_length), &view);
    scene.sampling = sampling;
    scene.termination = QV_TERMINATION_DEFAULT;
    paper_render(made, &scene, FRAME, FRAME);
    advise_volume_free(&stored);
}

/* ---- Errors ---------------------------------------------------------------------- */

typedef struct error {
    double rms, worst; /* levels */
} error;

/* From the medium, and from the same samples. */
typedef struct errors {
    error medium, samples;
} errors;

static void raise(error *most, const paper_picture *a, const paper_picture *b)
{
    double squares = 0;
    for (int i = 0; i < FRAME * FRAME; i++)
        for (int channel = 0; channel < 4; channel++) {
            const double off = 255 * fabs(a->rgba[i][channel] - b->rgba[i][channel]);
            squares += off * off;
            most->worst = fmax(most->worst, off);
        }
    most->rms = fmax(most->rms, sqrt(squares / (4.0 * FRAME * FRAME)));
}

/* A scene in double precision; weighted samples have the medium of corrected ones. */
typedef struct exact_pictures {
    paper_picture medium[EXACT_MODES], samples[EXACT_MODES][STEPS];
} exact_pictures;

static void render_all_exact(exact_pictures *made, const advise_scene *of)
{
    for (unsigned mode = REF_WEIGHTED; mode < EXACT_MODES; mode++) {
        if (ref_is_by_length((ref_mode)mode))
            render_exact(&made->medium[mode], of, (ref_mode)mode, finest);
        for (unsigned s = 0; s < STEPS; s++)
            render_exact(&made->samples[mode][s], of, (ref_mode)mode, steps[s]);
    }
}

static void free_all_exact(exact_pictures *made)
{
    for (unsigned mode = REF_WEIGHTED; mode < EXACT_MODES; mode++) {
        if (ref_is_by_length((ref_mode)mode))
            paper_picture_free(&made->medium[mode]);
        for (unsigned s = 0; s < STEPS; s++)
            paper_picture_free(&made->samples[mode][s]);
    }
}

/* Raises what a mode and step have reached so far by what they reach of this scene. */
static void measure(errors *most, const advise_scene *of, const exact_pictures *exact,
                    const bench_mode *by, unsigned step)
{
    const ref_mode mode = samples_of(by->name, QV_FIELD(by->sampling, by_length));
    paper_picture picture;
    render(&picture, of, by->sampling, steps[step]);
    raise(&most->medium, &picture, &exact->medium[medium_of(mode)]);
    raise(&most->samples, &picture, &exact->samples[mode][step]);
    paper_picture_free(&picture);
}

static void measure_scene(errors (*most)[STEPS], unsigned number)
{
    exact_pictures exact;
    advise_scene of;
    advise_scene_make(&of, number);
    render_all_exact(&exact, &of);
    for (unsigned m = 0; m < bench_mode_count; m++)
        for (unsigned s = 0; s < STEPS; s++)
            measure(&most[m][s], &of, &exact, &bench_modes[m], s);
    free_all_exact(&exact);
    free(of.values);
}

/* To hundredths of a level, upwards. */
static int hundredths(double levels)
{
    return (int)ceil(100 * levels - 1e-6);
}

int main(void)
{
    errors(*most)[STEPS] = paper_memory(bench_mode_count, sizeof *most);
    for (unsigned number = 0; number < ADVISE_SCENES; number++)
        measure_scene(most, number);
    for (unsigned m = 0; m < bench_mode_count; m++)
        for (unsigned s = 0; s < STEPS; s++) {
            const errors *of = &most[m][s];
            printf("error %s %s %g %d %d %d %d\n", bench_modes[m].storage, bench_modes[m].name,
                   steps[s], hundredths(of->medium.rms), hundredths(of->medium.worst),
                   hundredths(of->samples.rms), hundredths(of->samples.worst));
        }
    free(most);
    return 0;
}
