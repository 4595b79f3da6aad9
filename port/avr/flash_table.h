/*
 * flash_table.h - tables of fixedpoint/ in program memory, which only instructions of its
 * own read: below 64 KB, where avr-libc's linker scripts put it (see fx_table.h).
 */
#ifndef FLASH_TABLE_H
#define FLASH_TABLE_H

#include <avr/pgmspace.h>

#define FX_TABLE static const PROGMEM

static inline uint8_t fx_table8(const uint8_t *entry)
{
    return pgm_read_byte(entry);
}

static inline uint16_t fx_table16(const uint16_t *entry)
{
    return pgm_read_word(entry);
}

static inline uint32_t fx_table32(const uint32_t *entry)
{
    return pgm_read_dword(entry);
}

#endif /* FLASH_TABLE_H */
