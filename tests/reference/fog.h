/*
 * fog.h - slices of one opacity and of colour 255, blended by the library's functions in
 * the rules of Williams et al.: what accumulates, how far that is from exact blending, and
 * what two bricks of it make.
 *
 * Levels are 0 .. 255, opacities too: 1.0 there is 1/255.
 */
#ifndef REF_FOG_H
#define REF_FOG_H

#include <stdbool.h>
#include <stdint.h>

/* What most figures of the paper have. */
#define REF_FOG_PERIOD     32
#define REF_FOG_SLICES_MAX 1000

typedef enum ref_fog_technique {
    REF_FOG_PLAIN,        /* 8 bits of opacity, the blend rounded to 8 bits */
    REF_FOG_PLAIN_12,     /* the same of 12 bits */
    REF_FOG_ORDERED,      /* the paper's dithers of the opacity */
    REF_FOG_RANDOM,       /* */
    REF_FOG_ROUNDING,     /* dithered rounding of the blend in 8 bits, blocks of 8 slices */
    REF_FOG_ROUNDING_8_4, /* the same where the frame buffer has 4 or 8 bits more */
    REF_FOG_ROUNDING_8_8
} ref_fog_technique;

typedef struct ref_fog {
    ref_fog_technique technique;
    double opacity;
    /* Of the paper's dithers: factors of the opacity below and above the knee, and whether the
       bump grows (section 3). */
    double slope[2];
    bool bumping;
    uint32_t pixel; /* shifts the dither; the figures are those of 0 */
} ref_fog;

/* The paper's dithers: the opacity of 8 bits of a slice, where `value` has accumulated. */
uint32_t ref_fog_dithered(const ref_fog *fog, uint32_t slice, uint32_t value);

/* levels[n] after n slices, 0 <= n <= count. Those of 8.4 and 8.8 keep their fraction. */
void ref_fog_accumulate(double *levels, uint32_t count, const ref_fog *fog);

/* The same by exact blending of the opacity as it is. */
double ref_fog_exact(double opacity, uint32_t slices);

/* Largest difference from exact blending. */
double ref_fog_deviation(const double *levels, uint32_t count, double opacity);

/* Equation 8: the image of a near brick over that of a far one, which share an opacity channel
   of the same level as colour 255 has. */
double ref_fog_over(double near, double far);

/*
 * The paper's AAP error in percent where a near brick has n of `count` slices and a far one the
 * rest: how much more that is than one brick with all. ref_fog_seam: the largest, signed.
 */
double ref_fog_brick_error(const double *levels, uint32_t count, uint32_t n);
double ref_fog_seam(const double *levels, uint32_t count);

#endif /* REF_FOG_H */
