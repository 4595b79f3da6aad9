/*
 * fx_table.h - how the tables of functions are kept and read.
 *
 * A port whose constants do not lie in ordinary memory names a header in
 * FX_TABLE_HEADER that defines FX_TABLE and the three accessors.
 */
#ifndef FX_TABLE_H
#define FX_TABLE_H

#include <stdint.h>

#ifdef FX_TABLE_HEADER
#include FX_TABLE_HEADER
#else

#define FX_TABLE static const

static inline uint8_t fx_table8(const uint8_t *entry)
{
    return *entry;
}

static inline uint16_t fx_table16(const uint16_t *entry)
{
    return *entry;
}

static inline uint32_t fx_table32(const uint32_t *entry)
{
    return *entry;
}

#endif

#endif /* FX_TABLE_H */
