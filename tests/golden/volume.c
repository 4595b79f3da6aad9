/*
 * volume.c - seeded volumes of every storage and layout.
 */
#include "splitmix.h"
#include "scenes.h"

/* ---- Colours -------------------------------------------------------------- */

static uint16_t random_opacity(uint32_t *state, golden_content content)
{
    uint16_t any = random16(state);
    switch (content) {
    case GOLDEN_THIN:
        return any >> 6; /* up to 3 of 255 */
    case GOLDEN_BALL:
        return any | 0xC000u;
    case GOLDEN_SHELL:
        return any | 0x0100u; /* seen in 8 bits too */
    default:
        return any < 0x4000u ? 0 : any >> 1;
    }
}

static void random_colour(uint16_t rgba[4], uint32_t *state, golden_content content)
{
    for (unsigned channel = 0; channel < 3; channel++)
        rgba[channel] = random16(state);
    rgba[3] = random_opacity(state, content);
}

/* A palette whose entry 0 is transparent. */
static void random_palette(golden_memory *memory, uint32_t *state, golden_content content)
{
    for (unsigned entry = 0; entry < QV_PALETTE_ENTRIES; entry++)
        random_colour(memory->table.rgba[entry], state, content);
    memory->table.rgba[0][3] = 0;
    qv_transfer_to_palette8(memory->palette, &memory->table);
}

/* ---- Shapes --------------------------------------------------------------- */

/* Squared distance from the centre of the volume, where the faces of the box lie
   at 1: with 12 fraction bits, at most 3 * 4096. */
static uint32_t squared_distance(const golden_scene *golden, const uint16_t at[3])
{
    uint32_t sum = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        int32_t n = golden->size[axis];
        int32_t from_centre = (2 * at[axis] + 1 - n) * 64 / n; /* within +-64 */
        sum += (uint32_t)(from_centre * from_centre);
    }
    return sum;
}

static bool is_filled(const golden_scene *golden, const uint16_t at[3])
{
    uint32_t distance = squared_distance(golden, at);
    switch (golden->content) {
    case GOLDEN_SHELL:
        return distance > 1500 && distance < 4096;
    case GOLDEN_BALL:
        return distance < 3500;
    default:
        return true;
    }
}

/* ---- Memory --------------------------------------------------------------- */

/* The storage with opacity for extinction, which looks the same in memory; or with colours that
   are still to be weighted. */
static uint8_t with_opacity(const golden_scene *golden)
{
    uint8_t storage = QV_FIELD(golden->mode->sampling, storage);
    if (storage == QV_STORAGE_ASSOCIATED8)
        return QV_STORAGE_RGBA8;
    return storage < QV_STORAGE_RGBT8 ? storage : (uint8_t)(storage - QV_STORAGE_INDEXED8_16);
}

static uint32_t voxel_bytes(uint8_t storage)
{
    switch (storage) {
    case QV_STORAGE_RGBA8:
        return 4;
    case QV_STORAGE_RGBA16:
        return 8;
    default:
        return 1;
    }
}

/* The strides of a layout, and where voxel (0,0,0) lies; false where the volume
   does not fit. Sizes are small: a volume has at most GOLDEN_VOXEL_BYTES. */
static bool lay_out(qv_volume *volume, golden_memory *memory, const golden_scene *golden)
{
    const uint16_t *size = golden->size;
    int32_t bytes = (int32_t)voxel_bytes(with_opacity(golden));
    bool transposed = golden->layout == GOLDEN_TRANSPOSED;
    bool mirrored = golden->layout == GOLDEN_MIRRORED;
    int32_t gap = golden->layout == GOLDEN_PADDED ? 2 * bytes : 0;
    unsigned fastest = transposed ? 2 : 0, slowest = transposed ? 0 : 2;
    int32_t row = size[fastest] * bytes + gap;
    int32_t slice = size[1] * row + gap;
    int32_t first = mirrored ? (size[1] - 1) * row + (size[slowest] - 1) * slice : 0;
    int32_t total = size[slowest] * slice;
    if (total > GOLDEN_VOXEL_BYTES)
        return false;
    volume->stride[fastest] = bytes;
    volume->stride[1] = mirrored ? -row : row;
    volume->stride[slowest] = mirrored ? -slice : slice;
    volume->voxels = (qv_address)memory->voxels + first;
    volume->voxels_bytes = (uint64_t)total;
    return true;
}

