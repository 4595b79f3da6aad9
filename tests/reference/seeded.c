#include "seeded.h"
#include "draw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* From where scenes are drawn. */
typedef struct ranges {
    double least_spacing, most_spacing;
    double most_step;       /* world units; the least is 1/16 */
    const uint8_t *filling; /* 8 kinds, equally likely */
} ranges;

/* ---- The view ----------------------------------------------------------- */

static uint32_t to_q16(double value)
{
    return (uint32_t)floor(value * 65536 + 0.5);
}

/* Any angle; one in four is a multiple of 45 degrees, where ties and faces meet samples. */
static qv_angle draw_angle(draws *random)
{
    const qv_angle angle = draw_bits(random);
    return draw_once_in(random, 4) ? angle & 0xe0000000u : angle;
}

static double diagonal(const qv_volume *volume)
{
    double sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double edge = volume->size[axis] * (volume->spacing[axis] / 65536.0);
        sum += edge * edge;
    }
    return sqrt(sum);
}

/* The same view twice: as the library takes it and in real numbers. */
static void draw_view(qv_view *view, ref_view *real, const qv_volume *volume, double most_step,
                      draws *random)
{
    const qv_angle azimuth = draw_angle(random);
    const qv_angle elevation = draw_angle(random);
    const qv_angle roll = draw_angle(random);
    const uint32_t longest = SEEDED_MOST_EDGE, shortest = 24; /* pixels of an edge */
    view->width = (uint16_t)(shortest + draw_below(random, longest - shortest));
    view->height = (uint16_t)(shortest + draw_below(random, longest - shortest));
    view->pitch = to_q16(diagonal(volume) / longest * draw_real(random, 0.3, 0.9));
    view->step = to_q16(draw_scale(random, 1.0 / 16, most_step));
    qv_rotation(view->rotation, azimuth, elevation, roll);
    ref_rotation(real->rotation, azimuth, elevation, roll);
    real->pitch = view->pitch / 65536.0;
    real->step = view->step / 65536.0;
    real->width = view->width;
    real->height = view->height;
}

static qv_status draw_camera(seeded_scene *made, double most_step, draws *random)
{
    qv_camera *camera = &made->scene.camera;
    qv_view view;
    draw_view(&view, &made->view, &made->scene.volume, most_step, random);
    if (draw_once_in(random, 2)) {
        made->view.field_of_view = 0;
        return qv_orthographic(camera, &made->scene.volume, &view);
    }
    const double degrees = draw_real(random, 5, 120);
    const qv_angle angle = (qv_angle)(degrees / 360 * 4294967296.0);
    made->view.field_of_view = angle / 4294967296.0 * 2 * pi;
    return qv_perspective(camera, &made->scene.volume, &view, angle);
}

static void draw_background(uint8_t background[4], draws *random)
{
    const bool transparent = draw_once_in(random, 2);
    for (int channel = 0; channel < 4; channel++) {
        const uint8_t level = (uint8_t)draw_below(random, 256);
        background[channel] = transparent ? 0 : level;
    }
}

/* ---- The volume's shape ------------------------------------------------- */

static void draw_size(qv_volume *volume, const ranges *of, draws *random)
{
    const bool cubic = draw_once_in(random, 3), flat = draw_once_in(random, 5);
    const uint32_t thin = draw_below(random, 3);
    for (uint32_t axis = 0; axis < 3; axis++) {
        const uint32_t size = 2 + draw_below(random, SEEDED_LONGEST_AXIS - 1);
        const double spacing = draw_scale(random, of->least_spacing, of->most_spacing);
        volume->size[axis] = (uint16_t)(flat && axis == thin ? 1 : size);
        volume->spacing[axis] = cubic ? QV_ONE_Q16 : to_q16(spacing);
    }
}

static uint32_t voxel_bytes(uint8_t storage)
{
    return ref_is_indexed(storage) ? 1 : ref_is_wide(storage) ? 8 : 4;
}

