/*
 * march_helium.S - opacity-weighted samples of 8-bit entries along a ray, for cores with vectors
 * of integers (ARMv8.1-M with MVE, Helium): what qv_march and qv_march_back do with
 * qv_take_weighted, to the bit.
 *
 *     void helium_march_rgba8(uint32_t *records_at);
 *     void helium_march_back_rgba8(uint32_t *records_at);
 *     void helium_march_indexed8(uint32_t *records_at);
 *     void helium_march_back_indexed8(uint32_t *records_at);
 *
 * r7 walks through the helium_state of helium.h, whose axes lie before records_at.
 *
 * Four samples of a ray, side by side in lanes of 32 bits, are located and weighed. Then each
 * of them is interpolated by itself, its eight voxels side by side in lanes of 16 bits: a sum
 * over a cell is a sum over a vector, one instruction. So it matters neither how long the rays
 * of a row are nor how many they are. Of a sample's 53 instructions 24 are its share of what
 * prepares four.
 */
#if defined(__ARM_FEATURE_MVE) /* packages hand this file to every processor */

        .syntax unified
        .thumb

        /* Of helium_state, from records_at; and of a record. */
        .equ    AXES, -144
        .equ    LEFT, 16
        .equ    RIGHT, 32
        .equ    LIGHT, 48
        .equ    PALETTE, 64
        .equ    ENOUGH, 68
        .equ    SKIPPED, 72
        .equ    NEXT, 76
        .equ    PREPARED, 80
        .equ    UNPREPARED, 84
        .equ    RECORDS, 88
        .equ    RECORD_CELL, 16
        .equ    RECORD_BYTES, 20

        .equ    LANES, 4
        .equ    ONE, 0x10000            /* 1 voxel, Q16.16, and the weight 1 */

