#include "orders.h"

number linear_index(const triple *n, const triple *p)
{
    number row = add(p->v[1], mul(n->v[1], p->v[2]));
    return fits_unsigned(add(p->v[0], mul(n->v[0], row)), 36);
}

/* Where the curve is: the axis d that is halved next, and what is left of the box. */
typedef struct walk {
    long e[3];
    unsigned c[3], d;
    number index;
} walk;

/* Halves the box on axis d at h. Returns s: 1 where the voxel lies in the half that comes last. */
static unsigned halve(walk *at, long p, long h, unsigned first)
{
    const unsigned d = at->d;
    const long lower = h < at->e[d] ? h : at->e[d];
    const long half[2] = {lower, at->e[d] - lower};
    const unsigned upper = (unsigned)(p / h % 2);
    const unsigned s = upper ^ first;
    number area = mul(whole(at->e[(d + 1) % 3]), whole(at->e[(d + 2) % 3]));
    if (s != 0)
        at->index = add(at->index, mul(whole(half[first]), area));
    at->e[d] = half[upper];
    return s;
}

/* Hilbert's curve turns after each three halvings, by what they were. */
static void turn_curve(walk *at, unsigned w)
{
    static const unsigned k[8] = {0, 0, 0, 3, 3, 6, 6, 5}, t[8] = {1, 2, 2, 0, 0, 2, 2, 1};
    for (unsigned i = 0; i < 3; i++)
        at->c[(at->d + 1 + i) % 3] ^= k[w] >> i & 1;
    at->d = (at->d + t[w]) % 3;
}

number curve_index(const triple *n, const triple *p, bool is_hilbert)
{
    walk at = {.d = 2, .index = whole(0)};
    long E = 1;
    for (int a = 0; a < 3; a++) {
        at.e[a] = small(n->v[a]);
        while (E < at.e[a])
            E *= 2;
    }
    for (long h = E / 2; h >= 1; h /= 2) {
        unsigned w = 0;
        for (int i = 0; i < 3; i++) {
            const unsigned first = is_hilbert ? at.c[at.d] ^ (w & 1) : 0;
            w = 2 * w + halve(&at, small(p->v[at.d]), h, first);
            at.d = (at.d + 2) % 3;
        }
        if (is_hilbert)
            turn_curve(&at, w);
    }
    return fits_unsigned(at.index, 36);
}
