/*
 * render_splats.c - a golden scene of FreeVoxels, in four ways that divide the picture and the
 * voxels, and take the voxels in different orders: splats, or lit voxels that rays see.
 */
#include "crc32.h"
#include "scenes.h"

/* Levels of the largest volume, with level 0. */
enum { LEVELS_MOST = 5 };

/* Larger than any volume, and a prime: multiples of it reach every voxel. */
enum { STRIDE = 521 };

/* What is left of memory->voxels. */
typedef struct arena {
    uint8_t *next, *end;
} arena;

typedef struct frame {
    const golden_scene *golden;
    golden_memory *memory;
    golden_way way;
    uint32_t checksum; /* of the sums so far: rows come from the top, whatever the parts */
    uint8_t levels;    /* with level 0 */
    qv_volume volume[LEVELS_MOST];
    qv_attenuation attenuation[LEVELS_MOST];
    qv_splats splats;
} frame;

/* ---- Memory ------------------------------------------------------------------- */

/* Null where so many bytes are not left. Addresses are even. */
static uint8_t *take(arena *a, uint64_t bytes)
{
    uint8_t *taken = a->next;
    if (bytes > (uint64_t)(a->end - a->next))
        return NULL;
    a->next += (bytes + 1) / 2 * 2;
    return taken;
}

/* What the volume has left. */
static arena arena_of(golden_memory *memory, const qv_volume *volume)
{
    uint8_t *first = (uint8_t *)memory->voxels;
    arena a = {first, first + sizeof memory->voxels};
    (void)take(&a, volume->voxels_bytes);
    return a;
}

/* ---- Attenuation ---------------------------------------------------------------- */

static const qv_domain *domain_of(const qv_volume *volume)
{
    return volume->storage < QV_STORAGE_RGBT8 ? &qv_domain_extinction : &qv_domain_stored;
}

/* Makes the bytes of one direction on all levels. Of level 0 there are blocks where the other
   levels are made of them. */
static qv_status attenuate(frame *f, uint8_t direction)
{
    bool rebuilt = f->golden->splats.rebuilt;
    uint32_t *blocks = f->memory->sums[0];
    qv_status status = QV_OK;
    for (uint8_t l = 0; l < f->levels && status == QV_OK; l++) {
        const qv_attenuation *to = &f->attenuation[l];
        uint8_t *bytes =
            (uint8_t *)f->memory->voxels + (to->records - (qv_address)f->memory->voxels);
        const qv_volume *volume = &f->volume[l];
        if (l == 0 || rebuilt)
            status = qv_attenuate(bytes, (size_t)to->bytes, rebuilt ? NULL : blocks, to, volume,
                                  domain_of(volume), direction);
        else
            status = qv_attenuate_level(bytes, (size_t)to->bytes, to, blocks, f->volume[0].size, l,
                                        direction);
    }
    return status;
}

static qv_status make_attenuation(frame *f, arena *a, uint32_t directions)
{
    qv_status status = QV_OK;
    for (unsigned l = 0; l < f->levels; l++) {
        qv_attenuation *level = &f->attenuation[l];
        *level = (qv_attenuation){.order = f->golden->splats.order, .directions = directions};
        level->record = (uint16_t)(qv_directions_count(directions) + f->golden->splats.gap);
        for (unsigned axis = 0; axis < 3; axis++)
            level->size[axis] = f->volume[l].size[axis];
        level->bytes = qv_attenuation_bytes(level);
        level->records = take(a, level->bytes);
        if (!level->records)
            return QV_ERROR_BUFFER;
    }
    for (uint8_t direction = 0; direction < QV_DIRECTIONS && status == QV_OK; direction++)
        if ((directions >> direction & 1u) != 0)
            status = attenuate(f, direction);
    return status;
}

/* ---- Scenes --------------------------------------------------------------------- */

static qv_status make_volumes(frame *f)
{
    qv_status status = golden_volume(&f->volume[0], f->memory, f->golden);
    f->levels = 1;
    if (f->golden->splats.coarsest == 0 || status != QV_OK)
        return status;
    f->levels = (uint8_t)(1 + qv_pyramid_levels(f->golden->size));
    status = golden_pyramid(f->memory, &f->volume[0], f->golden);
    for (uint8_t l = 1; l < f->levels && status == QV_OK; l++)
        status = qv_pyramid_level(&f->volume[l], &f->volume[0], &f->memory->pyramid, l);
    return status;
}

/* The least set that the scene is content with: directions go one by one. */
static uint32_t find_directions(frame *f, qv_splat_scene *scene)
{
    uint32_t left = QV_DIRECTIONS_ALL;
    for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++) {
        scene->directions = left & ~((uint32_t)1 << direction);
        if (qv_splat_init(&f->splats, scene) == QV_OK)
            left = scene->directions;
    }
    return left;
}

