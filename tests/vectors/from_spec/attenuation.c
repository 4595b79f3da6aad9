/* Sections 62 and 63: depths of a small volume in one direction, and of its levels. */
#include "freevoxels.h"

#include "operations.h"

triple direction_step(number d)
{
    const long q = small(d) < 13 ? small(d) : small(d) + 1;
    return (triple){{whole(q % 3 - 1), whole(q / 3 % 3 - 1), whole(q / 9 - 1)}};
}

number step_length(const triple *step, const triple *spacing)
{
    triple v;
    for (int a = 0; a < 3; a++)
        v.v[a] = sign_of(step->v[a]) == 0 ? whole(0) : up(spacing->v[a], 7);
    return length_of(&v);
}

long box_voxels(const box *b)
{
    return b->n[0] * b->n[1] * b->n[2];
}

static box at_index(const box *b, long index)
{
    return (box){{index % b->n[0], index / b->n[0] % b->n[1], index / (b->n[0] * b->n[1])}};
}

number voxel_depth(const box *b, const number weight[], long index, const triple *step, thickness t)
{
    box at = at_index(b, index);
    number D = whole(0);
    for (;;) {
        for (int a = 0; a < 3; a++) {
            at.n[a] += small(step->v[a]);
            if (at.n[a] < 0 || at.n[a] >= b->n[a])
                return D;
        }
        const long voxel = at.n[0] + b->n[0] * (at.n[1] + b->n[1] * at.n[2]);
        D = fits_unsigned(add(D, thickness_depth(t, weight[voxel])), 64);
    }
}

box level_box(const box *b, unsigned level)
{
    box r;
    for (int a = 0; a < 3; a++)
        r.n[a] = (b->n[a] + (1L << level) - 1) >> level;
    return r;
}

unsigned level_count(const box *b)
{
    unsigned m = 0;
    while (b->n[0] > 1L << m || b->n[1] > 1L << m || b->n[2] > 1L << m)
        m++;
    return m;
}

static bool is_within(const box *fine, const box *coarse, unsigned levels)
{
    for (int a = 0; a < 3; a++)
        if (fine->n[a] >> levels != coarse->n[a])
            return false;
    return true;
}

/* The sum of what lies in voxel p of a coarser level. */
static number sum_within(const box *b, const number of[], const box *p, unsigned levels)
{
    number sum = whole(0);
    for (long i = 0; i < box_voxels(b); i++) {
        const box at = at_index(b, i);
        if (is_within(&at, p, levels))
            sum = add(sum, of == NULL ? whole(1) : of[i]);
    }
    return sum;
}

number block_depth(const box *b, const number D[], long block)
{
    const box blocks = level_box(b, 1), p = at_index(&blocks, block);
    number sum = whole(0);
    for (long i = 0; i < box_voxels(b); i++) {
        const box at = at_index(b, i);
        if (is_within(&at, &p, 1))
            sum = add(sum, rounded(least(D[i], power2(38)), 10));
    }
    return fits_unsigned(sum, 32);
}

number level_byte(const box *b, const number B[], long index, unsigned level)
{
    const box blocks = level_box(b, 1), of_level = level_box(b, level);
    const box p = at_index(&of_level, index);
    number N = sum_within(b, NULL, &p, level), R = sum_within(&blocks, B, &p, level - 1);
    const unsigned c = bits_of(N) > 31 ? bits_of(N) - 31 : 0;
    N = down(N, c);
    R = down(R, c);
    return attenuation_byte(up(floor_div(add(R, down(N, 1)), N), 10));
}
