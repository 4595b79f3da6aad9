/*
 * fx_inline.h - functions that must dissolve into their caller.
 *
 * The sampling modes are one loop put together from small parts that are passed
 * as constant arguments; inlined, no call and no pointer is left of them.
 */
#ifndef FX_INLINE_H
#define FX_INLINE_H

#if defined(__GNUC__)
#define FX_INLINE static inline __attribute__((always_inline))
#else
#define FX_INLINE static inline
#endif

#endif /* FX_INLINE_H */
