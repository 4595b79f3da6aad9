/*
 * part_mapper.c - whether the model of 15 bits computes what VTK's fixed-point mapper does.
 */
#include "pictures.h"

#include <math.h>

enum { fog_samples = 511 };

/* A fog of so many samples of uniform scalars, of colour 1, 1/2 and 1/10, by VTK 9.1.0 as Debian 12
   has it: errors of opacity, R, G and B in levels, to two digits. */
typedef struct fog_of_vtk {
    double opacity, error[4];
} fog_of_vtk;

static const fog_of_vtk fogs[] = {
    {1e-05, {-1.3, -1.3, -0.65, -0.13}}, {2e-05, {1.38, 1.38, 2.68, 3.72}},
    {3e-05, {0.1, 0.1, 2.04, 3.59}},     {5e-05, {1.52, 1.52, 0.76, 3.33}},
    {0.0001, {-0.77, -0.77, 1.6, 2.71}}, {0.0002, {3.06, 3.06, 3.52, 1.5}},
    {0.0005, {0.08, 0.5, 1.16, 2.2}},    {0.001, {1.35, 2.22, 3.66, 3.93}},
    {0.002, {0.85, 2.3, 2.12, 2.9}},     {0.004, {-0.38, 1.89, 2.78, 3.5}},
    {0.01, {-0.48, 1.5, 2.38, 2.21}},
};

static const double digits = 0.005;

static double add_fog(table *t, const fog_of_vtk *of)
{
    const double rgba[4] = {1, 0.5, 0.1, of->opacity};
    const double through = pow(1 - of->opacity, fog_samples);
    picture_scene fog;
    paper_picture got;
    double worst = 0;
    picture_fog_make(&fog, rgba, fog_samples);
    mapper_picture(&got, &fog, false);
    table_number(t, "%g", of->opacity);
    for (int i = 0; i < 4; i++) {
        const int channel = (i + 3) % 4; /* opacity first */
        const double exact = (channel == 3 ? 1 : rgba[channel]) * (1 - through);
        const double error = 255 * (got.rgba[0][channel] - exact);
        table_number(t, "%.2f", of->error[i]);
        table_number(t, "%.2f", error);
        worst = fmax(worst, fabs(error - of->error[i]));
    }
    paper_picture_free(&got);
    picture_scene_free(&fog);
    return worst;
}

void part_mapper(const char *folder)
{
    table t;
    double worst = 0;
    printf(
        "The model of 15 bits against VTK 9.1 itself: a fog of %d samples of one scalar, errors in "
        "levels, each\nas measured of VTK and of the model.\n\n",
        fog_samples);
    table_begin(&t, folder, "pictures_mapper",
                "opacity|opacity: VTK|model|colour 1: VTK|model|colour 1/2: VTK|model|colour 1/10: "
                "VTK|model");
    for (size_t i = 0; i < COUNT(fogs); i++) {
        worst = fmax(worst, add_fog(&t, &fogs[i]));
    }
    table_end(&t);
    goal(worst <= digits, "the model of 15 bits has the errors of VTK 9.1, to the digits measured");
    goals_end();
}
