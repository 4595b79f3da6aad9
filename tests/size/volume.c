/*
 * volume.c - the volume: what matters is that its bytes differ, so voxels and bytes of
 * attenuation are the same ones.
 */
#include "volume.h"

/* A port whose program memory has addresses of its own says how to get them. */
#ifdef FLASH_ADDRESS
#define IN_FLASH PROGMEM
#else
#define IN_FLASH
#define FLASH_ADDRESS(object) ((qv_address)(object))
#endif

#define FOUR(make, i) make(i), make((i) + 1), make((i) + 2), make((i) + 3)
#define SIXTEEN(make, i)                                                                           \
    FOUR(make, i), FOUR(make, (i) + 4), FOUR(make, (i) + 8), FOUR(make, (i) + 12)
#define ALL64(make, i)                                                                             \
    SIXTEEN(make, i), SIXTEEN(make, (i) + 16), SIXTEEN(make, (i) + 32), SIXTEEN(make, (i) + 48)
#define ALL256(make, i)                                                                            \
    ALL64(make, i), ALL64(make, (i) + 64), ALL64(make, (i) + 128), ALL64(make, (i) + 192)
#define ALL1024(make, i)                                                                           \
    ALL256(make, i), ALL256(make, (i) + 256), ALL256(make, (i) + 512), ALL256(make, (i) + 768)

#define BYTE(i) (uint8_t)((i)*97L >> 3 & 255)
#define COLOUR(i)                                                                                  \
    {                                                                                              \
        (i), 255 - (i), 128, (i) < 64 ? 0 : (i)                                                    \
    }

enum { BYTES = 4096 };
typedef char bytes_are_enough[BYTES >= VOLUME_VOXELS * QV_DIRECTIONS ? 1 : -1];

static const uint8_t bytes[BYTES] IN_FLASH = {ALL1024(BYTE, 0), ALL1024(BYTE, 1024),
                                              ALL1024(BYTE, 2048), ALL1024(BYTE, 3072)};
static const uint8_t palette[QV_PALETTE_ENTRIES][4] IN_FLASH = {ALL256(COLOUR, 0)};

void volume_describe(qv_volume *volume)
{
    *volume = (qv_volume){.voxels = FLASH_ADDRESS(bytes),
                          .voxels_bytes = VOLUME_VOXELS,
                          .palette = FLASH_ADDRESS(palette),
                          .palette_bytes = QV_PALETTE8_BYTES,
                          .storage = QV_STORAGE_INDEXED8,
                          .unit_distance = QV_ONE_Q16,
                          .size = {VOLUME_EDGE, VOLUME_EDGE, VOLUME_EDGE},
                          .stride = {1, VOLUME_EDGE, VOLUME_EDGE * VOLUME_EDGE}};
}

void volume_attenuation(qv_attenuation *attenuation)
{
    *attenuation = (qv_attenuation){.records = FLASH_ADDRESS(bytes),
                                    .bytes = BYTES,
                                    .directions = QV_DIRECTIONS_ALL,
                                    .size = {VOLUME_EDGE, VOLUME_EDGE, VOLUME_EDGE}};
}