/*
 * Lays the axes out in a drawn order with drawn gaps between their rows, and
 * lets some run downwards. Returns the offset of voxel (0,0,0).
 */
static size_t draw_strides(qv_volume *volume, draws *random)
{
    uint32_t order[3] = {0, 1, 2}, extent = voxel_bytes(volume->storage);
    size_t first = 0;
    for (uint32_t level = 0; level < 3; level++) {
        const uint32_t pick = level + draw_below(random, 3 - level);
        const uint32_t axis = order[pick];
        order[pick] = order[level];
        const uint32_t unit = ref_is_associated(volume->storage) ? 4 : 2; /* of alignment */
        const uint32_t gap = unit * draw_below(random, 4);
        const uint32_t stride = extent + gap, reach = stride * (volume->size[axis] - 1u);
        const bool downwards = draw_once_in(random, 3);
        volume->stride[axis] = downwards ? -(int32_t)stride : (int32_t)stride;
        first += downwards ? reach : 0;
        extent += reach;
    }
    volume->voxels_bytes = extent;
    return first;
}

/* ---- What fills it ------------------------------------------------------ */

typedef struct wave {
    double turns[3]; /* per voxel */
    double phase;
} wave;

typedef enum filling_kind { NOISE, WAVES, SPARSE, CONSTANT, WALLS, FILLINGS } filling_kind;

typedef struct filling {
    filling_kind kind;
    uint32_t thinning; /* opacities are shifted right by this */
    uint16_t constant[4];
    wave waves[4];
} filling;

static const char *const filling_names[FILLINGS] = {"noise", "waves", "sparse", "constant",
                                                    "walls"};

static const uint8_t without_lengths[8] = {NOISE, NOISE, NOISE,  WAVES,
                                           WAVES, WAVES, SPARSE, CONSTANT};
static const uint8_t with_lengths[8] = {NOISE, NOISE, WAVES, WAVES, WAVES, SPARSE, CONSTANT, WALLS};

static const ranges by_step = {0.4, 2.5, 4, without_lengths};
static const ranges by_length = {0.5, 2, 16, with_lengths};

static void draw_filling(filling *drawn, const uint8_t kinds[8], draws *random)
{
    drawn->kind = (filling_kind)kinds[draw_below(random, 8)];
    drawn->thinning = draw_below(random, 7);
    for (int channel = 0; channel < 4; channel++) {
        drawn->constant[channel] = (uint16_t)(0x4000u | draw_bits(random)); /* never empty */
        for (int axis = 0; axis < 3; axis++) {
            drawn->waves[channel].turns[axis] = draw_real(random, -0.1, 0.1);
        }
        drawn->waves[channel].phase = draw_real(random, 0, 1);
    }
}

static uint16_t wave_height(const wave *w, const int32_t at[3])
{
    const double turns = w->turns[0] * at[0] + w->turns[1] * at[1] + w->turns[2] * at[2];
    return (uint16_t)(32767.5 + 32767.5 * sin(2 * pi * (turns + w->phase)));
}

/* One colour of 16 bits a channel, at a voxel or, for palettes, along a line of entries. */
static void draw_colour(uint16_t rgba[4], const filling *from, const int32_t at[3], draws *random)
{
    for (int channel = 0; channel < 4; channel++) {
        const uint16_t noise = (uint16_t)draw_bits(random);
        const uint16_t height = wave_height(&from->waves[channel], at);
        rgba[channel] = from->kind == WAVES      ? height
                        : from->kind == CONSTANT ? from->constant[channel]
                                                 : noise;
    }
    rgba[3] = (uint16_t)(rgba[3] >> from->thinning);
    const bool thin = from->kind == SPARSE || from->kind == WALLS;
    const bool empty = thin && !draw_once_in(random, 8);
    if (empty) {
        rgba[3] = 0;
    } else if (from->kind == WALLS) {
        rgba[3] = UINT16_MAX;
    }
}

