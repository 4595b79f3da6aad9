/*
 * vector_explain.h - one test vector, step by step.
 */
#ifndef QVOL_HOST_VECTOR_EXPLAIN_H
#define QVOL_HOST_VECTOR_EXPLAIN_H

#include "vector_files.h"

/* Prints each column of a row: its value, what that stands for, and its formula, with names and
   then with numbers. */
void vector_explain(const struct vectors *vectors, size_t row);

#endif
