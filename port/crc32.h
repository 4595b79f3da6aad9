/*
 * crc32.h - the checksum that the command, the firmware and the golden scenes
 * print: CRC-32 of ISO-HDLC, that is zlib's, PNG's and gzip's.
 */
#ifndef QVOL_CRC32_H
#define QVOL_CRC32_H

#include <stddef.h>
#include <stdint.h>

/* The CRC-32 of what gave `crc` followed by these bytes; start with crc 0. */
uint32_t crc32_update(uint32_t crc, const void *bytes, size_t count);

#endif /* QVOL_CRC32_H */
