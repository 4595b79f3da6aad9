/*
 * program_memory.h - where a package can give no options to the compiler, its headers include this
 * file first (toolchain/dist): on an AVR it names those that keep constants in program memory.
 */
#ifndef PROGRAM_MEMORY_H
#define PROGRAM_MEMORY_H

#if defined(__AVR__) && !defined(QV_MEMORY_HEADER)
#define QV_MEMORY_HEADER "qvol/volume_flash.h"
#define FX_TABLE_HEADER  "flash_table.h"
#endif

#endif /* PROGRAM_MEMORY_H */
