/*
 * stack.h - the high-water mark of the stack.
 *
 * The start-up code paints the free RAM between the data and the stack pointer;
 * later the lowest word that lost its paint tells how deep the stack has been.
 */
#ifndef STACK_H
#define STACK_H

#include <stdint.h>

extern uint32_t link_stack_limit[], link_stack_top[];

void stack_paint(void);

/* Bytes between the top of the stack and the deepest word ever written. */
uint32_t stack_high_water(void);

#endif /* STACK_H */
