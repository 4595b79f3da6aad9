#include "tables.h"

#include <mpfr.h>

/* Far more bits than 32 and those of any cancellation below: no rounding is in doubt. */
enum { BITS = 256 };
enum { POWERS = 64, OCTAVE = 32, LEVELS = 256, PIECES = 48 };

static number powers[POWERS], reciprocals[OCTAVE], depths[OCTAVE], extinctions[LEVELS];
static number ends[PIECES], linears[PIECES], squares[PIECES], cubes[PIECES];

static number entry(number table[], long count, number i)
{
    const long place = small(i);
    if (place < 0 || place >= count)
        fail("entry %ld of a table of %ld", place, count);
    return table[place];
}

number exp_power(number i)
{
    return entry(powers, POWERS, i);
}

number log_reciprocal(number i)
{
    return entry(reciprocals, OCTAVE, i);
}

number log_depth(number i)
{
    return entry(depths, OCTAVE, i);
}

number phi_end(number i)
{
    return entry(ends, PIECES, i);
}

number phi_linear(number i)
{
    return entry(linears, PIECES, i);
}

number phi_square(number i)
{
    return entry(squares, PIECES, i);
}

number phi_cube(number i)
{
    return entry(cubes, PIECES, i);
}

number ext8(number a)
{
    return entry(extinctions, LEVELS, a);
}

/* round(2^exponent * x). */
static number round_scaled(const mpfr_t x, int exponent)
{
    mpfr_t scaled;
    mpz_t integer;
    mpfr_init2(scaled, BITS);
    mpz_init(integer);
    mpfr_mul_2si(scaled, x, exponent, MPFR_RNDN);
    mpfr_add_d(scaled, scaled, 0.5, MPFR_RNDN);
    mpfr_get_z(integer, scaled, MPFR_RNDD);
    number result = add(integer, whole(0)); /* a copy that the store keeps */
    mpz_clear(integer);
    mpfr_clear(scaled);
    return result;
}

/* Section 27: round(2^(31 + i/64)). */
static number make_power(unsigned i)
{
    mpfr_t x;
    mpfr_init2(x, BITS);
    mpfr_set_ui(x, i, MPFR_RNDN);
    mpfr_div_ui(x, x, POWERS, MPFR_RNDN);
    mpfr_exp2(x, x, MPFR_RNDN);
    number result = round_scaled(x, 31);
    mpfr_clear(x);
    return result;
}

/* Section 28: (round(2^31 * log2(reciprocal / 2^15)) - 1) mod 2^32. */
static number make_depth(number reciprocal)
{
    mpfr_t x;
    mpfr_init2(x, BITS);
    mpfr_set_z(x, reciprocal, MPFR_RNDN);
    mpfr_log2(x, x, MPFR_RNDN);
    mpfr_sub_ui(x, x, 15, MPFR_RNDN);
    number result = low_bits(sub(round_scaled(x, 31), whole(1)), 32);
    mpfr_clear(x);
    return result;
}

/* Section 28: round(2^24 * -log2(1 - a/255)), and 64 * 2^24 for 255. */
static number make_extinction(unsigned a)
{
    if (a == 255)
        return up(whole(64), 24);
    mpfr_t x;
    mpfr_init2(x, BITS);
    mpfr_set_ui(x, 255 - a, MPFR_RNDN);
    mpfr_div_ui(x, x, 255, MPFR_RNDN);
    mpfr_log2(x, x, MPFR_RNDN);
    mpfr_neg(x, x, MPFR_RNDN);
    number result = round_scaled(x, 24);
    mpfr_clear(x);
    return result;
}

/* Section 29: x(t) of piece i, whose way t leads back from its end. */
static void piece_depth(mpfr_t x, unsigned i, const mpfr_t t)
{
    const unsigned o = i / 8, j = i % 8;
    mpfr_ui_sub(x, j + 1, t, MPFR_RNDN);
    mpfr_div_ui(x, x, 8, MPFR_RNDN);
    mpfr_add_ui(x, x, o == 0 ? 0 : 1, MPFR_RNDN);
    mpfr_mul_2ui(x, x, o == 0 ? 1 : o, MPFR_RNDN);
}

