/*
 * part_modes.c - RGBA8 by each mode: what the arithmetic costs and what 8 bits of storage cost,
 * each with its bound for every pixel.
 */
#include "pictures.h"

#include <math.h>

enum { stride = 3 /* of the rows and columns that are compared */ };

typedef struct mode_case {
    const char *name;
    our_mode narrow, wide; /* of 8 bits, and of 16 for the same picture without that rounding */
    bool bounded;          /* whether storage has a bound */
} mode_case;

#define MODE(name, mode, bounded)                                                                  \
    {                                                                                              \
#name, {#name, QV_STORAGE_RGBA8, &qv_##name##_rgba8, mode },                               \
                {#name, QV_STORAGE_RGBA16, &qv_##name##_rgba16, mode }, bounded                    \
    }

static const mode_case cases[] = {
    MODE(nearest, REF_NEAREST, true),
    MODE(separate, REF_SEPARATE, true),
    MODE(weighted, REF_WEIGHTED, true),
    {"preweighted",
     {"preweighted", QV_STORAGE_ASSOCIATED8, &qv_preweighted_associated8, REF_WEIGHTED},
     {"weighted", QV_STORAGE_RGBA16, &qv_weighted_rgba16, REF_WEIGHTED},
     true},
    MODE(corrected, REF_CORRECTED, true),
    MODE(bspline_weighted, REF_BSPLINE_WEIGHTED, true),
    MODE(extinction, REF_EXTINCTION, false),
    MODE(bspline_extinction, REF_BSPLINE_EXTINCTION, false),
};

/* The errors of a mode, the largest bound of a pixel, and how much of its own one has reached. */
typedef struct by_mode {
    picture_error arithmetic, storage;
    pixel_bound largest, reached;
} by_mode;

static double farthest(const double a[4], const double b[4])
{
    double off = 0;
    for (int channel = 0; channel < 4; channel++) {
        off = fmax(off, fabs(a[channel] - b[channel]));
    }
    return off;
}

static void add_bound(by_mode *into, const pixel_bound *bound, double arithmetic, double storage)
{
    into->largest.arithmetic = fmax(into->largest.arithmetic, bound->arithmetic);
    into->largest.storage = fmax(into->largest.storage, bound->storage);
    into->reached.arithmetic = fmax(into->reached.arithmetic, arithmetic / bound->arithmetic);
    if (bound->storage > 0) {
        into->reached.storage = fmax(into->reached.storage, storage / bound->storage);
    }
}

/* The scene's step is its unit distance. */
static void name_unit(qv_scene *scene)
{
    scene->volume.unit_distance = scene->camera.step;
}

static void add_pixel(by_mode *into, const double got[4], const qv_scene *narrow,
                      const qv_scene *wide, ref_mode mode, int32_t x, int32_t y)
{
    ref_pixel exact, real;
    ref_render(&exact, narrow, mode, x, y);
    ref_render(&real, wide, mode, x, y);
    if (exact.opacity <= 0 && real.opacity <= 0) {
        return;
    }
    const pixel_bound bound = pixel_bound_of(narrow, mode, x, y);
    error_add_pixel(&into->arithmetic, got, exact.rgba);
    error_add_pixel(&into->storage, exact.rgba, real.rgba);
    add_bound(into, &bound, farthest(got, exact.rgba), farthest(exact.rgba, real.rgba));
}

static void add_scene(by_mode *into, const mode_case *of, unsigned number)
{
    picture_scene scene;
    ours_volume narrow, wide;
    paper_picture got;
    picture_scene_make(&scene, number);
    ours_make(&narrow, &scene, &of->narrow);
    ours_make(&wide, &scene, &of->wide);
    name_unit(&narrow.scene);
    name_unit(&wide.scene);
    paper_render(&got, &narrow.scene, scene.edge, scene.edge);
    for (int32_t y = 0; y < scene.edge; y += stride) {
        for (int32_t x = 0; x < scene.edge; x += stride) {
            add_pixel(into, got.rgba[y * scene.edge + x], &narrow.scene, &wide.scene,
                      of->narrow.mode, x, y);
        }
    }
    paper_picture_free(&got);
    ours_free(&narrow);
    ours_free(&wide);
    picture_scene_free(&scene);
}

static bool add_mode(table *t, const mode_case *of)
{
    by_mode found = {.largest = {0}};
    for (unsigned number = 0; number < picture_scenes; number++) {
        add_scene(&found, of, number);
    }
    table_text(t, of->name);
    table_number(t, "%.3g", 255 * found.largest.arithmetic);
    table_number(t, "%.2g", found.arithmetic.worst);
    table_number(t, "%.2f", 100 * found.reached.arithmetic);
    table_number(t, "%.2f", error_equal(&found.arithmetic));
    if (of->bounded) {
        table_number(t, "%.3g", 255 * found.largest.storage);
        table_number(t, "%.3g", found.storage.worst);
        table_number(t, "%.1f", 100 * found.reached.storage);
    } else {
        table_text(t, "255");
        table_number(t, "%.3g", found.storage.worst);
        table_text(t, "-");
    }
    return found.reached.arithmetic <= 1 && found.arithmetic.beyond == 0 &&
           (!of->bounded || found.reached.storage <= 1);
}

void part_modes(const char *folder)
{
    table t;
    bool holds = true;
    printf(
        "### 2.11 RGBA8 by mode\n\n"
        "Arithmetic: the library against double precision of the same bytes. Storage: double "
        "precision of\n8 bits a channel against that of 16. Each pixel has a bound of its own, "
        "summed along its ray as\n`tests/precision/pictures/bounds.c` says; the table has the "
        "largest of any pixel, and the most that\none has reached of its own. Roundings of a ray "
        "go both ways, bounds let "
        "all go the same way; those of\nstorage are nearly reached by mist, whose "
        "voxels do. Extinction of stored opacity has no bound short\nof full scale there: "
        "between 254/255 and 1, depth rises from 8 to 64.\n\n");
    table_begin(&t, folder, "pictures_modes",
                "mode|bound|worst|reached, %|equal after packing, %|storage: bound|storage: "
                "worst|storage: reached, %");
    for (size_t i = 0; i < COUNT(cases); i++) {
        holds = add_mode(&t, &cases[i]) && holds;
    }
    table_end(&t);
    goal(holds,
         "RGBA8: every pixel of every mode within its bound, none 2 of 255 off in arithmetic");
    goals_end();
}
