#include "attenuation.h"

#include "block.h"
#include "cell.h"
#include "direction.h"
#include "entry.h"
#include "fx_log.h"
#include "fx_wide.h"
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
#define LINES 16

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

/* ---- Rows --------------------------------------------------------------------- */

/* Lines first .. end - 1 of a bundle, of which the first has come to this voxel. */
typedef struct row {
    uint16_t first, end;
    uint16_t voxel[3];
} row;

/* Lines follow each other as places do, so against the voxels where the direction is positive. */
static void find_voxel(uint16_t voxel[3], const row *r, unsigned line, const pass *p)
{
    uint16_t ahead = (uint16_t)(line - r->first);
    memcpy(voxel, r->voxel, sizeof r->voxel);
    voxel[p->beside] =
        (uint16_t)(p->step[p->beside] > 0 ? voxel[p->beside] - ahead : voxel[p->beside] + ahead);
}

static void write_in_order(const bundle *b, const row *r, const pass *p)
{
    for (unsigned line = r->first; line < r->end; line++) {
        uint16_t voxel[3];
        find_voxel(voxel, r, line, p);
        p->target.first[qv_target_offset(&p->target, voxel)] = b->byte[line];
    }
}

/* The same in linear order, without an index for each: offsets are modulo 2^n of size_t. */
static void write_linear(const bundle *b, const row *r, const pass *p)
{
    size_t offset = qv_target_offset(&p->target, r->voxel), next = p->target.record;
    if (p->beside != 0)
        next *= p->target.size[0];
    if (p->step[p->beside] > 0)
        next = 0u - next;
    for (unsigned line = r->first; line < r->end; line++, offset += next)
        p->target.first[offset] = b->byte[line];
}

#define BLOCK_SHIFT (32u - QV_BLOCK_FRACTION) /* depths are Q32.32 */

static void add_to_blocks(const bundle *b, const row *r, const pass *p)
{
    for (unsigned line = r->first; line < r->end; line++) {
        uint16_t voxel[3];
        fx_depth depth = b->depth[line] < FX_OPAQUE_DEPTH ? b->depth[line] : FX_OPAQUE_DEPTH;
        find_voxel(voxel, r, line, p);
        p->blocks[qv_attenuation_block(p->volume->size, voxel)] +=
            (uint32_t)((depth + ((fx_depth)1 << (BLOCK_SHIFT - 1u))) >> BLOCK_SHIFT);
    }
}

/* The light passes the row. Most voxels are empty. A line of 2^12 is less deep than 2^62 of
   Q32.32. What does not change is kept where the stores of bytes cannot reach it. */
static void pass_voxels(bundle *b, const row *r, const pass *p)
{
    const qv_volume *volume = p->volume;
    const qv_thickness thickness = p->thickness;
    const unsigned storage = volume->storage, end = r->end;
    const qv_address first = qv_voxel_at(volume, r->voxel);
    qv_offset offset = 0, next = (qv_offset)volume->stride[p->beside];
    if (p->step[p->beside] > 0)
        next = -next;
    for (unsigned line = r->first; line < end; line++, offset += next) {
        qv_address entry = qv_entry(qv_at(first, offset), volume, storage);
        fx_unorm16 fourth = qv_entry_fourth(entry, storage);
        if (fourth == 0)
            continue;
        b->depth[line] += qv_thickness_depth(&thickness, QV_FIELD(p->domain, weight)(fourth));
        if (b->byte[line] != 0)
            b->byte[line] = qv_attenuation_byte(b->depth[line]);
    }
}

static void pass_row(bundle *b, const row *r, const pass *p)
{
    if (p->target.order == &qv_order_linear)
        write_linear(b, r, p);
    else
        write_in_order(b, r, p);
    if (p->blocks)
        add_to_blocks(b, r, p);
    pass_voxels(b, r, p);
}

/* ---- Lines -------------------------------------------------------------------- */

