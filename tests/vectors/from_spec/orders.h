/*
 * orders.h - tests/SPEC.md, section 61: numbers of voxels in three orders.
 */
#ifndef ORDERS_H
#define ORDERS_H

#include "number.h"

number linear_index(const triple *n, const triple *p);
number curve_index(const triple *n, const triple *p, bool is_hilbert);

#endif /* ORDERS_H */
