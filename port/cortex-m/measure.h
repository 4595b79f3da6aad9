/*
 * measure.h - marks for the counting plugin, tests/emulator/count.c.
 *
 * The plugin counts the instructions between the two calls, and how far the
 * stack grows below the caller of measure_begin.
 */
#ifndef MEASURE_H
#define MEASURE_H

void measure_begin(void);
void measure_end(void);

#endif /* MEASURE_H */
