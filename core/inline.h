/*
 * inline.h - functions that must dissolve into their caller.
 *
 * The sampling modes are one loop put together from small parts that are passed
 * as constant arguments; inlined, no call and no pointer is left of them.
 */
#ifndef QV_INLINE_H
#define QV_INLINE_H

#if defined(__GNUC__)
#define QV_INLINE static inline __attribute__((always_inline))
#else
#define QV_INLINE static inline
#endif

#endif /* QV_INLINE_H */
