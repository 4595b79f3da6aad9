#include "scenes.h"
#include "papers/paper.h"
#include "scan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 48 /* voxels an axis of what is no scan */, HEAD_FACTOR = 4 };

static const double pi = 3.14159265358979323846;

/* ---- Scenes ------------------------------------------------------------------- */

static uint8_t level_of(double fraction)
{
    return (uint8_t)floor(255 * fmax(0, fmin(fraction, 1)) + .5);
}

/* Colours turn with the value; the opacity rises from 0 with a power of it. */
static void make_entries(advise_scene *made, double opacity, double power)
{
    for (unsigned value = 0; value < QV_PALETTE_ENTRIES; value++) {
        const double v = value / 255.0;
        made->entries[value][0] = paper_channel(.5 + .5 * cos(2 * pi * v));
        made->entries[value][1] = paper_channel(v);
        made->entries[value][2] = paper_channel(1 - .7 * v);
        made->entries[value][3] = paper_channel(opacity * pow(v, power));
    }
}

/* A value 0 .. 1 at a point, whose coordinates are -1 .. 1 in the volume. */
typedef double field(const double point[3]);

static double fog_field(const double p[3])
{
    return .6 + .4 * sin(3 * p[0]) * cos(2 * p[1] + p[2]);
}

static double waves_field(const double p[3])
{
    return .5 + .5 * sin(9 * p[0] + 2 * p[1]) * sin(8 * p[1] - p[2]) * cos(7 * p[2] + p[0]);
}

static double ball_field(const double p[3])
{
    const double radius = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    const double border = 3 * 2.0 / EDGE;
    const double inside = fmax(0, fmin((.8 - radius) / border + .5, 1));
    return inside * inside * (3 - 2 * inside); /* no edge where it begins and ends */
}

static void fill(advise_scene *made, field *of)
{
    uint8_t *value = made->values = paper_memory((size_t)EDGE * EDGE * EDGE, 1);
    unsigned at[3];
    for (int axis = 0; axis < 3; axis++)
        made->size[axis] = EDGE;
    for (at[2] = 0; at[2] < EDGE; at[2]++)
        for (at[1] = 0; at[1] < EDGE; at[1]++)
            for (at[0] = 0; at[0] < EDGE; at[0]++) {
                double point[3];
                for (int axis = 0; axis < 3; axis++)
                    point[axis] = (at[axis] + .5) * 2 / EDGE - 1;
                *value++ = level_of(of(point));
            }
}

static void make_head(advise_scene *made)
{
    made->values = ref_scan_reduced(made->size, HEAD_FACTOR);
    paper_require(made->values != NULL, "cannot read the head (Debian's mricron-data)");
    ref_scan_palette(made->entries);
}

void advise_scene_make(advise_scene *made, unsigned number)
{
    static const struct {
        const char *name;
        field *of; /* null: the head */
        double opacity, power;
    } scenes[ADVISE_SCENES] = {
        {"head", NULL, 0, 0},
        {"fog", fog_field, .02, 1},
        {"waves", waves_field, .5, 2},
        {"ball", ball_field, .9, 1},
    };
    made->name = scenes[number].name;
    if (scenes[number].of == NULL) {
        make_head(made);
        return;
    }
    make_entries(made, scenes[number].opacity, scenes[number].power);
    fill(made, scenes[number].of);
}

/* ---- Storages ------------------------------------------------------------------- */

static bool is_indexed(qv_storage storage)
{
    return storage == QV_STORAGE_INDEXED8 || storage == QV_STORAGE_INDEXED8_16 ||
           storage == QV_STORAGE_INDEXED8_T8 || storage == QV_STORAGE_INDEXED8_T16;
}

/* What entries of a storage are. */
static qv_storage storage_of_entries(qv_storage storage)
{
    switch (storage) {
    case QV_STORAGE_INDEXED8:
        return QV_STORAGE_RGBA8;
    case QV_STORAGE_INDEXED8_16:
        return QV_STORAGE_RGBA16;
    case QV_STORAGE_INDEXED8_T8:
        return QV_STORAGE_RGBT8;
    case QV_STORAGE_INDEXED8_T16:
        return QV_STORAGE_RGBT16;
    default:
        return storage;
    }
}

static bool is_wide(qv_storage entries)
{
    return entries == QV_STORAGE_RGBA16 || entries == QV_STORAGE_RGBT16;
}

/* The scene's entries as stored ones, where the library makes them; returns the extinction of
   the full value, which of opacities is 0. */
static uint32_t convert(void *to, const advise_scene *of, qv_storage storage, uint32_t length)
{
    const qv_entries from = {.entries = (qv_address)of->entries,
                             .count = QV_PALETTE_ENTRIES,
                             .unit_distance = QV_ONE_Q16,
                             .storage = QV_STORAGE_RGBA16};
    uint32_t extinction = 0;
    qv_status status;
    if (storage == QV_STORAGE_RGBT8 || storage == QV_STORAGE_RGBT16) {
        status = qv_extinction_of(&extinction, &from, 0);
        paper_require(status == QV_OK, "extinction");
        status =
            qv_opacity_to_extinction(to, sizeof of->entries, (uint8_t)storage, extinction, &from);
    } else if (storage == QV_STORAGE_ASSOCIATED8) {
        uint8_t straight[QV_PALETTE_ENTRIES][4];
        const qv_entries narrow = {
            .entries = straight[0], .count = QV_PALETTE_ENTRIES, .storage = QV_STORAGE_RGBA8};
        status = qv_opacity_to_opacity(straight, sizeof straight, QV_STORAGE_RGBA8, length, &from);
        paper_require(status == QV_OK, "opacity");
        status = qv_opacity_to_associated(to, sizeof of->entries, &narrow);
    } else {
        status = qv_opacity_to_opacity(to, sizeof of->entries, (uint8_t)storage, length, &from);
    }
    paper_require(status == QV_OK, "entries");
    return extinction;
}

/* A voxel of its own for each value. */
static void spread(advise_volume *made, const advise_scene *of, size_t voxels, size_t bytes)
{
    made->memory = paper_memory(voxels, bytes);
    for (size_t i = 0; i < voxels; i++)
        memcpy(made->memory + i * bytes, (uint8_t *)made->entries + of->values[i] * bytes, bytes);
}

void advise_volume_make(advise_volume *made, const advise_scene *of, qv_storage storage,
                        uint32_t unit_distance, uint32_t step)
{
    const qv_storage entries = storage_of_entries(storage);
    const size_t voxels = (size_t)of->size[0] * of->size[1] * of->size[2];
    const bool indexed = is_indexed(storage);
    const size_t entry = is_wide(entries) ? 8 : 4, bytes = indexed ? 1 : entry;
    qv_volume *volume = &made->volume;
    int32_t stride = (int32_t)bytes;
    memset(made, 0, sizeof *made);
    volume->extinction =
        convert(made->entries, of, entries, unit_distance != 0 ? unit_distance : step);
    volume->unit_distance = unit_distance;
    volume->storage = (uint8_t)storage;
    volume->voxels_bytes = voxels * bytes;
    for (int axis = 0; axis < 3; axis++) {
        volume->size[axis] = of->size[axis];
        volume->stride[axis] = stride;
        stride *= of->size[axis];
    }
    if (indexed) {
        volume->voxels = of->values;
        volume->palette = (qv_address)made->entries;
        volume->palette_bytes = (uint32_t)(QV_PALETTE_ENTRIES * entry);
    } else {
        spread(made, of, voxels, bytes);
        volume->voxels = made->memory;
    }
}

void advise_volume_free(advise_volume *made)
{
    free(made->memory);
}
