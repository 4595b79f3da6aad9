/*
 * poison.h - makes the compiler reject floating point, even in a constant that
 * would leave no trace in the object.
 */
#pragma GCC poison float double
