/*
 * number.h - the numbers of tests/SPEC.md, section 1: whole, exact and without bounds.
 *
 * A number never changes. All are kept in one store that numbers_forget() empties, so
 * that formulas can be written as expressions; what must last longer is kept elsewhere.
 * Where SPEC.md states a width, fits_unsigned and fits_signed hold the number to it:
 * the program ends where one does not fit, as then SPEC.md is wrong.
 */
#ifndef NUMBER_H
#define NUMBER_H

#include <gmp.h>
#include <stdbool.h>
#include <stdint.h>

typedef mpz_srcptr number;

/* Three axes, or three colours. */
typedef struct triple {
    number v[3];
} triple;

number whole(int64_t value);
number power2(unsigned n);
number parse(const char *decimal); /* NULL where it is no decimal number */

number add(number a, number b);
number sub(number a, number b);
number mul(number a, number b);
number negative(number a);
number magnitude(number a);
number floor_div(number a, number b);  /* floor(a / b) */
number up(number a, unsigned n);       /* a * 2^n */
number down(number a, unsigned n);     /* floor(a / 2^n) */
number rounded(number a, unsigned n);  /* round(a / 2^n): to nearest, ties upwards; n > 0 */
number low_bits(number a, unsigned n); /* a mod 2^n */
number either(number a, number b);     /* a xor b, both at least 0 */
number least(number a, number b);
number most(number a, number b);
number clamp(number a, number from, number to);
number with_sign(number size, number of); /* sign(of) * size; the sign of 0 is 1 */

int sign_of(number a); /* -1, 0, 1 */
bool is_less(number a, number b);
bool is_equal(number a, number b);
unsigned bits_of(number a); /* of the magnitude: 0 for 0 */
long small(number a);       /* as a C number, which must hold it */
bool bit_of(number a, unsigned n);

number fits_unsigned(number a, unsigned width); /* a, which is 0 .. 2^width - 1 */
number fits_signed(number a, unsigned width);   /* a, which is -2^(width-1) .. 2^(width-1) - 1 */

/* All numbers end here, but for those made before numbers_keep was called. */
void numbers_keep(void);
void numbers_forget(void);

/* Says what is wrong, with the place that numbers_at told last, and ends the program. */
void numbers_at(const char *place);
void fail(const char *format, ...);

#endif /* NUMBER_H */
