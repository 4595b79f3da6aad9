/*
 * march_rv32im.S - opacity-weighted samples of RGBA8 along a ray, front to back, for RISC-V of 32
 * bits with multiplication: what qv_march does with qv_take_weighted, to the bit. GCC reads
 * ahead more than 28 registers hold.
 *
 *     void walk_march_rgba8(march_walk *walk);
 *
 * s0 is the walk of march_walk.h; s1 to s3 light, s4 transmittance, s5 samples that remain, s6
 * the transmittance below which the ray ends, s7 the voxels.
 */
#if defined(__riscv_mul) && __riscv_xlen == 32 && !defined(__riscv_32e) /* packages hand it to all */

        .equ    SKIPPED, 4
        .equ    RED, 8
        .equ    GREEN, 12
        .equ    BLUE, 16
        .equ    TAKEN, 20
        .equ    SAMPLES, 24
        .equ    ENOUGH, 28
        .equ    X_AXIS, 32
        .equ    VOXELS, 56
        .equ    Y_AXIS, 60
        .equ    Z_AXIS, 84
        .equ    FRAME, 64
        .equ    AXIS_MAX, 4096

/* The cell on one axis, in clamped cells with a stride of 0, and the ray's advance on it: adds
   what a0 moves by, and leaves the fraction, Q0.8. */
        .macro  locate axis, fraction, stride
        lw      t0, \axis(s0)
        lw      t1, \axis+4(s0)
        lw      t2, \axis+8(s0)
        lw      t3, \axis+12(s0)
        lw      t4, \axis+16(s0)
        lw      \stride, \axis+20(s0)
        bgeu    t1, t4, 2f              /* unsigned: -1 lies above every size */
        mul     t5, t1, \stride
        add     a0, a0, t5
1:      srli    \fraction, t0, 24
        add     t2, t2, t0
        sltu    t0, t2, t0
        add     t3, t3, t1
        add     t3, t3, t0
        sw      t2, \axis(s0)
        sw      t3, \axis+4(s0)
        .subsection 1
2:      li      t5, AXIS_MAX
        bltu    t5, t1, 3f
        mul     t5, t4, \stride
        add     a0, a0, t5
3:      li      \stride, 0
        j       1b
        .previous
        .endm

/* The corner at a0: the share of opacity, in the place of its weight, and colours times that. */
        .macro  corner weight
        lbu     t6, 3(a0)
        mul     \weight, \weight, t6
        lbu     t6, 0(a0)
        mul     t6, t6, \weight
        add     s9, s9, t6
        lbu     t6, 1(a0)
        mul     t6, t6, \weight
        add     s10, s10, t6
        lbu     t6, 2(a0)
        mul     t6, t6, \weight
        add     s11, s11, t6
        add     t0, t0, \weight
        .endm

/* t0 gathers the opacity of the corner at a0. */
        .macro  ask
        lbu     t1, 3(a0)
        or      t0, t0, t1
        .endm

/* \a = round(\a * transmittance / 2^32) */
        .macro  high a
        mul     t2, \a, s4
        mulhu   \a, \a, s4
        srli    t2, t2, 31
        add     \a, \a, t2
        .endm

        .section .text.walk_march_rgba8, "ax", %progbits
        .balign 4
        .global walk_march_rgba8
        .type   walk_march_rgba8, %function
walk_march_rgba8:
        addi    sp, sp, -FRAME
        sw      s0, 0(sp)
        sw      s1, 4(sp)
        sw      s2, 8(sp)
        sw      s3, 12(sp)
        sw      s4, 16(sp)
        sw      s5, 20(sp)
        sw      s6, 24(sp)
        sw      s7, 28(sp)
        sw      s9, 32(sp)
        sw      s10, 36(sp)
        sw      s11, 40(sp)
        mv      s0, a0
        lw      s1, RED(s0)
        lw      s2, GREEN(s0)
        lw      s3, BLUE(s0)
        lw      s4, TAKEN(s0)
        not     s4, s4
        lw      s5, SAMPLES(s0)
        lw      s6, ENOUGH(s0)
        lw      s7, VOXELS(s0)

