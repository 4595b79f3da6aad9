#include "attenuation.h"

#include "cell.h"
#include "direction.h"
#include "entry.h"
#include "fx_log.h"
#include "overlap.h"
#include "pyramid.h"
#include "thickness.h"

/*
 * Light comes in along lines of voxels, against the direction. Places count along the way of the
 * light: from 0 at the face where it comes in, on axes where it moves, and as voxels do on the
 * others. So light moves from a place to one that is higher by 1 on each of those axes.
 *
 * Lines that begin side by side are walked as a bundle, so that memory is read in rows: on x, or
 * on y where light moves along x alone. Where it moves along that axis too, rows of a bundle slide
 * over it, and lines come in, and end, one after another.
 */
#define LINES 16u

typedef struct bundle {
    fx_depth depth[LINES]; /* of all voxels that a line has passed, from 0 outside */
    uint8_t byte[LINES];
} bundle;

typedef struct pass {
    const qv_volume *volume;
    const qv_domain *domain;
    uint32_t *blocks; /* or null */
    qv_target target;
    qv_thickness thickness;
    int8_t step[3];             /* the direction */
    uint8_t beside, next, last; /* axes: that of a bundle's lines, and the other two */
} pass;

#define BLOCK_SHIFT (32u - QV_BLOCK_FRACTION) /* depths are Q32.32 */

static void add_to_block(const pass *p, const uint16_t position[3], fx_depth depth)
{
    if (depth > FX_OPAQUE_DEPTH)
        depth = FX_OPAQUE_DEPTH;
    p->blocks[qv_block_index(p->volume->size, position)] +=
        (uint32_t)((depth + ((fx_depth)1 << (BLOCK_SHIFT - 1u))) >> BLOCK_SHIFT);
}

/* ---- Lines -------------------------------------------------------------------- */

static uint16_t position_of(const pass *p, const uint16_t place[3], unsigned axis)
{
    return p->step[axis] > 0 ? (uint16_t)(p->volume->size[axis] - 1u - place[axis]) : place[axis];
}

/* Light passes a voxel. Most are empty. A line of 2^12 voxels is less deep than 2^62 of Q32.32. */
static void pass_voxel(bundle *b, unsigned line, const pass *p, qv_address voxel)
{
    unsigned storage = p->volume->storage;
    fx_unorm16 fourth = qv_entry_fourth(qv_entry(voxel, p->volume, storage), storage);
    if (fourth == 0)
        return;
    b->depth[line] += qv_thickness_depth(&p->thickness, p->domain->weight(fourth));
    if (b->byte[line] != 0)
        b->byte[line] = qv_attenuation_byte(b->depth[line]);
}

/* A row of a bundle: lines first .. end - 1, the first of which has come to this place. */
static void pass_row(bundle *b, unsigned first, unsigned end, const pass *p,
                     const uint16_t place[3])
{
    uint16_t position[3];
    qv_offset offset = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        position[axis] = position_of(p, place, axis);
        offset += (qv_offset)position[axis] * (qv_offset)p->volume->stride[axis];
    }
    uint16_t turn = p->step[p->beside] > 0 ? 0xFFFFu : 1u; /* -1 modulo 2^16 */
    qv_offset stride = (qv_offset)p->volume->stride[p->beside];
    for (unsigned line = first; line < end; line++) {
        *qv_target_byte(&p->target, position) = b->byte[line];
        if (p->blocks)
            add_to_block(p, position, b->depth[line]);
        pass_voxel(b, line, p, qv_at(p->volume->voxels, offset));
        position[p->beside] = (uint16_t)(position[p->beside] + turn);
        offset = turn == 1u ? offset + stride : offset - stride;
    }
}

/* Rows 0 .. rows - 1 of lines that begin at `first` on their axis, which may be outside. */
static void pass_bundle(const pass *p, int32_t first, const uint16_t begin[3], uint32_t rows)
{
    bundle b;
    uint16_t place[3] = {begin[0], begin[1], begin[2]};
    int32_t size = p->volume->size[p->beside], slide = p->step[p->beside] != 0;
    for (unsigned line = 0; line < LINES; line++) {
        b.depth[line] = 0;
        b.byte[line] = 255;
    }
    for (uint32_t row = 0; row < rows && first < size; row++, first += slide) {
        unsigned from = first < 0 ? (unsigned)-first : 0;
        unsigned end = size - first < (int32_t)LINES ? (unsigned)(size - first) : LINES;
        if (from < end) {
            place[p->beside] = (uint16_t)(first + (int32_t)from);
            pass_row(&b, from, end, p, place);
        }
        place[p->next] = (uint16_t)(place[p->next] + (p->step[p->next] != 0));
        place[p->last] = (uint16_t)(place[p->last] + (p->step[p->last] != 0));
    }
}

/* Rows from a place to where light leaves the volume on one of two axes; 0 where it does not come
   in there. */
