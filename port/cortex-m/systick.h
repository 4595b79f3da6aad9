/*
 * systick.h - counting with the system timer of every Cortex-M.
 *
 * Under an emulator that lets each instruction take the same time, the ticks
 * tell the instructions; on a real device they are cycles.
 */
#ifndef SYSTICK_H
#define SYSTICK_H

#include <stdint.h>

void systick_start(void);

/* Ticks since systick_start. */
uint64_t systick_ticks(void);

/* Instructions that take this long when each takes 2^8 ns (-icount shift=8). */
uint32_t systick_instructions(uint64_t ticks);

#endif /* SYSTICK_H */
