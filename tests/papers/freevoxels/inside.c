/*
 * inside.c - section 3.3: with the viewer in a voxel V, light from a voxel B is A_B / A_V, of
 * bytes both. The darker the viewer's voxel, the more their rounding counts.
 */
#include "freevoxels.h"

#include "bearing.h"

#include <math.h>
#include <string.h>

/* ---- A_B / A_V ------------------------------------------------------------------- */

/* The quotient of two bytes. */
typedef double quotient(const qv_bearing *bearing, uint8_t of_voxel, uint8_t of_viewer);

static double by_library(const qv_bearing *bearing, uint8_t of_voxel, uint8_t of_viewer)
{
    return ldexp(qv_bearing_transmittance(bearing, &of_voxel, &of_viewer), -32);
}

static double by_division(const qv_bearing *bearing, uint8_t of_voxel, uint8_t of_viewer)
{
    (void)bearing;
    return of_voxel / (double)of_viewer;
}

/* How far a quotient is at most from that of what the bytes were rounded from. A voxel behind
   the viewer's has no more light than it. */
static double off(quotient *of, const qv_bearing *bearing, int voxel, int viewer)
{
    const double made = of(bearing, (uint8_t)voxel, (uint8_t)viewer);
    const double least = (voxel - 0.5) / fmin(viewer + 0.5, 255);
    const double most = fmin((voxel + 0.5) / (viewer - 0.5), 1);
    return 255 * fmax(made - fmax(least, 0), most - made);
}

static double farthest_off(quotient *of, const qv_bearing *bearing, int viewer)
{
    double worst = 0;
    for (int voxel = 0; voxel <= viewer; voxel++) {
        worst = fmax(worst, off(of, bearing, voxel, viewer));
    }
    return worst;
}

/* A single direction: bytes count as they are. */
static void one_direction(qv_bearing *bearing)
{
    const int32_t v[3] = {INT32_MAX, 0, 0};
    const uint32_t set = ONLY(qv_direction(1, 0, 0));
    qv_compass compass;
    paper_volume voxel;
    uint32_t length;
    paper_volume_make(&voxel, 1, 1, 1);
    qv_compass_of(&compass, &voxel.volume, set, QV_NEAREST);
    paper_require(qv_bearing_of(bearing, &length, &compass, v) == QV_OK, "no bearing");
    paper_volume_free(&voxel);
}

static void write_curve(const char *folder, const qv_bearing *bearing)
{
    FILE *data = paper_open(folder, "inside.dat");
    for (int viewer = 1; viewer <= 255; viewer++) {
        fprintf(data, "%.5f %.4f %.4f\n", viewer / 255., farthest_off(by_division, bearing, viewer),
                farthest_off(by_library, bearing, viewer));
    }
    paper_close(data);
}

/* ---- A viewer in the dark ------------------------------------------------------------ */

static void fill_fog(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    (void)at;
    (void)from;
    rgba[3] = paper_channel(0.5);
}

/* What qv_splat_init says of an eye in a voxel that no light leaves. */
static qv_status in_the_dark(void)
{
    enum { size = 9 };
    const paper_view view = {30, 20, 0.25, 1, 16, 16};
    const uint8_t dark[QV_DIRECTIONS] = {0};
    paper_volume fog;
    qv_splat_scene scene;
    qv_splats splats;
    paper_volume_make(&fog, size, size, size);
    paper_volume_fill(&fog, fill_fog, NULL);
    splat_scene_make(&scene, &fog.volume, &view);
    scene.directions = QV_DIRECTIONS_ALL;
    scene.field_of_view =
        0x2AAAAAABu; /* 60 degrees: the eye is 2 / tan 30 voxels from the centre */
    scene.inside = dark;
    const qv_status status = qv_splat_init(&splats, &scene);
    paper_volume_free(&fog);
    return status;
}

void inside(FILE *table, const char *folder)
{
    static const double viewers[] = {1, 0.25, 0.1, 0.05};
    qv_bearing bearing;
    char what[96];
    one_direction(&bearing);
    paper_table_begin(table, "\n## Section 3.3: A_B / A_V of bytes, in levels");
    for (size_t i = 0; i < sizeof viewers / sizeof viewers[0]; i++) {
        const int byte = (int)floor(255 * viewers[i] + 0.5);
        (void)snprintf(what, sizeof what, "viewer in a voxel of %g: farthest off", viewers[i]);
        const paper_row row = {what, "slight", farthest_off(by_division, &bearing, byte),
                               farthest_off(by_library, &bearing, byte), 0.01};
        paper_table_add(table, &row);
    }
    const paper_row refused = {"viewer in a voxel of 0: refused (status)", "-", QV_ERROR_INSIDE,
                               in_the_dark(), 0};
    paper_table_add(table, &refused);
    write_curve(folder, &bearing);
}
