/*
 * helium.h - marches of the weighted modes through entries of 8 bits, on processors with
 * vectors of integers (Armv8.1-M MVE, Helium): the same bits as qv_march and qv_march_back. A
 * header for QV_MARCH_HEADER, see core/march.h.
 *
 * Four samples of a ray, side by side in lanes of 32 bits, are located and weighed. Then each
 * of them is interpolated by itself, its eight voxels side by side in lanes of 16 bits: a sum
 * over a cell is a sum over a vector, one instruction. So it matters neither how long the
 * rays of a row are nor how many they are. In assembly, because compilers keep too little of
 * it in the eight registers.
 *
 * Source of the formulas: core/cell.h, core/weights.h, core/sample.h, core/composite.h.
 */
#ifndef HELIUM_H
#define HELIUM_H

#define HELIUM_LANES 4u

/* Of longer rays, so many samples at a time: see helium_axis. */
#define HELIUM_SAMPLES_MAX 0x4000u

/* 1 voxel, Q16.16 */
#define HELIUM_ONE 0x10000u

/*
 * Where four samples lie on one axis, Q31.32: place * 2^16 + rest, and what takes them to the
 * next four. Place is one voxel too high, so that it is not below 0. What its steps, rounded
 * downwards, leave adds up in rest: below 2^18 every time, less than 2^31 in all.
 */
typedef struct {
    uint32_t place_step, rest_step;
    uint32_t stride;    /* bytes from voxel to voxel; 0 where there is but one */
    uint32_t last_cell; /* index of the last voxel but one */
    uint32_t place[HELIUM_LANES], rest[HELIUM_LANES];
} helium_axis;

/* What is prepared of a sample. Voxels are numbered as by qv_corners. */
typedef struct {
    uint32_t weight[4]; /* of voxels 2i in lower, of voxels 2i + 1 in upper halves */
    uint32_t cell;      /* voxel 0, in bytes from the volume's */
} helium_record;

/* The state of a march. The assembly takes it by the address of record_at. */
typedef struct {
    helium_axis axis[3];
    uint32_t record_at[HELIUM_LANES]; /* addresses of records */
    uint32_t left[4], right[4];       /* addresses of voxels 2i and 2i + 1 of the first cell */
    uint32_t light[4];                /* colour; and transmittance, front to back negative */
    uint32_t palette;                 /* address */
    uint32_t enough;                  /* transmittance at or below which a ray ends, Q1.31 */
    uint32_t skipped;                 /* samples in cells without opacity */
    uint32_t next;                    /* address of a record, the next to be taken */
    uint32_t prepared;                /* samples left of the four */
    uint32_t unprepared;              /* samples beyond */
    helium_record record[HELIUM_LANES];
} helium_state;

#define HELIUM_OFFSET(member)                                                                      \
    ((int)offsetof(helium_state, member) - (int)offsetof(helium_state, record_at))

/* An instruction to a line: */
/* clang-format off */

/*
 * One axis of four samples: where between two voxels they lie, 0 .. 256, in `q`; adds where
 * their cells begin to q6 (`add` is vmul.i32 on the first axis), and goes on to the next four.
 * Samples before the first voxel lie at it. Those beyond the last lie at it too, 256 from the
 * last but one: the weights are those of qv_cell_locate, which reads the one voxel twice.
 * vqdmlah adds rest / 2^16: the upper half of 2 * rest * 2^15. The axis lies at p.
 */
#define HELIUM_LOCATE(q, add)                                              \
    "ldmia %[p]!, {r0-r3}\n" /* place_step, rest_step, stride, last_cell */ \
    "vldrw.u32 " q ", [%[p]]\n"                                            \
    "vldrw.u32 q4, [%[p], #16]\n"                                          \
    "vadd.i32 q5, " q ", r0\n"                                             \
    "vqdmlah.s32 " q ", q4, r4\n" /* 2^15 */                               \
    "vadd.i32 q4, q4, r1\n"                                                \
    "vstrw.32 q5, [%[p]], #32\n"                                           \
    "vstrw.32 q4, [%[p], #-16]\n"                                          \
    "vqsub.u32 " q ", " q ", r12\n" /* less 1 voxel, not below 0 */        \
    "vdup.32 q4, r3\n"                                                     \
    "vshr.u32 q5, " q ", #16\n"                                            \
    "vmin.u32 q4, q5, q4\n"                                                \
    add " q6, q4, r2\n"                                                    \
    "vmla.u32 " q ", q4, lr\n" /* less the cell: below 3/2 */              \
    "vmin.u32 " q ", " q ", q7\n" /* 1 */                                  \
    "vshr.u32 " q ", " q ", #8\n"