.Lsample:
        mv      a0, s7
        locate  X_AXIS, a1, a4
        locate  Y_AXIS, a2, a5
        locate  Z_AXIS, a3, a6
        lbu     t0, 3(a0)
        beqz    t0, .Lask
.Lseen:

        /* Weights as in weights.h: t5, a1, a2, t1, a3, t2, t3, t4 are w[0] .. w[7]. */
        mul     t1, a1, a2
        mul     t2, a1, a3
        mul     t3, a2, a3
        mul     t4, t1, a3
        addi    t4, t4, 128
        srli    t4, t4, 8
        slli    a1, a1, 8
        slli    a2, a2, 8
        slli    a3, a3, 8
        sub     a2, a2, t1
        sub     a3, a3, t2
        lui     t5, 16                  /* 65536 is 1 */
        sub     t5, t5, a1
        sub     t5, t5, a2
        sub     a1, a1, t1
        sub     t1, t1, t4
        sub     t2, t2, t4
        sub     t3, t3, t4
        sub     a1, a1, t2
        sub     a2, a2, t3
        sub     a3, a3, t3
        sub     t5, t5, a3

        /* Sums: t0 opacity, s9 red, s10 green, s11 blue. Corners 0, 1, 3, 2, 6, 7, 5, 4. */
        mul     t0, t0, t5
        lbu     s9, 0(a0)
        mul     s9, s9, t0
        lbu     s10, 1(a0)
        mul     s10, s10, t0
        lbu     s11, 2(a0)
        mul     s11, s11, t0
        add     a0, a0, a4
        corner  a1
        add     a0, a0, a5
        corner  t1
        sub     a0, a0, a4
        corner  a2
        add     a0, a0, a6
        corner  t3
        add     a0, a0, a4
        corner  t4
        sub     a0, a0, a5
        corner  t2
        sub     a0, a0, a4
        corner  a3

        /* Under: qv_opacity_q32, and all four times the transmittance. */
        slli    t1, t0, 8
        add     t1, t1, t0
        srli    t2, t0, 8
        add     t1, t1, t2
        srli    t0, t0, 16
        add     t0, t0, t1
        high    s9
        high    s10
        high    s11
        high    t0
        add     s1, s1, s9
        add     s2, s2, s10
        add     s3, s3, s11
        sub     s4, s4, t0
        addi    s5, s5, -1
        beqz    s5, .Lend
        bgeu    s4, s6, .Lsample

.Lend:
        sw      s1, RED(s0)
        sw      s2, GREEN(s0)
        sw      s3, BLUE(s0)
        not     s4, s4
        sw      s4, TAKEN(s0)
        sw      s5, SAMPLES(s0)
        lw      s0, 0(sp)
        lw      s1, 4(sp)
        lw      s2, 8(sp)
        lw      s3, 12(sp)
        lw      s4, 16(sp)
        lw      s5, 20(sp)
        lw      s6, 24(sp)
        lw      s7, 28(sp)
        lw      s9, 32(sp)
        lw      s10, 36(sp)
        lw      s11, 40(sp)
        addi    sp, sp, FRAME
        ret

.Lask:
        mv      t2, a0
        add     a0, a0, a4
        ask
        add     a0, a0, a5
        ask
        sub     a0, a0, a4
        ask
        add     a0, a0, a6
        ask
        add     a0, a0, a4
        ask
        sub     a0, a0, a5
        ask
        sub     a0, a0, a4
        ask
        mv      a0, t2
        mv      t1, t0
        li      t0, 0                   /* opacity of the first corner */
        bnez    t1, .Lseen
        lw      t0, SKIPPED(s0)
        addi    t0, t0, 1
        sw      t0, SKIPPED(s0)
        addi    s5, s5, -1
        bnez    s5, .Lsample
        j       .Lend
        .size   walk_march_rgba8, . - walk_march_rgba8

#endif

#if defined(__ELF__) && defined(__linux__)
        .section .note.GNU-stack, "", %progbits
#endif
