#include "view.h"

#include "operations.h"

enum { TERMS = 5 };

static number series(const int64_t k[TERMS], number w)
{
    number t = whole(k[0]);
    for (int i = 1; i < TERMS; i++)
        t = fits_unsigned(sub(whole(k[i]), hi(w, t)), 32);
    return t;
}

turn turn_of(number angle)
{
    static const int64_t ks[TERMS] = {0x0000053B, 0x000265A6, 0x00A335E3, 0x14ABBCE6, 0xC90FDAA2};
    static const int64_t kc[TERMS] = {0x0000006A, 0x00003C3F, 0x00155D3C, 0x040F07C2, 0x4EF4F327};
    const unsigned q = (unsigned)small(down(fits_unsigned(angle, 32), 30));
    number r = low_bits(angle, 30);
    const bool m = is_less(power2(29), r);
    number e = m ? sub(power2(30), r) : r;
    number u = is_equal(e, power2(29)) ? sub(power2(32), whole(1)) : up(e, 3);
    number w = hi(u, u);
    number S = rounded(hi(u, series(ks, w)), 2);
    number C = sub(power2(30), rounded(hi(w, series(kc, w)), 2));
    const bool swapped = m != (q % 2 == 1);
    number p = swapped ? S : C, o = swapped ? C : S;
    return (turn){q >= 2 ? negative(o) : o, q == 1 || q == 2 ? negative(p) : p};
}

number voxels(number length, number spacing)
{
    number wide = add(up(length, 32), down(spacing, 1));
    return fits_signed(floor_div(wide, spacing), 64);
}

rotation rotation_of(number azimuth, number elevation, number roll)
{
    const turn a = turn_of(azimuth), e = turn_of(elevation), r = turn_of(roll);
    const triple right = {{a.cosine, a.sine, whole(0)}};
    const triple lower = {
        {q30(a.sine, e.sine), negative(q30(a.cosine, e.sine)), negative(e.cosine)}};
    rotation M;
    M.row[2] =
        (triple){{negative(q30(a.sine, e.cosine)), q30(a.cosine, e.cosine), negative(e.sine)}};
    for (int i = 0; i < 3; i++) {
        M.row[0].v[i] = add(q30(right.v[i], r.cosine), q30(lower.v[i], r.sine));
        M.row[1].v[i] = sub(q30(lower.v[i], r.cosine), q30(right.v[i], r.sine));
    }
    return M;
}

/* From the centre of the frame's first pixel to its own, on one axis. */
static number half_of_frame(const view *v, number across, number lower)
{
    number whole_of = add(mul(across, sub(v->W, whole(1))), mul(lower, sub(v->H, whole(1))));
    return rounded(whole_of, 1);
}

camera orthographic(const view *v)
{
    camera c = {.is_perspective = false};
    for (int a = 0; a < 3; a++) {
        number pitch = voxels(v->pitch, v->spacing.v[a]);
        c.across.v[a] = q30(pitch, v->M.row[0].v[a]);
        c.down.v[a] = q30(pitch, v->M.row[1].v[a]);
        c.along.v[a] = q30(voxels(v->step, v->spacing.v[a]), v->M.row[2].v[a]);
        number half = half_of_frame(v, c.across.v[a], c.down.v[a]);
        c.origin.v[a] = sub(up(v->size.v[a], 31), half);
        c.pace.v[a] = whole(0);
    }
    return c;
}

/* Half the height of the frame, by the cotangent of half the field. */
static number eye_distance(const view *v, number field)
{
    const turn half = turn_of(down(field, 1));
    number cot = floor_div(up(half.cosine, 32), half.sine);
    return down(mul(fits_unsigned(mul(v->pitch, v->H), 32), cot), 17);
}

static number to_voxels(number length, number spacing)
{
    number wide = add(up(magnitude(length), 16), down(spacing, 1));
    return with_sign(floor_div(wide, spacing), length);
}

camera perspective(const view *v, number field)
{
    camera c = {.is_perspective = true};
    number distance = eye_distance(v, field);
    number pitch = up(v->pitch, 16);
    for (int a = 0; a < 3; a++) {
        number back = q30(distance, v->M.row[2].v[a]);
        c.across.v[a] = q30(pitch, v->M.row[0].v[a]);
        c.down.v[a] = q30(pitch, v->M.row[1].v[a]);
        c.along.v[a] = sub(back, half_of_frame(v, c.across.v[a], c.down.v[a]));
        c.origin.v[a] = sub(up(v->size.v[a], 31), to_voxels(back, v->spacing.v[a]));
        c.pace.v[a] = voxels(v->step, v->spacing.v[a]);
    }
    return c;
}