/* The weight of the edge `both`, Q1.16, of which its right voxel has `right`: for the records
   at q7. */
#define HELIUM_SHARE(both, right, offset)                                  \
    "vsub.i32 " both ", " both ", " right "\n"                             \
    "vsli.32 " both ", " right ", #16\n"                                   \
    "vstrw.32 " both ", [q7, #" offset "]\n"

/*
 * Locates and weighs four samples. Weights are those of qv_weights, modulo 2^16. An edge along x
 * has y * z, y * (1 - z) and so on, Q0.8 times Q0.8, exact. Of it, the right voxel has xyz,
 * xy - xyz, xz - xyz, and x * (1 - y) - (xz - xyz).
 */
#define HELIUM_PREPARE                                                     \
    "add %[p], %[axis]\n"                                                  \
    "mov r4, #0x8000\n"                                                    \
    "mov r12, #0x10000\n"                                                  \
    "rsb lr, r12, #0\n"                                                    \
    "vmov.i32 q7, #0x10000\n"                                              \
    HELIUM_LOCATE("q0", "vmul.i32") /* x */                                \
    HELIUM_LOCATE("q1", "vmla.u32") /* y */                                \
    HELIUM_LOCATE("q2", "vmla.u32") /* z */                                \
    "vldrw.u32 q7, [%[p]]\n"                                               \
    "vstrw.32 q6, [q7, #16]\n"                                             \
    "vmul.i32 q3, q0, q1\n" /* xy */                                       \
    "vmul.i32 q4, q0, q2\n" /* xz */                                       \
    "vmul.i32 q5, q3, q2\n"                                                \
    "vrshr.u32 q5, q5, #8\n" /* xyz, to nearest, ties upwards */           \
    "vsub.i32 q3, q3, q5\n"                                                \
    "vsub.i32 q4, q4, q5\n"                                                \
    "vmul.i32 q6, q1, q2\n"                                                \
    HELIUM_SHARE("q6", "q5", "12")                                         \
    "vmov.i32 q5, #256\n"                                                  \
    "vsub.i32 q6, q5, q1\n" /* 1 - y */                                    \
    "vsub.i32 q5, q5, q2\n" /* 1 - z */                                    \
    "vmul.i32 q1, q1, q5\n"                                                \
    HELIUM_SHARE("q1", "q3", "4")                                          \
    "vmul.i32 q2, q2, q6\n"                                                \
    HELIUM_SHARE("q2", "q4", "8")                                          \
    "vmul.i32 q0, q0, q6\n"                                                \
    "vsub.i32 q0, q0, q4\n"                                                \
    "vmul.i32 q6, q6, q5\n"                                                \
    HELIUM_SHARE("q6", "q0", "0")

/* Entries of the cell at r0: of voxels 2i in q2, of voxels 2i + 1 in q3. */
#define HELIUM_DIRECT                                                      \
    "vldrw.u32 q2, [r0, q0]\n"                                             \
    "vldrw.u32 q3, [r0, q1]\n"
#define HELIUM_INDEXED                                                     \
    "vldrb.u32 q4, [r0, q0]\n"                                             \
    "vldrb.u32 q5, [r0, q1]\n"                                             \
    "ldr r12, [%[p], %[palette]]\n"                                        \
    "vldrw.u32 q2, [r12, q4, uxtw #2]\n"                                   \
    "vldrw.u32 q3, [r12, q5, uxtw #2]\n"

/* qv_under and qv_over. q3: colour and opacity, Q0.32, of the sample, its opacity in r0 too; q7:
   light. The first keeps the transmittance in r5, and branches to 6 where r8 is enough. */
