#include "pyramid.h"

#include "fx_wide.h"
#include "cell.h"
#include "entry.h"

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
    uint32_t tap[TAPS];     /* the filter on x */
    uint32_t share[GROUPS]; /* on y and z, by the number of inner taps: <= 2^10 */
    qv_offset y[TAPS], z[TAPS];
} row;

/* Index of a voxel, mirrored in a face that it lies beyond. From size + 1 a single voxel's
   other face is passed as well, and mirrors it back to 0. */
static uint16_t mirrored(int32_t at, uint16_t size)
{
    if (at >= size)
        at = 2 * size - 1 - at;
    return (uint16_t)(at < 0 ? 0 : at);
}

/* From voxel 0 to a tap of result `at` on an axis. */
static qv_offset tap_offset(const qv_volume *finer, unsigned axis, uint32_t at, uint32_t tap)
{
    uint16_t index = mirrored((int32_t)(2u * at + tap) - 1, finer->size[axis]);
    return (qv_offset)index * (qv_offset)finer->stride[axis];
}

/* Where the fourth channel is 0, the weight is 0 in every domain. */
static void add_voxel(sums *to, const row *r, qv_offset offset)
{
    fx_unorm16 entry[4];
    const qv_volume *finer = r->finer;
    qv_address voxel = qv_at(finer->voxels, offset);
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

/* The sum of parts, each times its share. */
static void weigh(sums *to, const sums *part, const uint32_t *share, unsigned parts)
{
    sums all = {0, {0, 0, 0}};
    for (unsigned i = 0; i < parts; i++) {
        all.weight += times(part[i].weight, share[i]);
        for (unsigned c = 0; c < 3; c++)
            all.light[c] += times(part[i].light[c], share[i]);
    }
    *to = all;
}

static unsigned is_inner(unsigned tap)
{
    return tap == 1u || tap == 2u;
}

/* The column of voxels at one tap of result `at` on x: the filter over y and z. */
static void sum_column(sums *to, const row *r, uint32_t at, uint32_t tap)
{
    sums part[GROUPS] = {{0, {0, 0, 0}}, {0, {0, 0, 0}}, {0, {0, 0, 0}}};
    qv_offset x = tap_offset(r->finer, 0, at, tap);
    for (unsigned k = 0; k < TAPS; k++)
        for (unsigned j = 0; j < TAPS; j++) {
            unsigned group = is_inner(j) + is_inner(k);
            if (r->share[group] != 0)
                add_voxel(&part[group], r, x + r->y[j] + r->z[k]);
        }
    weigh(to, part, r->share, GROUPS);
}

/* A result from its sums; black where nothing has weight. light + weight / 2 is at most
   65535 * 2^48 + 2^47. */
static void resolve(fx_unorm16 entry[4], const sums *all, const qv_domain *domain)
{
    uint64_t half = (uint64_t)1 << (FILTER_BITS - 1u);
    entry[3] = QV_FIELD(domain, channel)((uint32_t)((all->weight + half) >> FILTER_BITS));
    for (unsigned c = 0; c < 3; c++)
        entry[c] = all->weight == 0 ? 0 : fx_quotient16(all->light[c], all->weight);
}

/* A window of four columns moves along the row, two further from each result to the next. */
static void make_row(uint8_t *out, const row *r)
{
    sums column[TAPS];
    unsigned storage = r->finer->storage;
    uint32_t width = qv_coarser_size(r->finer->size[0]);
    sum_column(&column[2], r, 0, 0);
    sum_column(&column[3], r, 0, 1);
    for (uint32_t at = 0; at < width; at++) {
        sums all;
        fx_unorm16 entry[4];
        column[0] = column[2];
        column[1] = column[3];
        sum_column(&column[2], r, at, 2);
        sum_column(&column[3], r, at, 3);
        weigh(&all, column, r->tap, TAPS);
        resolve(entry, &all, r->domain);
        qv_entry_write(out, storage, entry);
        out += qv_entry_bytes(storage);
    }
}

static void set_filter(row *r, const qv_filter *filter)
{
    uint32_t outer = QV_FIELD(filter, outer), inner = QV_FIELD(filter, inner);
    r->tap[0] = r->tap[3] = outer;
    r->tap[1] = r->tap[2] = inner;
    r->share[0] = outer * outer;
    r->share[1] = outer * inner;
    r->share[2] = inner * inner;
}

static void set_taps(qv_offset offset[TAPS], const qv_volume *finer, unsigned axis, uint32_t at)
{
    for (uint32_t tap = 0; tap < TAPS; tap++)
        offset[tap] = tap_offset(finer, axis, at, tap);
}

static qv_status check(const qv_volume *finer, const qv_filter *filter, const qv_domain *domain)
{
    /* Spacing is not read, and that of a deep level may be out of a volume's range. */
    qv_volume volume = *finer;
    for (unsigned axis = 0; axis < 3; axis++)
        volume.spacing[axis] = 0;
    qv_status status = qv_volume_check(&volume);
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

    row r = {finer, domain, {0}, {0}, {0}, {0}};
    uint8_t *out = (uint8_t *)voxels;
    set_filter(&r, filter);
    for (uint32_t z = first_z; z < end_z; z++) {
        set_taps(r.z, finer, 2, z);
        for (uint32_t y = 0; y < height; y++, out += row_bytes) {
            set_taps(r.y, finer, 1, y);
            make_row(out, &r);
        }
    }
    return QV_OK;
}
