/*
 * set.h - the modes of a set, listed by the names of their descriptors.
 */
#ifndef GOLDEN_SET_H
#define GOLDEN_SET_H

#include "scenes.h"

#define COUNT(table) (sizeof(table) / sizeof *(table))

/* One mode. */
#define MODE(name, family, towards)                                                                \
    {                                                                                              \
        &name, family, towards                                                                     \
    }

/* The storages that hold opacity, and those that hold extinction; `order` is the end of
   the descriptors' names. */
#define OPACITY_MODES(mode, order, family, towards)                                                \
    MODE(mode##_rgba8##order, family, towards), MODE(mode##_rgba16##order, family, towards),       \
        MODE(mode##_indexed8##order, family, towards),                                             \
        MODE(mode##_indexed8_16##order, family, towards)
#define EXTINCTION_MODES(mode, order, family, towards)                                             \
    MODE(mode##_rgbt8##order, family, towards), MODE(mode##_rgbt16##order, family, towards),       \
        MODE(mode##_indexed8_t8##order, family, towards),                                          \
        MODE(mode##_indexed8_t16##order, family, towards)

#endif /* GOLDEN_SET_H */