static void describe(qv_splat_scene *scene, const frame *f)
{
    const golden_scene *golden = f->golden;
    const golden_splatting *splats = &golden->splats;
    *scene = (qv_splat_scene){.splatting = splats->how->splatting,
                              .kernel = splats->how->kernel,
                              .domain = domain_of(&f->volume[0]),
                              .directions = splats->directions,
                              .field_of_view = golden->field_of_view,
                              .interpolation = splats->interpolation,
                              .level = splats->level,
                              .coarsest = splats->coarsest,
                              .detail = splats->detail,
                              .lighting = splats->lighting,
                              .volume = f->volume[0]};
    for (unsigned channel = 0; channel < 4; channel++)
        scene->background[channel] = golden->background[channel];
    golden_view(&scene->view, golden);
}

static qv_status make_splats(frame *f)
{
    qv_splat_scene scene;
    uint16_t eye[3];
    qv_status status = make_volumes(f);
    if (status != QV_OK)
        return status;
    describe(&scene, f);
    if (scene.directions == 0)
        scene.directions = find_directions(f, &scene);
    arena a = arena_of(f->memory, &f->volume[0]);
    status = make_attenuation(f, &a, scene.directions);
    if (qv_splat_eye(eye, &scene))
        scene.inside = qv_attenuation_at(&f->attenuation[0], eye);
    return status == QV_OK ? qv_splat_init(&f->splats, &scene) : status;
}

/* ---- Voxels ----------------------------------------------------------------------- */

/* Voxels of a level, each at the multiple of the stride: some of them. */
typedef struct stream {
    const frame *f;
    uint32_t next, between; /* the first of them, and from one to the next */
    uint8_t level;
} stream;

static uint32_t count_voxels(const qv_volume *volume)
{
    return (uint32_t)volume->size[0] * volume->size[1] * volume->size[2];
}

static int next_voxel(void *user, qv_freevoxel *voxel)
{
    stream *s = user;
    const qv_volume *volume = &s->f->volume[s->level];
    const qv_attenuation *attenuation = &s->f->attenuation[s->level];
    uint32_t count = count_voxels(volume);
    if (s->next >= count)
        return 0;
    qv_status status = qv_order_position(voxel->position, attenuation->order, volume->size,
                                         s->next * STRIDE % count);
    voxel->voxel = volume->voxels;
    for (unsigned axis = 0; axis < 3; axis++)
        voxel->voxel += (qv_offset)volume->stride[axis] * (qv_offset)voxel->position[axis];
    voxel->attenuation = qv_attenuation_at(attenuation, voxel->position);
    voxel->level = s->level;
    s->next += s->between;
    return status == QV_OK ? 1 : (int)status;
}

/* All levels, from the coarsest; of each every `between`th voxel. */
static qv_status add_streams(const frame *f, const qv_sums *sums, uint32_t first, uint32_t between)
{
    qv_status status = QV_OK;
    for (unsigned l = f->levels; l-- > 0 && status == QV_OK;) {
        stream s = {f, first, between, (uint8_t)l};
        status = qv_splat_stream(sums, &f->splats, next_voxel, &s);
    }
    return status;
}

/* Parts of the voxels, each in sums of its own, which are then added. */
static qv_status add_parts(const frame *f, const qv_sums *sums)
{
    const qv_sums part = {f->memory->sums[1], GOLDEN_SUMS, sums->rect};
    uint32_t parts = f->golden->splats.parts;
    qv_status status = QV_OK;
    for (uint32_t i = 0; i < parts && status == QV_OK; i++) {
        status = qv_sums_clear(&part, &f->splats);
        if (status == QV_OK)
            status = add_streams(f, &part, i, parts);
        if (status == QV_OK)
            status = qv_sums_add(sums, &part);
    }
    return status;
}

/* A level in slabs across z, the lowest first, or the highest. */
static qv_status add_slabs(const frame *f, const qv_sums *sums, uint8_t level, unsigned slab,
                           bool highest_first)
{
    const uint16_t *size = f->volume[level].size;
    unsigned slabs = (size[2] + slab - 1u) / slab;
    qv_status status = QV_OK;
    for (unsigned i = 0; i < slabs && status == QV_OK; i++) {
        unsigned first = (highest_first ? slabs - 1u - i : i) * slab;
        unsigned end = first + slab < size[2] ? first + slab : size[2];
        const qv_block block = {{0, 0, (uint16_t)first}, {size[0], size[1], (uint16_t)end}};
        status = qv_splat_block(sums, &f->splats, &f->volume[level], &f->attenuation[level], level,
                                &block);
    }
    return status;
}

/* Back to front, whole or, of orthographic views, in slabs. */
static qv_status add_levels(const frame *f, const qv_sums *sums)
{
    bool divided = f->way == GOLDEN_PIECES && f->golden->field_of_view == 0;
    bool highest_first = f->splats.scene.view.rotation[2][2] > 0;
    qv_status status = QV_OK;
    for (uint8_t l = 0; l < f->levels && status == QV_OK; l++)
        status = add_slabs(f, sums, l, divided ? 2 : f->volume[l].size[2], highest_first);
    return status;
}

