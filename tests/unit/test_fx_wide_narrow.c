/*
 * test_fx_wide.c once more, with the products that machines without a wide
 * multiplication use.
 */
#define FX_NARROW 1
#include "test_fx_wide.c"