#define HELIUM_UNDER                                                       \
    "vdup.32 q2, r5\n"                                                     \
    "vrmulh.u32 q3, q3, q2\n"                                              \
    "vadd.i32 q7, q7, q3\n"                                                \
    "vmov.32 r0, q7[3]\n"                                                  \
    "rsb r5, r0, #0\n"                                                     \
    "cmp r5, r8\n"                                                         \
    "bls 6f\n"
#define HELIUM_OVER                                                        \
    "vdup.32 q2, r0\n"                                                     \
    "vrmulh.u32 q2, q7, q2\n"                                              \
    "vsub.i32 q7, q7, q2\n"                                                \
    "movs r0, #0\n"                                                        \
    "vmov.32 q3[3], r0\n"                                                  \
    "vrshr.u32 q3, q3, #1\n"                                               \
    "vadd.i32 q7, q7, q3\n"

/*
 * Takes samples as qv_take does, until none is left, light is enough, or one needs the C form.
 *
 * All weights but 1 fit 16 bits; 1 is that of a single voxel, and then all are 0 modulo 2^16.
 * So an opacity of 0 is that, or nothing to see, or voxels without weight that
 * qv_any_opacity sees, or does not: where all eight are clear, that is the same.
 *
 * A product of two channels fits 16 bits; vmlav adds up products of 16 by 16 bits, here to at
 * most 65536 * 255^2. q0, q1: addresses; q6: weights; q4: B and A of all voxels; q5: A; q2: R
 * and G; r4: next; lr: prepared.
 */
#define HELIUM_MARCH(entries, composite)                                   \
    "vldrw.u32 q7, [%[p], %[light]]\n"                                     \
    "vmov.32 r5, q7[3]\n"                                                  \
    "rsb r5, r5, #0\n"                                                     \
    "ldr r8, [%[p], %[enough]]\n"                                          \
    "ldr r4, [%[p], %[next]]\n"                                            \
    "ldr lr, [%[p], %[prepared]]\n"                                        \
    "cmp lr, #0\n"                                                         \
    "bne 2f\n"                                                             \
    "1:\n"                                                                 \
    HELIUM_PREPARE                                                         \
    "ldr r1, [%[p], %[unprepared]]\n"                                      \
    "mov lr, #4\n"                                                         \
    "cmp r1, #4\n"                                                         \
    "csel lr, r1, lr, lo\n"                                                \
    "sub r1, lr\n"                                                         \
    "str r1, [%[p], %[unprepared]]\n"                                      \
    "add r4, %[p], %[record]\n"                                            \
    "vldrw.u32 q7, [%[p], %[light]]\n"                                     \
    "2:\n"                                                                 \
    "dls lr, lr\n"                                                         \
    "vldrw.u32 q0, [%[p], %[left]]\n"                                      \
    "vldrw.u32 q1, [%[p], %[right]]\n"                                     \
    "3:\n"                                                                 \
    "vldrw.u32 q6, [r4], #20\n"                                            \
    "ldr r0, [r4, #-4]\n"                                                  \
    entries                                                                \
    "vmov q4, q3\n"                                                        \
    "vsri.32 q4, q2, #16\n"                                                \
    "vshr.u16 q5, q4, #8\n"                                                \
    "vmlav.u16 r0, q5, q6\n"                                               \
    "cbz r0, 5f\n"                                                         \
    "vsli.32 q2, q3, #16\n"                                                \
    "vmullb.u8 q3, q5, q2\n"                                               \
    "vmullt.u8 q2, q4, q2\n"                                               \
    "vmullb.u8 q4, q5, q4\n"                                               \
    "add r1, r0, r0, lsl #8\n" /* qv_opacity_q32 */                        \
    "add r1, r1, r0, lsr #8\n"                                             \
    "add r0, r1, r0, lsr #16\n"                                            \
    "vmlav.u16 r2, q3, q6\n"                                               \
    "vmlav.u16 r12, q4, q6\n"                                              \
    "vmov q3[2], q3[0], r2, r12\n"                                         \
    "vmlav.u16 r2, q2, q6\n"                                               \
    "vmov q3[3], q3[1], r2, r0\n"                                          \
    composite                                                              \
    "4:\n"                                                                 \
    "le lr, 3b\n"                                                          \
    "vstrw.32 q7, [%[p], %[light]]\n"                                      \
    "ldr r1, [%[p], %[unprepared]]\n"                                      \
    "cmp r1, #0\n"                                                         \
    "bne 1b\n"                                                             \
    "mov lr, #0\n"                                                         \
    "b 7f\n"                                                               \
    "5:\n"                                                                 \
    "vaddv.u16 r0, q5\n"                                                   \
    "cbnz r0, 6f\n"                                                        \
    "ldr r0, [%[p], %[skipped]]\n"                                         \
    "add r0, #1\n"                                                         \
    "str r0, [%[p], %[skipped]]\n"                                         \
    "b 4b\n"                                                               \
    "6:\n"                                                                 \
    "vstrw.32 q7, [%[p], %[light]]\n"                                      \
    "7:\n"                                                                 \
    "str r4, [%[p], %[next]]\n"                                            \
    "str lr, [%[p], %[prepared]]\n"