static qv_status add_voxels(const frame *f, const qv_sums *sums)
{
    if (f->golden->splats.how->splatting == &qv_splatting_over)
        return add_levels(f, sums);
    switch (f->way) {
    case GOLDEN_STRIPS:
        return add_streams(f, sums, 0, 1);
    case GOLDEN_PIECES:
        return add_parts(f, sums);
    default:
        return add_levels(f, sums);
    }
}

/* ---- The picture ------------------------------------------------------------------ */

/* Of the pixels' sums, whose last bits no picture shows: each number's lowest byte first. */
static uint32_t add_to_checksum(uint32_t checksum, const qv_sums *sums)
{
    const qv_rect *rect = &sums->rect;
    int32_t pixels = (rect->right - rect->left) * (rect->bottom - rect->top);
    for (uint32_t i = 0; i < QV_SUM_CHANNELS * (uint32_t)pixels; i++) {
        uint32_t sum = sums->sums[i];
        const uint8_t bytes[4] = {(uint8_t)sum, (uint8_t)(sum >> 8), (uint8_t)(sum >> 16),
                                  (uint8_t)(sum >> 24)};
        checksum = crc32_update(checksum, bytes, sizeof bytes);
    }
    return checksum;
}

static qv_status draw_splats(void *user, const qv_image *image, const qv_rect *rect)
{
    frame *f = user;
    const qv_sums sums = {f->memory->sums[0], GOLDEN_SUMS, *rect};
    qv_status status = qv_sums_clear(&sums, &f->splats);
    if (status == QV_OK)
        status = add_voxels(f, &sums);
    f->checksum = add_to_checksum(f->checksum, &sums);
    return status == QV_OK ? qv_sums_read_out(image, &sums, &f->splats) : status;
}

static qv_status render_splats(uint32_t *checksum, frame *f)
{
    int32_t height = f->way == GOLDEN_STRIPS ? f->golden->strip : f->way == GOLDEN_ROWS ? 1 : 0;
    qv_status status = make_splats(f);
    if (status == QV_OK)
        status = golden_draw_parts(f->memory, f->golden, height, draw_splats, f);
    if (status == QV_OK)
        *checksum = crc32_update(f->checksum, f->memory->pixels, sizeof f->memory->pixels);
    return status;
}

/* ---- Lit voxels ------------------------------------------------------------------- */

/* Describes the memory of the lit volume: entries, tightly packed. */
static void describe_lit(qv_volume *lit, const frame *f, uint8_t *voxels, uint8_t bytes)
{
    int32_t stride = bytes;
    *lit = f->volume[0];
    lit->storage = QV_FIELD(f->golden->splats.lit_mode->sampling, storage);
    lit->voxels = voxels;
    lit->palette = NULL;
    lit->palette_bytes = 0;
    for (unsigned axis = 0; axis < 3; stride *= lit->size[axis++])
        lit->stride[axis] = stride;
    lit->voxels_bytes = (uint64_t)stride;
}

/* Lights the volume whole or, the other ways, slice by slice. */
static qv_status light(const frame *f, uint8_t *voxels, uint32_t slice_bytes)
{
    const golden_splatting *splats = &f->golden->splats;
    const uint16_t *size = f->golden->size;
    unsigned slab = f->way == GOLDEN_WHOLE ? size[2] : 1u;
    qv_status status = QV_OK;
    for (unsigned z = 0; z < size[2] && status == QV_OK; z += slab) {
        const qv_block block = {{0, 0, (uint16_t)z}, {size[0], size[1], (uint16_t)(z + slab)}};
        status = qv_illuminate(voxels + z * slice_bytes, (size_t)slab * (size_t)slice_bytes,
                               &f->volume[0], &f->attenuation[0], &splats->lighting,
                               splats->interpolation, &block);
    }
    return status;
}

static qv_status render_lit(uint32_t *checksum, frame *f)
{
    const golden_scene *golden = f->golden;
    uint8_t bytes = QV_FIELD(golden->splats.lit_mode->sampling, storage) % 2 == 0 ? 8 : 4;
    qv_scene scene;
    qv_status status = golden_make(&scene, f->memory, golden);
    if (status != QV_OK)
        return status;
    f->volume[0] = scene.volume;
    f->levels = 1;
    arena a = arena_of(f->memory, &f->volume[0]);
    uint8_t *voxels = take(&a, (uint64_t)count_voxels(&f->volume[0]) * bytes);
    if (!voxels)
        return QV_ERROR_BUFFER;
    status = make_attenuation(f, &a, golden->splats.directions);
    if (status == QV_OK)
        status = light(f, voxels, (uint32_t)bytes * golden->size[0] * golden->size[1]);
    describe_lit(&scene.volume, f, voxels, bytes);
    scene.sampling = golden->splats.lit_mode->sampling;
    return status == QV_OK ? golden_render_scene(checksum, f->memory, golden, &scene, f->way)
                           : status;
}

qv_status golden_render_splats(uint32_t *checksum, golden_memory *memory,
                               const golden_scene *golden, golden_way way)
{
    frame f = {.golden = golden, .memory = memory, .way = way};
    return golden->splats.how->splatting ? render_splats(checksum, &f) : render_lit(checksum, &f);
}
