/*
 * crc32.c - CRC-32, four bits at a time: the table takes 64 bytes of flash.
 */
#include "crc32.h"

/* Remainders of the 16 values of a nibble: n times x^32 modulo the reflected
   polynomial 0xEDB88320. */
static const uint32_t remainders[16] = {
    0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
    0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
    0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu,
};

uint32_t crc32_update(uint32_t crc, const void *bytes, size_t count)
{
    const uint8_t *byte = bytes;
    const uint8_t *end = byte + count;
    crc = ~crc;
    for (; byte != end; byte++) {
        crc = (crc >> 4) ^ remainders[(crc ^ *byte) & 15u];
        crc = (crc >> 4) ^ remainders[(crc ^ (uint32_t)(*byte >> 4)) & 15u];
    }
    return ~crc;
}
