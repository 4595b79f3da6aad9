/* The stage of sections 65 and 68: lamps. */
#include "stages.h"

#include "bearing.h"

/* Transmittance of a voxel to a lamp. */
static number lamp_light(const compass *of, const triple *direction, enum interpolation kind,
                         const number byte[])
{
    const triple v = lamp_vector(direction, &of->spacing);
    const bearing b = bearing_of(of, &v, kind);
    return light_through(&b, byte);
}

/* C of a channel, of the light q, u51. */
static number lit_colour(number colour, number q)
{
    number light = least(whole(65535), rounded(q, 32));
    number wide = up(mul(colour, light), 1);
    return floor_div(add(wide, whole(65535)), whole(131070));
}

void stage_lamp(csv *c)
{
    const triple spacing = in_triple(c, "spacing");
    const compass of = compass_of(&spacing, sign_of(in(c, "unit")) != 0);
    const enum interpolation kind = (enum interpolation)small(in(c, "interpolation"));
    const triple da = in_triple(c, "da"), db = in_triple(c, "db");
    const triple ca = in_triple(c, "ca"), cb = in_triple(c, "cb");
    const triple ambient = in_triple(c, "ambient"), rgb = in_triple(c, "rgb");
    const long count = small(in(c, "count"));
    number byte[DIRECTIONS], of_eye[DIRECTIONS];
    in_all(c, "byte", byte, DIRECTIONS);
    for (unsigned d = 0; d < DIRECTIONS; d++)
        of_eye[d] = in(c, "eye");
    number ta = count > 0 ? lamp_light(&of, &da, kind, byte) : whole(0);
    number tb = count > 1 ? lamp_light(&of, &db, kind, byte) : whole(0);
    number inside = whole(0);
    if (count > 0)
        inside = light_from_eye(ta, lamp_light(&of, &da, kind, of_eye));
    bool is_lit = count > 0;
    for (int i = 0; i < 3; i++)
        is_lit = is_lit || sign_of(ambient.v[i]) != 0;
    out(c, ta, "ta");
    out(c, tb, "tb");
    out(c, inside, "inside");
    for (unsigned i = 0; i < 3; i++) {
        number lamps = add(mul(ta, ca.v[i]), mul(tb, cb.v[i]));
        number q = add(up(ambient.v[i], 32), lamps);
        out(c, is_lit ? lit_colour(rgb.v[i], q) : rgb.v[i], "lit%u", i);
    }
}
