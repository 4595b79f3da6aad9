/*
 * fx_number.h - how the numbers of the sampling kernel are represented.
 *
 * In an ordinary build they are unsigned integers. With FX_COUNTING they are
 * structures, so that a raw * or + does not compile, and every named
 * multiplication and addition is counted: the test of the operation counts of
 * Wittenbrink et al., table 1, runs the shipped kernel this way.
 */
#ifndef FX_NUMBER_H
#define FX_NUMBER_H

#include <stdint.h>

#ifndef FX_COUNTING
#define FX_COUNTING 0
#endif

/* Defines the type `name` with name_of(bits) and name_bits(number). */
#if FX_COUNTING
extern unsigned long fx_multiplications, fx_additions;
#define FX_COUNT(operations) ((void)((operations)++))
#define FX_NUMBER(name)                                                                            \
    typedef struct {                                                                               \
        uint32_t bits;                                                                             \
    } name;                                                                                        \
    static inline name name##_of(uint32_t bits)                                                    \
    {                                                                                              \
        name number = {bits};                                                                      \
        return number;                                                                             \
    }                                                                                              \
    static inline uint32_t name##_bits(name number)                                                \
    {                                                                                              \
        return number.bits;                                                                        \
    }
#else
#define FX_COUNT(operations) ((void)0)
#define FX_NUMBER(name)                                                                            \
    typedef uint32_t name;                                                                         \
    static inline name name##_of(uint32_t bits)                                                    \
    {                                                                                              \
        return bits;                                                                               \
    }                                                                                              \
    static inline uint32_t name##_bits(name number)                                                \
    {                                                                                              \
        return number;                                                                             \
    }
#endif

#endif /* FX_NUMBER_H */
