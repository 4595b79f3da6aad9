/*
 * golden.h - CRC-32 of each golden scene: written by `make golden-update`.
 *
 * A new value here is a new picture, and a new version of tests/SPEC.md.
 */
#ifndef GOLDEN_H
#define GOLDEN_H

#include "scenes.h"

static const uint32_t golden_checksums[GOLDEN_SCENES] = {
    0xcec35df4u, /* 0 nearest, rgba8, front to back, perspective, rgba8888 */
    0xc1ba48deu, /* 1 nearest, rgba16, front to back, orthographic, bgra8888 */
    0x419f7dc8u, /* 2 nearest, indexed8, front to back, orthographic, rgb888 */
    0x37a76ea2u, /* 3 nearest, indexed8_16, front to back, perspective, rgb565_le */
    0x177f39a1u, /* 4 separate, rgba8, front to back, orthographic, rgb565_be */
    0xb2cb8ce5u, /* 5 separate, rgba16, front to back, perspective, l8 */
    0x80bbee65u, /* 6 separate, indexed8, front to back, orthographic, grey4 */
    0x574ebe02u, /* 7 separate, indexed8_16, front to back, perspective, mono_horizontal */
    0x761b9ab8u, /* 8 weighted, rgba8, front to back, perspective, mono_vertical */
    0x566d8c29u, /* 9 weighted, rgba16, front to back, perspective, rgba8888 */
    0xe11a0074u, /* 10 weighted, indexed8, front to back, orthographic, bgra8888 */
    0x1d6167dfu, /* 11 weighted, indexed8_16, front to back, orthographic, rgb888 */
    0x71d8ef41u, /* 12 nearest, rgba8, back to front, perspective, rgb565_le */
    0x5e278a2eu, /* 13 nearest, rgba16, back to front, orthographic, rgb565_be */
    0x65583ac7u, /* 14 nearest, indexed8, back to front, orthographic, l8 */
    0xf9f7a7a1u, /* 15 nearest, indexed8_16, back to front, orthographic, grey4 */
    0x7f338822u, /* 16 separate, rgba8, back to front, orthographic, mono_horizontal */
    0xdb26e8f3u, /* 17 separate, rgba16, back to front, perspective, mono_vertical */
    0x1616b38bu, /* 18 separate, indexed8, back to front, orthographic, rgba8888 */
    0xc5b69f03u, /* 19 separate, indexed8_16, back to front, perspective, bgra8888 */
    0x94e154cbu, /* 20 weighted, rgba8, back to front, orthographic, rgb888 */
    0x67b6104cu, /* 21 weighted, rgba16, back to front, perspective, rgb565_le */
    0x85d08d49u, /* 22 weighted, indexed8, back to front, perspective, rgb565_be */
    0xf295acacu, /* 23 weighted, indexed8_16, back to front, perspective, l8 */
    0x85c3a4d2u, /* 24 nearest, rgba8, front to back, orthographic, grey4 */
    0xb070159eu, /* 25 nearest, rgba16, front to back, orthographic, mono_horizontal */
    0xc96a696du, /* 26 nearest, indexed8, front to back, orthographic, mono_vertical */
    0x3b243a27u, /* 27 nearest, indexed8_16, front to back, perspective, rgba8888 */
    0x7295553du, /* 28 separate, rgba8, front to back, orthographic, bgra8888 */
    0x525a9cddu, /* 29 separate, rgba16, front to back, orthographic, rgb888 */
    0x5d71c837u, /* 30 separate, indexed8, front to back, orthographic, rgb565_le */
    0x113ce941u, /* 31 separate, indexed8_16, front to back, perspective, rgb565_be */
    0x522b5c0bu, /* 32 weighted, rgba8, front to back, orthographic, l8 */
    0x6e6c747au, /* 33 weighted, rgba16, front to back, orthographic, grey4 */
    0x7674449bu, /* 34 weighted, indexed8, front to back, perspective, mono_horizontal */
    0x556de689u, /* 35 weighted, indexed8_16, front to back, orthographic, mono_vertical */
    0xf91243acu, /* 36 nearest, rgba8, back to front, orthographic, rgba8888 */
    0xd30b8c3fu, /* 37 nearest, rgba16, back to front, perspective, bgra8888 */
    0x9e7ce39au, /* 38 nearest, indexed8, back to front, perspective, rgb888 */
    0x622eda7fu, /* 39 nearest, indexed8_16, back to front, orthographic, rgb565_le */
    0x16913df3u, /* 40 separate, rgba8, back to front, perspective, rgb565_be */
    0x494a20c4u, /* 41 separate, rgba16, back to front, perspective, l8 */
    0x0fdb1c03u, /* 42 separate, indexed8, back to front, orthographic, grey4 */
    0xb7369e24u, /* 43 separate, indexed8_16, back to front, orthographic, mono_horizontal */
    0x8c6e8b0eu, /* 44 weighted, rgba8, back to front, orthographic, mono_vertical */
    0x88b2fea7u, /* 45 weighted, rgba16, back to front, orthographic, rgba8888 */
    0x61b69ce7u, /* 46 weighted, indexed8, back to front, perspective, bgra8888 */
    0x3ed97e1au, /* 47 weighted, indexed8_16, back to front, perspective, rgb888 */
};

#endif /* GOLDEN_H */
