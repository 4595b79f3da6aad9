#include "picture.h"

#include <string.h>

/* What a ray has gathered: E and T, or by extinction. */
typedef struct gathered {
    light plain;
    extinction_ray dense;
} gathered;

static bool is_by_extinction(const scene *s)
{
    return s->mode == MODE_EXTINCTION || s->mode == MODE_BSPLINE_EXTINCTION;
}

static bool is_spline(const scene *s)
{
    return s->mode == MODE_BSPLINE_WEIGHTED || s->mode == MODE_BSPLINE_EXTINCTION;
}

static void read_entry(entries *e, const scene *s, unsigned q, const triple *index)
{
    number row = add(index->v[1], mul(s->size.v[1], index->v[2]));
    const long voxel = small(add(index->v[0], mul(s->size.v[0], row)));
    for (int channel = 0; channel < 3; channel++)
        e->K[channel][q] = s->K[channel][voxel];
    e->A[q] = s->A[voxel];
}

/* The eight corners of a cell. */
static void read_corners(entries *e, const scene *s, const cell *c)
{
    e->bits = s->bits;
    e->count = 8;
    for (unsigned q = 0; q < 8; q++) {
        const triple index = {
            {corner_index(c, q, 0), corner_index(c, q, 1), corner_index(c, q, 2)}};
        read_entry(e, s, q, &index);
    }
}

/* The 27 voxels of a B-spline. */
static void read_neighbours(entries *e, const scene *s, const spline_cell *c)
{
    e->bits = s->bits;
    e->count = 27;
    for (unsigned q = 0; q < 27; q++) {
        const triple index = {
            {c->voxel[q % 3].v[0], c->voxel[q / 3 % 3].v[1], c->voxel[q / 9].v[2]}};
        read_entry(e, s, q, &index);
    }
}

/* Entries and weights of the sample at a point; f is the place in the cell. */
static void read_sample(entries *e, number w[], triple *f, const scene *s, const triple *point)
{
    if (is_spline(s)) {
        spline_parts unused;
        const spline_cell c = spline_cell_of(point, &s->size);
        read_neighbours(e, s, &c);
        spline_weights(w, &c.f, &unused);
        *f = c.f;
        return;
    }
    const cell c = cell_of_point(point, &s->size);
    const weights eight = weights_of(&c.f);
    read_corners(e, s, &c);
    memcpy(w, eight.w, sizeof eight.w);
    *f = c.f;
}

/* shift is s of section 41. */
static sample sample_at(const scene *s, const triple *point, number *shift)
{
    entries e;
    number w[ENTRIES_MAX];
    triple f;
    weighted_steps of_weighted;
    separate_steps of_separate;
    converted_steps of_converted;
    read_sample(&e, w, &f, s, point);
    *shift = whole(0);
    if (s->mode == MODE_NEAREST)
        return nearest(&e, nearest_corner(&f));
    if (s->mode == MODE_SEPARATE)
        return separate(&e, w, &of_separate);
    if (!is_by_extinction(s))
        return weighted(&e, w, &of_weighted);
    const sample of = converted(&e, w, &of_converted);
    *shift = of_converted.s;
    return of;
}

static void gather(gathered *g, const scene *s, const triple *L, number a32)
{
    g->plain = s->is_back_to_front ? over(&g->plain, L, a32) : under(&g->plain, L, a32);
}

/* True where the sample was skipped. */
static bool take_sample(gathered *g, const scene *s, const ray *r, number k)
{
    number shift;
    const triple point = sample_point(r, k);
    const sample of = sample_at(s, &point, &shift);
    if (!of.is_skipped)
        gather(g, s, &of.L, opacity32(of.O, s->bits));
    return of.is_skipped;
}

static void gather_extinction(gathered *g, const scene *s, const sample *of, number shift,
                              const medium *m)
{
    extinction_steps unused;
    g->dense = s->is_back_to_front ? extinction_over(&g->dense, of, shift, m, &unused)
                                   : extinction_under(&g->dense, of, shift, m, &unused);
    g->plain.T = g->dense.T;
    for (int c = 0; c < 3; c++)
        g->plain.E.v[c] =
            s->is_back_to_front ? g->dense.E.v[c] : extinction_light(g->dense.G.v[c], m->b);
}

/* Piece j of a way, section 38. True where it was skipped. */
static bool take_piece(gathered *g, const scene *s, const ray *r, const way *w, number j)
{
    number shift;
    corrected_steps unused;
    triple lit;
    number begin = most(w->enter, sub(up(j, 24), power2(23)));
    const piece p = piece_from(r, begin, w->leave, 0);
    const sample of = sample_at(s, &p.P, &shift);
    if (of.is_skipped)
        return true;
    medium m = s->medium;
    m.depth = of_length(m.depth, p.l);
    m.light = of_length(m.light, p.l);
    if (is_by_extinction(s)) {
        gather_extinction(g, s, &of, shift, &m);
        return false;
    }
    number a32 = corrected(&lit, &of.L, opacity32(of.O, s->bits), &m, &unused);
    gather(g, s, &lit, a32);
    return false;
}

/* The numbers of a ray's samples, or of its pieces. */
static span stations(const scene *s, const ray *r, way *w)
{
    if (s->mode < MODE_CORRECTED)
        return clip(r, &s->size);
    number first = s->camera.is_perspective ? up(s->phase, 8) : power2(46);
    *w = way_through(r, &s->size, negative(first));
    if (!w->is_there)
        return (span){whole(1), whole(0)};
    return (span){rounded(w->enter, 24), rounded(sub(w->leave, whole(1)), 24)};
}

static light light_of_ray(const scene *s, const ray *r, statistics *sum)
{
    way w = {NULL, NULL, false};
    gathered g = {light_at_start(), extinction_at_start()};
    const span k = stations(s, r, &w);
    const long first = small(k.first), last = small(k.last);
    for (long i = first; i <= last; i++) {
        number at = whole(s->is_back_to_front ? last - (i - first) : i);
        const bool is_skipped =
            s->mode < MODE_CORRECTED ? take_sample(&g, s, r, at) : take_piece(&g, s, r, &w, at);
        sum->samples++;
        sum->skipped += is_skipped ? 1 : 0;
        if (!is_skipped && !s->is_back_to_front && is_end(g.plain.T, s->threshold)) {
            sum->terminated += i < last ? 1 : 0;
            break;
        }
    }
    return g.plain;
}

channels pixel_of(const scene *s, long x, long y, statistics *sum)
{
    ray_steps unused;
    const ray r = ray_of_pixel(&s->camera, whole(x), whole(y), s->phase, &unused);
    const light l = light_of_ray(s, &r, sum);
    const channels G = background_levels(&s->background);
    const int64_t plain = s->bits == 8 ? 33686018 : 33424380;
    return read_out(&l, &G, whole(is_by_extinction(s) ? 66847740 : plain));
}
