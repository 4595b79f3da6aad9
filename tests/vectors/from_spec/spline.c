/* Section 40: B-splines. */
#include "lengths.h"
#include "operations.h"

spline_cell spline_cell_of(const triple *point, const triple *size)
{
    spline_cell c;
    for (int a = 0; a < 3; a++) {
        number moved = add(point->v[a], power2(31));
        number last = sub(size->v[a], whole(1));
        c.f.v[a] = low_bits(down(moved, 24), 8);
        for (int v = 0; v < 3; v++) {
            number i = add(down(moved, 32), whole(v - 1));
            c.voxel[v].v[a] = clamp(i, whole(0), last);
        }
    }
    return c;
}

/* Splits w by the fraction f. */
static triple part(number w, number f)
{
    number back = sub(whole(256), f);
    triple p;
    p.v[0] = rounded(mul(w, mul(back, back)), 17);
    p.v[2] = rounded(mul(w, mul(f, f)), 17);
    p.v[1] = fits_unsigned(sub(sub(w, p.v[0]), p.v[2]), 17);
    return p;
}

void spline_weights(number w[], const triple *f, spline_parts *step)
{
    step->z = part(power2(16), f->v[2]);
    for (int v2 = 0; v2 < 3; v2++) {
        step->y[v2] = part(step->z.v[v2], f->v[1]);
        for (int v1 = 0; v1 < 3; v1++) {
            const triple x = part(step->y[v2].v[v1], f->v[0]);
            for (int v0 = 0; v0 < 3; v0++)
                w[v0 + 3 * v1 + 9 * v2] = x.v[v0];
        }
    }
}