static void store_voxel(uint8_t *voxel, uint8_t storage, const uint16_t rgba[4], uint8_t index)
{
    for (unsigned channel = 0; channel < 4; channel++) {
        if (storage == QV_STORAGE_RGBA8)
            voxel[channel] = (uint8_t)(rgba[channel] >> 8);
        else if (storage == QV_STORAGE_RGBA16)
            ((uint16_t *)(void *)voxel)[channel] = rgba[channel];
    }
    if (storage == QV_STORAGE_INDEXED8 || storage == QV_STORAGE_INDEXED8_16)
        voxel[0] = index;
}

static void random_voxel(uint8_t *voxel, uint32_t *state, const golden_scene *golden,
                         const uint16_t at[3])
{
    uint16_t rgba[4];
    random_colour(rgba, state, golden->content);
    uint8_t index = (uint8_t)(1 + random_below(state, 255));
    if (!is_filled(golden, at)) {
        rgba[3] = 0;
        index = 0;
    }
    store_voxel(voxel, with_opacity(golden), rgba, index);
}

static void random_voxels(golden_memory *memory, const qv_volume *volume, uint32_t *state,
                          const golden_scene *golden)
{
    uint8_t *first = (uint8_t *)memory->voxels + (volume->voxels - (qv_address)memory->voxels);
    uint16_t at[3];
    for (at[2] = 0; at[2] < golden->size[2]; at[2]++) {
        for (at[1] = 0; at[1] < golden->size[1]; at[1]++) {
            for (at[0] = 0; at[0] < golden->size[0]; at[0]++) {
                int32_t offset = at[0] * volume->stride[0] + at[1] * volume->stride[1] +
                                 at[2] * volume->stride[2];
                random_voxel(first + offset, state, golden, at);
            }
        }
    }
}

/* ---- Classified scalars --------------------------------------------------- */

/* A bright centre with some noise: 12288 at the centre, about 0 in the corners. */
static bool make_scalars(golden_memory *memory, uint32_t *state, const golden_scene *golden)
{
    uint16_t at[3];
    uint32_t i = 0;
    if (golden->size[0] * golden->size[1] * golden->size[2] > GOLDEN_SCALARS)
        return false;
    for (at[2] = 0; at[2] < golden->size[2]; at[2]++) {
        for (at[1] = 0; at[1] < golden->size[1]; at[1]++) {
            for (at[0] = 0; at[0] < golden->size[0]; at[0]++) {
                uint32_t noise = random16(state) >> 6;
                memory->scalars[i++] = (uint16_t)(3 * 4096 - squared_distance(golden, at) + noise);
            }
        }
    }
    return true;
}

static qv_status classify(golden_memory *memory, uint32_t *state, const golden_scene *golden)
{
    static const qv_control_point points[] = {
        {60, {50000, 20000, 10000, 0}},
        {120, {60000, 40000, 30000, 3000}},
        {180, {30000, 50000, 60000, 20000}},
        {255, {65535, 65535, 60000, 60000}},
    };
    static const qv_shading shading = {
        .light = {-300, -500, 400},
        .viewer = {0, -1, 0},
        .ambient = 80,
        .diffuse = 170,
        .specular = 60,
        .gloss = 4,
        .least_gradient = 2,
    };
    const uint16_t *size = golden->size;
    qv_classifier classifier = {
        .scalars = {.values = (qv_address)memory->scalars,
                    .values_bytes = sizeof memory->scalars,
                    .stride = {2, 2 * size[0], 2 * size[0] * size[1]},
                    .size = {size[0], size[1], size[2]},
                    .type = QV_SCALAR_U16},
        .low = 2000,
        .high = 13000,
        .transfer = &memory->table,
        .shading = &shading,
    };
    const qv_block whole = {{0, 0, 0}, {size[0], size[1], size[2]}};
    qv_status status = qv_transfer_build(&memory->table, points, sizeof points / sizeof *points);
    if (status != QV_OK)
        return status;
    if (!make_scalars(memory, state, golden))
        return QV_ERROR_BUFFER;
    for (unsigned axis = 0; axis < 3; axis++)
        classifier.scalars.spacing[axis] = golden->spacing[axis];
    qv_transfer_to_palette8(memory->palette, &memory->table);
    return qv_classify(memory->voxels, sizeof memory->voxels, with_opacity(golden), &classifier,
                       &whole);
}