static void store8(unsigned char *bytes, const uint16_t rgba[4])
{
    for (int channel = 0; channel < 4; channel++) {
        bytes[channel] = (unsigned char)(rgba[channel] >> 8);
    }
}

static void store16(unsigned char *bytes, const uint16_t rgba[4])
{
    memcpy(bytes, rgba, 8);
}

/* Colours weighted by the opacity of 8 bits, to nearest. */
static void store_associated(unsigned char *bytes, const uint16_t rgba[4])
{
    const double opacity = rgba[3] >> 8;
    for (int channel = 0; channel < 3; channel++) {
        bytes[channel] = (unsigned char)floor((rgba[channel] >> 8) * opacity / 255 + 0.5);
    }
    bytes[3] = (unsigned char)opacity;
}

static void store_voxel(unsigned char *voxel, uint8_t storage, const uint16_t rgba[4])
{
    if (ref_is_indexed(storage)) {
        *voxel = (unsigned char)(rgba[0] >> 8);
    } else if (ref_is_wide(storage)) {
        store16(voxel, rgba);
    } else if (ref_is_associated(storage)) {
        store_associated(voxel, rgba);
    } else {
        store8(voxel, rgba);
    }
}

static void fill_voxels(unsigned char *origin, const qv_volume *volume, const filling *from,
                        draws *random)
{
    int32_t at[3];
    uint16_t rgba[4];
    for (at[2] = 0; at[2] < volume->size[2]; at[2]++) {
        for (at[1] = 0; at[1] < volume->size[1]; at[1]++) {
            for (at[0] = 0; at[0] < volume->size[0]; at[0]++) {
                const ptrdiff_t offset = (ptrdiff_t)at[0] * volume->stride[0] +
                                         (ptrdiff_t)at[1] * volume->stride[1] +
                                         (ptrdiff_t)at[2] * volume->stride[2];
                draw_colour(rgba, from, at, random);
                store_voxel(origin + offset, volume->storage, rgba);
            }
        }
    }
}

static void fill_palette(seeded_scene *made, const filling *from, draws *random)
{
    const bool wide = ref_is_wide(made->scene.volume.storage);
    for (int32_t entry = 0; entry < QV_PALETTE_ENTRIES; entry++) {
        const int32_t at[3] = {entry, 0, 0};
        uint16_t rgba[4];
        draw_colour(rgba, from, at, random);
        if (wide) {
            store16(made->palette + 8 * entry, rgba);
        } else {
            store8(made->palette + 4 * entry, rgba);
        }
    }
    made->scene.volume.palette = made->palette;
    made->scene.volume.palette_bytes = wide ? QV_PALETTE16_BYTES : QV_PALETTE8_BYTES;
}

/* ---- All together ------------------------------------------------------- */

static qv_status make(seeded_scene *made, draws *random, qv_storage storage, const ranges *of)
{
    qv_volume *volume = &made->scene.volume;
    filling from;
    memset(made, 0, sizeof *made);
    draw_size(volume, of, random);
    draw_background(made->scene.background, random);
    const uint16_t phase = (uint16_t)draw_bits(random);
    made->scene.phase = draw_once_in(random, 3) ? 0 : phase;
    const qv_status status = draw_camera(made, of->most_step, random);
    volume->storage = (uint8_t)storage;
    const size_t first = draw_strides(volume, random);
    made->memory = malloc((size_t)volume->voxels_bytes);
    if (made->memory == NULL) {
        return QV_ERROR_NULL;
    }
    memset(made->memory, 0xff, (size_t)volume->voxels_bytes); /* gaps must not be read */
    volume->voxels = made->memory + first;
    draw_filling(&from, of->filling, random);
    made->filling = filling_names[from.kind];
    fill_voxels(made->memory + first, volume, &from, random);
    if (ref_is_indexed(volume->storage)) {
        fill_palette(made, &from, random);
    }
    return status;
}

