/*
 * part_bits.c - the error of the picture by the bits of one stage, all others being exact.
 */
#include "pictures.h"

/* A setting of one stage. */
typedef void set_bits(model *of, store *by, int bits);

static void set_storage(model *of, store *by, int bits)
{
    (void)of;
    by->kind = STORE_UNORM;
    by->bits = (unsigned)bits;
}

static void set_associated(model *of, store *by, int bits)
{
    set_storage(of, by, bits);
    by->associated = true;
}

static void set_position(model *of, store *by, int bits)
{
    (void)by;
    of->position = bits;
}

static void set_weights(model *of, store *by, int bits)
{
    (void)by;
    of->weights = bits;
}

static void set_accumulators(model *of, store *by, int bits)
{
    (void)by;
    of->transmittance = bits;
    of->light = bits;
}

typedef struct sweep {
    const char *title, *file, *note;
    set_bits *set;
    int bits[14]; /* ends with 0 */
} sweep;

static const sweep sweeps[] = {
    {"Storage: bits a channel, colours not weighted",
     "pictures_storage_bits",
     "The library stores 8 or 16. Thin, film and veil\nhave opacities of whole 255ths, which 8 and "
     "16 bits hold, and others do not.",
     set_storage,
     {4, 5, 6, 7, 8, 10, 12, 14, 15, 16, 0}},
    {"Storage: bits a channel, colours weighted by opacity",
     "pictures_associated_bits",
     "The library's associated8 has 8.",
     set_associated,
     {4, 5, 6, 7, 8, 10, 12, 14, 15, 16, 0}},
    {"Position: fraction bits of a sample's point",
     "pictures_position_bits",
     "The library has 8. A picture of sharp edges needs the most.",
     set_position,
     {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 0}},
    {"Weights: fraction bits of the products of fractions",
     "pictures_weight_bits",
     "The library has 16, of fractions of 8, so that only xyz is rounded; here fractions are "
     "exact,\nand rounded too.",
     set_weights,
     {3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 0}},
    {"Accumulators: fraction bits of light and transmittance",
     "pictures_accumulator_bits",
     "The library has 31 along rays; frame buffers of slices are in section 2.5.",
     set_accumulators,
     {8, 10, 12, 14, 15, 16, 18, 20, 22, 24, 28, 31, 0}},
};

/* All scenes, and three of them: thin, shells, and a scan. */
enum { groups = 4, settings_most = 14 };
static const int group_scene[groups] = {-1, scene_haze, scene_shells, scene_head};

typedef picture_error errors[COUNT(sweeps)][settings_most][groups];

static void add_setting(picture_error into[groups], const sweep *of, int bits,
                        const picture_scene *scene, int number, const paper_picture *truth)
{
    model as = model_reference;
    store by = store_real;
    paper_picture got;
    of->set(&as, &by, bits);
    model_picture(&got, &as, scene, &by);
    for (int group = 0; group < groups; group++) {
        if (group_scene[group] < 0 || group_scene[group] == number) {
            error_add(&into[group], &got, truth);
        }
    }
    paper_picture_free(&got);
}

static void add_scene(errors into, unsigned number)
{
    picture_scene scene;
    paper_picture truth;
    picture_scene_make(&scene, number);
    truth_picture(&truth, &scene);
    for (size_t i = 0; i < COUNT(sweeps); i++) {
        for (int j = 0; sweeps[i].bits[j] != 0; j++) {
            add_setting(into[i][j], &sweeps[i], sweeps[i].bits[j], &scene, (int)number, &truth);
        }
    }
    paper_picture_free(&truth);
    picture_scene_free(&scene);
}

static void print_sweep(const char *folder, const sweep *of, picture_error found[][groups])
{
    table t;
    printf("**%s.** %s\n\n", of->title, of->note);
    table_begin(&t, folder, of->file,
                "bits|all scenes: RMS|worst|PSNR|haze: RMS|shells: RMS|head: RMS");
    for (int j = 0; of->bits[j] != 0; j++) {
        table_number(&t, "%.0f", of->bits[j]);
        table_error(&t, &found[j][0]);
        for (int group = 1; group < groups; group++) {
            table_number(&t, "%.3g", error_rms(&found[j][group]));
        }
    }
    table_end(&t);
}

void part_bits(const char *folder)
{
    static errors found;
    printf("### 2.2 Bits of one stage\n\n"
           "Each table rounds one stage and leaves all others exact, real voxels and points "
           "included.\n\n"
           "Plot: `pictures_bits.png`.\n\n");
    for (unsigned number = 0; number < picture_scenes; number++) {
        add_scene(found, number);
    }
    for (size_t i = 0; i < COUNT(sweeps); i++) {
        print_sweep(folder, &sweeps[i], found[i]);
    }
}