static uint32_t rows_from(const pass *p, const uint16_t place[3])
{
    uint32_t rows = QV_AXIS_MAX;
    int enters = 0;
    const uint8_t axes[2] = {p->next, p->last};
    for (unsigned i = 0; i < 2; i++) {
        uint32_t left = (uint32_t)p->volume->size[axes[i]] - place[axes[i]];
        if (p->step[axes[i]] == 0)
            continue;
        rows = left < rows ? left : rows;
        enters |= place[axes[i]] == 0;
    }
    return enters ? rows : 0;
}

/* All bundles that begin in one row; those that slide begin up to a row's length outside. */
static void pass_bundles(const pass *p, const uint16_t begin[3], uint32_t rows)
{
    int32_t slide = p->step[p->beside] != 0 ? (int32_t)rows - 1 : 0;
    for (int32_t first = -slide; first < p->volume->size[p->beside]; first += (int32_t)LINES)
        pass_bundle(p, first, begin, rows);
}

static void pass_volume(const pass *p)
{
    uint16_t begin[3] = {0, 0, 0};
    for (begin[p->last] = 0; begin[p->last] < p->volume->size[p->last]; begin[p->last]++)
        for (begin[p->next] = 0; begin[p->next] < p->volume->size[p->next]; begin[p->next]++) {
            uint32_t rows = rows_from(p, begin);
            if (rows != 0)
                pass_bundles(p, begin, rows);
        }
}

/* ---- Checks ------------------------------------------------------------------- */

/* Whether voxels stand in the gaps between records, all at the same place: their strides are then
   whole records. */
static int in_gaps(const qv_volume *volume, const void *to, const qv_attenuation *attenuation)
{
    uint16_t record = qv_attenuation_record(attenuation);
    uintptr_t distance;
    for (unsigned axis = 0; axis < 3; axis++)
        if (volume->size[axis] != 1 && volume->stride[axis] % record != 0)
            return 0;
    if (!qv_distance(&distance, to, volume->voxels))
        return 1;
    uintptr_t behind = (uintptr_t)(0u - distance);
    uintptr_t place = distance < behind ? distance % record : (record - behind % record) % record;
    return place >= qv_directions_count(attenuation->directions) &&
           place + qv_voxel_bytes(volume->storage) <= record;
}

static qv_status check_overlap(const void *to, const uint32_t *blocks,
                               const qv_attenuation *attenuation, const qv_volume *volume)
{
    uint64_t bytes = qv_attenuation_bytes(attenuation);
    uint64_t block_bytes = qv_blocks_bytes(volume->size);
    if (qv_palette_meets(volume, to, bytes) ||
        (qv_voxels_meet(volume, to, bytes) && !in_gaps(volume, to, attenuation)))
        return QV_ERROR_OVERLAP;
    if (blocks && (qv_regions_meet((uintptr_t)blocks - (uintptr_t)to, bytes, block_bytes) ||
                   qv_palette_meets(volume, blocks, block_bytes) ||
                   qv_voxels_meet(volume, blocks, block_bytes)))
        return QV_ERROR_OVERLAP;
    return QV_OK;
}

/* ------------------------------------------------------------------------------- */

static void set_direction(pass *p, uint8_t direction)
{
    qv_direction_step(p->step, direction);
    int along_x = p->step[1] == 0 && p->step[2] == 0;
    p->beside = along_x ? 1 : 0;
    p->next = along_x ? 0 : 1;
    p->last = 2;
}

/* All that the volume's light depends on. */
static qv_status prepare(pass *p, const qv_volume *volume, const qv_domain *domain,
                         uint8_t direction)
{
    if (domain->of_opacity == qv_storage_extinction(volume->storage))
        return QV_ERROR_STORAGE;
    p->volume = volume;
    p->domain = domain;
    set_direction(p, direction);
    return qv_thickness_of(&p->thickness, volume, qv_direction_length(volume->spacing, direction));
}

qv_status qv_attenuate(void *to, size_t bytes, uint32_t *blocks, const qv_attenuation *attenuation,
                       const qv_volume *volume, const qv_domain *domain, uint8_t direction)
{
    if (!to || !attenuation || !volume || !domain)
        return QV_ERROR_NULL;
    pass p;
    qv_status status = qv_volume_check(volume);
    if (status == QV_OK)
        status = qv_target_init(&p.target, to, bytes, attenuation, volume->size, direction);
    if (status == QV_OK)
        status = prepare(&p, volume, domain, direction);
    if (status == QV_OK)
        status = check_overlap(to, blocks, attenuation, volume);
    if (status != QV_OK)
        return status;
    p.blocks = blocks;
    if (blocks)
        memset(blocks, 0, (size_t)qv_blocks_bytes(volume->size));
    pass_volume(&p);
    return QV_OK;
}
