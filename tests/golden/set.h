/*
 * set.h - the modes of a set, listed by the names of their descriptors.
 */
#ifndef GOLDEN_SET_H
#define GOLDEN_SET_H

#include "scenes.h"

#define COUNT(table) (sizeof(table) / sizeof *(table))

/* Kinds of storages. A program for little flash links the modes of some of them, GOLDEN_STORAGES;
   the others stand in the tables without a sampling mode, so that scenes keep their numbers. */
#define DIRECT8   1
#define DIRECT16  2
#define INDEXED8  4
#define INDEXED16 8 /* of 8 bits each, entries of 16 */
#ifndef GOLDEN_STORAGES
#define GOLDEN_STORAGES (DIRECT8 | DIRECT16 | INDEXED8 | INDEXED16)
#endif

/* One mode. */
#define MODE(kind, name, family, towards)                                                          \
    {                                                                                              \
        (GOLDEN_STORAGES) & (kind) ? &name : NULL, family, towards                                 \
    }

/* The storages that hold opacity, and those that hold extinction; `order` is the end of
   the descriptors' names. */
#define OPACITY_MODES(mode, order, family, towards)                                                \
    MODE(DIRECT8, mode##_rgba8##order, family, towards),                                           \
        MODE(DIRECT16, mode##_rgba16##order, family, towards),                                     \
        MODE(INDEXED8, mode##_indexed8##order, family, towards),                                   \
        MODE(INDEXED16, mode##_indexed8_16##order, family, towards)
#define EXTINCTION_MODES(mode, order, family, towards)                                             \
    MODE(DIRECT8, mode##_rgbt8##order, family, towards),                                           \
        MODE(DIRECT16, mode##_rgbt16##order, family, towards),                                     \
        MODE(INDEXED8, mode##_indexed8_t8##order, family, towards),                                \
        MODE(INDEXED16, mode##_indexed8_t16##order, family, towards)

#endif /* GOLDEN_SET_H */
