/*
 * march_thumb1.S - opacity-weighted samples of RGBA8 along a ray, front to back, for cores without
 * Thumb-2 (ARMv6-M, ARMv8-M without the main extension): what qv_march does with
 * qv_take_weighted, to the bit.
 *
 *     void walk_march_rgba8(march_walk *walk);
 *
 * r0 walks through what march_walk.h lays out: it is at the x axis where a sample begins. On the
 * stack lie seven weights, in the order of STACK_W1 and so on, and the walk.
 */
#if defined(__thumb__) && !defined(__thumb2__) /* packages hand this file to every processor */

        .syntax unified
        .thumb

        .equ    X_AXIS, 32              /* in the walk */
        .equ    SKIPPED, 4
        .equ    LIGHT, 8
        .equ    TAKEN, 20
        .equ    SAMPLES, 24

        .equ    STACK_W1, 0
        .equ    STACK_W2, 4
        .equ    STACK_W4, 8
        .equ    STACK_W3, 12
        .equ    STACK_W5, 16
        .equ    STACK_W6, 20
        .equ    STACK_W7, 24
        .equ    STACK_WALK, 28
        .equ    STACK_BYTES, 32

/* The cell on one axis, in clamped cells with a stride of 0, and the ray's advance on it. r1 lower
   word of the place, r2 index, r3 and r4 advance, r5 last index, r6 stride; adds what r7 moves
   by. The index before a clamped lower face is -1. */
        .macro  locate bytes
        cmp     r2, r5
        blo     1f
        cmp     r2, #0
        blt     0f
        muls    r5, r6
        adds    r7, r5
0:      movs    r6, #0
1:      adds    r3, r1
        adcs    r4, r2
        muls    r2, r6
        adds    r7, r2
        subs    r0, #\bytes
        stmia   r0!, {r3, r4}
        adds    r0, #(\bytes - 8)
        .endm

