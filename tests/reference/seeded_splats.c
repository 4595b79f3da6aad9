#include "seeded_splats.h"

#include "draw.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* The view of a scene in the library's numbers. */
static void set_view(qv_splat_scene *scene, const ref_view *real)
{
    qv_view *view = &scene->view;
    for (int row = 0; row < 3; row++) {
        for (int axis = 0; axis < 3; axis++) {
            view->rotation[row][axis] = (int32_t)lround(ldexp(real->rotation[row][axis], 30));
        }
    }
    view->pitch = (uint32_t)lround(real->pitch * 65536);
    view->step = QV_ONE_Q16;
    view->width = (uint16_t)real->width;
    view->height = (uint16_t)real->height;
    scene->field_of_view = (qv_angle)llround(real->field_of_view / (2 * pi) * 4294967296.0);
}

/* One lamp in four shines along an axis, an edge or a corner. */
static void draw_lamp(qv_lamp *lamp, draws *random)
{
    const bool straight = draw_once_in(random, 4);
    for (int axis = 0; axis < 3; axis++) {
        const int32_t step = (int32_t)draw_below(random, 3) - 1;
        const int32_t any = (int32_t)draw_below(random, 65535) - 32767;
        lamp->direction[axis] = (int16_t)(straight ? step : any);
        lamp->colour[axis] = (uint16_t)draw_bits(random);
    }
    if (lamp->direction[0] == 0 && lamp->direction[1] == 0) {
        lamp->direction[2] = 1;
    }
}

static void draw_lighting(qv_lighting *lighting, draws *random)
{
    const bool bare = draw_once_in(random, 3);
    lighting->count = (uint8_t)(bare ? 0 : draw_below(random, QV_LAMPS_MAX + 1));
    for (int i = 0; i < lighting->count; i++) {
        draw_lamp(&lighting->lamps[i], random);
    }
    for (int channel = 0; channel < 3; channel++) {
        const uint16_t ambient = (uint16_t)draw_below(random, 0x8000);
        lighting->ambient[channel] = bare ? 0 : ambient;
    }
}

/* Sets of directions without interpolation: all, those of faces, or any with most of them. */
static uint32_t draw_directions(draws *random)
{
    const uint32_t any = QV_DIRECTIONS_FACES | draw_bits(random), kind = draw_below(random, 3);
    return kind == 0   ? QV_DIRECTIONS_ALL
           : kind == 1 ? QV_DIRECTIONS_FACES
                       : any & QV_DIRECTIONS_ALL;
}

static void draw_levels(seeded_splats *made, draws *random)
{
    const uint32_t count = (uint32_t)made->levels + 1;
    const uint32_t a = draw_below(random, count), b = draw_below(random, count);
    made->scene.level = (uint8_t)(a < b ? a : b);
    made->scene.coarsest = (uint8_t)(a < b ? b : a);
    /* widths of pixels round that of a voxel of the volume */
    made->scene.detail = (uint16_t)lround(256 * draw_scale(random, 0.5, 16));
    if (draw_once_in(random, 2)) {
        made->scene.level = made->scene.coarsest = 0;
    }
}

static void set_real(seeded_splats *made)
{
    ref_splats *real = &made->real;
    real->scene = &made->scene;
    real->view = made->drawn.view;
    real->levels = made->level;
    real->kernel = made->scene.kernel == &qv_kernel_linear ? 2 : 3;
    real->inside = ref_splat_eye(real->eye, real);
}

qv_status seeded_splats_make(seeded_splats *made, uint32_t seed, qv_storage storage)
{
    draws random = draw_seeded(seed ^ 0x5a5a5a5au); /* apart from those of the volume */
    qv_splat_scene *scene = &made->scene;
    memset(made, 0, sizeof *made);
    qv_status status = seeded_make_by_length(&made->drawn, seed, storage);
    if (status == QV_OK) {
        status = seeded_add_pyramid(&made->drawn, seed);
    }
    if (status != QV_OK) {
        return status;
    }
    made->levels = made->drawn.pyramid.levels;
    for (int level = 0; level <= made->levels; level++) {
        ref_pyramid_level(&made->level[level], &made->drawn.scene, level);
    }
    set_view(scene, &made->drawn.view);
    scene->volume = made->drawn.scene.volume;
    scene->kernel = draw_once_in(&random, 2) ? &qv_kernel_linear : &qv_kernel_quadratic;
    scene->domain =
        ref_holds_extinction(scene->volume.storage) ? &qv_domain_stored : &qv_domain_extinction;
    scene->interpolation = draw_once_in(&random, 4)   ? QV_NEAREST
                           : draw_once_in(&random, 4) ? QV_BETWEEN_DEPTHS
                                                      : QV_BETWEEN_LIGHT;
    scene->directions = draw_directions(&random);
    if (scene->interpolation != QV_NEAREST) {
        scene->directions = QV_DIRECTIONS_ALL;
    }
    memcpy(scene->background, made->drawn.scene.background, sizeof scene->background);
    draw_levels(made, &random);
    draw_lighting(&scene->lighting, &random);
    set_real(made);
    return QV_OK;
}

void seeded_splats_free(seeded_splats *made)
{
    seeded_free(&made->drawn);
}
