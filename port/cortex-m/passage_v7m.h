/*
 * passage_v7m.h - qv_passage_under for Cortex-M3 and up, where GCC finds too few registers. Named in
 * QV_PASSAGE_HEADER by the targets.
 *
 * r0 points to the passage's light, with the steps before it and the transmittance after it.
 * While it runs, light[0] holds red and blue * 2^16, and light[1] green and what was taken from
 * the transmittance * 2^16, modulo 2^32: so both are sums of whole words, and come apart at the
 * end. Taken was QV_UNDIMMED less the transmittance, of which 2^16 times is 0.
 */
#ifndef PASSAGE_V7M_H
#define PASSAGE_V7M_H

/* The channels in the lower halves of a word's halves, and in the upper ones. */
#ifdef __ARM_FEATURE_DSP
#define LOW(to, from) "\tuxtb16 " to ", " from "\n"
#define HIGH(word)    "\tuxtb16 " word ", " word ", ror #8\n"
#else
#define LOW(to, from) "\tand " to ", " from ", #0x00FF00FF\n"
#define HIGH(word)    "\tlsr " word ", " word ", #8\n\tand " word ", " word ", #0x00FF00FF\n"
#endif

/* An instruction a line. */
/* clang-format off */
__attribute__((naked)) void qv_passage_under(__attribute__((unused)) qv_passage *passage)
{
    __asm__ volatile(
        "\tpush {r4-r11, lr}\n"
        "\tldr r1, [r0, #52]\n"
        "\tldr r2, [r0, #56]\n"
        "\tldr r3, [r0, #44]!\n"
        "\tldr r4, [r0, #4]\n"
        "\tadd r3, r3, r1, lsl #16\n"
        "\tsub r4, r4, r2, lsl #16\n"
        "\tstrd r3, r4, [r0]\n"
        "1:\n"
        "\tldmdb r0, {r1-r11}\n"                   /* next, advance, step, place, base */
        "\tlsr r12, r9, #24\n"                     /* y */
        "\tlsr lr, r10, #24\n"                     /* z */
        "\tadds r4, r4, r8\n"
        "\tit cs\n"
        "\taddcs r7, r7, r1\n"
        "\tadds r5, r5, r9\n"
        "\tit cs\n"
        "\taddcs r7, r7, r2\n"
        "\tadds r6, r6, r10\n"
        "\tit cs\n"
        "\taddcs r7, r7, r3\n"
        "\tadd r7, r7, r11\n"
        "\tstmdb r0, {r4-r7}\n"                    /* place, base */
        "\tlsr r8, r8, #24\n"                      /* x */
        "\tmul r4, r12, lr\n"
        "\tadd r4, r4, #128\n"
        "\tlsr r4, r4, #8\n"                       /* weight of y and z */
        "\tsub r5, r12, r4\n"                      /* of y alone */
        "\tsub r6, lr, r4\n"                       /* of z alone */
        "\tadd r7, r12, r6\n"
        "\trsb r7, r7, #256\n"                     /* of neither */
        "\tadd r3, r3, r11\n"                      /* the cell's upper rows */
        "\tldr r12, [r11]\n"
        LOW("lr", "r12")
        "\tmul r9, lr, r7\n"
        HIGH("r12")
        "\tmul r10, r12, r7\n"
        "\tldr r12, [r11, r2]\n"
        LOW("lr", "r12")
        "\tmla r9, lr, r5, r9\n"
        HIGH("r12")
        "\tmla r10, r12, r5, r10\n"
        "\tldr r12, [r3]\n"
        LOW("lr", "r12")
        "\tmla r9, lr, r6, r9\n"
        HIGH("r12")
        "\tmla r10, r12, r6, r10\n"
        "\tldr r12, [r3, r2]\n"
        LOW("lr", "r12")
        "\tmla r9, lr, r4, r9\n"
        HIGH("r12")
        "\tmla r10, r12, r4, r10\n"
        "\tadd r11, r11, r1\n"
        "\tadd r3, r3, r1\n"
        "\tldr r12, [r11]\n"
        LOW("lr", "r12")
        "\tmul r1, lr, r7\n"
        HIGH("r12")
        "\tmul r7, r12, r7\n"
        "\tldr r12, [r11, r2]\n"
        LOW("lr", "r12")
        "\tmla r1, lr, r5, r1\n"
        HIGH("r12")
        "\tmla r7, r12, r5, r7\n"
        "\tldr r12, [r3]\n"
        LOW("lr", "r12")
        "\tmla r1, lr, r6, r1\n"
        HIGH("r12")
        "\tmla r7, r12, r6, r7\n"
        "\tldr r12, [r3, r2]\n"
        LOW("lr", "r12")
        "\tmla r1, lr, r4, r1\n"
        HIGH("r12")
        "\tmla r7, r12, r4, r7\n"
        "\tldr r5, [r0, #12]\n"                    /* transmittance */
        "\tlsr r11, r5, #16\n"
        "\tadd r11, r11, r5, lsr #24\n"            /* share */
        "\tmul r8, r8, r11\n"
        "\tlsr r8, r8, #8\n"                       /* share of the higher end */
        "\tsub r11, r11, r8\n"                     /* and of the lower */
        "\tlsr r6, r10, #16\n"
        "\tmul r6, r6, r11\n"
        "\tlsr r12, r7, #16\n"
        "\tmla r6, r12, r8, r6\n"                  /* taken */
        "\tcbz r6, 3f\n"
        "\tsub r6, r5, r6\n"
        "\tldm r0, {r2, r3, r5}\n"
        "\tmla r2, r9, r11, r2\n"
        "\tmla r2, r1, r8, r2\n"                   /* red, and blue above */
        "\tmla r3, r10, r11, r3\n"
        "\tmla r3, r7, r8, r3\n"                   /* green, and opacity above */
        "\tlsr r9, r9, #16\n"
        "\tmla r5, r9, r11, r5\n"
        "\tlsr r1, r1, #16\n"
        "\tmla r5, r1, r8, r5\n"                   /* blue */
        "\tldrd r9, r10, [r0, #16]\n"            /* samples, enough */
        "\tsubs r9, r9, #1\n"
        "\tstm r0, {r2, r3, r5, r6, r9}\n"
        "\tbeq 2f\n"
        "\tcmp r6, r10\n"
        "\tbhi 1b\n"
        "2:\n"
        "\tldm r0, {r1-r4}\n"
        "\tsub r1, r1, r3, lsl #16\n"
        "\tadd r2, r2, r4, lsl #16\n"
        "\tstrd r1, r2, [r0]\n"
        "\tpop {r4-r11, pc}\n"
        "3:\n"
        "\tldr r1, [r0, #24]\n"
        "\tadd r1, r1, #1\n"
        "\tstr r1, [r0, #24]\n"                    /* skipped */
        "\tldr r1, [r0, #16]\n"
        "\tsubs r1, r1, #1\n"
        "\tstr r1, [r0, #16]\n"
        "\tbne 1b\n"
        "\tb 2b\n");
}
/* clang-format on */

#undef LOW
#undef HIGH

#endif /* PASSAGE_V7M_H */