/*
 * The axis at r7: where between two voxels four samples lie, 0 .. 256, in \q; adds where their
 * cells begin to q6 (\add is vmul.i32 on the first axis), and goes on to the next four.
 * Samples before the first voxel lie at it. Those beyond the last lie at it too, 256 from the
 * last but one: the weights are those of qv_cell_locate, which reads the one voxel twice.
 * r4 is 2^15, r12 1 voxel, lr -1 voxel, q7 1.
 */
        .macro  locate q, add
        ldmia   r7!, {r0-r3}            /* place_step, rest_step, stride, last_cell */
        vldrw.u32 \q, [r7]
        vldrw.u32 q4, [r7, #16]
        vadd.i32 q5, \q, r0
        vqdmlah.s32 \q, q4, r4          /* rest / 2^16: the upper half of 2 * rest * 2^15 */
        vadd.i32 q4, q4, r1
        vstrw.32 q5, [r7], #32
        vstrw.32 q4, [r7, #-16]
        vqsub.u32 \q, \q, r12           /* not below 0 */
        vdup.32 q4, r3
        vshr.u32 q5, \q, #16
        vmin.u32 q4, q5, q4
        \add    q6, q4, r2
        vmla.u32 \q, q4, lr             /* in the cell: below 3/2 */
        vmin.u32 \q, \q, q7
        vshr.u32 \q, \q, #8
        .endm

/* The weight \edge of an edge along x, Q1.16, of which its right voxel has \right: left in the
   lower, right in the upper half, modulo 2^16, for the records at q7. */
        .macro  share edge, right, offset
        vsub.i32 \edge, \edge, \right
        vsli.32 \edge, \right, #16
        vstrw.32 \edge, [q7, #\offset]
        .endm

/*
 * Locates and weighs four samples: the weights of qv_weights. An edge along x has y * z,
 * y * (1 - z) and so on, Q0.8 times Q0.8, exact. Of it, the right voxel has xyz, xy - xyz,
 * xz - xyz, and x * (1 - y) - (xz - xyz).
 */
        .macro  prepare
        add     r7, #AXES
        mov     r4, #0x8000
        mov     r12, #ONE
        rsb     lr, r12, #0
        vmov.i32 q7, #0x10000           /* ONE */
        locate  q0, vmul.i32            /* x */
        locate  q1, vmla.u32            /* y */
        locate  q2, vmla.u32            /* z */
        vldrw.u32 q7, [r7]
        vstrw.32 q6, [q7, #RECORD_CELL]
        vmul.i32 q3, q0, q1             /* xy */
        vmul.i32 q4, q0, q2             /* xz */
        vmul.i32 q5, q3, q2
        vrshr.u32 q5, q5, #8            /* xyz, to nearest, ties upwards */
        vsub.i32 q3, q3, q5
        vsub.i32 q4, q4, q5
        vmul.i32 q6, q1, q2
        share   q6, q5, 12
        vmov.i32 q5, #256
        vsub.i32 q6, q5, q1             /* 1 - y */
        vsub.i32 q5, q5, q2             /* 1 - z */
        vmul.i32 q1, q1, q5
        share   q1, q3, 4
        vmul.i32 q2, q2, q6
        share   q2, q4, 8
        vmul.i32 q0, q0, q6
        vsub.i32 q0, q0, q4
        vmul.i32 q6, q6, q5
        share   q6, q0, 0
        .endm

/* Entries of the cell at r0: of voxels 2i, at q0, in q2, of voxels 2i + 1, at q1, in q3. */
        .macro  fetch indexed
        .if     \indexed
        vldrb.u32 q4, [r0, q0]
        vldrb.u32 q5, [r0, q1]
        ldr     r12, [r7, #PALETTE]
        vldrw.u32 q2, [r12, q4, uxtw #2]
        vldrw.u32 q3, [r12, q5, uxtw #2]
        .else
        vldrw.u32 q2, [r0, q0]
        vldrw.u32 q3, [r0, q1]
        .endif
        .endm

/*
 * Red, green, blue and opacity, Q0.32, of a sample in q3, from its entries, its weights q6 and
 * its opacity r0. vmlav sums products of 16 by 16 bits: a channel times an opacity fits, and
 * the sums are at most 65536 * 255^2. q4: B and A of all voxels; q5: A; q2: R and G.
 */
        .macro  interpolate
        vsli.32 q2, q3, #16
        vmullb.u8 q3, q5, q2
        vmullt.u8 q2, q4, q2
        vmullb.u8 q4, q5, q4
        add     r1, r0, r0, lsl #8      /* qv_opacity_q32 */
        add     r1, r1, r0, lsr #8
        add     r0, r1, r0, lsr #16
        vmlav.u16 r2, q3, q6
        vmlav.u16 r12, q4, q6
        vmov    q3[2], q3[0], r2, r12
        vmlav.u16 r2, q2, q6
        vmov    q3[3], q3[1], r2, r0
        .endm

/* qv_over, and qv_under of the complement of the transmittance, whose own value is in r5. */
        .macro  composite back
        .if     \back
        vdup.32 q2, r0
        vrmulh.u32 q2, q7, q2
        vsub.i32 q7, q7, q2
        movs    r0, #0
        vmov.32 q3[3], r0
        vrshr.u32 q3, q3, #1
        vadd.i32 q7, q7, q3
        .else
        vdup.32 q2, r5
        vrmulh.u32 q3, q3, q2
        vadd.i32 q7, q7, q3
        vmov.32 r5, q7[3]
        mvn     r5, r5
        .endif
        .endm

/*
 * Takes samples until none is left, light is enough, or one needs the C form: then `prepared` of
 * the four are left, this one among them. lr counts them, r4 is `next`, q7 light.
 *
 * All weights but 1 fit 16 bits; 1 is that of a single voxel, and then all are 0 modulo 2^16.
 * So an opacity of 0 is that, or nothing to see, or voxels without weight that
 * qv_any_opacity sees, or does not: where all eight are clear, that is the same.
 */
        .macro  march name, indexed, back
        .section .text.\name, "ax", %progbits
        .balign 4
        .global \name
        .thumb_func
        .type   \name, %function
\name:
        push    {r3-r7, lr}
        vpush   {d8-d15}
        mov     r7, r0
        vldrw.u32 q7, [r7, #LIGHT]
        vmov.32 r5, q7[3]
        mvn     r5, r5
        ldr     r6, [r7, #ENOUGH]
        ldr     r4, [r7, #NEXT]
        ldr     lr, [r7, #PREPARED]
        cmp     lr, #0
        bne     .Lresume_\name
.Lfour_\name:
        prepare
        ldr     r1, [r7, #UNPREPARED]
        mov     lr, #LANES
        cmp     r1, #LANES
        csel    lr, r1, lr, lo
        sub     r1, lr
        str     r1, [r7, #UNPREPARED]
        add     r4, r7, #RECORDS
        vldrw.u32 q7, [r7, #LIGHT]
.Lresume_\name:
        dls     lr, lr
        vldrw.u32 q0, [r7, #LEFT]
        vldrw.u32 q1, [r7, #RIGHT]
.Lsample_\name:
        vldrw.u32 q6, [r4], #RECORD_BYTES
        ldr     r0, [r4, #(RECORD_CELL - RECORD_BYTES)]
        fetch   \indexed
        vmov    q4, q3
        vsri.32 q4, q2, #16
        vshr.u16 q5, q4, #8
        vmlav.u16 r0, q5, q6
        cbz     r0, .Lclear_\name
        interpolate
        composite \back
        .if     !\back
        cmp     r5, r6
        bls     .Lstop_\name
        .endif
.Lnext_\name:
        le      lr, .Lsample_\name
        vstrw.32 q7, [r7, #LIGHT]
        ldr     r1, [r7, #UNPREPARED]
        cmp     r1, #0
        bne     .Lfour_\name
        mov     lr, #0
        b       .Lend_\name
.Lclear_\name:
        vaddv.u16 r0, q5
        cbnz    r0, .Lstop_\name
        ldr     r0, [r7, #SKIPPED]
        adds    r0, #1
        str     r0, [r7, #SKIPPED]
        b       .Lnext_\name
.Lstop_\name:
        vstrw.32 q7, [r7, #LIGHT]
.Lend_\name:
        str     r4, [r7, #NEXT]
        str     lr, [r7, #PREPARED]
        vpop    {d8-d15}
        pop     {r3-r7, pc}
        .size   \name, . - \name
        .endm

        march   helium_march_rgba8, 0, 0
        march   helium_march_back_rgba8, 0, 1
        march   helium_march_indexed8, 1, 0
        march   helium_march_back_indexed8, 1, 1

#endif

#if defined(__ELF__) && defined(__linux__)
        .section .note.GNU-stack, "", %progbits
#endif
