/*
 * bytes.c - memcpy, memset and memmove: all that a compiler may call on its own
 * in freestanding code.
 *
 * The firmware is built with -fno-tree-loop-distribute-patterns, or GCC would
 * turn these loops into calls of themselves.
 */
#include <stddef.h>
#include <stdint.h>

void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memset(void *to, int value, size_t count);
void *memmove(void *to, const void *from, size_t count);

void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    uint8_t *restrict t = to;
    const uint8_t *restrict f = from;
    while (count-- > 0)
        *t++ = *f++;
    return to;
}

void *memset(void *to, int value, size_t count)
{
    uint8_t *t = to;
    while (count-- > 0)
        *t++ = (uint8_t)value;
    return to;
}

void *memmove(void *to, const void *from, size_t count)
{
    uint8_t *t = to;
    const uint8_t *f = from;
    if ((uintptr_t)to - (uintptr_t)from >= count)
        return memcpy(to, from, count); /* `to` is not inside the source */
    while (count-- > 0)
        t[count] = f[count];
    return to;
}
