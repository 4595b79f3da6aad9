/*
 * attenuated.c - attenuation of a volume, and scenes of splats.
 */
#include "attenuated.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const qv_domain *domain_of(const qv_volume *volume)
{
    return ref_holds_extinction(volume->storage) ? &qv_domain_stored : &qv_domain_extinction;
}

/* ---- Bytes ------------------------------------------------------------------ */

static void describe(attenuated *made, const qv_volume *volume, uint32_t directions, uint8_t number)
{
    qv_attenuation *level = &made->level[number];
    for (int axis = 0; axis < 3; axis++) {
        level->size[axis] = (uint16_t)((volume->size[axis] + (1 << number) - 1) >> number);
    }
    level->directions = directions;
    level->bytes = qv_attenuation_bytes(level);
    made->bytes[number] = paper_memory((size_t)level->bytes, 1);
    level->records = made->bytes[number];
}

/* One direction of all levels; `blocks` as qv_attenuate wants them. */
static void fill(const attenuated *made, const qv_volume *volume, uint32_t *blocks,
                 uint8_t direction, uint8_t coarsest)
{
    const qv_attenuation *level = made->level;
    const qv_status status = qv_attenuate(made->bytes[0], (size_t)level->bytes, blocks, level,
                                          volume, domain_of(volume), direction);
    paper_require(status == QV_OK, qv_status_text(status));
    for (uint8_t number = 1; number <= coarsest; number++) {
        level = &made->level[number];
        paper_require(qv_attenuate_level(made->bytes[number], (size_t)level->bytes, level, blocks,
                                         volume->size, number, direction) == QV_OK,
                      "cannot attenuate a level");
    }
}

void attenuated_make(attenuated *made, const qv_volume *volume, uint32_t directions,
                     uint8_t coarsest)
{
    size_t count = 1;
    memset(made, 0, sizeof *made);
    for (int axis = 0; axis < 3; axis++) {
        count *= (size_t)(volume->size[axis] + 1) / 2;
    }
    uint32_t *blocks = paper_memory(count, sizeof *blocks);
    for (uint8_t number = 0; number <= coarsest; number++) {
        describe(made, volume, directions, number);
    }
    for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++) {
        if ((directions & ONLY(direction)) != 0) {
            fill(made, volume, blocks, direction, coarsest);
        }
    }
    free(blocks);
}

void attenuated_free(attenuated *made)
{
    for (int number = 0; number <= coarsest_level; number++) {
        free(made->bytes[number]);
        made->bytes[number] = NULL;
    }
}

uint8_t attenuated_byte(const attenuated *of, unsigned x, unsigned y, unsigned z)
{
    const uint16_t at[3] = {(uint16_t)x, (uint16_t)y, (uint16_t)z};
    return *qv_attenuation_at(&of->level[0], at);
}

/* ---- Directions --------------------------------------------------------------- */

/* Along each axis on which v is at least so long. */
static uint8_t along(const double v[3], double least)
{
    int step[3];
    for (int axis = 0; axis < 3; axis++) {
        step[axis] = fabs(v[axis]) >= least ? (v[axis] > 0) - (v[axis] < 0) : 0;
    }
    return qv_direction(step[0], step[1], step[2]);
}

/* Along its longest axis, its longest two and all three. */
uint32_t directions_around(const double v[3])
{
    uint32_t set = 0;
    for (int axis = 0; axis < 3; axis++) {
        set |= ONLY(along(v, fabs(v[axis])));
    }
    return set;
}

void to_viewer(double v[3], const qv_view *view)
{
    for (int axis = 0; axis < 3; axis++) {
        v[axis] = -ldexp(view->rotation[2][axis], -30);
    }
}

/* ---- Scenes --------------------------------------------------------------------- */

void splat_scene_make(qv_splat_scene *scene, const qv_volume *volume, const paper_view *view)
{
    double v[3];
    memset(scene, 0, sizeof *scene);
    scene->splatting = &qv_splatting_added;
    scene->kernel = &qv_kernel_quadratic;
    scene->domain = domain_of(volume);
    scene->volume = *volume;
    paper_frame(&scene->view, view);
    to_viewer(v, &scene->view);
    scene->directions = directions_around(v);
}
