#include "bearing.h"

#include "depth.h"
#include "freevoxels.h"
#include "operations.h"

/* div, whose divisor of 2^31 and more is halved with what is divided. */
static number halved_div(number n, number d)
{
    return is_less(d, power2(31)) ? floor_div(n, d) : floor_div(down(n, 1), down(d, 1));
}

compass compass_of(const triple *spacing, bool has_unit)
{
    compass c = {.spacing = *spacing, .has_unit = has_unit};
    triple step;
    for (int a = 0; a < 3; a++)
        step.v[a] = up(spacing->v[a], 7);
    number longest = length_of(&step);
    for (int a = 0; a < 3; a++)
        c.side.v[a] = halved_div(up(spacing->v[a], 38), longest);
    return c;
}

/* inverse[g] of the axes along which a step moves, u32.19. */
static number inverse_of(const compass *c, const triple *step)
{
    triple v;
    for (int a = 0; a < 3; a++)
        v.v[a] = sign_of(step->v[a]) == 0 ? whole(0) : c->side.v[a];
    return halved_div(power2(50), length_of(&v));
}

static number greatest_of(const triple *v)
{
    return most(magnitude(v->v[0]), most(magnitude(v->v[1]), magnitude(v->v[2])));
}

/* The greatest magnitude becomes 2^30 .. 2^31 - 1; what is below is cut towards 0. */
static triple scaled_vector(const triple *v)
{
    const unsigned bits = bits_of(greatest_of(v));
    triple r;
    for (int a = 0; a < 3; a++) {
        number size = magnitude(v->v[a]);
        number cut = bits > 31 ? down(size, bits - 31) : up(size, 31 - bits);
        r.v[a] = with_sign(cut, v->v[a]);
    }
    return r;
}

/* h(m): the share of axis m in the greatest magnitude, u32.30. */
static number height(number size, number greatest)
{
    if (is_equal(size, greatest))
        return power2(30);
    return least(power2(30), down(mul(size, recip(greatest)), 28));
}

static triple heights(const triple *v)
{
    triple h;
    number greatest = greatest_of(v);
    for (int a = 0; a < 3; a++)
        h.v[a] = height(magnitude(v->v[a]), greatest);
    return h;
}

static number length_of_light(const compass *c, const triple *h)
{
    triple way;
    for (int a = 0; a < 3; a++)
        way.v[a] = down(mul(h->v[a], c->side.v[a]), 30);
    return least(power2(31), length_of(&way));
}

static number scale_of(const compass *c, const triple *step, number length)
{
    return c->has_unit ? down(mul(inverse_of(c, step), length), 31) : power2(19);
}

/* Axes by falling magnitude, of equals the lower one first. */
static void sort_axes(unsigned axis[3], const triple *v)
{
    for (unsigned i = 0; i < 3; i++) {
        unsigned place = i;
        for (; place > 0; place--) {
            if (!is_less(magnitude(v->v[axis[place - 1]]), magnitude(v->v[i])))
                break;
            axis[place] = axis[place - 1];
        }
        axis[place] = i;
    }
}

static unsigned direction_of(const triple *step)
{
    const long q = 13 + small(step->v[0]) + 3 * small(step->v[1]) + 9 * small(step->v[2]);
    return (unsigned)(q < 13 ? q : q - 1);
}

static void add_share(bearing *b, const triple *step, number own, number scale)
{
    b->direction[b->count] = direction_of(step);
    b->own[b->count] = own;
    b->scale[b->count] = scale;
    b->count++;
}

static bearing between_three(const compass *c, const triple *v, enum interpolation kind)
{
    unsigned axis[3];
    bearing b = {.kind = kind};
    const triple h = heights(v);
    number length = length_of_light(c, &h);
    sort_axes(axis, v);
    number second = h.v[axis[1]], third = h.v[axis[2]];
    number own[3] = {sub(power2(30), second), sub(second, third), third};
    triple step = {{whole(0), whole(0), whole(0)}};
    for (unsigned i = 0; i < 3; i++) {
        step.v[axis[i]] = with_sign(whole(1), v->v[axis[i]]);
        if (is_equal(own[i], power2(30))) {
            add_share(&b, &step, own[i], power2(19));
        } else if (sign_of(own[i]) != 0) {
            number scale = scale_of(c, &step, length);
            if (kind == BETWEEN_DEPTHS)
                scale = down(mul(scale, own[i]), 30);
            add_share(&b, &step, own[i], scale);
        }
    }
    return b;
}