qv_status seeded_make(seeded_scene *made, uint32_t seed, qv_storage storage)
{
    draws random = draw_seeded(seed);
    return make(made, &random, storage, &by_step);
}

/* Keeps full opacity to a depth of 64 for a piece: more would make pixels of the last bits
   of weights. */
static void limit_depth(qv_scene *scene, int level)
{
    const uint32_t longest = scene->camera.step << level;
    if (scene->volume.unit_distance < longest) {
        scene->volume.unit_distance = longest;
    }
}

qv_status seeded_make_by_length(seeded_scene *made, uint32_t seed, qv_storage storage)
{
    draws random = draw_seeded(seed);
    const double ratio = draw_scale(&random, 1.0 / 16, 16);
    const double depth = draw_scale(&random, 1.0 / 16, SEEDED_MOST_EXTINCTION);
    const bool same = draw_once_in(&random, 4), named = draw_once_in(&random, 2);
    const qv_status status = make(made, &random, storage, &by_length);
    qv_volume *volume = &made->scene.volume;
    volume->unit_distance = to_q16((same ? 1 : ratio) * made->view.step);
    if (same && !named) {
        volume->unit_distance = 0; /* the step too */
    }
    if (made->filling == filling_names[WALLS]) {
        limit_depth(&made->scene, 0);
    }
    volume->extinction = to_q16(depth);
    return status;
}

/* ---- Coarser levels, filled like volumes rather than made from them --------- */

/* Steps from the eye to the centre of the volume. */
static double steps_to_centre(const seeded_scene *made)
{
    const qv_scene *scene = &made->scene;
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double eye = (double)scene->camera.origin[axis] / 4294967296.0;
        const double way = scene->volume.size[axis] / 2.0 - eye;
        square += pow(way * (scene->volume.spacing[axis] / 65536.0), 2);
    }
    return sqrt(square) / made->view.step;
}

/* The level to be sampled; in perspective it may rise with the distance. */
static void draw_level(seeded_scene *made, draws *random)
{
    const uint32_t between = draw_below(random, made->pyramid.levels * 256u + 1);
    const bool whole = draw_once_in(random, 3), rises = !draw_once_in(random, 3);
    const double part = draw_scale(random, 0.1, 2);
    made->scene.level = (uint16_t)(whole ? between & 0xff00u : between);
    if (rises && made->view.field_of_view > 0) {
        made->scene.level = (uint16_t)(draw_once_in(random, 3) ? between : 0);
        made->scene.level_distance = (uint32_t)ceil(part * steps_to_centre(made));
    }
}

qv_status seeded_add_pyramid(seeded_scene *made, uint32_t seed)
{
    draws random = draw_seeded(~seed); /* apart from the draws of the volume */
    qv_pyramid *pyramid = &made->pyramid;
    qv_volume level = made->scene.volume;
    filling from;
    made->scene.pyramid = pyramid;
    while (level.size[0] > 1 || level.size[1] > 1 || level.size[2] > 1) {
        ref_pyramid_level(&level, &made->scene, ++pyramid->levels);
        pyramid->bytes += level.voxels_bytes;
    }
    made->coarser = malloc((size_t)pyramid->bytes + 1); /* a volume of one voxel has none */
    if (made->coarser == NULL) {
        return QV_ERROR_NULL;
    }
    pyramid->voxels = made->coarser;
    draw_filling(&from, with_lengths, &random);
    unsigned char *next = made->coarser;
    for (int number = 1; number <= pyramid->levels; number++) {
        ref_pyramid_level(&level, &made->scene, number);
        fill_voxels(next, &level, &from, &random);
        next += level.voxels_bytes;
    }
    if (from.kind == WALLS || made->filling == filling_names[WALLS]) {
        limit_depth(&made->scene, pyramid->levels);
    }
    draw_level(made, &random);
    return QV_OK;
}

void seeded_free(seeded_scene *made)
{
    free(made->memory);
    free(made->coarser);
    made->memory = NULL;
    made->coarser = NULL;
}
