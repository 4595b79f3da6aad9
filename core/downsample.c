#include "pyramid.h"

#include "fx_wide.h"
#include "block.h"
#include "cell.h"
#include "entry.h"
#include "layout.h"

QV_DESCRIPTOR qv_filter qv_filter_box2 = {0, 32};
QV_DESCRIPTOR qv_filter qv_filter_box4 = {16, 16};
QV_DESCRIPTOR qv_filter qv_filter_quad4 = {13, 19};

/* A filter's taps sum to 64 on an axis, and so to 2^18 over the three. */
#define TAPS        4u
#define HALF_FILTER 32u
#define FILTER_BITS 18u

/*
 * Sums over voxels, each times its share of the filter. A weight is at most 2^30, and a
 * colour has 16 bits, whatever it is stored in; so shares of f in all give weight <= 2^30 f
 * and light <= 65535 * 2^30 f. A column of voxels has f = 2^12, which keeps light below
 * 2^58; a result has f = 2^18, which keeps it below 2^64.
 */
typedef struct sums {
    uint64_t weight;
    uint64_t light[3]; /* of weight * colour */
} sums;

/* The filter's 16 taps on y and z have three shares: both taps outer ones, one, none. */
#define GROUPS 3u

/* What a row of results is made of. */
typedef struct row {
    const qv_volume *finer;
    const qv_domain *domain;
    uint8_t outer, inner;      /* the filter's taps */
    uint16_t y[TAPS], z[TAPS]; /* voxels at the taps of its results */
} row;

/* Index of a voxel, mirrored in a face that it lies beyond. From size + 1 a single voxel's
   other face is passed as well, and mirrors it back to 0. */
static uint16_t mirrored(int32_t at, uint16_t size)
{
    if (at >= size)
        at = 2 * size - 1 - at;
    return (uint16_t)(at < 0 ? 0 : at);
}

/* The voxel at a tap of result `at` on an axis. */
static uint16_t tap_index(const qv_volume *finer, unsigned axis, uint32_t at, uint32_t tap)
{
    return mirrored((int32_t)(2u * at + tap) - 1, finer->size[axis]);
}

/* Where the fourth channel is 0, the weight is 0 in every domain. */
static void add_voxel(sums *to, const row *r, const uint16_t at[3])
{
    fx_unorm16 entry[4];
    const qv_volume *finer = r->finer;
    qv_address voxel = qv_voxel_at(finer, at);
    qv_entry_read(entry, qv_entry(voxel, finer, finer->storage), finer->storage);
    if (entry[3] == 0)
        return;
    uint32_t weight = QV_FIELD(r->domain, weight)(entry[3]);
    to->weight += weight;
    for (unsigned c = 0; c < 3; c++)
        to->light[c] += fx_wide_product(weight, entry[c]);
}

/* v * share, for the parts of a column and of a result: below 32 * 2^58 = 2^63. */
static uint64_t times(uint64_t v, uint32_t share)
{
    return (uint64_t)fx_multiply((int64_t)v, (int32_t)share);
}

static void add(sums *to, const sums *part, uint32_t share)
{
    to->weight += times(part->weight, share);
    for (unsigned c = 0; c < 3; c++)
        to->light[c] += times(part->light[c], share);
}

static unsigned is_inner(unsigned tap)
{
    return tap == 1u || tap == 2u;
}

/* The voxels of a column whose taps on y and z have so many inner ones. */
static FX_NOINLINE void add_group(sums *to, const row *r, uint16_t x, unsigned group)
{
    for (unsigned k = 0; k < TAPS; k++)
        for (unsigned j = 0; j < TAPS; j++)
            if (is_inner(j) + is_inner(k) == group) {
                const uint16_t at[3] = {x, r->y[j], r->z[k]};
                add_voxel(to, r, at);
            }
}

/* The column of voxels at one tap of result `at` on x: the filter over y and z. */
static FX_NOINLINE void sum_column(sums *to, const row *r, uint32_t at, uint32_t tap)
{
    uint16_t x = tap_index(r->finer, 0, at, tap);
    memset(to, 0, sizeof *to);
    for (unsigned group = 0; group < GROUPS; group++) {
        sums part = {0, {0, 0, 0}};
        uint32_t share = (uint32_t)(group != 0 ? r->inner : r->outer) *
                         (group == 2u ? r->inner : r->outer); /* <= 2^10 */
        if (share == 0)
            continue;
        add_group(&part, r, x, group);
        add(to, &part, share);
    }
}