/* The corner at r0, with the weight \weight of the stack. */
        .macro  corner weight
        ldr     r1, [sp, #\weight]
        ldrb    r2, [r0, #3]
        muls    r1, r2
        ldrb    r2, [r0]
        muls    r2, r1
        adds    r4, r2
        ldrb    r2, [r0, #1]
        muls    r2, r1
        adds    r5, r2
        ldrb    r2, [r0, #2]
        muls    r2, r1
        adds    r6, r2
        adds    r7, r1
        .endm

/* r2 gathers the opacity of the corner at r1. */
        .macro  ask
        ldrb    r5, [r1, #3]
        orrs    r2, r5
        .endm

/* \a = round(\a * b / 2^32), of digits of b: r0 the lower, r1 the upper, at most 2^15. What lands
   on bits 16 to 47 is summed up with a carry, and rounded by the last bit that is shifted out. */
        .macro  high a
        lsrs    r2, \a, #16
        uxth    \a, \a
        movs    r3, \a
        muls    r3, r0
        lsrs    r3, r3, #16
        muls    \a, r1
        mov     r8, r2
        muls    r2, r0
        adds    r3, r2                  /* <= 65535^2 + 65534 */
        mov     r2, r8
        muls    r2, r1
        adds    \a, r3
        bcc     1f
        movs    r3, #1
        lsls    r3, r3, #16
        adds    r2, r3
1:      lsrs    \a, \a, #16
        adcs    \a, r2
        .endm

        .section .text.walk_march_rgba8, "ax", %progbits
        .balign 4
        .global walk_march_rgba8
        .thumb_func
        .type   walk_march_rgba8, %function
walk_march_rgba8:
        push    {r4-r7, lr}
        mov     r4, r8
        mov     r5, r9
        mov     r6, r10
        mov     r7, r11
        push    {r4-r7}
        sub     sp, #STACK_BYTES
        str     r0, [sp, #STACK_WALK]
        adds    r0, #X_AXIS

/* x in r8, y in r9, z in r3, their strides in r10 to r12; r7 the voxel. */
.Lsample:
        ldmia   r0!, {r1-r7}
        locate  28
        lsrs    r1, r1, #24
        mov     r8, r1
        mov     r10, r6
        ldmia   r0!, {r1-r6}
        locate  24
        lsrs    r1, r1, #24
        mov     r9, r1
        mov     r11, r6
        ldmia   r0!, {r1-r6}
        locate  24
        lsrs    r3, r1, #24
        mov     r12, r6
        ldrb    r2, [r7, #3]
        cmp     r2, #0
        bne     .Lseen

        mov     r4, r10
        adds    r1, r7, r4
        ask
        add     r1, r11
        ask
        subs    r1, r4
        ask
        mov     r1, r7
        add     r1, r12
        ask
        adds    r1, r4
        ask
        add     r1, r11
        ask
        subs    r1, r4
        ask
        bne     .Lseen
        ldr     r0, [sp, #STACK_WALK]
        ldr     r1, [r0, #SKIPPED]
        adds    r1, #1
        str     r1, [r0, #SKIPPED]
        ldr     r1, [r0, #SAMPLES]
        subs    r1, #1
        str     r1, [r0, #SAMPLES]
        beq     .Lfar_end
        adds    r0, #X_AXIS
        b       .Lsample
.Lfar_end:
        b       .Lend

/* Weights as in weights.h: r7, r1, r2, r4, r3, r5, r6, and the last on the stack alone. */
.Lseen:
        mov     lr, r7
        mov     r1, r8
        mov     r2, r9
        movs    r4, r1
        muls    r4, r2
        movs    r5, r1
        muls    r5, r3
        movs    r6, r2
        muls    r6, r3
        movs    r7, r4
        muls    r7, r3
        adds    r7, #128
        lsrs    r7, r7, #8
        lsls    r1, r1, #8
        lsls    r2, r2, #8
        lsls    r3, r3, #8
        subs    r2, r4
        subs    r3, r5
        mov     r8, r1
        add     r8, r2
        subs    r1, r4
        subs    r4, r7
        subs    r5, r7
        subs    r6, r7
        subs    r1, r5
        subs    r2, r6
        subs    r3, r6
        mov     r0, sp
        stmia   r0!, {r1-r7}
        movs    r7, #1
        lsls    r7, r7, #16
        mov     r1, r8
        subs    r7, r1
        subs    r7, r3

/* Sums: r4 red, r5 green, r6 blue, r7 opacity. Corners 0, 1, 3, 2, 4, 5, 7, 6; r3 steps on x. */
        mov     r0, lr
        mov     r3, r10
        ldrb    r2, [r0, #3]
        muls    r7, r2
        ldrb    r4, [r0]
        muls    r4, r7
        ldrb    r5, [r0, #1]
        muls    r5, r7
        ldrb    r6, [r0, #2]
        muls    r6, r7
        adds    r0, r3
        corner  STACK_W1
        add     r0, r11
        corner  STACK_W3
        subs    r0, r3
        corner  STACK_W2
        mov     r0, lr
        add     r0, r12
        corner  STACK_W4
        adds    r0, r3
        corner  STACK_W5
        add     r0, r11
        corner  STACK_W7
        subs    r0, r3
        corner  STACK_W6

/* Under: qv_opacity_q32, and all four times the transmittance. */
        lsls    r1, r7, #8
        lsrs    r2, r7, #8
        lsrs    r3, r7, #16
        adds    r7, r1
        adds    r7, r2
        adds    r7, r3
        ldr     r0, [sp, #STACK_WALK]
        ldr     r1, [r0, #TAKEN]
        mvns    r1, r1
        uxth    r0, r1
        lsrs    r1, r1, #16
        high    r4
        high    r5
        high    r6
        high    r7
        ldr     r0, [sp, #STACK_WALK]
        adds    r0, #LIGHT
        ldmia   r0!, {r1-r3}
        adds    r4, r1
        adds    r5, r2
        adds    r6, r3
        ldr     r1, [r0]
        adds    r7, r1
        subs    r0, #12
        stmia   r0!, {r4-r7}
        ldr     r1, [r0]
        ldr     r2, [r0, #4]
        subs    r1, #1
        str     r1, [r0]
        beq     .Lend
        adds    r0, #8
        cmn     r7, r2                  /* no carry: more than the threshold remains */
        bcs     .Lend
        b       .Lsample

.Lend:
        add     sp, #STACK_BYTES
        pop     {r4-r7}
        mov     r8, r4
        mov     r9, r5
        mov     r10, r6
        mov     r11, r7
        pop     {r4-r7, pc}
        .size   walk_march_rgba8, . - walk_march_rgba8

#endif

#if defined(__ELF__) && defined(__linux__)
        .section .note.GNU-stack, "", %progbits
#endif
