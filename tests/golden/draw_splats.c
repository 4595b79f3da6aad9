/*
 * draw_splats.c - what the scenes of FreeVoxels have beside the others: a volume that leaves
 * room for the bytes of its directions, a small picture, lamps, levels.
 */
#include "splitmix.h"
#include "scenes.h"

#define DEGREES(d) ((qv_angle)((int64_t)(d)*0x100000000 / 360))
#define Q16(n, d)  ((n)*65536u / (d))

#define COUNT(table)       (sizeof(table) / sizeof *(table))
#define DRAW(state, table) random_below(state, COUNT(table))

/* Room for 26 directions. */
static const uint16_t small_sizes[][3] = {
    {5, 6, 3}, {4, 5, 5}, {9, 3, 3}, {4, 4, 4}, {5, 1, 7}, {7, 4, 3}, {3, 2, 4},
};

/* Of indexed volumes: room for 6 directions, or for those that a view and a lamp need. */
static const uint16_t large_sizes[][3] = {{8, 8, 8}, {12, 6, 5}, {7, 8, 9}};

/* The widest puts the eye into the volume. */
#define INSIDE DEGREES(120)

static const qv_angle fields_of_view[] = {0, 0, 0, DEGREES(30), DEGREES(65), INSIDE};

static const int16_t lamps[][3] = {
    {1, 2, 3}, {-30000, 0, 0}, {5, -7, 0}, {-1, -1, 1}, {17, -400, 9}, {0, 0, -1},
};

static const uint8_t interpolations[] = {QV_BETWEEN_LIGHT, QV_NEAREST, QV_BETWEEN_DEPTHS};

/* Widths in pixels, Q8.8. */
static const uint16_t details[] = {0, 0x0100, 0x0280, 0x0600, 0xFFFF};

/* Voxels of levels, their attenuation and their lit colours fit the memory of a small volume. */
static bool draw_size(golden_scene *golden, uint32_t mode, uint32_t *state)
{
    bool indexed = mode % 4 >= 2;
    bool large = indexed && golden->splats.how->splatting && random_below(state, 2) != 0;
    uint32_t size = large ? DRAW(state, large_sizes) : DRAW(state, small_sizes);
    for (unsigned axis = 0; axis < 3; axis++)
        golden->size[axis] = large ? large_sizes[size][axis] : small_sizes[size][axis];
    return large;
}

/* Within GOLDEN_SPLAT_PIXELS; the rectangle may reach beyond the frame. */
static void draw_picture(golden_scene *golden, uint32_t *state)
{
    qv_rect *rect = &golden->rect;
    rect->left = (int32_t)random_below(state, 3) - 1;
    rect->top = (int32_t)random_below(state, 3) - 1;
    rect->right = rect->left + 4 + (int32_t)random_below(state, 3);
    rect->bottom = rect->top + 4 + (int32_t)random_below(state, 3);
    golden->width = (uint16_t)(rect->right - 1 + (int32_t)random_below(state, 3));
    golden->height = (uint16_t)(rect->bottom - 1 + (int32_t)random_below(state, 3));
}

/* As many world units as the longest side has: the frame shows all of it. */
static uint32_t longest_side(const golden_scene *golden)
{
    uint32_t longest = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t spacing = golden->spacing[axis] == 0 ? QV_ONE_Q16 : golden->spacing[axis];
        uint32_t side = golden->size[axis] * spacing; /* at most 12 * 2^17 */
        longest = side > longest ? side : longest;
    }
    return longest;
}

/* An eye in the volume needs light that gets out of it. */
static void draw_eye(golden_scene *golden, uint32_t *state)
{
    golden->field_of_view = fields_of_view[DRAW(state, fields_of_view)];
    golden->pitch = longest_side(golden) / golden->height;
    if (golden->field_of_view != INSIDE)
        return;
    golden->pitch /= 2;
    golden->content = GOLDEN_THIN;
    golden->extinction = Q16(12, 1);
    if (golden->unit_distance != 0)
        golden->unit_distance = Q16(1, 2);
}

/* Of some orthographic views, only those that they need. */
static void draw_directions(golden_scene *golden, bool large, uint32_t *state)
{
    golden_splatting *splats = &golden->splats;
    bool few = golden->field_of_view == 0 && splats->how->splatting;
    splats->directions = QV_DIRECTIONS_ALL;
    splats->interpolation = interpolations[DRAW(state, interpolations)];
    if (few && (large || random_below(state, 2) != 0)) {
        splats->directions = 0;
    } else if (large) {
        splats->directions = QV_DIRECTIONS_FACES;
        splats->interpolation = QV_NEAREST;
    }
    splats->gap = (uint8_t)(splats->directions == QV_DIRECTIONS_ALL ? 0 : random_below(state, 2));
}

static void draw_levels(golden_scene *golden, uint32_t *state)
{
    static const qv_filter *const filters[] = {&qv_filter_box2, &qv_filter_quad4};
    golden_splatting *splats = &golden->splats;
    uint32_t most = qv_pyramid_levels(golden->size);
    golden->filter = filters[DRAW(state, filters)];
    splats->rebuilt = random_below(state, 2) != 0;
    splats->detail = details[DRAW(state, details)];
    if (random_below(state, 3) == 0)
        return;
    splats->coarsest = (uint8_t)random_below(state, most + 1);
    splats->level = (uint8_t)(random_below(state, 4) == 0 ? splats->coarsest : 0);
    if (golden->field_of_view == INSIDE && splats->coarsest > 1)
        splats->coarsest = 1; /* else the voxel round the eye may be all that there is */
}

/* Of a large volume at most one, for the room that its directions take. */
static void draw_lamps(qv_lighting *lighting, uint32_t most, uint32_t *state)
{
    lighting->count = (uint8_t)random_below(state, most + 1);
    for (unsigned i = 0; i < lighting->count; i++) {
        uint32_t to = DRAW(state, lamps);
        for (unsigned axis = 0; axis < 3; axis++)
            lighting->lamps[i].direction[axis] = lamps[to][axis];
        for (unsigned c = 0; c < 3; c++)
            lighting->lamps[i].colour[c] = random16(state);
    }
    for (unsigned c = 0; c < 3; c++)
        lighting->ambient[c] = random16(state) / 4;
}

void golden_draw_splats(golden_scene *golden, const golden_set *set, uint32_t mode, uint32_t *state)
{
    golden_splatting *splats = &golden->splats;
    bool large = draw_size(golden, mode, state);
    draw_picture(golden, state);
    draw_eye(golden, state);
    draw_directions(golden, large, state);
    if (splats->how->splatting)
        draw_levels(golden, state);
    draw_lamps(&splats->lighting, large ? 1 : QV_LAMPS_MAX, state);
    splats->order = set->splats->order[random_below(state, GOLDEN_ORDERS)];
    splats->lit_mode = &set->modes[mode & ~2u];
    splats->parts = (uint8_t)(2 + random_below(state, 4));
    golden->strip = (uint16_t)(golden->format == GOLDEN_MONO_VERTICAL ? 1 : 2);
}
