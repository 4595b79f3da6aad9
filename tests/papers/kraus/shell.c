/*
 * shell.c - thin shells: the hardest thing to keep opaque in a pyramid.
 */
#include "subject.h"

#include <math.h>

enum { size = 128 /* voxels an axis */, edge = 256 /* pixels of the frame */ };

static const double radius = 52;

typedef struct shell {
    double opacity;
    bool dome;
} shell;

/* One voxel thick; lit from the viewer's upper left. A dome is the half that faces the
   viewer, so that a ray meets it once. */
static void fill_shell(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    const double light[3] = {-0.48, -0.64, 0.6}, teal[3] = {0.45, 0.85, 0.8};
    const double viewer[3] = {0.4532, -0.7849, 0.4226}; /* azimuth 30, elevation 25 */
    const shell *of = from;
    double lit = 0, facing = 0, square = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double off = at[axis] + 0.5 - size / 2;
        lit += off * light[axis];
        facing += off * viewer[axis];
        square += off * off;
    }
    const double distance = sqrt(square);
    if (fabs(distance - radius) > 0.5 || (of->dome && facing < 0)) {
        return;
    }
    for (int channel = 0; channel < 3; channel++) {
        rgba[channel] = paper_channel(teal[channel] * (0.6 + 0.4 * lit / distance));
    }
    rgba[3] = paper_channel(of->opacity);
}

static void make(subject *made, const shell *of)
{
    made->levels = 5;
    made->kept = 3;
    made->view = (paper_view){30, 25, 1.3 * size / edge, 1, edge, edge};
    paper_volume_make(&made->made, size, size, size);
    paper_volume_fill(&made->made, fill_shell, of);
}

void make_shell(subject *made)
{
    const shell of = {0.5, false};
    made->name = "shell";
    make(made, &of);
}

void make_dome(subject *made)
{
    const shell of = {0.98, true};
    made->name = "dome";
    make(made, &of);
}