#define HELIUM_RUN(entries, composite)                                     \
    __asm__ volatile(HELIUM_MARCH(entries, composite)                      \
                     : [p] "+r"(p)                                         \
                     : [axis] "i"(HELIUM_OFFSET(axis)), [left] "i"(HELIUM_OFFSET(left)), \
                       [right] "i"(HELIUM_OFFSET(right)),                  \
                       [light] "i"(HELIUM_OFFSET(light)),                  \
                       [palette] "i"(HELIUM_OFFSET(palette)),              \
                       [enough] "i"(HELIUM_OFFSET(enough)),                \
                       [skipped] "i"(HELIUM_OFFSET(skipped)),              \
                       [next] "i"(HELIUM_OFFSET(next)),                    \
                       [prepared] "i"(HELIUM_OFFSET(prepared)),            \
                       [unprepared] "i"(HELIUM_OFFSET(unprepared)),        \
                       [record] "i"(HELIUM_OFFSET(record))                 \
                     : "r0", "r1", "r2", "r3", "r4", "r5", "r8", "r12", "lr", "q0", \
                       "q1", "q2", "q3", "q4", "q5", "q6", "q7", "cc", "memory")

/* clang-format on */

/* Takes samples until none is left, or light is enough, or the next one but `next` needs the C form. */
FX_INLINE void helium_run(helium_state *h, unsigned storage, int back)
{
    uint32_t *p = h->record_at;
    if (back && qv_storage_indexed(storage))
        HELIUM_RUN(HELIUM_INDEXED, HELIUM_OVER);
    else if (back)
        HELIUM_RUN(HELIUM_DIRECT, HELIUM_OVER);
    else if (qv_storage_indexed(storage))
        HELIUM_RUN(HELIUM_INDEXED, HELIUM_UNDER);
    else
        HELIUM_RUN(HELIUM_DIRECT, HELIUM_UNDER);
}

/* Whether a volume's entries can be read as words. */
static inline int helium_reads(const qv_volume *volume, unsigned storage)
{
    uint32_t bits = (uint32_t)(uintptr_t)volume->palette;
    if (!qv_storage_indexed(storage))
        bits = (uint32_t)(uintptr_t)volume->voxels | (uint32_t)volume->stride[0] |
               (uint32_t)volume->stride[1] | (uint32_t)volume->stride[2];
    return (bits & 3u) == 0;
}

static inline void helium_begin_axis(helium_axis *axis, qv_coord place, qv_coord advance,
                                     uint32_t size, uint32_t stride)
{
    uint64_t at = (uint64_t)place + ((uint64_t)HELIUM_ONE << 16);
    uint32_t whole = (uint32_t)((uint64_t)advance >> 16), part = (uint16_t)advance;
    for (uint32_t lane = 0; lane < HELIUM_LANES; lane++) {
        axis->place[lane] = (uint32_t)(at >> 16) + lane * whole;
        axis->rest[lane] = (uint16_t)at + lane * part;
    }
    axis->place_step = HELIUM_LANES * whole;
    axis->rest_step = HELIUM_LANES * part;
    axis->stride = size == 1 ? 0 : stride;
    axis->last_cell = size == 1 ? 0 : size - 2u;
}