/* The row of a bundle so many rows behind its begin, where its first line may lie outside.
   Returns 0 where none of its lines is in the volume. */
static int find_row(row *r, const pass *p, const int32_t begin[3], int32_t rows)
{
    const uint16_t *size = p->volume->size;
    int32_t place[3];
    for (unsigned axis = 0; axis < 3; axis++)
        place[axis] = begin[axis] + (p->step[axis] != 0 ? rows : 0);
    int32_t first = place[p->beside] < 0 ? -place[p->beside] : 0;
    int32_t end = size[p->beside] - place[p->beside];
    r->first = (uint16_t)first;
    r->end = (uint16_t)(end < LINES ? end : LINES);
    place[p->beside] += first;
    for (unsigned axis = 0; axis < 3; axis++)
        r->voxel[axis] = (uint16_t)(p->step[axis] > 0 ? size[axis] - 1 - place[axis] : place[axis]);
    return first < end && first < LINES;
}

static FX_NOINLINE void pass_bundle(const pass *p, const int32_t begin[3], uint32_t rows)
{
    bundle b;
    row r;
    int32_t start = begin[p->beside], first = 0, end = (int32_t)rows;
    if (p->step[p->beside] != 0) { /* only while it slides past the volume */
        int32_t left = p->volume->size[p->beside] - start;
        first = start + LINES > 0 ? 0 : 1 - LINES - start;
        end = left < end ? left : end;
    }
    for (unsigned line = 0; line < LINES; line++) {
        b.depth[line] = 0;
        b.byte[line] = 255;
    }
    for (int32_t i = first; i < end; i++)
        if (find_row(&r, p, begin, i))
            pass_row(&b, &r, p);
}

/* All bundles that begin in a row. Those that slide begin up to so many rows outside. */
static void pass_bundles(const pass *p, int32_t begin[3], uint32_t rows)
{
    int32_t outside = p->step[p->beside] != 0 ? (int32_t)rows - 1 : 0;
    for (begin[p->beside] = -outside; begin[p->beside] < p->volume->size[p->beside];
         begin[p->beside] += LINES)
        pass_bundle(p, begin, rows);
}

/* Rows from a place on, until light leaves the volume; 0 where it does not come in there. */
static uint32_t rows_from(const pass *p, const int32_t begin[3])
{
    const uint8_t axes[2] = {p->next, p->last};
    int32_t rows = QV_AXIS_MAX;
    int enters = 0;
    for (unsigned i = 0; i < 2; i++) {
        int32_t left = p->volume->size[axes[i]] - begin[axes[i]];
        if (p->step[axes[i]] == 0)
            continue;
        rows = left < rows ? left : rows;
        enters |= begin[axes[i]] == 0;
    }
    return enters ? (uint32_t)rows : 0;
}

static void pass_volume(const pass *p)
{
    const uint16_t *size = p->volume->size;
    int32_t begin[3];
    for (begin[p->last] = 0; begin[p->last] < size[p->last]; begin[p->last]++)
        for (begin[p->next] = 0; begin[p->next] < size[p->next]; begin[p->next]++) {
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
        if (volume->size[axis] != 1 && fx_magnitude(volume->stride[axis]) % record != 0)
            return 0;
    if (!qv_distance(&distance, to, volume->voxels))
        return 1;
    uintptr_t behind = (uintptr_t)(0u - distance);
    uintptr_t place = distance < behind ? distance % record : (record - behind % record) % record;
    return place >= qv_directions_count(attenuation->directions) &&
           place + qv_voxel_bytes(volume->storage) <= record;
}

static FX_NOINLINE qv_status check_overlap(const void *to, const uint32_t *blocks,
                                           const qv_attenuation *attenuation,
                                           const qv_volume *volume)
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
static FX_NOINLINE qv_status prepare(pass *p, const qv_volume *volume, const qv_domain *domain,
                                     uint8_t direction)
{
    if (QV_FIELD(domain, of_opacity) == qv_storage_extinction(volume->storage))
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
