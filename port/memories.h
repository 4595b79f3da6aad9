/*
 * memories.h - what start-up code does to RAM before main.
 */
#ifndef MEMORIES_H
#define MEMORIES_H

/* Copies the initial values of static data from flash, and clears the rest. Names that begin with
   `link_` come from the linker script. */
void memories_load(void);

#endif /* MEMORIES_H */
