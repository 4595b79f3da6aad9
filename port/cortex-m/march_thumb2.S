/*
 * march_thumb2.S - opacity-weighted samples of 8-bit entries along a ray, for cores with Thumb-2
 * (ARMv7-M, ARMv7E-M, ARMv8-M with the main extension): what qv_march and qv_march_back do with
 * qv_take_weighted, to the bit. C spills what 14 registers hold here.
 *
 *     void walk_march_rgba8(march_walk *walk);
 *     void walk_march_back_rgba8(march_walk *walk);
 *     void walk_march_indexed8(march_walk *walk);
 *     void walk_march_back_indexed8(march_walk *walk);
 *
 * r0 walks through what march_walk.h lays out, and is back at the x axis where a sample begins:
 *
 *     palette, skipped samples     r0 - 32 .. r0 - 24
 *     light, counter, threshold    r0 - 24 .. r0
 *     x axis, voxels               r0 .. r0 + 28
 *     y axis                       r0 + 28 .. r0 + 52
 *     z axis                       r0 + 52 .. r0 + 76: here it stands in between
 *     weights                      r0 + 76 .. r0 + 100
 */
#if defined(__thumb2__) /* packages hand this file to every processor */

        .syntax unified
        .thumb

        .equ    AXES, 76
        .equ    PALETTE, -108           /* from behind the axes */
        .equ    SKIPPED, -104
        .equ    SAMPLES, -84
        .equ    AXIS_MAX, 4096
        .equ    HALF, 0x80000000        /* of what a product's upper half counts */

/* The cell on one axis, in clamped cells with a stride of 0, and the ray's advance on it: adds
   what r12 moves by, and leaves the fraction, Q0.8. */
        .macro  locate fraction, stride, bytes
        cmp     r5, r8                  /* unsigned: -1 lies above every size */
        bhs     1f
        mla     r12, r5, \stride, r12
