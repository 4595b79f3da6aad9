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
    0x61f5c361u, /* 48 corrected, rgba8, front to back, orthographic, rgb565_le */
    0x3b6316f9u, /* 49 corrected, rgba16, front to back, perspective, rgb565_be */
    0x1af9a57cu, /* 50 corrected, indexed8, front to back, perspective, l8 */
    0xf8bd2531u, /* 51 corrected, indexed8_16, front to back, orthographic, grey4 */
    0x65618b30u, /* 52 extinction, rgba8, front to back, perspective, mono_horizontal */
    0x6694406eu, /* 53 extinction, rgba16, front to back, orthographic, mono_vertical */
    0x492622b8u, /* 54 extinction, indexed8, front to back, perspective, rgba8888 */
    0x11949772u, /* 55 extinction, indexed8_16, front to back, perspective, bgra8888 */
    0xd3d03660u, /* 56 extinction, rgbt8, front to back, orthographic, rgb888 */
    0x6203f1b6u, /* 57 extinction, rgbt16, front to back, perspective, rgb565_le */
    0xbfceb56cu, /* 58 extinction, indexed8_t8, front to back, perspective, rgb565_be */
    0xb50b3614u, /* 59 extinction, indexed8_t16, front to back, perspective, l8 */
    0x0aeca86bu, /* 60 corrected, rgba8, back to front, orthographic, grey4 */
    0x9b644e03u, /* 61 corrected, rgba16, back to front, perspective, mono_horizontal */
    0xcc2514bau, /* 62 corrected, indexed8, back to front, orthographic, mono_vertical */
    0x26010efau, /* 63 corrected, indexed8_16, back to front, perspective, rgba8888 */
    0x24ecbb49u, /* 64 extinction, rgba8, back to front, orthographic, bgra8888 */
    0xbe919c6cu, /* 65 extinction, rgba16, back to front, perspective, rgb888 */
    0xa286a70cu, /* 66 extinction, indexed8, back to front, perspective, rgb565_le */
    0x298e501du, /* 67 extinction, indexed8_16, back to front, orthographic, rgb565_be */
    0x58d4ca73u, /* 68 extinction, rgbt8, back to front, orthographic, l8 */
    0x8712e28fu, /* 69 extinction, rgbt16, back to front, perspective, grey4 */
    0x2f1f282fu, /* 70 extinction, indexed8_t8, back to front, perspective, mono_horizontal */
    0xa1c2ea4cu, /* 71 extinction, indexed8_t16, back to front, orthographic, mono_vertical */
    0xe8bfe752u, /* 72 corrected, rgba8, levels, perspective, rgba8888 */
    0xc21edfc2u, /* 73 corrected, rgba16, levels, orthographic, bgra8888 */
    0x9a860c31u, /* 74 corrected, indexed8, levels, perspective, rgb888 */
    0x6a4ce0d7u, /* 75 corrected, indexed8_16, levels, perspective, rgb565_le */
    0x2bbaa3c6u, /* 76 extinction, rgba8, levels, orthographic, rgb565_be */
    0x8a71d7e2u, /* 77 extinction, rgba16, levels, orthographic, l8 */
    0x11e1fe5cu, /* 78 extinction, indexed8, levels, orthographic, grey4 */
    0x50a1338eu, /* 79 extinction, indexed8_16, levels, perspective, mono_horizontal */
    0x528d4e01u, /* 80 extinction, rgbt8, levels, orthographic, mono_vertical */
    0xfde1164bu, /* 81 extinction, rgbt16, levels, perspective, rgba8888 */
    0x79324b53u, /* 82 extinction, indexed8_t8, levels, perspective, bgra8888 */
    0x44f6e5dfu, /* 83 extinction, indexed8_t16, levels, orthographic, rgb888 */
    0x08c958a6u, /* 84 corrected, rgba8, front to back, orthographic, rgb565_le */
    0x9abcd20cu, /* 85 corrected, rgba16, front to back, perspective, rgb565_be */
    0x2a27ec9fu, /* 86 corrected, indexed8, front to back, perspective, l8 */
    0x2f1162fau, /* 87 corrected, indexed8_16, front to back, perspective, grey4 */
    0x7391bddau, /* 88 extinction, rgba8, front to back, perspective, mono_horizontal */
    0x59c811a9u, /* 89 extinction, rgba16, front to back, orthographic, mono_vertical */
    0x1fca22c4u, /* 90 extinction, indexed8, front to back, perspective, rgba8888 */
    0x97da52e2u, /* 91 extinction, indexed8_16, front to back, perspective, bgra8888 */
    0xa67a0694u, /* 92 extinction, rgbt8, front to back, orthographic, rgb888 */
    0x58951087u, /* 93 extinction, rgbt16, front to back, perspective, rgb565_le */
    0xce36c3fau, /* 94 extinction, indexed8_t8, front to back, perspective, rgb565_be */
    0xe6e04f5fu, /* 95 extinction, indexed8_t16, front to back, perspective, l8 */
    0x1cbc3f88u, /* 96 corrected, rgba8, back to front, perspective, grey4 */
    0xc0d234efu, /* 97 corrected, rgba16, back to front, orthographic, mono_horizontal */
    0x145a9d3au, /* 98 corrected, indexed8, back to front, orthographic, mono_vertical */
    0x7b374c0au, /* 99 corrected, indexed8_16, back to front, perspective, rgba8888 */
    0xd30378eeu, /* 100 extinction, rgba8, back to front, orthographic, bgra8888 */
    0x1d1500ebu, /* 101 extinction, rgba16, back to front, orthographic, rgb888 */
    0x30916f2fu, /* 102 extinction, indexed8, back to front, orthographic, rgb565_le */
    0x70918b5fu, /* 103 extinction, indexed8_16, back to front, orthographic, rgb565_be */
    0x9d6d3fa7u, /* 104 extinction, rgbt8, back to front, perspective, l8 */
    0x9bac54abu, /* 105 extinction, rgbt16, back to front, perspective, grey4 */
    0xdf6f6ac6u, /* 106 extinction, indexed8_t8, back to front, perspective, mono_horizontal */
    0x90d9f9fcu, /* 107 extinction, indexed8_t16, back to front, orthographic, mono_vertical */
    0x953bf586u, /* 108 corrected, rgba8, levels, orthographic, rgba8888 */
    0x3cd86c79u, /* 109 corrected, rgba16, levels, perspective, bgra8888 */
    0xa76f3a14u, /* 110 corrected, indexed8, levels, orthographic, rgb888 */
    0xacd986aeu, /* 111 corrected, indexed8_16, levels, perspective, rgb565_le */
    0x7c0f134fu, /* 112 extinction, rgba8, levels, orthographic, rgb565_be */
    0xcb045abfu, /* 113 extinction, rgba16, levels, orthographic, l8 */
    0xdb26eb81u, /* 114 extinction, indexed8, levels, orthographic, grey4 */
    0xee38b977u, /* 115 extinction, indexed8_16, levels, perspective, mono_horizontal */
    0x97e3bf4eu, /* 116 extinction, rgbt8, levels, orthographic, mono_vertical */
    0x246ea633u, /* 117 extinction, rgbt16, levels, perspective, rgba8888 */
    0xf91c4bbbu, /* 118 extinction, indexed8_t8, levels, orthographic, bgra8888 */
    0x49318d07u, /* 119 extinction, indexed8_t16, levels, perspective, rgb888 */
    0xfafecf25u, /* 120 bspline_weighted, rgba8, front to back, perspective, rgb565_le */
    0x8a2b2bfeu, /* 121 bspline_weighted, rgba16, front to back, perspective, rgb565_be */
    0xaad57478u, /* 122 bspline_weighted, indexed8, front to back, orthographic, l8 */
    0x626ef7a2u, /* 123 bspline_weighted, indexed8_16, front to back, orthographic, grey4 */
    0x9af06021u, /* 124 bspline_extinction, rgba8, front to back, perspective, mono_horizontal */
    0x10a2297bu, /* 125 bspline_extinction, rgba16, front to back, orthographic, mono_vertical */
    0xc3f64623u, /* 126 bspline_extinction, indexed8, front to back, orthographic, rgba8888 */
    0xbf3dd3b2u, /* 127 bspline_extinction, indexed8_16, front to back, perspective, bgra8888 */
    0xae5503edu, /* 128 bspline_extinction, rgbt8, front to back, perspective, rgb888 */
    0xff91bb99u, /* 129 bspline_extinction, rgbt16, front to back, orthographic, rgb565_le */
    0x523c798fu, /* 130 bspline_extinction, indexed8_t8, front to back, orthographic, rgb565_be */
    0x7a2dab74u, /* 131 bspline_extinction, indexed8_t16, front to back, orthographic, l8 */
    0x4443d087u, /* 132 bspline_weighted, rgba8, back to front, perspective, grey4 */
    0xcfdf9d76u, /* 133 bspline_weighted, rgba16, back to front, perspective, mono_horizontal */
    0x3c1e4bfcu, /* 134 bspline_weighted, indexed8, back to front, orthographic, mono_vertical */
    0x4467567bu, /* 135 bspline_weighted, indexed8_16, back to front, perspective, rgba8888 */
    0xf0dd056fu, /* 136 bspline_extinction, rgba8, back to front, perspective, bgra8888 */
    0xd4d98215u, /* 137 bspline_extinction, rgba16, back to front, perspective, rgb888 */
    0x17c1bdc2u, /* 138 bspline_extinction, indexed8, back to front, perspective, rgb565_le */
    0x4532887bu, /* 139 bspline_extinction, indexed8_16, back to front, perspective, rgb565_be */
    0x9ee2ed8fu, /* 140 bspline_extinction, rgbt8, back to front, orthographic, l8 */
    0x7ebdfe5cu, /* 141 bspline_extinction, rgbt16, back to front, perspective, grey4 */
    0x4839d40cu, /* 142 bspline_extinction, indexed8_t8, back to front, perspective, mono_horizontal */
    0xba32a4a4u, /* 143 bspline_extinction, indexed8_t16, back to front, orthographic, mono_vertical */
    0xfccf4bd9u, /* 144 bspline_weighted, rgba8, levels, orthographic, rgba8888 */
    0x1e90b3dfu, /* 145 bspline_weighted, rgba16, levels, perspective, bgra8888 */
    0x1b570edcu, /* 146 bspline_weighted, indexed8, levels, perspective, rgb888 */
    0x5b1995fcu, /* 147 bspline_weighted, indexed8_16, levels, perspective, rgb565_le */
    0x0d427a25u, /* 148 bspline_extinction, rgba8, levels, perspective, rgb565_be */
    0x9d60b33cu, /* 149 bspline_extinction, rgba16, levels, perspective, l8 */
    0x11929cb7u, /* 150 bspline_extinction, indexed8, levels, perspective, grey4 */
    0xb014c4bdu, /* 151 bspline_extinction, indexed8_16, levels, perspective, mono_horizontal */
    0x097bcf9fu, /* 152 bspline_extinction, rgbt8, levels, perspective, mono_vertical */
    0x9f840db1u, /* 153 bspline_extinction, rgbt16, levels, orthographic, rgba8888 */
    0xe3a13176u, /* 154 bspline_extinction, indexed8_t8, levels, orthographic, bgra8888 */
    0xd2e30bc4u, /* 155 bspline_extinction, indexed8_t16, levels, orthographic, rgb888 */
    0x77369fbeu, /* 156 bspline_weighted, rgba8, front to back, perspective, rgb565_le */
    0x0a626ecfu, /* 157 bspline_weighted, rgba16, front to back, perspective, rgb565_be */
    0xd636e60cu, /* 158 bspline_weighted, indexed8, front to back, orthographic, l8 */
    0xb7606f00u, /* 159 bspline_weighted, indexed8_16, front to back, orthographic, grey4 */
    0x43d7ad9fu, /* 160 bspline_extinction, rgba8, front to back, orthographic, mono_horizontal */
    0x6c39ea6fu, /* 161 bspline_extinction, rgba16, front to back, orthographic, mono_vertical */
    0x0baa8f25u, /* 162 bspline_extinction, indexed8, front to back, perspective, rgba8888 */
    0xf816f2ddu, /* 163 bspline_extinction, indexed8_16, front to back, perspective, bgra8888 */
    0xf037e62au, /* 164 bspline_extinction, rgbt8, front to back, orthographic, rgb888 */
    0xeace8fdcu, /* 165 bspline_extinction, rgbt16, front to back, orthographic, rgb565_le */
    0x0e5ad0efu, /* 166 bspline_extinction, indexed8_t8, front to back, orthographic, rgb565_be */
    0x92547381u, /* 167 bspline_extinction, indexed8_t16, front to back, orthographic, l8 */
    0x24821ceeu, /* 168 bspline_weighted, rgba8, back to front, perspective, grey4 */
    0xa93d4e8fu, /* 169 bspline_weighted, rgba16, back to front, orthographic, mono_horizontal */
    0x7aa04866u, /* 170 bspline_weighted, indexed8, back to front, orthographic, mono_vertical */
    0xec6af974u, /* 171 bspline_weighted, indexed8_16, back to front, orthographic, rgba8888 */
    0x285e58d8u, /* 172 bspline_extinction, rgba8, back to front, perspective, bgra8888 */
    0x4b0950e2u, /* 173 bspline_extinction, rgba16, back to front, orthographic, rgb888 */
    0xb26fabccu, /* 174 bspline_extinction, indexed8, back to front, orthographic, rgb565_le */
    0xee8cbdc2u, /* 175 bspline_extinction, indexed8_16, back to front, perspective, rgb565_be */
    0x6e44c0deu, /* 176 bspline_extinction, rgbt8, back to front, perspective, l8 */
    0xe5a42162u, /* 177 bspline_extinction, rgbt16, back to front, perspective, grey4 */
    0xfe584851u, /* 178 bspline_extinction, indexed8_t8, back to front, perspective, mono_horizontal */
    0xdc036097u, /* 179 bspline_extinction, indexed8_t16, back to front, perspective, mono_vertical */
    0xecca2852u, /* 180 bspline_weighted, rgba8, levels, perspective, rgba8888 */
    0xb29b84b1u, /* 181 bspline_weighted, rgba16, levels, orthographic, bgra8888 */
    0x175074e9u, /* 182 bspline_weighted, indexed8, levels, orthographic, rgb888 */
    0x41342794u, /* 183 bspline_weighted, indexed8_16, levels, orthographic, rgb565_le */
    0xd76e5b32u, /* 184 bspline_extinction, rgba8, levels, perspective, rgb565_be */
    0x42fcd0deu, /* 185 bspline_extinction, rgba16, levels, orthographic, l8 */
    0x8906c0f8u, /* 186 bspline_extinction, indexed8, levels, orthographic, grey4 */
    0x697c05e6u, /* 187 bspline_extinction, indexed8_16, levels, orthographic, mono_horizontal */
    0xb0f46ea0u, /* 188 bspline_extinction, rgbt8, levels, perspective, mono_vertical */
    0x003b63feu, /* 189 bspline_extinction, rgbt16, levels, perspective, rgba8888 */
    0x869fd1bcu, /* 190 bspline_extinction, indexed8_t8, levels, orthographic, bgra8888 */
    0xea4d4da3u, /* 191 bspline_extinction, indexed8_t16, levels, perspective, rgb888 */
    0xa03ba30fu, /* 192 nearest, rgba8, over_rgba8888, perspective, rgb565_le */
    0x78a9780fu, /* 193 nearest, rgba16, under_rgb888, perspective, rgb565_be */
    0xa1d33053u, /* 194 nearest, indexed8, over_rgba8888_residual4, orthographic, l8 */
    0xd2bcea48u, /* 195 nearest, indexed8_16, hardware_rgba8888, orthographic, grey4 */
    0xabcaa331u, /* 196 separate, rgba8, over_rgb888, perspective, mono_horizontal */
    0x41145522u, /* 197 weighted, rgba8, over_rgb888_residual4, orthographic, mono_vertical */
    0xfded0d18u, /* 198 weighted, rgba16, over_rgb888_residual8, perspective, rgba8888 */
    0x63ddeb8cu, /* 199 weighted, indexed8, over_rgba8888_residual8, perspective, bgra8888 */
    0x462f0f36u, /* 200 weighted, indexed8_16, over_rgb565, perspective, rgb888 */
    0x932c04d9u, /* 201 corrected, rgba8, over_rgba12, orthographic, rgb565_le */
    0xe56d1a92u, /* 202 corrected, rgba16, over_rgb16, perspective, rgb565_be */
    0x13f6c299u, /* 203 corrected, indexed8, over_rgba16, perspective, l8 */
    0x30697f87u, /* 204 corrected, indexed8_16, over_rgb24, orthographic, grey4 */
    0x3f90817cu, /* 205 extinction, rgba8, over_rgba24, orthographic, mono_horizontal */
    0xbe7bba30u, /* 206 extinction, rgba16, under_rgb16, perspective, mono_vertical */
    0x3040c352u, /* 207 extinction, indexed8, under_rgb24, orthographic, rgba8888 */
    0x9aa727a1u, /* 208 extinction, indexed8_16, hardware_rgb888, perspective, bgra8888 */
    0x8e862491u, /* 209 extinction, rgbt8, hardware_rgb565, orthographic, rgb888 */
    0x61ce5b5du, /* 210 extinction, rgbt16, hardware_rgba12, perspective, rgb565_le */
    0x691b7a8cu, /* 211 extinction, indexed8_t8, hand_out_rgba8888, perspective, rgb565_be */
    0x620fcdf5u, /* 212 extinction, indexed8_t16, over_rgba8888, orthographic, l8 */
    0x37cefa5bu, /* 213 bspline_weighted, rgba8, under_rgb888, orthographic, grey4 */
    0xbb027129u, /* 214 bspline_extinction, indexed8_t8, over_rgba8888_residual4, orthographic, mono_horizontal */
    0xf8cbdde2u, /* 215 corrected, rgba8, hardware_rgba8888, orthographic, mono_vertical */
    0xa9547503u, /* 216 extinction, indexed8, over_rgb888, perspective, rgba8888 */
    0x64fe61f8u, /* 217 extinction, rgbt16, over_rgb888_residual4, perspective, bgra8888 */
    0x3e4a49c6u, /* 218 nearest, rgba8, over_rgb888_residual8, orthographic, rgb888 */
    0x2a4dc165u, /* 219 nearest, rgba16, over_rgba8888_residual8, orthographic, rgb565_le */
    0xf26a0fddu, /* 220 nearest, indexed8, over_rgb565, orthographic, rgb565_be */
    0x16386e81u, /* 221 nearest, indexed8_16, over_rgba12, orthographic, l8 */
    0x48d6b007u, /* 222 separate, rgba8, over_rgb16, perspective, grey4 */
    0xc039406cu, /* 223 weighted, rgba8, over_rgba16, orthographic, mono_horizontal */
    0x79feca33u, /* 224 weighted, rgba16, over_rgb24, perspective, mono_vertical */
    0x57ca97cau, /* 225 weighted, indexed8, over_rgba24, perspective, rgba8888 */
    0x2b7fbf4cu, /* 226 weighted, indexed8_16, under_rgb16, orthographic, bgra8888 */
    0x9690c2b5u, /* 227 corrected, rgba8, under_rgb24, orthographic, rgb888 */
    0xc526b382u, /* 228 corrected, rgba16, hardware_rgb888, orthographic, rgb565_le */
    0xce52d78au, /* 229 corrected, indexed8, hardware_rgb565, perspective, rgb565_be */
    0x65012006u, /* 230 corrected, indexed8_16, hardware_rgba12, perspective, l8 */
    0x88587014u, /* 231 extinction, rgba8, hand_out_rgba8888, orthographic, grey4 */
    0x48771bc0u, /* 232 extinction, rgba16, over_rgba8888, orthographic, mono_horizontal */
    0x53cb0ea8u, /* 233 extinction, indexed8, under_rgb888, perspective, mono_vertical */
    0x23515b5du, /* 234 extinction, indexed8_16, over_rgba8888_residual4, perspective, rgba8888 */
    0x368173b3u, /* 235 extinction, rgbt8, hardware_rgba8888, orthographic, bgra8888 */
    0xf9cb8942u, /* 236 extinction, rgbt16, over_rgb888, perspective, rgb888 */
    0x09db8636u, /* 237 extinction, indexed8_t8, over_rgb888_residual4, perspective, rgb565_le */
    0x0a065eaau, /* 238 extinction, indexed8_t16, over_rgb888_residual8, perspective, rgb565_be */
    0xa7334c05u, /* 239 bspline_weighted, rgba8, over_rgba8888_residual8, perspective, l8 */
    0x5160e294u, /* 240 bspline_extinction, indexed8_t8, over_rgb565, orthographic, grey4 */
    0xf37135a0u, /* 241 corrected, rgba8, over_rgba12, orthographic, mono_horizontal */
    0x080df793u, /* 242 extinction, indexed8, over_rgb16, orthographic, mono_vertical */
    0xba7d1f4cu, /* 243 extinction, rgbt16, over_rgba16, orthographic, rgba8888 */
    0x2522aac5u, /* 244 nearest, rgba8, over_rgb24, orthographic, bgra8888 */
    0xbdc4f320u, /* 245 nearest, rgba16, over_rgba24, perspective, rgb888 */
    0xb445b03au, /* 246 nearest, indexed8, under_rgb16, perspective, rgb565_le */
    0x0fc4bd75u, /* 247 nearest, indexed8_16, under_rgb24, perspective, rgb565_be */
    0x485e143bu, /* 248 separate, rgba8, hardware_rgb888, perspective, l8 */
    0xd476f1b5u, /* 249 weighted, rgba8, hardware_rgb565, perspective, grey4 */
    0x6cb0fcbdu, /* 250 weighted, rgba16, hardware_rgba12, perspective, mono_horizontal */
    0x3080992du, /* 251 weighted, indexed8, hand_out_rgba8888, perspective, mono_vertical */
    0x7d1f2134u, /* 252 freevoxels, rgba8, added linear, orthographic, rgba8888 */
    0x6d807885u, /* 253 freevoxels, rgba16, added quadratic, orthographic, bgra8888 */
    0x83b66b86u, /* 254 freevoxels, indexed8, over linear, perspective, rgb888 */
    0x96ebcb46u, /* 255 freevoxels, indexed8_16, over quadratic, orthographic, rgb565_le */
    0x8da6e803u, /* 256 freevoxels, rgba8, lit, perspective, rgb565_be */
    0xb565aff7u, /* 257 freevoxels, rgba16, added linear, orthographic, l8 */
    0x2ae7f6dbu, /* 258 freevoxels, indexed8, added quadratic, perspective, grey4 */
    0x825c4c18u, /* 259 freevoxels, indexed8_16, over linear, perspective, mono_horizontal */
    0xd5cea2e0u, /* 260 freevoxels, rgbt8, over quadratic, orthographic, mono_vertical */
    0x5e69f0a2u, /* 261 freevoxels, rgbt16, lit, perspective, rgba8888 */
    0x91c5f036u, /* 262 freevoxels, indexed8_t8, added linear, orthographic, bgra8888 */
    0x8ffdff23u, /* 263 freevoxels, indexed8_t16, added quadratic, orthographic, rgb888 */
    0xe480ccbdu, /* 264 freevoxels, rgba8, over linear, perspective, rgb565_le */
    0xb8bcb75au, /* 265 freevoxels, rgba16, over quadratic, perspective, rgb565_be */
    0x13324c63u, /* 266 freevoxels, indexed8, lit, orthographic, l8 */
    0x18d1ddbeu, /* 267 freevoxels, indexed8_16, added linear, perspective, grey4 */
    0x87f3b9ddu, /* 268 freevoxels, rgba8, added quadratic, orthographic, mono_horizontal */
    0xcff858d6u, /* 269 freevoxels, rgba16, over linear, orthographic, mono_vertical */
    0xda29dc23u, /* 270 freevoxels, indexed8, over quadratic, perspective, rgba8888 */
    0x57d8c0fau, /* 271 freevoxels, indexed8_16, lit, orthographic, bgra8888 */
    0x3c5b8930u, /* 272 freevoxels, rgbt8, added linear, orthographic, rgb888 */
    0xe09fdac7u, /* 273 freevoxels, rgbt16, added quadratic, perspective, rgb565_le */
    0x4485ee4fu, /* 274 freevoxels, indexed8_t8, over linear, perspective, rgb565_be */
    0xa7c1e191u, /* 275 freevoxels, indexed8_t16, over quadratic, perspective, l8 */
    0x4b2d3e79u, /* 276 freevoxels, rgba8, lit, orthographic, grey4 */
    0x8567a8cbu, /* 277 freevoxels, rgba16, added linear, perspective, mono_horizontal */
    0xcfaa87edu, /* 278 freevoxels, indexed8, added quadratic, orthographic, mono_vertical */
    0x60679125u, /* 279 freevoxels, indexed8_16, over linear, orthographic, rgba8888 */
    0x1c81c30au, /* 280 freevoxels, rgba8, over quadratic, perspective, bgra8888 */
    0x77196981u, /* 281 freevoxels, rgba16, lit, orthographic, rgb888 */
    0xf6c667a2u, /* 282 freevoxels, indexed8, added linear, perspective, rgb565_le */
    0x07001daeu, /* 283 freevoxels, indexed8_16, added quadratic, perspective, rgb565_be */
    0x5f895652u, /* 284 freevoxels, rgbt8, over linear, orthographic, l8 */
    0x377ce4c5u, /* 285 freevoxels, rgbt16, over quadratic, orthographic, grey4 */
    0xacab9babu, /* 286 freevoxels, indexed8_t8, lit, perspective, mono_horizontal */
    0x9717681cu, /* 287 freevoxels, indexed8_t16, added linear, orthographic, mono_vertical */
    0xd38eb4e0u, /* 288 preweighted, associated8, front to back, perspective, rgba8888 */
    0xa338bbe8u, /* 289 preweighted, associated8, back to front, perspective, bgra8888 */
    0x7b1f64b9u, /* 290 preweighted, associated8, front to back, orthographic, rgb888 */
    0x9a50ba17u, /* 291 preweighted, associated8, back to front, perspective, rgb565_le */
    0x09c55da6u, /* 292 preweighted, associated8, front to back, orthographic, rgb565_be */
    0x24f59fc4u, /* 293 preweighted, associated8, back to front, perspective, l8 */
    0x45bd06bau, /* 294 preweighted, associated8, front to back, orthographic, grey4 */
    0x5499ce64u, /* 295 preweighted, associated8, back to front, orthographic, mono_horizontal */
    0x7cbe4121u, /* 296 preweighted, associated8, front to back, orthographic, mono_vertical */
    0x32b0a70du, /* 297 preweighted, associated8, back to front, perspective, rgba8888 */
    0xa8414c0fu, /* 298 preweighted, associated8, front to back, perspective, bgra8888 */
    0xb72e7218u, /* 299 preweighted, associated8, back to front, perspective, rgb888 */
    0xd51f51d0u, /* 300 preweighted, associated8, front to back, orthographic, rgb565_le */
    0x8a2791feu, /* 301 preweighted, associated8, back to front, orthographic, rgb565_be */
    0xc007b564u, /* 302 preweighted, associated8, front to back, perspective, l8 */
    0x25b246ceu, /* 303 preweighted, associated8, back to front, orthographic, grey4 */
};

#endif /* GOLDEN_H */