/* A result from its sums; black where nothing has weight. light + weight / 2 is at most
   65535 * 2^48 + 2^47. */
static FX_NOINLINE void resolve(fx_unorm16 entry[4], const sums *all, const qv_domain *domain)
{
    uint64_t half = (uint64_t)1 << (FILTER_BITS - 1u);
    entry[3] = QV_FIELD(domain, channel)((uint32_t)((all->weight + half) >> FILTER_BITS));
    for (unsigned c = 0; c < 3; c++)
        entry[c] = all->weight == 0 ? 0 : fx_quotient16(all->light[c], all->weight);
}

/* A window of four columns moves along the row, two further from each result to the next: so
   two that end one window begin the next. */
static FX_NOINLINE void make_row(uint8_t *out, const row *r)
{
    sums now, next = {0, {0, 0, 0}}, column;
    unsigned storage = r->finer->storage;
    uint32_t width = qv_coarser_size(r->finer->size[0]);
    sum_column(&column, r, 0, 0);
    add(&next, &column, r->outer);
    sum_column(&column, r, 0, 1);
    add(&next, &column, r->inner);
    for (uint32_t at = 0; at < width; at++) {
        fx_unorm16 entry[4];
        now = next;
        memset(&next, 0, sizeof next);
        sum_column(&column, r, at, 2);
        add(&now, &column, r->inner);
        add(&next, &column, r->outer);
        sum_column(&column, r, at, 3);
        add(&now, &column, r->outer);
        add(&next, &column, r->inner);
        resolve(entry, &now, r->domain);
        qv_entry_write(out, storage, entry);
        out += qv_entry_bytes(storage);
    }
}

static void set_taps(uint16_t index[TAPS], const qv_volume *finer, unsigned axis, uint32_t at)
{
    for (uint32_t tap = 0; tap < TAPS; tap++)
        index[tap] = tap_index(finer, axis, at, tap);
}

static FX_NOINLINE qv_status check(const qv_volume *finer, const qv_filter *filter,
                                   const qv_domain *domain)
{
    qv_status status = qv_voxels_check(finer);
    if (status != QV_OK)
        return status;
    if (qv_storage_associated(finer->storage) ||
        (QV_FIELD(domain, of_opacity) && qv_storage_extinction(finer->storage)))
        return QV_ERROR_STORAGE;
    if (qv_pyramid_levels(finer->size) == 0)
        return QV_ERROR_LEVEL;
    return QV_FIELD(filter, outer) + QV_FIELD(filter, inner) == HALF_FILTER ? QV_OK
                                                                            : QV_ERROR_MIXTURE;
}

qv_status qv_downsample(void *voxels, size_t bytes, const qv_volume *finer, const qv_filter *filter,
                        const qv_domain *domain, uint16_t first_z, uint16_t end_z)
{
    if (!voxels || !finer || !filter || !domain)
        return QV_ERROR_NULL;
    qv_status status = check(finer, filter, domain);
    if (status != QV_OK)
        return status;
    if (first_z >= end_z || end_z > qv_coarser_size(finer->size[2]))
        return QV_ERROR_SIZE;

    uint32_t width = qv_coarser_size(finer->size[0]), height = qv_coarser_size(finer->size[1]);
    uint32_t row_bytes = width * qv_entry_bytes(finer->storage);
    uint32_t rows = height * (uint32_t)(end_z - first_z);
    if (bytes < fx_wide_product(row_bytes, rows)) /* <= 2^14 * 2^22 */
        return QV_ERROR_BUFFER;

    row r = {finer, domain, QV_FIELD(filter, outer), QV_FIELD(filter, inner), {0}, {0}};
    uint8_t *out = (uint8_t *)voxels;
    for (uint32_t z = first_z; z < end_z; z++) {
        set_taps(r.z, finer, 2, z);
        for (uint32_t y = 0; y < height; y++, out += row_bytes) {
            set_taps(r.y, finer, 1, y);
            make_row(out, &r);
        }
    }
    return QV_OK;
}