0:      adds    r6, r4
        adcs    r7, r5
        strd    r6, r7, [r0, #-\bytes]
        lsrs    \fraction, r4, #24
        .subsection 1
1:      cmp     r5, #AXIS_MAX
        it      ls
        mlals   r12, r8, \stride, r12
        movs    \stride, #0
        b       0b
        .previous
        .endm

/* \entry: where the entry of the voxel at r12 lies. */
        .macro  look_up entry, palette
        ldrb    \entry, [r12]
        add     \entry, \palette, \entry, lsl #2
        .endm

/* One corner: the share of opacity, in the place of its weight, and three colours times that. */
        .macro  corner entry, weight
        ldrb    lr, [\entry, #3]
        mul     \weight, \weight, lr
        ldrb    lr, [\entry]
        mla     r5, \weight, lr, r5
        ldrb    lr, [\entry, #1]
        mla     r6, \weight, lr, r6
        ldrb    lr, [\entry, #2]
        mla     r7, \weight, lr, r7
        add     r4, \weight
        .endm

        .macro  corner_at move, by, weight, indexed
        \move   r12, \by
        .if     \indexed
        look_up r1, r8
        corner  r1, \weight
        .else
        corner  r12, \weight
        .endif
        .endm

/* Whether a corner has opacity: into r5. */
        .macro  ask move, by, indexed
        \move   r12, \by
        .if     \indexed
        look_up lr, r2
        ldrb    lr, [lr, #3]
        .else
        ldrb    lr, [r12, #3]
        .endif
        orrs    r5, lr
        .endm

/* \sum + round(\factor * \by / 2^32): the rounding lies in the lower half. */
        .macro  add_high sum, factor, by
        mov     r11, #HALF
        umlal   r11, \sum, \factor, \by
        .endm

/* qv_over of one colour: less what the opacity r12 hides, and half of the sample's, rounded. */
        .macro  over light, colour
        movs    lr, #0
        add_high lr, \light, r12
        subs    \light, lr
        lsrs    \colour, #1
        adcs    \light, \colour
        .endm

        .macro  march name, indexed, back
        .section .text.\name, "ax", %progbits
        .balign 4
        .global \name
        .thumb_func
        .type   \name, %function
\name:
        push    {r4-r11, lr}
        adds    r0, #32
.Lsample_\name:
        ldmia   r0!, {r4-r9, r12}
        locate  r1, r9, 28
        ldmia   r0!, {r4-r8, r10}
        locate  r3, r10, 24
        ldmia   r0!, {r4-r8, r11}
        locate  r8, r11, 24

        /* Opacity of the first corner: r4. */
        .if     \indexed
        ldr     r2, [r0, #PALETTE]
        look_up lr, r2
        ldrb    r4, [lr, #3]
        .else
        ldrb    r4, [r12, #3]
        .endif
        cmp     r4, #0
        beq     .Lask_\name
.Lseen_\name:

        /* Weights as in weights.h: lr, r1, r3, r2, r8, r7, r5, r6 are w[0] .. w[7]. */
        mul     r2, r1, r3
        mul     r7, r1, r8
        mul     r5, r3, r8
        mul     r6, r2, r8
        adds    r6, #128
        lsrs    r6, r6, #8
        rsb     lr, r1, #256
        rsb     r1, r2, r1, lsl #8
        rsb     r3, r2, r3, lsl #8
        rsb     r8, r7, r8, lsl #8
        rsb     lr, r3, lr, lsl #8
        subs    r2, r6
        subs    r7, r6
        subs    r5, r6
        sub     r8, r5
        sub     lr, r8
        subs    r1, r7
        subs    r3, r5
        stmia   r0, {r2, r3, r5-r8}

        /* Sums: r4 opacity, r5 red, r6 green, r7 blue. Corners 0, 1, 3, 2, 6, 7, 5, 4. */
        mul     r4, r4, lr
        .if     \indexed
        ldr     r8, [r0, #PALETTE]
        look_up r2, r8
        .else
        mov     r2, r12
        .endif
        ldrb    r5, [r2]
        muls    r5, r4, r5
        ldrb    r6, [r2, #1]
        muls    r6, r4, r6
        ldrb    r7, [r2, #2]
        muls    r7, r4, r7
        .if     \indexed
        add     r12, r9
        look_up r2, r8
        corner  r2, r1
        .else
        corner_at add, r9, r1, \indexed
        .endif
        ldrd    r2, r3, [r0]
        corner_at add, r10, r2, \indexed
        corner_at sub, r9, r3, \indexed
        ldrd    r2, r3, [r0, #8]
        corner_at add, r11, r2, \indexed
        corner_at add, r9, r3, \indexed
        ldrd    r2, r3, [r0, #16]
        corner_at sub, r10, r2, \indexed
        corner_at sub, r9, r3, \indexed

        /* r1, r2, r3 light; r8 the complement of the transmittance, so that what is taken from
           that is added to it; r9 samples; r10 the threshold and 1. */
        subs    r0, #(AXES + 24)
        ldmia   r0!, {r1-r3, r8-r10}
        mvn     lr, r8
        add     r12, r4, r4, lsl #8     /* qv_opacity_q32 */
        add     r12, r12, r4, lsr #8
        add     r12, r12, r4, lsr #16
        .if     \back
        add_high r8, r12, lr
        over    r1, r5
        over    r2, r6
        over    r3, r7
        .else
        add_high r1, r5, lr
        add_high r2, r6, lr
        add_high r3, r7, lr
        add_high r8, r12, lr
        .endif
        subs    r9, #1
        stmdb   r0, {r1-r3, r8-r10}
        .if     \back
        bne     .Lsample_\name
        .else
        beq     .Lend_\name
        cmn     r8, r10                 /* no carry: more than the threshold remains */
        bcc     .Lsample_\name
        .endif
.Lend_\name:
        pop     {r4-r11, pc}

.Lask_\name:
        movs    r5, #0
        push    {r12}
        ask     add, r9, \indexed
        ask     add, r10, \indexed
        ask     sub, r9, \indexed
        ask     add, r11, \indexed
        ask     add, r9, \indexed
        ask     sub, r10, \indexed
        ask     sub, r9, \indexed
        pop     {r12}
        bne     .Lseen_\name
        ldr     r1, [r0, #SKIPPED]
        ldr     r2, [r0, #SAMPLES]
        adds    r1, #1
        str     r1, [r0, #SKIPPED]
        subs    r2, #1
        str     r2, [r0, #SAMPLES]
        sub     r0, #AXES
        bne     .Lsample_\name
        pop     {r4-r11, pc}
        .size   \name, . - \name
        .endm

        march   walk_march_rgba8, 0, 0
        march   walk_march_back_rgba8, 0, 1
        march   walk_march_indexed8, 1, 0
        march   walk_march_back_indexed8, 1, 1

#endif

#if defined(__ELF__) && defined(__linux__)
        .section .note.GNU-stack, "", %progbits
#endif