/* ---- The volume ----------------------------------------------------------- */

static void attach_palette(qv_volume *volume, golden_memory *memory, uint8_t storage)
{
    if (storage == QV_STORAGE_INDEXED8) {
        volume->palette = (qv_address)memory->palette;
        volume->palette_bytes = sizeof memory->palette;
    } else if (storage == QV_STORAGE_INDEXED8_16) {
        volume->palette = (qv_address)&memory->table;
        volume->palette_bytes = sizeof memory->table;
    }
}

static qv_status fill(qv_volume *volume, golden_memory *memory, const golden_scene *golden)
{
    uint32_t state = golden->seed;
    if (golden->content == GOLDEN_CLASSIFIED)
        return classify(memory, &state, golden);
    random_palette(memory, &state, golden->content);
    random_voxels(memory, volume, &state, golden);
    return QV_OK;
}

/* All of the memory, gaps too. */
static qv_status weight_colours(golden_memory *memory)
{
    const qv_entries all = {.entries = (qv_address)memory->voxels,
                            .count = sizeof memory->voxels / 4,
                            .storage = QV_STORAGE_RGBA8};
    return qv_opacity_to_associated(memory->voxels, sizeof memory->voxels, &all);
}

qv_status golden_volume(qv_volume *volume, golden_memory *memory, const golden_scene *golden)
{
    *volume = (qv_volume){.storage = QV_FIELD(golden->mode->sampling, storage),
                          .unit_distance = golden->unit_distance,
                          .extinction = golden->extinction};
    for (unsigned axis = 0; axis < 3; axis++) {
        volume->size[axis] = golden->size[axis];
        volume->spacing[axis] = golden->spacing[axis];
    }
    attach_palette(volume, memory, with_opacity(golden));
    if (!lay_out(volume, memory, golden))
        return QV_ERROR_BUFFER;
    qv_status status = fill(volume, memory, golden);
    if (status == QV_OK && volume->storage == QV_STORAGE_ASSOCIATED8)
        status = weight_colours(memory);
    return status;
}

/* ---- The pyramid ------------------------------------------------------------ */

/* Opacities are averaged as extinction where the mode samples them so. */
static const qv_domain *find_domain(const qv_volume *volume, const golden_scene *golden)
{
    bool extinction = golden->mode->family == GOLDEN_EXTINCTION ||
                      golden->mode->family == GOLDEN_BSPLINE_EXTINCTION;
    return extinction && volume->storage < QV_STORAGE_RGBT8 ? &qv_domain_extinction
                                                            : &qv_domain_stored;
}

qv_status golden_pyramid(golden_memory *memory, const qv_volume *volume, const golden_scene *golden)
{
    qv_pyramid *pyramid = &memory->pyramid;
    uint8_t levels = qv_pyramid_levels(volume->size);
    *pyramid = (qv_pyramid){(qv_address)memory->scalars, sizeof memory->scalars, levels};
    for (uint8_t number = 1; number <= levels; number++) {
        qv_volume finer, level;
        qv_status status = qv_pyramid_level(&finer, volume, pyramid, (uint8_t)(number - 1));
        if (status == QV_OK)
            status = qv_pyramid_level(&level, volume, pyramid, number);
        if (status != QV_OK)
            return status;
        size_t before = (size_t)(level.voxels - pyramid->voxels);
        status =
            qv_downsample((uint8_t *)memory->scalars + before, sizeof memory->scalars - before,
                          &finer, golden->filter, find_domain(volume, golden), 0, level.size[2]);
        if (status != QV_OK)
            return status;
    }
    return QV_OK;
}
