#include "pixels.h"

#include "operations.h"

channels background_levels(const channels *B)
{
    channels G;
    for (int c = 0; c < 4; c++) {
        number p = mul(c == 3 ? whole(255) : B->v[c], B->v[3]);
        G.v[c] = fits_unsigned(mul(whole(2), add(mul(whole(257), p), div255(p))), 32);
    }
    return G;
}

channels read_out(const light *l, const channels *G, number factor)
{
    channels r;
    number shut = sub(whole(0x00FF0000), hi(l->T, whole(0x01FE0000)));
    r.v[3] = fits_unsigned(add(shut, hi(l->T, G->v[3])), 32);
    for (int c = 0; c < 3; c++)
        r.v[c] = least(r.v[3], add(hi(l->E.v[c], factor), hi(l->T, G->v[c])));
    return r;
}

number level8(number v)
{
    return rounded(v, 16);
}

number grey_of(const channels *c)
{
    number red = mul(whole(77), c->v[0]);
    number green = mul(whole(150), c->v[1]);
    return rounded(add(add(red, green), mul(whole(29), c->v[2])), 8);
}

number threshold_at(number x, number y)
{
    number column = low_bits(x, 3), line = low_bits(y, 3);
    number t = whole(0);
    for (unsigned bit = 0; bit < 3; bit++) {
        number of_line = whole(bit_of(line, bit));
        number both = either(whole(bit_of(column, bit)), of_line);
        t = add(up(t, 2), add(up(both, 1), of_line));
    }
    return t;
}

number dither(number v, number top, number t)
{
    number place = mul(whole(130560), add(up(t, 1), whole(1)));
    return floor_div(add(mul(v, top), place), whole(16711680));
}

number rgb565(const channels *c, number t)
{
    number red = dither(c->v[0], whole(31), t);
    number green = dither(c->v[1], whole(63), t);
    return add(add(up(red, 11), up(green, 5)), dither(c->v[2], whole(31), t));
}