/* c of a direction: how far light along size goes its way. */
static number closeness(const compass *c, const triple *w, const triple *step)
{
    number sum = whole(0);
    for (int a = 0; a < 3; a++) {
        if (sign_of(step->v[a]) == 0)
            continue;
        number part = down(mul(magnitude(w->v[a]), c->side.v[a]), 31);
        const bool is_back = sign_of(w->v[a]) < 0;
        sum = is_back == (sign_of(step->v[a]) < 0) ? add(sum, part) : sub(sum, part);
    }
    return mul(down(inverse_of(c, step), 1), sum);
}

static bool is_along(const triple *v, const triple *step)
{
    number greatest = greatest_of(v);
    for (int a = 0; a < 3; a++) {
        number wanted = sign_of(step->v[a]) == 0 ? whole(0) : greatest;
        if (!is_equal(magnitude(v->v[a]), wanted))
            return false;
    }
    return true;
}

static bearing nearest_direction(const compass *c, const triple *v)
{
    bearing b = {.kind = NEAREST_DIRECTION};
    triple size, w, nearest = {{NULL, NULL, NULL}};
    for (int a = 0; a < 3; a++) {
        size.v[a] = down(mul(magnitude(v->v[a]), c->side.v[a]), 31);
        w.v[a] = with_sign(size.v[a], v->v[a]);
    }
    number bound = up(length_of(&size), 17);
    for (unsigned d = 0; d < DIRECTIONS; d++) {
        const triple step = direction_step(whole(d));
        number close = closeness(c, &w, &step);
        if (is_less(bound, close)) {
            bound = close;
            nearest = step;
        }
    }
    if (nearest.v[0] == NULL)
        return b;
    const triple h = heights(v);
    number scale = scale_of(c, &nearest, length_of_light(c, &h));
    add_share(&b, &nearest, power2(30), is_along(v, &nearest) ? power2(19) : scale);
    return b;
}

bearing bearing_of(const compass *c, const triple *vector, enum interpolation kind)
{
    const triple v = scaled_vector(vector);
    return kind == NEAREST_DIRECTION ? nearest_direction(c, &v) : between_three(c, &v, kind);
}

static number pass(number d)
{
    number T = transmittance(d);
    return sub(up(T, 1), down(T, 31));
}

static number depth_of_byte(number byte, number scale)
{
    number E =
        sign_of(byte) == 0 ? up(whole(10), 24) : ext16(mul(whole(257), sub(whole(255), byte)));
    return down(mul(scale, E), 11);
}

static number light_by_depths(const bearing *of, const number byte[])
{
    number sum = whole(0);
    bool is_dark = true;
    for (unsigned i = 0; i < of->count; i++) {
        number b = byte[of->direction[i]];
        is_dark = is_dark && sign_of(b) == 0;
        sum = add(sum, depth_of_byte(b, of->scale[i]));
    }
    return is_dark ? whole(0) : pass(sum);
}

number light_through(const bearing *of, const number byte[])
{
    if (of->kind == BETWEEN_DEPTHS && of->count > 1)
        return light_by_depths(of, byte);
    number sum = whole(0);
    for (unsigned i = 0; i < of->count; i++) {
        number b = byte[of->direction[i]];
        const bool is_exact = sign_of(b) == 0 || is_equal(of->scale[i], power2(19));
        number part = is_exact ? mul(whole(0x01010101), b) : pass(depth_of_byte(b, of->scale[i]));
        sum = add(sum, mul(part, of->own[i]));
    }
    return fits_unsigned(rounded(sum, 30), 32);
}

number light_from_eye(number of_voxel, number of_eye)
{
    if (sign_of(of_voxel) == 0 || sign_of(of_eye) == 0)
        return whole(0);
    return pass(most(whole(0), sub(depth_of(of_voxel), depth_of(of_eye))));
}

triple lamp_vector(const triple *direction, const triple *spacing)
{
    triple v;
    for (int a = 0; a < 3; a++) {
        number size = floor_div(up(magnitude(direction->v[a]), 40), spacing->v[a]);
        v.v[a] = with_sign(size, direction->v[a]);
    }
    return v;
}
