/*
 * operations.h - tests/SPEC.md, section 2, but for sines, and what others use like it.
 */
#ifndef OPERATIONS_H
#define OPERATIONS_H

#include "number.h"

number hi(number a, number b);
number shift16(number a, number b);
number q30(number v, number f);
number quot16(number n, number d);

/* 1/sqrt(n) = r * 2^-30 * 2^-x. */
typedef struct root {
    number r;
    unsigned x;
} root;

root rsqrt(number n);

number to8(number a);
number div255(number p);

/* The least integer s >= 0 with a * 2^(step s) >= bound; a > 0. */
unsigned least_shift(number a, unsigned step, number bound);

#endif /* OPERATIONS_H */