/* Section 29: g(t) = 2^o phi(x(t)), and 2^o / (x(t) ln 2) in the last octave. */
static void piece_value(mpfr_t g, unsigned i, const mpfr_t t)
{
    mpfr_t x, y;
    mpfr_inits2(BITS, x, y, (mpfr_ptr)0);
    piece_depth(x, i, t);
    if (mpfr_zero_p(x)) {
        mpfr_set_ui(g, 1, MPFR_RNDN);
    } else {
        mpfr_neg(y, x, MPFR_RNDN);
        mpfr_exp2(y, y, MPFR_RNDN);
        mpfr_ui_sub(g, 1, y, MPFR_RNDN);
        if (i / 8 == 5)
            mpfr_set_ui(g, 1, MPFR_RNDN);
        mpfr_const_log2(y, MPFR_RNDN);
        mpfr_mul(y, y, x, MPFR_RNDN);
        mpfr_div(g, g, y, MPFR_RNDN);
        mpfr_mul_2ui(g, g, i / 8, MPFR_RNDN);
    }
    mpfr_clears(x, y, (mpfr_ptr)0);
}

/* What the cubic through g at 0, t and 1 has to bend there: (chord(t) - g(t)) / (t (1 - t)),
   which is c2 + c3 (1 + t). */
static void bend(mpfr_t u, unsigned i, const mpfr_t t)
{
    mpfr_t zero, one, first, last;
    mpfr_inits2(BITS, zero, one, first, last, (mpfr_ptr)0);
    mpfr_set_ui(zero, 0, MPFR_RNDN);
    mpfr_set_ui(one, 1, MPFR_RNDN);
    piece_value(first, i, zero);
    piece_value(last, i, one);
    piece_value(u, i, t);
    mpfr_sub(last, last, first, MPFR_RNDN);
    mpfr_fma(first, last, t, first, MPFR_RNDN);
    mpfr_sub(u, first, u, MPFR_RNDN);
    mpfr_ui_sub(one, 1, t, MPFR_RNDN);
    mpfr_mul(one, one, t, MPFR_RNDN);
    mpfr_div(u, u, one, MPFR_RNDN);
    mpfr_clears(zero, one, first, last, (mpfr_ptr)0);
}

/* The curve of piece i: c3 from the two bends at 1 - sqrt(1/2) and sqrt(1/2), then c2. */
static void make_curve(unsigned i)
{
    mpfr_t near, far, square, cube;
    mpfr_inits2(BITS, near, far, square, cube, (mpfr_ptr)0);
    mpfr_sqrt_ui(far, 2, MPFR_RNDN);
    mpfr_div_ui(far, far, 2, MPFR_RNDN);
    mpfr_ui_sub(near, 1, far, MPFR_RNDN);
    bend(square, i, near);
    bend(cube, i, far);
    mpfr_sub(cube, cube, square, MPFR_RNDN);
    mpfr_sub(far, far, near, MPFR_RNDN);
    mpfr_div(cube, cube, far, MPFR_RNDN);
    cubes[i] = fits_unsigned(round_scaled(cube, 24), 16);
    mpfr_add_ui(near, near, 1, MPFR_RNDN);
    mpfr_mul(cube, cube, near, MPFR_RNDN);
    mpfr_sub(square, square, cube, MPFR_RNDN);
    squares[i] = fits_unsigned(round_scaled(square, 21), 16);
    mpfr_clears(near, far, square, cube, (mpfr_ptr)0);
}

/* The ends of piece i. The linear term takes what the rounding of the others left. */
static void make_ends(unsigned i)
{
    mpfr_t place, value;
    mpfr_inits2(BITS, place, value, (mpfr_ptr)0);
    mpfr_set_ui(place, 0, MPFR_RNDN);
    piece_value(value, i, place);
    ends[i] = fits_unsigned(round_scaled(value, 31), 32);
    mpfr_set_ui(place, 1, MPFR_RNDN);
    piece_value(value, i, place);
    number full = whole(65535);
    number curved = add(mul(whole(1024), squares[i]), down(mul(cubes[i], full), 9));
    number rest = sub(sub(round_scaled(value, 31), ends[i]), down(mul(curved, full), 16));
    linears[i] = fits_unsigned(rest, 32);
    mpfr_clears(place, value, (mpfr_ptr)0);
}

void tables_make(void)
{
    for (unsigned i = 0; i < POWERS; i++)
        powers[i] = make_power(i);
    for (unsigned i = 0; i < OCTAVE; i++) {
        reciprocals[i] = floor_div(power2(21), whole(33 + i));
        depths[i] = make_depth(reciprocals[i]);
    }
    for (unsigned a = 0; a < LEVELS; a++)
        extinctions[a] = make_extinction(a);
    for (unsigned i = 0; i < PIECES; i++) {
        make_curve(i);
        make_ends(i);
    }
    mpfr_free_cache();
}
