/*
 * fx_inline.h - functions that must dissolve into their caller, and functions that must not.
 *
 * The sampling modes are one loop put together from small parts that are passed
 * as constant arguments; inlined, no call and no pointer is left of them.
 *
 * A step of some length keeps its temporaries in a stack frame of its own, which is gone before
 * the next step begins. Compilers that see its one caller would inline it, and the frame of all
 * steps together would lie below the deepest of them.
 */
#ifndef FX_INLINE_H
#define FX_INLINE_H

#if defined(__GNUC__)
#define FX_INLINE   static inline __attribute__((always_inline))
#define FX_NOINLINE __attribute__((noinline))
#else
#define FX_INLINE static inline
#define FX_NOINLINE
#endif

#endif /* FX_INLINE_H */
