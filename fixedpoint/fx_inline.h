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
#define FX_DISSOLVED inline __attribute__((always_inline))
#define FX_NOINLINE  __attribute__((noinline))
#else
#define FX_DISSOLVED inline
#define FX_NOINLINE
#endif
#define FX_INLINE static FX_DISSOLVED

/* Where size counts, -Os, parts of an inner loop are functions that modes share, and frames are
   small; else the loop is one piece, which costs stack and saves calls. */
#if defined(__OPTIMIZE_SIZE__)
#define FX_SMALL 1
#define FX_APART FX_NOINLINE
#else
#define FX_SMALL 0
#define FX_APART FX_DISSOLVED
#endif

/* In front of a loop of at most 8 rounds whose arrays are to become registers. Where size counts,
   it stays a loop; other compilers decide for themselves. */
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__) && !FX_SMALL
#define FX_UNROLL _Pragma("GCC unroll 8")
#else
#define FX_UNROLL
#endif

/* Has compilers store what they keep of memory in registers, and read it anew where it is wanted:
   where registers are few, that is cheaper than to spill them. */
#if defined(__GNUC__)
#define FX_FORGET() __asm__ volatile("" ::: "memory")
#else
#define FX_FORGET() ((void)0)
#endif

/* Has GCC read memory in the order that is written, where it else reads ahead more than it has
   registers for. */
#if defined(__riscv) || defined(__ARM_ARCH_6M__)
#define FX_IN_ORDER() FX_FORGET()
#else
#define FX_IN_ORDER() ((void)0)
#endif

#endif /* FX_INLINE_H */