static inline void helium_load(helium_state *h, const qv_light *light, int back)
{
    for (unsigned c = 0; c < 3; c++)
        h->light[c] = light->colour[c];
    h->light[3] = back ? light->transmittance : 0u - light->transmittance;
    h->skipped = light->skipped;
}

static inline void helium_store(qv_light *light, const helium_state *h, int back)
{
    for (unsigned c = 0; c < 3; c++)
        light->colour[c] = h->light[c];
    light->transmittance = back ? h->light[3] : 0u - h->light[3];
    light->skipped = h->skipped;
}

/* From where a ray stands. */
static inline void helium_begin(helium_state *h, const qv_ray *ray, const qv_context *context,
                                uint32_t samples)
{
    const qv_volume *volume = &context->scene.volume;
    for (unsigned axis = 0; axis < 3; axis++)
        helium_begin_axis(&h->axis[axis], ray->place[axis], ray->advance[axis], volume->size[axis],
                          (uint32_t)volume->stride[axis]);
    for (unsigned i = 0; i < 4; i++) {
        h->left[i] = (uint32_t)(uintptr_t)volume->voxels + (i & 1u) * h->axis[1].stride +
                     (i >> 1) * h->axis[2].stride;
        h->right[i] = h->left[i] + h->axis[0].stride;
        h->record_at[i] = (uint32_t)(uintptr_t)&h->record[i];
    }
    h->palette = (uint32_t)(uintptr_t)volume->palette;
    h->enough = (uint32_t)context->scene.termination << 15; /* Q0.16 to Q1.31 */
    h->prepared = 0;
    h->unprepared = samples;
}

/* Takes sample `number` from where the ray stands, in the C form. Seldom called: by itself, for
   any storage and order, so that its stack and code are none of the march's. */
__attribute__((noinline, unused)) static void
helium_take_alone(qv_light *light, qv_ray *ray, int32_t number, const qv_volume *volume, int back)
{
    uint32_t colour[3], opacity;
    qv_ray_count_from(ray, number);
    if (!qv_take(colour, &opacity, ray, volume, volume->storage, qv_take_weighted))
        light->skipped++;
    else if (back)
        qv_over(light, colour, opacity);
    else
        qv_under(light, colour, opacity);
    qv_ray_count_from(ray, -1 - number); /* it has gone on */
}

/* Takes the next of a ray's samples, until light is enough. */
FX_INLINE void helium_march(qv_light *light, qv_ray *ray, const qv_context *context,
                            unsigned storage, int back)
{
    uint32_t some = ray->samples < HELIUM_SAMPLES_MAX ? ray->samples : HELIUM_SAMPLES_MAX;
    uint32_t left = some;
    helium_state h;
    helium_begin(&h, ray, context, some);
    while (left != 0 && (back || light->transmittance > h.enough)) {
        helium_load(&h, light, back);
        helium_run(&h, storage, back);
        helium_store(light, &h, back);
        left = h.prepared + h.unprepared;
        if (left == 0)
            break;
        if (back || light->transmittance > h.enough)
            helium_take_alone(light, ray, (int32_t)(some - left), &context->scene.volume, back);
        h.prepared--;
        left--;
    }
    ray->samples -= some - left;
    light->terminated = !back && light->transmittance <= h.enough && ray->samples != 0;
    if (some == HELIUM_SAMPLES_MAX)
        qv_ray_count_from(ray, (int32_t)some);
}

FX_INLINE int qv_march_twin(qv_light *light, qv_ray *ray, const qv_context *context,
                            unsigned storage, qv_taking *mode, int back)
{
    if (mode != qv_take_weighted || qv_channel_bytes(storage) != 1 ||
        !helium_reads(&context->scene.volume, storage))
        return 0;
    qv_ray_clip(ray, context);
    if (back)
        qv_reverse(ray);
    while (ray->samples != 0 && !light->terminated)
        helium_march(light, ray, context, storage, back);
    return 1;
}

#endif /* HELIUM_H */
