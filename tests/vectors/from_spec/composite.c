#include "composite.h"

#include "operations.h"

light light_at_start(void)
{
    return (light){{{whole(0), whole(0), whole(0)}}, power2(31)};
}

static number rest_of(number T, number a32)
{
    return fits_unsigned(sub(T, hi(T, a32)), 32);
}

light under(const light *before, const triple *L, number a32)
{
    light r;
    for (int c = 0; c < 3; c++)
        r.E.v[c] = fits_unsigned(add(before->E.v[c], hi(L->v[c], before->T)), 32);
    r.T = rest_of(before->T, a32);
    return r;
}

light over(const light *before, const triple *L, number a32)
{
    light r;
    for (int c = 0; c < 3; c++) {
        number left = sub(before->E.v[c], hi(before->E.v[c], a32));
        r.E.v[c] = fits_unsigned(add(left, rounded(L->v[c], 1)), 32);
    }
    r.T = rest_of(before->T, a32);
    return r;
}

bool is_end(number T, number threshold)
{
    return !is_less(up(threshold, 15), T);
}
