/*
 * measure.h - marks for what counts: the plugin tests/emulator/count.c on a Cortex-M,
 * the simulator tests/emulator/avr.c on an AVR.
 *
 * Counted is what the firmware executes between the two calls; on a Cortex-M also how
 * far the stack grows below the caller of measure_begin.
 */
#ifndef MEASURE_H
#define MEASURE_H

void measure_begin(void);
void measure_end(void);

#endif /* MEASURE_H */
