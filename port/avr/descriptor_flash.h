/*
 * descriptor_flash.h - the library's constants in program memory, in its lower half, as tables
 * are, so that they have pointers (see QV_DESCRIPTOR in qvol.h).
 */
#ifndef DESCRIPTOR_FLASH_H
#define DESCRIPTOR_FLASH_H

#include <avr/pgmspace.h>

/* A definition of a descriptor; and its field, by as many bytes as it has. */
#define QV_DESCRIPTOR const PROGMEM
#define QV_FIELD(descriptor, field)                                                                \
    ((__typeof__((descriptor)->field))__builtin_choose_expr(                                       \
        sizeof((descriptor)->field) == sizeof(uint32_t), pgm_read_dword(&(descriptor)->field),     \
        __builtin_choose_expr(sizeof((descriptor)->field) == sizeof(uint16_t),                     \
                              pgm_read_word(&(descriptor)->field),                                 \
                              pgm_read_byte(&(descriptor)->field))))

#endif /* DESCRIPTOR_FLASH_H */
