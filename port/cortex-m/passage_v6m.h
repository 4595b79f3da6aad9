/*
 * passage_v6m.h - qv_passage_under for Cortex-M0, which has eight registers to compute in. Named in
 * QV_PASSAGE_HEADER by the targets.
 *
 * A copy of the passage lies on the stack, with QV_WEIGHT_ALL, the step along x and QV_HALVES
 * between base and light; then come x, a weight and the passage's address. r8 .. r11 sum up
 * whole words and their upper channels, at the lower and the higher end of the rows; red and blue
 * are what is left of the one without the other. Light is held as in passage_v7m.h.
 */
#ifndef PASSAGE_V6M_H
#define PASSAGE_V6M_H

/* An instruction a line. */
/* clang-format off */
__attribute__((naked)) void qv_passage_under(__attribute__((unused)) qv_passage *passage)
{
    __asm__ volatile(
        "\t.syntax unified\n"
        "\tpush {r4-r7, lr}\n"
        "\tmov r4, r8\n"
        "\tmov r5, r9\n"
        "\tmov r6, r10\n"
        "\tmov r7, r11\n"
        "\tpush {r4-r7}\n"
        "\tsub sp, #96\n"
        "\tstr r0, [sp, #92]\n"
        "\tmov r1, sp\n"
        "\tldmia r0!, {r2-r7}\n"
        "\tstmia r1!, {r2-r7}\n"
        "\tldmia r0!, {r2-r6}\n"
        "\tstmia r1!, {r2-r6}\n"                   /* next, advance, step, place, base */
        "\tmovs r2, #255\n"
        "\tlsls r4, r2, #16\n"
        "\tadds r4, r4, r2\n"                      /* QV_HALVES */
        "\tadds r2, #1\n"                          /* QV_WEIGHT_ALL */
        "\tldr r3, [sp]\n"
        "\tstmia r1!, {r2-r4}\n"
        "\tldmia r0!, {r2-r7}\n"
        "\tstmia r1!, {r2-r7}\n"                   /* light, transmittance, samples, enough */
        "\tldr r0, [r0]\n"
        "\tstr r0, [r1]\n"                         /* skipped */
        "\tlsls r4, r4, #16\n"
        "\tadds r2, r2, r4\n"
        "\tstr r2, [sp, #56]\n"
        "\tlsls r5, r5, #16\n"
        "\tsubs r3, r3, r5\n"
        "\tstr r3, [sp, #60]\n"
        "\tldr r0, [sp, #4]\n"
        "\tmov r12, r0\n"                          /* next on y */
        "\tldr r0, [sp, #8]\n"
        "\tmov lr, r0\n"                           /* and on z */
        "1:\n"
        "\tadd r0, sp, #12\n"
        "\tldmia r0!, {r1-r4}\n"                   /* advance, step */
        "\tldmia r0!, {r5-r7}\n"                   /* place */
        "\tadds r1, r1, r5\n"
        "\tbcc 2f\n"
        "\tldr r0, [sp]\n"
        "\tadds r4, r4, r0\n"
        "2:\n"
        "\tadds r2, r2, r6\n"
        "\tbcc 3f\n"
        "\tadd r4, r12\n"
        "3:\n"
        "\tadds r3, r3, r7\n"
        "\tbcc 4f\n"
        "\tadd r4, lr\n"
        "4:\n"
        "\tldr r0, [sp, #40]\n"                    /* base */
        "\tadds r4, r4, r0\n"
        "\tlsrs r5, r5, #24\n"
        "\tstr r5, [sp, #84]\n"                    /* x */
        "\tadd r5, sp, #28\n"
        "\tstmia r5!, {r1-r4}\n"                   /* place, base */
        "\tldmia r5, {r2, r3, r5}\n"               /* QV_WEIGHT_ALL, next on x, QV_HALVES */
        "\tlsrs r6, r6, #24\n"                     /* y */
        "\tlsrs r7, r7, #24\n"                     /* z */
        "\tmovs r1, r6\n"
        "\tmuls r1, r7\n"
        "\tadds r1, #128\n"
        "\tlsrs r1, r1, #8\n"                      /* weight of y and z */
        "\tsubs r2, r2, r6\n"
        "\tsubs r6, r6, r1\n"                      /* of y alone */
        "\tsubs r7, r7, r1\n"                      /* of z alone */
        "\tsubs r2, r2, r7\n"                      /* of neither */
        "\tstr r1, [sp, #88]\n"
        "\tldr r4, [r0]\n"
        "\tlsrs r1, r4, #8\n"
        "\tands r1, r5\n"
        "\tmuls r1, r2\n"
        "\tmov r9, r1\n"
        "\tmuls r4, r2\n"
        "\tmov r8, r4\n"
        "\tldr r4, [r0, r3]\n"
        "\tlsrs r1, r4, #8\n"
        "\tands r1, r5\n"
        "\tmuls r1, r2\n"
        "\tmov r11, r1\n"
        "\tmuls r4, r2\n"
        "\tmov r10, r4\n"
        "\tadd r0, r12\n"
        "\tldr r4, [r0]\n"
        "\tlsrs r1, r4, #8\n"
        "\tands r1, r5\n"
        "\tmuls r1, r6\n"
        "\tadd r9, r1\n"
        "\tmuls r4, r6\n"
        "\tadd r8, r4\n"
        "\tldr r4, [r0, r3]\n"
        "\tlsrs r1, r4, #8\n"
        "\tands r1, r5\n"
        "\tmuls r1, r6\n"
        "\tadd r11, r1\n"
        "\tmuls r4, r6\n"
        "\tadd r10, r4\n"
        "\tadd r0, lr\n"
        "\tldr r6, [sp, #88]\n"
        "\tldr r4, [r0]\n"
        "\tlsrs r1, r4, #8\n"
        "\tands r1, r5\n"
        "\tmuls r1, r6\n"
        "\tadd r9, r1\n"
        "\tmuls r4, r6\n"
        "\tadd r8, r4\n"
        "\tldr r4, [r0, r3]\n"
        "\tlsrs r1, r4, #8\n"
        "\tands r1, r5\n"
        "\tmuls r1, r6\n"
        "\tadd r11, r1\n"
        "\tmuls r4, r6\n"
        "\tadd r10, r4\n"
        "\tmov r2, r12\n"
        "\tsubs r0, r0, r2\n"
        "\tldr r4, [r0]\n"
        "\tlsrs r1, r4, #8\n"
        "\tands r1, r5\n"
        "\tmuls r1, r7\n"
        "\tadd r9, r1\n"
        "\tmuls r4, r7\n"
        "\tadd r8, r4\n"
        "\tldr r4, [r0, r3]\n"
        "\tlsrs r1, r4, #8\n"
        "\tands r1, r5\n"
        "\tmuls r1, r7\n"
        "\tadd r11, r1\n"
        "\tmuls r4, r7\n"
        "\tadd r10, r4\n"
        "\tldr r6, [sp, #68]\n"                    /* transmittance */
        "\tlsrs r0, r6, #16\n"
        "\tlsrs r1, r6, #24\n"
        "\tadds r0, r0, r1\n"                      /* share */
        "\tldr r1, [sp, #84]\n"
        "\tmuls r1, r0\n"
        "\tlsrs r1, r1, #8\n"                      /* share of the higher end */
        "\tsubs r0, r0, r1\n"                      /* and of the lower */
        "\tmov r2, r9\n"
        "\tlsrs r3, r2, #16\n"
        "\tmuls r3, r0\n"
        "\tmov r4, r11\n"
        "\tlsrs r5, r4, #16\n"
        "\tmuls r5, r1\n"
        "\tadds r3, r3, r5\n"                      /* taken */
        "\tbeq 6f\n"
        "\tsubs r6, r6, r3\n"
        "\tmov r3, r8\n"
        "\tlsls r5, r2, #8\n"
        "\tsubs r3, r3, r5\n"                      /* red and blue of the lower end */
        "\tmov r5, r10\n"
        "\tlsls r7, r4, #8\n"
        "\tsubs r5, r5, r7\n"                      /* and of the higher */
        "\tmuls r2, r0\n"
        "\tmuls r4, r1\n"
        "\tadds r2, r2, r4\n"                      /* green, and opacity above */
        "\tlsrs r4, r3, #16\n"
        "\tmuls r4, r0\n"
        "\tlsrs r7, r5, #16\n"
        "\tmuls r7, r1\n"
        "\tadds r4, r4, r7\n"                      /* blue */
        "\tmuls r3, r0\n"
        "\tmuls r5, r1\n"
        "\tadds r3, r3, r5\n"                      /* red, and blue above */
        "\tadd r0, sp, #56\n"
        "\tldmia r0!, {r1, r5, r7}\n"
        "\tadds r1, r1, r3\n"
        "\tadds r2, r2, r5\n"
        "\tadds r4, r4, r7\n"
        "\tldr r7, [sp, #72]\n"                    /* samples */
        "\tadd r0, sp, #56\n"
        "\tsubs r7, r7, #1\n"
        "\tstmia r0!, {r1, r2, r4, r6, r7}\n"
        "\tbeq 5f\n"
        "\tldr r0, [sp, #76]\n"                    /* enough */
        "\tcmp r6, r0\n"
        "\tbls 5f\n"
        "\tb 1b\n"
        "6:\n"
        "\tldr r0, [sp, #80]\n"
        "\tadds r0, #1\n"
        "\tstr r0, [sp, #80]\n"                    /* skipped */
        "\tldr r0, [sp, #72]\n"
        "\tsubs r0, r0, #1\n"
        "\tstr r0, [sp, #72]\n"
        "\tbeq 5f\n"
        "\tb 1b\n"
        "5:\n"
        "\tldr r0, [sp, #92]\n"
        "\tadds r0, #44\n"
        "\tadd r1, sp, #56\n"
        "\tldmia r1!, {r2-r7}\n"
        "\tlsls r1, r4, #16\n"
        "\tsubs r2, r2, r1\n"
        "\tlsls r1, r5, #16\n"
        "\tadds r3, r3, r1\n"
        "\tstmia r0!, {r2-r7}\n"
        "\tldr r2, [sp, #80]\n"
        "\tstr r2, [r0]\n"
        "\tadd sp, #96\n"
        "\tpop {r4-r7}\n"
        "\tmov r8, r4\n"
        "\tmov r9, r5\n"
        "\tmov r10, r6\n"
        "\tmov r11, r7\n"
        "\tpop {r4-r7, pc}\n");
}
/* clang-format on */

#endif /* PASSAGE_V6M_H */
