/*
 * qvol.h - an integer-only volume renderer: the whole public interface.
 *
 * qvol turns semi-transparent voxels in the caller's memory into rows of pixels
 * in the caller's buffer. It allocates nothing, keeps no state of its own, calls
 * no library function but memcpy, memset and memmove, and computes the same bits
 * on every target.
 *
 *     voxels -> classify -> sample -> composite -> pixels
 *
 * CONVENTIONS (fixed for good; tests/SPEC.md states them as integer formulas)
 *
 * Space. A volume of size (nx, ny, nz) fills the box [0,nx] x [0,ny] x [0,nz] of
 *   voxel coordinates. The centre of voxel (i, j, k) is (i+1/2, j+1/2, k+1/2).
 *   World coordinates are voxel coordinates times the spacing of each axis;
 *   their unit is the caller's (millimetres, or voxels where every spacing is 1).
 *   World axes are right-handed: x right, y into the picture and z up for a
 *   viewer at azimuth 0 and elevation 0.
 * Box. A point belongs to the volume where 0 <= p < n holds on every axis.
 *   Between the outermost voxel centres and the faces of the box, values are
 *   clamped: they are those of the nearest point between centres.
 * Angles are binary: 2^32 is one full turn, so 0x40000000 is 90 degrees.
 * Pixels. x runs to the right and y downwards; a pixel's ray goes through its
 *   centre. Rectangles are half-open and absolute: the same pixel has the same
 *   value in every rectangle, strip or row that contains it.
 * Samples. The samples of a ray lie on the grid s = (k + phase) * step, k an
 *   integer, with the step a length in world units and the caller's phase in
 *   [0, 1). s is measured along the ray: from the camera's origin plane
 *   (orthographic: k of either sign; the cameras of qv_orthographic put it
 *   through the centre of the box) or from the eye (perspective: k >= 0).
 * Stretches. A sample stands for the stretch of one step centred on it. nearest,
 *   separate, weighted and preweighted know no lengths: they take a sample where its point lies
 *   in the box, and take it for a whole step. The other modes weigh by length: the
 *   borders between stretches cut the ray's way through the box into pieces, and
 *   each piece is sampled at its middle, with its own length. So the pieces add up
 *   to the way, and all but the first and the last are whole steps. Where a ray
 *   enters and leaves is known to 2^-23 of a step, the length of a piece to 2^-17.
 * Reconstruction reads the sample's point rounded to 1/256 voxel on each axis,
 *   to nearest, ties upwards; rays advance in steps of 2^-32 voxel.
 * Colour. 255 of 8 bits and 65535 of 16 bits are exactly 1. Stored colours are
 *   not weighted by opacity, but in one storage; the renderer weights them while it interpolates.
 *   Pixels with an alpha channel hold associated (premultiplied) colours.
 * Unit distance. The length for which a stored opacity holds. It is the step
 *   itself where the volume's unit_distance is 0. Modes that know no lengths
 *   take opacities as they are, so any other value must equal the step there.
 * Extinction is optical depth per world unit, and depth is in base 2: a stretch of
 *   depth x lets 2^-x of the light through. (Kraus and Buerger's tau is ln 2 times
 *   as much.) A stored value v of 255 or 65535 means v / 255 or v / 65535 of the
 *   volume's extinction. Full opacity is a depth of 64 for its unit distance.
 * Rounding is to nearest with ties upwards unless a declaration says otherwise.
 *
 * ERRORS. A function that can fail returns a qv_status: 0 or a positive value on
 * success, a negative one on error. On error nothing has been written through
 * any pointer argument; but qv_splat_init may leave zeros, since it makes its result where
 * it is to be. Order of arguments: what is written, then what is read.
 *
 * THREADS. Every function works on its arguments alone, so calls on different
 * outputs may run at the same time; contexts and volumes may be shared freely.
 */
#ifndef QVOL_H
#define QVOL_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define QV_VERSION_MAJOR 0
#define QV_VERSION_MINOR 1
#define QV_VERSION_PATCH 0
#define QV_VERSION       "0.1.0"

/* Of tests/SPEC.md, which states every bit of output; counted up when one changes. */
#define QV_SPECIFICATION 1

/* ---- Memory ------------------------------------------------------------- */

/*
 * Address of data that may lie in program memory: voxels, palettes, scalars.
 * A port whose program memory is not reached through plain pointers names a
 * header in QV_MEMORY_HEADER that defines qv_address, qv_offset (a signed
 * integer that spans a volume) and the accessors of core/access.h.
 */
#ifdef QV_MEMORY_HEADER
#include QV_MEMORY_HEADER
#else
typedef const unsigned char *qv_address;
typedef ptrdiff_t qv_offset;
#endif

/*
 * What a definition of one of the library's constants begins with, and a field of it: modes,
 * formats, projections, blends, filters and whatever else is declared `extern const` below. A
 * QV_MEMORY_HEADER that defines both, as that of the AVR does, keeps them in program memory;
 * tables lie there by FX_TABLE_HEADER. Callers name constants by their address as anywhere
 * (.sampling = &qv_weighted_indexed8) and do not look into them; one of their own, such as a
 * qv_filter, they define by QV_DESCRIPTOR. A macro, since no function returns fields of any type.
 */
#ifndef QV_DESCRIPTOR
#define QV_DESCRIPTOR               const
#define QV_FIELD(descriptor, field) ((descriptor)->field)
#endif

/* ---- Status ------------------------------------------------------------- */

typedef enum qv_status {
    QV_OK = 0,
    QV_MORE = 1,           /* not an error: bounded work remains to be done */
    QV_ERROR_NULL = -1,    /* a required pointer is null */
    QV_ERROR_STORAGE = -2, /* unknown storage, or not the one the sampling mode reads */
    QV_ERROR_SIZE = -3,    /* an axis is 0 or longer than QV_AXIS_MAX */
    QV_ERROR_STRIDE = -4,  /* strides overlap or leave the memory; data not aligned */
    QV_ERROR_PALETTE = -5, /* palette missing, not of 256 entries, or 16-bit at an odd address */
    QV_ERROR_SPACING = -6, /* spacing outside 1/16 .. 256 */
    QV_ERROR_STEP = -7,    /* step out of range */
    QV_ERROR_UNIT = -8,   /* unit distance out of range, or, where it must equal it, not the step */
    QV_ERROR_CAMERA = -9, /* matrix degenerate or out of range */
    QV_ERROR_VIEW = -10,  /* frame size, pitch or field of view out of range */
    QV_ERROR_RECT = -11,  /* rectangle empty or outside +-QV_PIXEL_MAX */
    QV_ERROR_BUFFER = -12,      /* output buffer too small, or rows overlap */
    QV_ERROR_TRANSFER = -13,    /* control points out of order, or none */
    QV_ERROR_WINDOW = -14,      /* window of scalar values is empty or out of range */
    QV_ERROR_LIGHT = -15,       /* shading: zero vector or coefficient out of range */
    QV_ERROR_EXTINCTION = -16,  /* extinction of the full value 0, or too much for a step */
    QV_ERROR_MIXTURE = -17,     /* percentages sum to more than 1; a filter does not sum to 1 */
    QV_ERROR_LEVEL = -18,       /* more levels than the size has, or a level without a pyramid */
    QV_ERROR_DITHER = -19,      /* dither: no sequence or technique, period or slope out of range */
    QV_ERROR_SLICE = -20,       /* slice out of range, or no slices */
    QV_ERROR_DIRECTION = -21,   /* directions: none, unknown, or one missing from a set */
    QV_ERROR_ATTENUATION = -22, /* attenuation: records too short, or their memory too small */
    QV_ERROR_INSIDE = -23,      /* eye in the volume where no light gets out of it */
    QV_ERROR_SUMS = -24,        /* a sum of splats is full */
    QV_ERROR_OVERLAP = -25,     /* memory that is written is also read */
    QV_ERROR_READ = -26,        /* voxels could not be read; qv_pages has the caller's own status */
    QV_ERROR_PAGES = -27 /* pages too few, too small, odd for 16 bits, or of another volume */
} qv_status;

/* One line of English for a status, never null; also for values not listed. Like that of
   qv_version, the text lies where tables do: on an AVR in program memory, for pgm_read_byte. */
const char *qv_status_text(qv_status status);

/* The version of the library that is linked, QV_VERSION at its build. */
const char *qv_version(void);

/* ---- Volumes ------------------------------------------------------------ */

#define QV_AXIS_MAX        4096
#define QV_PALETTE_ENTRIES 256
#define QV_PALETTE8_BYTES  1024 /* 256 RGBA8 entries */
#define QV_PALETTE16_BYTES 2048 /* 256 RGBA16 entries */

/* A length or ratio with 16 fraction bits: 65536 is 1. */
#define QV_ONE_Q16 65536u

typedef enum qv_storage {
    QV_STORAGE_RGBA8 = 1,       /* 4 bytes R,G,B,A; any alignment */
    QV_STORAGE_RGBA16 = 2,      /* 4 uint16_t R,G,B,A in the machine's byte order, 2-aligned */
    QV_STORAGE_INDEXED8 = 3,    /* 1 byte, index into 256 RGBA8 entries */
    QV_STORAGE_INDEXED8_16 = 4, /* 1 byte, index into 256 RGBA16 entries */
    /* The same with extinction for opacity; T is tau, as the papers call it. */
    QV_STORAGE_RGBT8 = 5,
    QV_STORAGE_RGBT16 = 6,
    QV_STORAGE_INDEXED8_T8 = 7,
    QV_STORAGE_INDEXED8_T16 = 8,
    /* 4 bytes R,G,B,A, 4-aligned; colours are associated: weighted by opacity, and none above it.
       Voxels only, for preweighted */
    QV_STORAGE_ASSOCIATED8 = 9
} qv_storage;

struct qv_pages;

/*
 * A volume: a view of voxels in the caller's memory, flash included.
 * The caller keeps voxels and palette alive and unchanged while contexts that
 * were made from the descriptor are in use; the descriptor itself is copied.
 */
typedef struct qv_volume {
    qv_address voxels;      /* voxel (0,0,0) */
    qv_address palette;     /* indexed storage: 256 entries, alignment as storage says; else null */
    uint64_t voxels_bytes;  /* memory that the voxels span, from the lowest byte to the highest */
    uint32_t palette_bytes; /* QV_PALETTE8_BYTES or QV_PALETTE16_BYTES; 0 without palette */
    uint16_t size[3];       /* voxels on x, y, z: 1 .. QV_AXIS_MAX */
    uint8_t storage;        /* a qv_storage */
    uint32_t spacing[3];    /* world units per voxel, Q16.16, 1/16 .. 256; 0 means 1 */
    uint32_t unit_distance; /* world length for which opacities hold, Q16.16; 0: the step */
    uint32_t extinction;    /* depth per world unit of the full stored value, Q16.16; read where
                               the storage holds extinction */
    int32_t stride[3];      /* bytes to the next voxel on x, y, z; any order, any sign, even for
                               16-bit data. The axes must nest: sorted by size, each stride is at
                               least the extent of the axis below it. Ignored on axes of size 1 */
    struct qv_pages *pages; /* what _paged modes read voxels through; they need no voxels, no
                               voxels_bytes and no stride. Else not read, and may be null */
} qv_volume;

/*
 * Checks a volume as qv_init does. Returns QV_OK or QV_ERROR_NULL, _STORAGE,
 * _SIZE, _STRIDE, _PALETTE, _SPACING.
 */
qv_status qv_volume_check(const qv_volume *volume);

/* ---- Cameras ------------------------------------------------------------ */

typedef int64_t qv_coord;  /* voxel or world coordinate, Q31.32 */
typedef uint32_t qv_angle; /* 2^32 is a full turn */

struct qv_camera;
struct qv_scene;
struct qv_context;
struct qv_ray;

/*
 * How rays leave the frame: side by side, or from an eye. The caller names one of
 * the two, and only that one is linked. The fields are the library's own.
 */
typedef struct qv_projection {
    int (*ray)(struct qv_ray *ray, const struct qv_context *context, int32_t x, int32_t y);
    int (*in_range)(const struct qv_camera *camera);
} qv_projection;

extern const qv_projection qv_projection_orthographic, qv_projection_perspective;

/*
 * A camera: where the ray of pixel (x, y) goes. Fill it with qv_orthographic or
 * qv_perspective, or by hand, as a matrix of the caller's own. Ranges below are
 * checked by qv_init. Voxel coordinates; x and y count pixel centres.
 *
 *   orthographic: p = origin + x*across + y*down + (k + phase)*along
 *                 pace is 0 on every axis
 *   perspective:  v = along + x*across + y*down   (a direction in world units)
 *                 p = origin + (k + phase)*pace * v/|v|,  k >= 0, by component
 *
 * Ranges. Of both: |origin| <= 2^20 voxels, |across| and |down| <= 2^12.
 * Orthographic: |along| <= 2^8 voxels, its largest component >= 2^-9; samples
 * lie at -2^22 <= k < 2^22. Perspective: 2^-8 <= pace <= 2^8, |origin| <= 2^20 *
 * pace (so that k < 2^22 in the volume), |along| <= 2^20 world units; pixels whose
 * |v| is below 2^-16 on every axis show the background.
 *
 * across, down and along must be independent: the determinant of the three, each
 * scaled by a power of 2 that takes its largest component to 1/2 .. 1, is at
 * least 2^-14 in magnitude. (The rotations of a view pass where no spacing is more
 * than 32 times another.)
 */
typedef struct qv_camera {
    const qv_projection *projection;
    uint32_t step; /* length of the step in world units, Q16.16, not 0 */
    qv_coord origin[3];
    qv_coord across[3];
    qv_coord down[3];
    qv_coord along[3];
    qv_coord pace[3]; /* perspective: step by spacing, voxels per step; orthographic: 0 */
} qv_camera;

/*
 * Rotation from binary angles. Rows of the result are the directions right,
 * down and forward (into the picture) in world axes, Q2.30.
 * Azimuth moves the viewer round the z axis, from -y towards +x; elevation
 * lifts the viewer towards +z; roll turns the camera clockwise about its line
 * of sight, hence the picture counter-clockwise. With all three 0 the rows are
 * (1,0,0), (0,0,-1), (0,1,0). Exact at multiples of 90 degrees; else each
 * component within 2^-27.
 */
void qv_rotation(int32_t rotation[3][3], qv_angle azimuth, qv_angle elevation, qv_angle roll);

/*
 * A view: a frame that looks at the centre of the volume's box.
 */
typedef struct qv_view {
    int32_t rotation[3][3]; /* rows right, down, forward, Q2.30; from qv_rotation or the caller's
                               own: not checked here, but by what qv_init asks of cameras */
    uint32_t pitch;         /* world units from pixel to pixel, in perspective at the volume's
                               centre; Q16.16, 2^-12 .. 2^8 */
    uint32_t step;          /* world units from sample to sample, Q16.16, 1/16 .. 16 */
    uint16_t width;         /* of the whole frame in pixels, 1 .. QV_PIXEL_MAX */
    uint16_t height;
} qv_view;

#define QV_PIXEL_MAX 32767

/*
 * Cameras for a view. The centre of the frame (the corner of four pixels where
 * width and height are even) sees the centre of the box.
 *
 * qv_perspective: field_of_view is the angle from the top edge of the frame to
 * the bottom edge, 1 .. 150 degrees; the eye lies where the plane through the
 * volume's centre shows at the view's pitch.
 *
 * A sample at the distance s from the eye, or from the plane through the centre,
 * lies within 2^-12 + 2^-29 * s / (least spacing) voxel of the real-arithmetic ray
 * of the same view, and within 1/256 voxel once its point is rounded, where s is at
 * most 2^17 times the least spacing (every view of a cubic volume of 4096 voxels
 * an axis, from 1.8 degrees of field). Along its ray a perspective sample may
 * besides be off by 2^-28 / sin(field_of_view / 2) of the eye's distance, as the
 * eye itself is.
 *
 * Return QV_OK or QV_ERROR_NULL, _SPACING, _VIEW (also, in perspective, a frame
 * higher than 65535 world units), _STEP. Whether the volume's size is in range,
 * the rotation independent and the eye near enough, qv_init tells.
 */
qv_status qv_orthographic(qv_camera *camera, const qv_volume *volume, const qv_view *view);
qv_status qv_perspective(qv_camera *camera, const qv_volume *volume, const qv_view *view,
                         qv_angle field_of_view);

/* ---- Sampling modes ----------------------------------------------------- */

struct qv_light;

/*
 * A sampling mode for one storage, front to back or back to front. The caller
 * names the modes it uses, and only those are linked. The fields are the
 * library's own.
 */
typedef struct qv_sampling {
    qv_status (*prepare)(struct qv_context *context, const struct qv_scene *scene);
    void (*march)(struct qv_light *light, struct qv_ray *ray, const struct qv_context *context);
    uint32_t read_out; /* accumulated light to pixel levels, core/composite.h */
    uint8_t storage;   /* the qv_storage it reads */
    uint8_t by_length; /* whether it weighs by length */
} qv_sampling;

/* Front to back, back to front, and front to back through a pyramid. */
#define QV_DECLARE_LENGTH_SAMPLINGS(name)                                                          \
    extern const qv_sampling name, name##_back_to_front, name##_levels;
#define QV_DECLARE_OPACITY_SAMPLINGS(mode)                                                         \
    QV_DECLARE_LENGTH_SAMPLINGS(mode##_rgba8)                                                      \
    QV_DECLARE_LENGTH_SAMPLINGS(mode##_rgba16)                                                     \
    QV_DECLARE_LENGTH_SAMPLINGS(mode##_indexed8)                                                   \
    QV_DECLARE_LENGTH_SAMPLINGS(mode##_indexed8_16)
#define QV_DECLARE_EXTINCTION_SAMPLINGS(mode)                                                      \
    QV_DECLARE_LENGTH_SAMPLINGS(mode##_rgbt8)                                                      \
    QV_DECLARE_LENGTH_SAMPLINGS(mode##_rgbt16)                                                     \
    QV_DECLARE_LENGTH_SAMPLINGS(mode##_indexed8_t8)                                                \
    QV_DECLARE_LENGTH_SAMPLINGS(mode##_indexed8_t16)

/*
 * nearest:  the voxel that contains the sample's rounded point; a point halfway
 *           between two centres takes the one with the higher index.
 * separate: colour and opacity interpolated trilinearly, each on its own, then
 *           multiplied (Levoy's pipeline, Wittenbrink et al. section 2): wrong
 *           at the border of materials, kept for comparison.
 * weighted: opacity-weighted interpolation (Wittenbrink et al. equations 9-12):
 *           weights in 4 multiplications and 12 additions, 36 and 40 in all (the
 *           paper's table 1 has 19 and 47; here differences are shared).
 *
 * Weights have 16 fraction bits and sum to exactly 1; only the product xyz is
 * rounded. Sums of 8-bit storage are exact (32 bits), those of 16-bit storage
 * at most 2^-29 low. A cell whose eight opacities are 0 is skipped before any
 * multiplication of weights, opacities or colours.
 *
 * front_to_back modes end a ray at the context's termination threshold
 * (equations 5, 6 and 8); back_to_front modes (equation 7) take every sample.
 * Light and transmittance accumulate with 31 fraction bits, rounding to
 * nearest: n samples cost at most n * 2^-32 of transmittance, 2 n * 2^-32 of light.
 */
extern const qv_sampling qv_nearest_rgba8, qv_nearest_rgba16;
extern const qv_sampling qv_nearest_indexed8, qv_nearest_indexed8_16;
extern const qv_sampling qv_separate_rgba8, qv_separate_rgba16;
extern const qv_sampling qv_separate_indexed8, qv_separate_indexed8_16;
extern const qv_sampling qv_weighted_rgba8, qv_weighted_rgba16;
extern const qv_sampling qv_weighted_indexed8, qv_weighted_indexed8_16;

extern const qv_sampling qv_nearest_rgba8_back_to_front, qv_nearest_rgba16_back_to_front;
extern const qv_sampling qv_nearest_indexed8_back_to_front, qv_nearest_indexed8_16_back_to_front;
extern const qv_sampling qv_separate_rgba8_back_to_front, qv_separate_rgba16_back_to_front;
extern const qv_sampling qv_separate_indexed8_back_to_front, qv_separate_indexed8_16_back_to_front;
extern const qv_sampling qv_weighted_rgba8_back_to_front, qv_weighted_rgba16_back_to_front;
extern const qv_sampling qv_weighted_indexed8_back_to_front, qv_weighted_indexed8_16_back_to_front;

/*
 * preweighted: as weighted, of voxels whose colours have been weighted once and for all (Blinn's
 *           and Porter and Duff's associated colours; qv_opacity_to_associated): the fastest, and
 *           the coarsest, by what associated colours of 8 bits lose (there) and by its short
 *           numbers: of a sample's channels at most 1 of 255 (half of it times |v00 - v10 - v01 +
 *           v11| of the rows along x), and not in places where they are linear in y or z.
 *
 * Sums have 16 bits, transmittance and light 32, of which products read the upper 16: a ray's
 * transmittance and light are within 2^-15 of those of its samples, and light is never above the
 * opacity. On rays that stay at a fraction f of a voxel on x, 2^-16 / min(f, 1 - f) comes to that:
 * 1 level of 255 at most, 1/128 level in the middle. On 200 random scenes pictures are within 1
 * level of exact for the same voxels, 99 % of all channels equal (weighted: 99.99 %).
 * Opacity 0 is clear, 255 opaque; a constant fog is never too thin to add up. Sampled are the
 * points of weighted; a sample is skipped whose opacity comes out as 0. A colour above its opacity
 * gives colours that mean nothing. Samples in the outermost half voxel of the box cost more.
 */
extern const qv_sampling qv_preweighted_associated8, qv_preweighted_associated8_back_to_front;

/*
 * Modes that weigh by length, trilinear or by the triquadratic B-spline (27 voxels;
 * weights have 16 fraction bits and sum to exactly 1):
 *
 * corrected:   opacity-based sampling (Kraus and Buerger 2008, section 3.2): weighted,
 *              then equations 16 and 17 for the length that the sample stands for. A
 *              length of the unit distance needs no correction and gets none.
 * extinction:  extinction-based sampling (section 3.3): extinction and extinction-
 *              weighted colour are interpolated. The ray sums depth up with 32 fraction
 *              bits, so that the step changes nothing in a homogeneous medium.
 *              Of volumes that store opacity, each voxel's is converted as it is read.
 * bspline_weighted, bspline_extinction: the same two with B-splines.
 *
 * Each names a storage; _levels reads a pyramid besides (qv_pyramid), front to back: a
 * point of the volume at 2^-l of its coordinates on level l, whose stretches are 2^l
 * steps long, counted from the border before stretch 0. Two levels are blended as sums,
 * before anything is made of them.
 *
 * Errors, beside those of weights (of B-splines, 27 of them: 2^-27) and compositing
 * above. Depth is exact but for 2^-31 a sample and, of stored opacity, 2^-24 for a unit
 * distance. Light is within 2^-16 of itself and 2^-29 a sample; where the full value's
 * depth for a piece is above 2^12, within 2^-28 times that depth of itself. Corrected
 * opacity is within 2^-27, times the ratio of length to unit distance where that is above
 * 1; corrected colour within 2^-15 of itself.
 *
 * The unit distance may be 2^-12 .. 2^12 steps, and in corrected modes at least 2^-11
 * steps of the coarsest level (else QV_ERROR_UNIT). The full value's depth for a step, of
 * the coarsest level, is above 0 and below 2^22 (else QV_ERROR_EXTINCTION).
 */
QV_DECLARE_OPACITY_SAMPLINGS(qv_corrected)
QV_DECLARE_OPACITY_SAMPLINGS(qv_bspline_weighted)
QV_DECLARE_OPACITY_SAMPLINGS(qv_extinction)
QV_DECLARE_EXTINCTION_SAMPLINGS(qv_extinction)
QV_DECLARE_OPACITY_SAMPLINGS(qv_bspline_extinction)
QV_DECLARE_EXTINCTION_SAMPLINGS(qv_bspline_extinction)

/* ---- Pixel formats ------------------------------------------------------ */

struct qv_pixel;

/*
 * A pixel format, named by its bytes in memory. Channels of 8 bits round to
 * nearest; narrower ones are dithered with an 8x8 ordered pattern taken from
 * the absolute pixel position, so that 0 and 1 stay exactly 0 and full scale.
 * Grey is (77 R + 150 G + 29 B) / 256. The fields are the library's own.
 */
typedef struct qv_format {
    void (*store)(uint8_t *row, uint32_t column, uint32_t line, const struct qv_pixel *pixel);
    uint8_t bits;       /* per pixel along a row */
    uint8_t line_shift; /* 2^line_shift rows of pixels share one row of bytes: 3 in
                           qv_format_mono_vertical, else 0 */
} qv_format;

extern const qv_format qv_format_rgba8888;  /* R, G, B, A; associated colour */
extern const qv_format qv_format_bgra8888;  /* B, G, R, A; the same (LVGL: premultiplied ARGB) */
extern const qv_format qv_format_rgb888;    /* R, G, B */
extern const qv_format qv_format_rgb565_le; /* 16 bits, R in the highest 5; low byte first */
extern const qv_format qv_format_rgb565_be; /* the same; high byte first */
extern const qv_format qv_format_l8;        /* grey */
extern const qv_format qv_format_grey4;     /* two pixels a byte, the left one in the high bits */
extern const qv_format qv_format_mono_horizontal; /* 8 pixels a byte, the leftmost in the MSB */
extern const qv_format qv_format_mono_vertical;   /* 8 rows a byte, the topmost in the LSB */

/* Bytes of one row of pixels, without padding: (width * bits + 7) / 8. */
uint32_t qv_row_bytes(const qv_format *format, uint16_t width);

/* ---- Rendering ---------------------------------------------------------- */

/*
 * Coarser levels of a volume in the caller's memory, kept alive and unchanged as its
 * voxels are: level 1, then 2, and so on, each tightly packed, x fastest, without
 * gaps, as qv_downsample makes them. A voxel of level l is 2^l voxels of the volume
 * wide and begins where one of them does: level l has ceil(size / 2^l) of them on an
 * axis, and the last may reach beyond the box, which is the volume's on every level.
 * Voxels are RGBA or RGBT with the channels of the volume or of its palette.
 */
typedef struct qv_pyramid {
    qv_address voxels; /* voxel (0,0,0) of level 1 */
    uint64_t bytes;    /* at least qv_pyramid_bytes */
    uint8_t levels;    /* coarser levels, 1 .. qv_pyramid_levels */
} qv_pyramid;

typedef struct qv_scene {
    const qv_sampling *sampling; /* must read the volume's storage */
    uint16_t phase;              /* of the sample grid, Q0.16 of a step */
    uint16_t termination;        /* transmittance, Q0.16, at or below which a front-to-back ray
                                    ends; 0: only where nothing more can be seen.
                                    QV_TERMINATION_DEFAULT costs at most 1/4 of an 8-bit level */
    uint8_t background[4];       /* R, G, B (unweighted) and opacity; all 0: transparent */
    uint16_t level;              /* what _levels modes sample, Q8.8: 0 the volume, 256 level 1; in
                                    between, both, in proportion. At most the levels there are */
    uint32_t level_distance;     /* 0: that level everywhere. Else, in perspective: so many steps
                                    from the border of stretch 0, that is from within half a step
                                    of the eye, its whole part begins to rise, by 1 up to twice
                                    the distance, and so on; see qv_detail. Below 2^23 */
    const qv_pyramid *pyramid;   /* kept by the caller; null where no _levels mode is used */
    qv_volume volume;
    qv_camera camera;
} qv_scene;

#define QV_TERMINATION_DEFAULT 64

/* What depth a step has; of modes that weigh by length, core/medium.h. */
typedef struct qv_medium {
    uint64_t depth;
    uint32_t light;
    uint32_t light_shift;
} qv_medium;

/* A checked scene, ready to render. Plain data: it may be copied, and holds no
   pointer into itself. Its fields are the library's own. */
typedef struct qv_context {
    uint32_t background[4]; /* associated, levels with 17 fraction bits */
    qv_medium medium;
    qv_scene scene;
} qv_context;

/*
 * Checks a scene and makes a context of it. Returns QV_OK, or any error of
 * qv_volume_check, or QV_ERROR_NULL, _STORAGE, _STEP, _CAMERA, _UNIT, _EXTINCTION, and of
 * _levels modes QV_ERROR_LEVEL (no pyramid, more levels than the volume has, a level that
 * it lacks, or a level_distance out of range or without an eye), _STRIDE and _BUFFER (the
 * pyramid's memory).
 */
qv_status qv_init(qv_context *context, const qv_scene *scene);

typedef struct qv_rect { /* half-open: left <= x < right, top <= y < bottom */
    int32_t left, top, right, bottom;
} qv_rect;

/*
 * Where pixels go. Pixel (left, top) of the rectangle starts at pixels; the
 * next row of bytes follows at pixels + stride, which may be negative (then
 * the rows lie below pixels). bytes counts the memory that the rows may use:
 * from pixels upwards, or with a negative stride from the lowest row to the
 * end of the first. Only the bits of the rectangle's pixels are changed. Pixels
 * narrower than a byte are counted from the rectangle's corner too: its left
 * column takes the first bits of a row, its top row bit 0 of a mono_vertical page.
 */
typedef struct qv_image {
    void *pixels;
    size_t bytes;
    ptrdiff_t stride;
    const qv_format *format;
} qv_image;

/*
 * Renders a rectangle in one call. Returns QV_OK, or QV_ERROR_NULL, _RECT,
 * _BUFFER.
 */
qv_status qv_render(const qv_image *image, const qv_context *context, const qv_rect *rect);

/*
 * Rendering in bounded pieces: zero a qv_progress, then call qv_render_some
 * until it returns QV_OK. Each call renders at most max_pixels pixels, row by row
 * from the top, and returns QV_MORE while pixels remain; a
 * caller may stop at any time. The pixels are those of qv_render. A ray takes
 * at most 2^22 samples. Returns QV_OK, QV_MORE, or QV_ERROR_NULL, _RECT (also
 * for a progress outside the rectangle), _BUFFER.
 */
typedef struct qv_progress {
    uint16_t column;     /* next pixel, counted from the rectangle's left top */
    uint16_t line;       /* the rectangle's height where all are done */
    uint32_t terminated; /* rays that ended at the termination threshold */
    uint32_t samples;    /* samples that were taken, skipped ones included; modulo 2^32 */
    uint32_t skipped;    /* samples in cells whose opacities are all 0; modulo 2^32 */
} qv_progress;

qv_status qv_render_some(const qv_image *image, qv_progress *progress, const qv_context *context,
                         const qv_rect *rect, uint32_t max_pixels);

/* ---- Transfer functions and classification ------------------------------- */

/* A transfer table: 256 entries R,G,B,A of 16 bits, unweighted colours. As it
   stands it is the palette of QV_STORAGE_INDEXED8_16. */
typedef struct qv_transfer {
    uint16_t rgba[QV_PALETTE_ENTRIES][4];
} qv_transfer;

typedef struct qv_control_point {
    uint8_t index;    /* table entry that gets exactly this colour */
    uint16_t rgba[4]; /* unweighted colour and opacity for the unit distance */
} qv_control_point;

/*
 * Builds a table from control points of strictly rising index: each channel
 * linear between points, rounded to nearest with ties upwards; constant before
 * the first and after the last. 32-bit arithmetic. Returns QV_OK or
 * QV_ERROR_NULL, QV_ERROR_TRANSFER (count 0 or above 256, or index not rising).
 */
qv_status qv_transfer_build(qv_transfer *table, const qv_control_point *points, uint16_t count);

/* The same table with 8 bits a channel, each rounded to nearest. */
void qv_transfer_to_palette8(uint8_t palette[QV_PALETTE_ENTRIES][4], const qv_transfer *table);

typedef enum qv_scalar_type {
    QV_SCALAR_U8 = 1,
    QV_SCALAR_U16 = 2, /* machine byte order, 2-aligned */
    QV_SCALAR_S16 = 3
} qv_scalar_type;

/* Scalars in the caller's memory; fields as in qv_volume. */
typedef struct qv_scalars {
    qv_address values;     /* value (0,0,0) */
    uint64_t values_bytes; /* memory that the values span */
    uint32_t spacing[3];
    int32_t stride[3];
    uint16_t size[3];
    uint8_t type; /* a qv_scalar_type */
} qv_scalars;

/*
 * Shading of voxels before they are stored (Wittenbrink et al. figure 3): the
 * gradient by central differences in world units (at the border of the volume
 * the outermost value is repeated), the normal against the gradient, and
 *   colour = min(1, colour * (ambient + diffuse * max(0, n.l)) + specular * max(0, n.h)^(2^gloss))
 * where h is halfway between light and viewer (Blinn-Phong; specular 0 is
 * Lambert). Coefficients are Q0.8 with 256 as 1. Where the gradient is 0, or its
 * magnitude below least_gradient (an exact comparison), the voxel keeps its
 * colour. Light and viewer within 1/256 of a radian of opposite give no highlight.
 */
typedef struct qv_shading {
    int16_t light[3];        /* direction to the light in world axes, any length but 0 */
    int16_t viewer[3];       /* direction to the viewer, as light; not read where specular is 0 */
    uint16_t ambient;        /* 0 .. 256 */
    uint16_t diffuse;        /* 0 .. 256 */
    uint16_t specular;       /* 0 .. 256 */
    uint8_t gloss;           /* exponent 2^gloss, 0 .. 7 */
    uint16_t least_gradient; /* window units of 1/256 of the window per world unit */
} qv_shading;

/*
 * Classification. A scalar s becomes the table index
 *   round(255 * (s - low) / (high - low)), clamped to 0 .. 255,
 * where a window about a level has low = level - window/2, high = level +
 * window/2. Then the table gives colour and opacity, shading changes the colour,
 * and the voxel is stored.
 */
typedef struct qv_classifier {
    qv_scalars scalars;
    int32_t low, high;           /* of the scalars' values; low < high, each in -65536 .. 131071 */
    const qv_transfer *transfer; /* may be null for QV_STORAGE_INDEXED8 and _16 */
    const qv_shading *shading;   /* null: none; not used for indexed storage */
} qv_classifier;

/* A part of the volume, half-open on every axis. */
typedef struct qv_block {
    uint16_t first[3];
    uint16_t end[3];
} qv_block;

/*
 * Classifies a block into tightly packed voxels, x fastest, then y, then z:
 * bytes must be at least the block's voxels times the storage's 4, 8 or 1, and
 * the address needs no alignment. Blocks give the same voxels as the whole
 * volume. Rounding: the index to nearest; shaded colours within 1 of 255, or 1
 * of 65535, of real arithmetic.
 * Returns QV_OK or QV_ERROR_NULL, _STORAGE, _SIZE (also an empty block or one
 * outside the volume), _STRIDE, _SPACING, _WINDOW, _LIGHT, _BUFFER.
 */
qv_status qv_classify(void *voxels, size_t bytes, uint8_t storage, const qv_classifier *classifier,
                      const qv_block *block);

/*
 * Reduces scalars by whole factors: each result is the mean of a box of
 * factor[0] x factor[1] x factor[2] values (those of them inside the volume, at
 * its upper faces), rounded to nearest. The result has ceil(size/factor) values
 * an axis, tightly packed, in the same type; slices first_z <= z < end_z of it
 * are written. Its spacing is the source's times the factor, so its box is longer
 * than the source's where a factor does not divide the size. Factors 1 .. 64.
 * Returns QV_OK or QV_ERROR_NULL, _STORAGE (type), _SIZE, _STRIDE, _BUFFER.
 */
qv_status qv_reduce(void *values, size_t bytes, const qv_scalars *scalars, const uint8_t factor[3],
                    uint16_t first_z, uint16_t end_z);

/* ---- Volumes larger than memory --------------------------------------------- */

/*
 * Voxels that the caller reads from somewhere, an SD card or serial flash, when they are wanted.
 * The volume is divided into bricks; a page of the caller's memory holds one. Pictures are those
 * of the same voxels in memory, bit for bit, whatever the pages and their shape:
 *
 *     qv_pages pages = {.read = read_brick, .memory = memory, .bytes = sizeof memory,
 *                       .table = table, .count = 16, .shift = {3, 3, 3}};
 *     volume.pages = &pages;
 *     qv_pages_init(&pages, &volume);
 *     scene.sampling = &qv_weighted_rgba8_paged;
 *     qv_init, qv_render, qv_slice ...               as ever; pages keep their bricks
 *
 * Reading changes the pages: only one call at a time may use them. Threads have their own.
 */

/* A brick that is wanted. Its voxel (x, y, z), counted from block.first, goes to byte
   x * voxel bytes + y * row + z * slice of the page; bytes in between need not be written. */
typedef struct qv_brick {
    qv_block block;      /* its voxels, those that lie in the volume */
    uint32_t number;     /* x fastest, then y, then z */
    uint32_t row, slice; /* as if the brick did not reach beyond the volume */
    uint32_t bytes;      /* of a page */
} qv_brick;

/* A place in the table of pages; the library's own. */
typedef struct qv_page {
    uint32_t brick;
    uint16_t page;
} qv_page;

/* Most of shift[]: a brick as wide as any volume. */
#define QV_PAGE_SHIFT_MAX 12u

/*
 * A cache of pages. A brick is 2^shift voxels wide, or as wide as the volume where that is less:
 * {12, 12, 0} are slices. A sample may lie in 2 bricks on each axis that has several, so 8 pages
 * are the least for cubes and 2 for slices; B-splines lie in 3 where bricks are 1 voxel wide.
 * The brick that has not been wanted for longest makes room, among 8 pages or more that its
 * number chooses; all, where there are fewer than 16.
 */
typedef struct qv_pages {
    /* Fills a page. Voxels of 16 bits a channel are in the machine's byte order. Returns 0 or a
       positive value, or a negative status of the caller's. May not render from these pages. */
    int (*read)(void *user, void *page, const qv_brick *brick);
    void *user;
    void *memory; /* count pages of qv_page_bytes; 2-aligned for 16 bits a channel */
    size_t bytes;
    qv_page *table; /* one place for each page */
    uint16_t count; /* pages */
    uint8_t shift[3];

    /* What has happened. The caller may set them to 0 at any time. */
    qv_status status;  /* QV_ERROR_READ from the first failure on; what qv_render returns */
    int error;         /* of that failure: what read returned */
    uint32_t searches; /* for a page; samples that lie in the same bricks as the last need none */
    uint32_t reads;    /* calls of read */
    uint32_t failures; /* those of them that failed */

    /* The library's own, core/pages.h. */
    uint16_t size[3], sets, ways;
    uint32_t stride[3], page_bytes;
    uint32_t first[3], cells[3];
    const uint8_t *corner[8];
    qv_brick wanted;
} qv_pages;

/* Bytes of a page; 0 where a shift or the size is out of range. */
uint64_t qv_page_bytes(const uint8_t shift[3], const uint16_t size[3], uint8_t storage);

/*
 * Makes pages ready for a volume, of which voxels and strides are not read: no page holds a
 * brick, and the counters are 0. qv_init takes pages that were made ready for a volume of the
 * same size and bytes a voxel. Returns QV_OK or QV_ERROR_NULL, _STORAGE, _SIZE, _PALETTE,
 * _SPACING, _PAGES (no pages, memory too small or odd, a shift above QV_PAGE_SHIFT_MAX, a page of
 * 2^32 bytes or more, or 2^32 - 1 bricks or more).
 *
 * qv_init returns QV_ERROR_PAGES too where there are fewer pages than a sample may need at a time.
 *
 * A page that cannot be read holds bytes of 0: transparent voxels, or those of the palette's entry
 * 0. It is read again when it is wanted after its place was needed for another. A call that
 * renders goes on to its end, and returns pages->status for QV_OK.
 * Where the same reads fail each time, its picture is that of a volume with 0 in those bricks.
 */
qv_status qv_pages_init(qv_pages *pages, const qv_volume *volume);

/* Voxels that lie x fastest, then y, then z, without gaps, in something larger. */
typedef struct qv_linear {
    /* Reads bytes at an offset; returns a negative status of the caller's where it cannot. */
    int (*read)(void *user, void *to, uint64_t offset, uint32_t bytes);
    void *user;
    uint64_t offset;  /* of voxel (0,0,0) */
    uint64_t bytes;   /* that were read; the caller may set it to 0 */
    uint32_t reads;   /* calls of read; likewise */
    uint16_t size[3]; /* of the volume */
    uint8_t storage;
} qv_linear;

/*
 * A read function for qv_pages, whose user is a qv_linear: reads a brick row by row, or where rows
 * or slices of the volume lie in it whole, all of them that follow each other at once. Returns 0 or
 * the first negative status.
 */
int qv_linear_read(void *linear, void *page, const qv_brick *brick);

/* The sampling modes through pages, but for those of pyramids. */
#define QV_DECLARE_PAGED(name) extern const qv_sampling name##_paged, name##_paged_back_to_front;

/* Where QV_MEMORY_HEADER makes addresses that reach no RAM, pages hold indices alone. */
#ifdef QV_MEMORY_HEADER
#define QV_DECLARE_PAGED_ENTRIES(mode, fourth)
#else
#define QV_DECLARE_PAGED_ENTRIES(mode, fourth)                                                     \
    QV_DECLARE_PAGED(mode##_rgb##fourth##8)                                                        \
    QV_DECLARE_PAGED(mode##_rgb##fourth##16)
#endif
#define QV_DECLARE_PAGED_OPACITY(mode)                                                             \
    QV_DECLARE_PAGED_ENTRIES(mode, a)                                                              \
    QV_DECLARE_PAGED(mode##_indexed8)                                                              \
    QV_DECLARE_PAGED(mode##_indexed8_16)
#define QV_DECLARE_PAGED_EXTINCTION(mode)                                                          \
    QV_DECLARE_PAGED_ENTRIES(mode, t)                                                              \
    QV_DECLARE_PAGED(mode##_indexed8_t8)                                                           \
    QV_DECLARE_PAGED(mode##_indexed8_t16)

QV_DECLARE_PAGED_OPACITY(qv_nearest)
QV_DECLARE_PAGED_OPACITY(qv_separate)
QV_DECLARE_PAGED_OPACITY(qv_weighted)
QV_DECLARE_PAGED_OPACITY(qv_corrected)
QV_DECLARE_PAGED_OPACITY(qv_bspline_weighted)
QV_DECLARE_PAGED_OPACITY(qv_extinction)
QV_DECLARE_PAGED_EXTINCTION(qv_extinction)
QV_DECLARE_PAGED_OPACITY(qv_bspline_extinction)
QV_DECLARE_PAGED_EXTINCTION(qv_bspline_extinction)

/* ---- Slices ----------------------------------------------------------------- */

/*
 * Rendering slice by slice into a frame buffer that stays in the caller's memory
 * (Williams et al., alpha dithering for 8-bit compositing). Slice k is what every ray sees
 * of its sample k; in modes that weigh by length, of stretch k. Orthographic slices are
 * planes, those of an eye spheres round it. A frame:
 *
 *     qv_slice_range(&first, &end, &context, &rect);
 *     qv_clear(&buffer, &context, &rect);
 *     for (k = end; k-- > first;)                       back to front; qv_under_*: first to end
 *         qv_slice(&buffer, &dither, &context, &rect, k);
 *     qv_read_out(&image, &buffer, &context, &rect);    where the display has another format
 *
 * Rectangles of a frame may be rendered apart, down to rows: the dither of a pixel depends on
 * its absolute position, the slice and the frame alone. Any mode will do, of either order.
 * Front to back, pixels at the scene's termination take no more slices. Through a pyramid slices
 * are one step thick on every level, where rays take pieces as long as the level's steps.
 */

struct qv_fragment;
struct qv_moment;

/*
 * How the pixels of a frame buffer lie in memory and how a slice is blended with them. The
 * caller names those it uses, and only those are linked. The fields are the library's own.
 */
typedef struct qv_blend {
    void (*blend)(uint8_t *pixel, uint8_t *beside, const struct qv_fragment *fragment,
                  const struct qv_moment *moment);
    void (*clear)(uint8_t *pixel, uint8_t *beside, const struct qv_fragment *background);
    void (*read)(struct qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside);
    void (*look)(uint32_t *value, uint32_t *colour, const uint8_t *pixel,
                 const struct qv_fragment *fragment); /* null where no technique is wanted */
    uint8_t bytes;                                    /* of a pixel */
    uint8_t beside; /* bytes of what is kept beside a pixel, 0 where nothing is */
    uint8_t kind;   /* of the families below, core/blend.h */
} qv_blend;

/*
 * Back to front (equations 6 and 7), each result rounded by dither. A pixel is a state:
 * levels, 255 being 1, with as many fraction bits as the channel has beyond 8; colours are
 * associated, and the fourth channel, where there is one, is the accumulated opacity. States
 * of more than 8 bits lie in memory lowest byte first. How far off they are, qv_recommend tells.
 */
extern const qv_blend qv_over_rgb888, qv_over_rgba8888;
extern const qv_blend qv_over_rgb888_residual4, qv_over_rgba8888_residual4;
extern const qv_blend qv_over_rgb888_residual8, qv_over_rgba8888_residual8;
extern const qv_blend qv_over_rgb565;                /* low byte first */
extern const qv_blend qv_over_rgba12;                /* 6 bytes; of R the lowest bits first */
extern const qv_blend qv_over_rgb16, qv_over_rgba16; /* 6 and 8 bytes */
extern const qv_blend qv_over_rgb24, qv_over_rgba24; /* 9 and 12, best by qv_sequence_rounded */

/*
 * The residuals above are 4 or 8 bits a channel beside a frame buffer of 8 bits (error
 * feedback): 2 bytes a pixel, red in the lowest 4 bits; or 3 and 4 bytes.
 *
 * Front to back (section 8.2): colours in the same states, without opacity; beside each pixel 3
 * bytes of transmittance, lowest first. Largest deviation from exact compositing over 1000
 * slices, in levels of 8 bits, by qv_sequence_blocks: in a fog, and on any of the contents of
 * tests/reference/slice_cases.h.
 */
extern const qv_blend qv_under_rgb888; /* 9, 48 */
extern const qv_blend qv_under_rgb16;  /* .62, .75 */
extern const qv_blend qv_under_rgb24;  /* .51, .51 by qv_sequence_rounded */

/*
 * As blending hardware does it (section 2.1): a slice has an opacity of 8 bits, made by the
 * technique of the dither, and a colour of 8 bits; each result is rounded to nearest. Without
 * accumulated opacity by equation 1; with it by equations 6 and 7, colours weighted by the
 * dithered opacity (section 5). rgba12: opacities of 12 bits, rounded without a technique, 4095
 * being 1; 6 bytes, as above. A colour is found from light by shift and subtract, so these cost
 * some 400 instructions a pixel on a Cortex-M3, where qv_over_rgb888 costs 60.
 */
extern const qv_blend qv_hardware_rgb888, qv_hardware_rgba8888;
extern const qv_blend qv_hardware_rgb565, qv_hardware_rgba12;

/* No blend: each pixel becomes the slice's own, the R, G, B, A of 8 bits that hardware is to
   blend, with colour weighted by the dithered opacity. A row at a time will do. */
extern const qv_blend qv_hand_out_rgba8888;

/*
 * The dither value of a slice by its number, Q0.32. Numbers rise in the order of blending: slice k
 * has 2^22 - k, front to back 2^22 + k; and 1024 more from frame to frame. The slice's place in
 * the period of a table or pattern is that of frame 0, modulo the period.
 */
typedef uint32_t qv_sequence(uint32_t slice);

uint32_t qv_sequence_rounded(uint32_t slice); /* 1/2 for all: rounding to nearest, no dither */
uint32_t qv_sequence_golden(uint32_t slice);  /* best where no slice is empty */
uint32_t qv_sequence_hash(uint32_t slice);    /* the noise of a random walk, but on anything */
uint32_t qv_sequence_blocks(uint32_t slice);  /* best over all contents: see qv_recommend */

/*
 * How qv_hardware_* and qv_hand_out_rgba8888 come by an opacity of 8 bits. The caller names
 * those it uses, and only those are linked. The fields are the library's own. `value` is what a
 * pixel has accumulated: its opacity or, where that is not kept, its channel of the slice's
 * largest colour; `colour` the slice's there.
 */
typedef struct qv_technique {
    uint32_t (*opacity)(const struct qv_moment *moment, uint32_t level, uint32_t value,
                        uint32_t colour);
    uint8_t by_value;  /* whether value and colour are read */
    uint8_t by_period; /* whether period, slopes and cutoff of the dither are */
} qv_technique;

extern const qv_technique qv_technique_rounded; /* no dither */
extern const qv_technique qv_technique_random;  /* section 3: hits by dither value */
extern const qv_technique qv_technique_ordered; /* section 3: hits by the place in the period */

/* Section 3 too: exponential bumps and the second slope, by the pixel's value; hits ordered or at
   random. Handed out, where no value is known, without bumps. */
extern const qv_technique qv_technique_bumped, qv_technique_bumped_random;

/* Section 9.2: by the pixel's value, such that the rounded blend of 8 bits does what a dithered
   one would; exact on average in the channel that is looked at, not in those that share its
   opacity. Handed out, as for a pixel of value 0. */
extern const qv_technique qv_technique_corrected;

typedef struct qv_dither {
    qv_sequence *sequence;         /* never null */
    const qv_technique *technique; /* of qv_hardware_* and qv_hand_out_*, else not read */
    uint32_t slope[2]; /* slope modifiers, Q16.16, 0 .. 2^20; 0: 1. The first alone but for bumped,
                          which takes the second once the value has reached its knee */
    uint32_t frame; /* counter: moves the dither of all pixels from frame to frame; patterns by 1,
                          so that as many frames as the period has slices show each place once */
    uint8_t period; /* of random, ordered and bumped ones: 2 .. 64 slices */
    uint8_t cutoff; /* levels: opacities above are rounded by these; 0: none are */
    uint8_t still;  /* 1: the same dither for all pixels of a slice, as published */
} qv_dither;

/*
 * A frame buffer. Pixel (left, top) of a call's rectangle starts at pixels, the next row at
 * pixels + stride, which may be negative; bytes as in qv_image. `beside` likewise, for blends
 * that keep something beside the pixels; else it is not read. No alignment is needed.
 */
typedef struct qv_buffer {
    void *pixels;
    void *beside;
    size_t bytes, beside_bytes;
    ptrdiff_t stride, beside_stride;
    const qv_blend *blend;
} qv_buffer;

/*
 * The slices first <= k < end that pixels of the rectangle may see; first == end where they
 * see none. Exact but for two more at each end. Takes some 1200 .. 1600 instructions a pixel on a
 * Cortex-M3; the ranges of parts may be joined. Returns QV_OK or QV_ERROR_NULL, _RECT.
 */
qv_status qv_slice_range(int32_t *first, int32_t *end, const qv_context *context,
                         const qv_rect *rect);

/* Sets the rectangle to the scene's background, to nearest; where blends keep no opacity,
   black stands behind it. qv_under_*: clears it, and the background comes with qv_read_out.
   A brick or a chunk that is to be combined is cleared by a context without background.
   Returns QV_OK or QV_ERROR_NULL, _RECT, _BUFFER. */
qv_status qv_clear(const qv_buffer *buffer, const qv_context *context, const qv_rect *rect);

/*
 * Blends one slice. Any slice may be asked for; where the volume has none, nothing changes
 * (qv_hand_out_rgba8888: all becomes 0). Returns QV_OK or QV_ERROR_NULL, _RECT, _BUFFER,
 * _DITHER (period or slope out of range, no sequence, or no technique where the blend needs
 * it), _SLICE (not -2^22 <= slice < 2^22).
 */
qv_status qv_slice(const qv_buffer *buffer, const qv_dither *dither, const qv_context *context,
                   const qv_rect *rect, int32_t slice);

/*
 * Puts the front picture before the one behind, which becomes the result: two bricks, or a chunk
 * and what lies behind it (equations 4 and 8, sections 2.3 and 7). The two may have different
 * blends; front should keep opacity or transmittance, or it hides all. Its pixels count as
 * those of a slice, whose opacity qv_hardware_* rounds: technique, slopes and cutoff are not read,
 * as they have done their work. Returns QV_OK or QV_ERROR_NULL, _RECT, _BUFFER (of either, or
 * behind is one of qv_under_*, which only what lies farther can follow), _DITHER, _SLICE.
 */
qv_status qv_combine(const qv_buffer *behind, const qv_buffer *front, const qv_dither *dither,
                     const qv_rect *rect, int32_t slice);

/*
 * The same, to the bit, for bricks of one colour and opacity of 8 bits that qv_hardware_rgba8888
 * has blended without dither, the front one over nothing: behind becomes what all slices in one
 * buffer would have given, by replaying as many as made the front pixel out of nothing, at most
 * 160. (After those no pixel changes, so that more of them cannot be told apart; behind none at all
 * they may be one too few.) A pixel that they never make is put in front by equation 8. Returns
 * QV_OK or QV_ERROR_NULL, _RECT, _BUFFER (also for another blend).
 */
qv_status qv_replay(const qv_buffer *behind, const qv_buffer *front, const uint8_t rgba[4],
                    const qv_rect *rect);

/* Turns a rectangle of a frame buffer into pixels of a display's format, as qv_render would
   store them. Returns QV_OK or QV_ERROR_NULL, _RECT, _BUFFER (of either). */
qv_status qv_read_out(const qv_image *image, const qv_buffer *buffer, const qv_context *context,
                      const qv_rect *rect);

/*
 * Equation 3: an opacity, Q0.32 of which 2^32 - 1 is 1, for `wanted` slices in place of
 * `slices`, 1 .. 65535 each: 1 - (1 - opacity)^(slices / wanted). 0 and 1 stay. At most
 * (slices / wanted + 2) * 2^-28 off. 0 slices of either count as 1.
 */
uint32_t qv_opacity_for_slices(uint32_t opacity, uint16_t slices, uint16_t wanted);

/*
 * The same for the opacities of a table's entries, colours as they are. `from` may be `to`.
 * Off by at most 1/2 + (slices / wanted + 2) / 4096 of 1/65535. Returns QV_OK, QV_ERROR_NULL, or
 * QV_ERROR_SLICE (0 slices).
 */
qv_status qv_transfer_for_slices(qv_transfer *to, const qv_transfer *from, uint16_t slices,
                                 uint16_t wanted);

/*
 * Opacities from a histogram (equation 12): scale / ln(count) levels, scale in levels Q16.16,
 * and at most 255 levels, which counts of 0 and 1 get. Peaks, bins of at least `peak` counts
 * (0: none are), get peak_opacity instead, and so do the bins beside them, so that
 * interpolation between entries stays at the peak's (figure 41). The bins next to those go by
 * the mean of their count and that neighbour's, in whole counts. Colours stay. Each to
 * nearest, .51 of 1/65535. Returns QV_OK or QV_ERROR_NULL.
 */
qv_status qv_transfer_from_histogram(qv_transfer *table, const uint32_t histogram[256],
                                     uint32_t scale, uint32_t peak, uint16_t peak_opacity);

/*
 * A transfer function as a temporal dither table (section 6, table 3): for each of 256 values
 * and each place in the period the dithered opacity, alone (1 byte: 256 * period bytes) or
 * after the colour weighted by it (R, G, B, A: 4 bytes, 1024 * period bytes). Value v, place p:
 * entry 256 p + v. It is a plain array: it may be built on the host and linked as a constant.
 */
typedef struct qv_dither_table {
    qv_address entries;
    uint64_t bytes;
    uint8_t period;      /* 2 .. 64 */
    uint8_t entry_bytes; /* 1 or 4 */
} qv_dither_table;

/* Bytes of such a table; 0 where period or entry_bytes are out of range. */
uint32_t qv_dither_table_bytes(uint8_t period, uint8_t entry_bytes);

/*
 * Builds the entries of first <= value < end of a table at `to`, which holds all of it. Hits are
 * ordered; each value's pattern is turned by 1 against that of the value below, so that equal
 * neighbours never hit together while no more than half of the slices hit. Of the dither, period,
 * cutoff and slope[0] are read. On a Cortex-M3 some 55 instructions an entry, 100
 * with colours; on a Cortex-M0 220 and 270. Returns QV_OK or
 * QV_ERROR_NULL, _SIZE (entry_bytes, or values), _DITHER, _BUFFER.
 */
qv_status qv_dither_table_build(void *to, size_t bytes, uint8_t entry_bytes,
                                const qv_dither *dither, const qv_transfer *transfer,
                                uint16_t first, uint16_t end);

/*
 * The place that pixel (x, y) of a slice and frame reads, 0 .. period - 1: the slice moves it by 1,
 * and the pixels of a frame spread evenly over all places. For a table that all pixels share, the
 * pixel is (0, 0). 0 where the period is out of range.
 */
uint8_t qv_dither_table_place(uint8_t period, int32_t slice, uint32_t frame, int32_t x, int32_t y);

/*
 * Blends a slice of an indexed volume through a table with colours, in place of its palette: the
 * entry of the voxel that is nearest to sample `slice`, whatever the context's sampling. Of the
 * dither, frame and still are read. The blend is qv_hardware_rgba8888, _rgb888 or
 * qv_hand_out_rgba8888; no division, and no multiplication by a colour. Returns QV_OK or
 * QV_ERROR_NULL, _RECT, _BUFFER (also for another blend), _SIZE (the table), _STORAGE (not
 * indexed, or without voxels in memory), _SLICE.
 */
qv_status qv_slice_table(const qv_buffer *buffer, const qv_dither_table *table,
                         const qv_dither *dither, const qv_context *context, const qv_rect *rect,
                         int32_t slice);

/* ---- Recommendation --------------------------------------------------------- */

typedef enum qv_advice {
    QV_ADVICE_PLAIN = 1,    /* qv_hardware_*, rounded */
    QV_ADVICE_DITHER = 2,   /* qv_over_* of the frame buffer's bits */
    QV_ADVICE_RESIDUAL = 3, /* qv_over_*_residual4 or 8 */
    QV_ADVICE_ROUND = 4     /* qv_over_rgb24 */
} qv_advice;

typedef struct qv_recommendation {
    qv_advice advice;
    qv_sequence *sequence;
    uint16_t worst_fog; /* largest error to expect, 1/100 of an 8-bit level: in a constant fog */
    uint16_t worst;     /* and on any of the contents of tests/reference/slice_cases.h */
} qv_recommendation;

/*
 * What to take for a frame buffer of so many bits a channel (5, 6, 8, 12, 16 or 24), with
 * residuals of 0, 4 or 8 bits beside (which only 8 bits make use of), where a pixel meets up to
 * so many slices that are not empty, 1 .. 4096, of which none has less than this opacity, Q0.32,
 * not 0. (At the borders of what is clear, interpolation makes less than any voxel has.)
 *
 * It is what has the smallest error on any content: dither by blocks, which is within 5.5 levels
 * of 8 bits in a fog as well; but for few bits and high opacities plain rounding. Where slices are
 * known not to be empty, qv_sequence_golden may be better. The errors were measured, back to
 * front (core/recommend_table.h). Returns QV_OK or QV_ERROR_NULL, _SIZE (bits), _SLICE (slices,
 * or opacity 0).
 */
qv_status qv_recommend(qv_recommendation *recommendation, uint8_t bits, uint8_t residual_bits,
                       uint16_t slices, uint32_t opacity);

/* ---- Opacity and extinction ----------------------------------------------- */

/* R,G,B,A or R,G,B,T entries: voxels or a palette; tightly packed, 16-bit ones 2-aligned. */
typedef struct qv_entries {
    qv_address entries;
    uint32_t count;
    uint32_t unit_distance; /* of opacities, Q16.16 world units, not 0; else not read */
    uint32_t extinction;    /* of the full stored value, Q16.16 as in qv_volume; else not read */
    uint8_t storage;        /* QV_STORAGE_RGBA8, _RGBA16, _RGBT8 or _RGBT16 */
} qv_entries;

/*
 * Conversions of entries, also between 8 and 16 bits a channel: from opacity to
 * extinction and back, to another unit distance, and to another extinction of the full
 * value. The storage to make, and the unit distance or extinction that it is to have,
 * stand before the source. bytes is the memory at `to`, which needs no alignment and
 * may be the source itself unless 8 bits become 16.
 * Colours are rounded to nearest. An opacity's depth is found within 2^-27; the fourth
 * channel is within .51 of its last place of what real arithmetic makes of that depth, or
 * of a stored extinction. 0 stays 0. Extinction beyond the full value becomes the full
 * value; full opacity has its depth of 64, but stays full for another unit distance.
 * 8-bit opacities come back unchanged from 16 bits of extinction where the full value's
 * depth for the unit distance is 9 .. 64.
 * Each links only what it needs. Return QV_OK or QV_ERROR_NULL, _STORAGE (one of the two
 * is not of the kind in the name), _STRIDE (16-bit source at an odd address), _UNIT (0),
 * _EXTINCTION (0), _BUFFER.
 */
qv_status qv_opacity_to_extinction(void *to, size_t bytes, uint8_t storage, uint32_t extinction,
                                   const qv_entries *from);
qv_status qv_extinction_to_opacity(void *to, size_t bytes, uint8_t storage, uint32_t unit_distance,
                                   const qv_entries *from);
qv_status qv_opacity_to_opacity(void *to, size_t bytes, uint8_t storage, uint32_t unit_distance,
                                const qv_entries *from);
qv_status qv_extinction_to_extinction(void *to, size_t bytes, uint8_t storage, uint32_t extinction,
                                      const qv_entries *from);

/*
 * Entries of QV_STORAGE_RGBA8 or _RGBA16 as those of QV_STORAGE_ASSOCIATED8, 4 bytes each: colour
 * times opacity and opacity, each rounded to nearest. bytes is the memory at `to`, which needs no
 * alignment here and may be the source itself; neither unit distance nor extinction is read.
 *
 * What is lost: at an opacity of a of 255 a colour has a + 1 levels instead of 256, so that it is
 * off by up to 1/2 * 255/a of its own levels (Wittenbrink et al. 1998, section 7). A picture shows
 * it multiplied by the opacity again, 1/2 level a sample at most; many thin samples add up, to 36
 * levels in the worst of 200 random scenes.
 * Returns QV_OK or QV_ERROR_NULL, _STORAGE (of the source), _STRIDE (16-bit source at an odd
 * address), _BUFFER.
 */
qv_status qv_opacity_to_associated(void *to, size_t bytes, const qv_entries *from);

/*
 * The least extinction of the full value, Q16.16, that holds every entry; 1 or more, and
 * at most 2^32 - 1, even where that is too little. Full opacity counts as `opaque`,
 * Q16.16 too; 0 stands for its depth of 64, which leaves few of 8 bits for the rest.
 * Returns QV_OK or QV_ERROR_NULL, _STORAGE (not RGBA8 or RGBA16), _STRIDE, _UNIT.
 */
qv_status qv_extinction_of(uint32_t *extinction, const qv_entries *from, uint32_t opaque);

/*
 * A medium of several materials (Kraus and Buerger 2008, section 3.1): a point holds
 * a percentage of each.
 */
typedef struct qv_material {
    uint16_t colour[3];  /* unweighted */
    uint32_t extinction; /* depth per world unit, Q16.16 */
} qv_material;

/* Sums over the materials, exact: equations 6 and 7. */
typedef struct qv_mixture {
    uint64_t extinction; /* sum of p * extinction: depth per world unit times 65536 * 65535 */
    uint64_t light[3];   /* sum of p * extinction * colour: 65535 times the unit of extinction */
} qv_mixture;

/*
 * Mixes materials; percentages are 16-bit fractions, 65535 is 1, and their sum is at
 * most 1. Returns QV_OK, QV_ERROR_NULL, or QV_ERROR_MIXTURE.
 */
qv_status qv_mix(qv_mixture *mixture, const qv_material *materials, const uint16_t *percentages,
                 uint16_t count);

/* A mixture as a voxel of QV_STORAGE_RGBT16 with this extinction of the full value, not 0:
   each channel to nearest; extinction beyond the full value becomes it. Black where the
   mixture's extinction is 0. */
void qv_mixture_to_voxel(uint16_t rgbt[4], const qv_mixture *mixture, uint32_t extinction);

/* ---- Pyramids --------------------------------------------------------------- */

/* Coarser levels until one voxel is left: 0 .. 12. */
uint8_t qv_pyramid_levels(const uint16_t size[3]);

/* Memory of levels 1 .. levels of a volume of this size and storage; at most 2^36 * 8 / 7. */
uint64_t qv_pyramid_bytes(const uint16_t size[3], uint8_t storage, uint8_t levels);

/*
 * Describes a level as a volume of its own, level 0 being the volume itself: spacing
 * times 2^level; unit distance and extinction are per world unit and stay. Its box is
 * its voxels' and so may be longer than the volume's by less than a voxel. Where the
 * spacing passes 256, only qv_downsample takes the level, which reads no spacing; 65536
 * and more become 2^32 - 1. Only levels 1 and up need a pyramid. Returns QV_OK or an
 * error of qv_volume_check, QV_ERROR_LEVEL, _STORAGE (associated colours have no levels), _STRIDE
 * (16-bit levels at an odd address),
 * _BUFFER (pyramid too small, or beyond what offsets reach).
 */
qv_status qv_pyramid_level(qv_volume *level, const qv_volume *volume, const qv_pyramid *pyramid,
                           uint8_t number);

/* A symmetric filter of four taps on each axis, in 1/64: outer, inner, inner, outer. */
typedef struct qv_filter {
    uint8_t outer, inner; /* their sum is 32 */
} qv_filter;

extern const qv_filter qv_filter_box2;  /* 0 1 1 0 by 2 */
extern const qv_filter qv_filter_box4;  /* 1 1 1 1 by 4: best for trilinear sampling */
extern const qv_filter qv_filter_quad4; /* 13 19 19 13 by 64: best for B-splines */

/*
 * What is averaged: the fourth channel as it is stored, or the extinction of stored
 * opacities. The caller names one, and only that one is linked. The fields are the
 * library's own.
 */
typedef struct qv_domain {
    uint32_t (*weight)(uint16_t channel); /* 0 for 0 only; at most 2^30 */
    uint16_t (*channel)(uint32_t weight); /* the reverse */
    uint8_t of_opacity;                   /* 1: stored extinction is refused */
} qv_domain;

extern const qv_domain qv_domain_stored, qv_domain_extinction;

/*
 * Downsampling (Kraus and Buerger 2008, section 4): makes the slices first_z <= z <
 * end_z of the next coarser level, ceil(size / 2) voxels on each axis, tightly packed
 * at `voxels`, which needs no alignment and must not overlap the finer level. Voxel i
 * has its taps at 2i-1 .. 2i+2; beyond a face the volume is mirrored in it (-1 is 0, n
 * is n-1). The fourth channel is averaged in the domain, colours weighted by it; sums
 * are exact, and each channel is rounded once, to nearest. With qv_domain_extinction,
 * besides, an extinction is off by up to .61 * 2^-24: the fourth channel is within .51 of its
 * last place of real arithmetic, colours of 8 bits are too, and colours of 16 bits within .5 +
 * .0009 / (least opacity under the filter that is not 0), at most .51 once weighted by opacity.
 * Where all voxels under the filter have 0, the result is black.
 * Returns QV_OK or an error of qv_volume_check (spacing is not read), or QV_ERROR_SIZE
 * (slices), _BUFFER, _LEVEL (finer has one voxel), _MIXTURE (a filter that does not sum
 * to 1), _STORAGE (associated colours; qv_domain_extinction of stored extinction: take
 * qv_domain_stored).
 */
qv_status qv_downsample(void *voxels, size_t bytes, const qv_volume *finer, const qv_filter *filter,
                        const qv_domain *domain, uint16_t first_z, uint16_t end_z);

/*
 * Sets scene->level and level_distance so that a pixel is as wide as a voxel of the level
 * that it sees, by the volume's least spacing and the view's pitch. Orthographic: the level
 * is log2(pitch / spacing), to 1/256, at least 0 and at most the pyramid's last; the
 * distance is 0. Perspective: level 0, and the distance at which a pixel is as wide as the
 * spacing, in whole steps, cut, but at least 1. The scene's volume, camera (that of the
 * view) and pyramid must be set. Returns QV_OK or QV_ERROR_NULL, _VIEW, _STEP, _SPACING,
 * _CAMERA.
 */
qv_status qv_detail(qv_scene *scene, const qv_view *view);

/* ---- FreeVoxels --------------------------------------------------------------- */

/*
 * Voxels that need no other voxel to be drawn (FreeVoxels). Each keeps, for every direction of
 * a set, a byte: how much light passes between it and the outside of the volume, 255 being all.
 * So voxels may be added to a picture in any order, from any place, by any number of workers,
 * and light that falls on them is known:
 *
 *     qv_attenuate(...)                              once a direction
 *     qv_splat_init(&splats, &scene);
 *     qv_sums_clear(&sums);
 *     qv_splat, qv_splat_block or qv_splat_stream    in any order
 *     qv_sums_read_out(&image, &sums, &splats);
 *
 * Sums of integers do not depend on their order: the same voxels make the same picture.
 */

/*
 * A direction leads from a voxel to one of its 26 neighbours, and so on outside: (dx, dy, dz), each
 * -1, 0 or 1, has the number n = (dx+1) + 3 (dy+1) + 9 (dz+1), less 1 beyond the middle, 13. The
 * opposite of d is 25 - d. A set of directions has bit d for direction d; the bytes of a voxel
 * are those of its set, lowest number first.
 */
#define QV_DIRECTIONS       26u
#define QV_DIRECTIONS_ALL   0x3FFFFFFu
#define QV_DIRECTIONS_FACES 0x020B410u /* +-x, +-y, +-z: 4, 10, 12, 13, 15, 21 */

/* The number of (dx, dy, dz); 255 where there is none. */
uint8_t qv_direction(int dx, int dy, int dz);

/* How many directions a set has. */
uint8_t qv_directions_count(uint32_t directions);

/*
 * How the voxels of a box follow each other in memory. The caller names those it uses, and only
 * those are linked. The fields are the library's own. Morton and Hilbert curves are those of the
 * least cube of 2^b voxels an axis that holds the box, without what lies outside of the box:
 * indices are 0 .. voxels - 1, without gaps, for every size.
 */
typedef struct qv_order {
    uint64_t (*index)(const uint16_t size[3], const uint16_t position[3]);
    void (*position)(uint16_t position[3], const uint16_t size[3], uint64_t index);
} qv_order;

extern const qv_order qv_order_linear;  /* x fastest, then y, then z */
extern const qv_order qv_order_morton;  /* x is the lowest of each three bits */
extern const qv_order qv_order_hilbert; /* in a cube, neighbours on the curve share a face */

/*
 * The index of a voxel, and the voxel of an index. QV_OK or QV_ERROR_NULL, _SIZE (an axis out of
 * range, or a voxel or an index outside of the box).
 */
qv_status qv_order_index(uint64_t *index, const qv_order *order, const uint16_t size[3],
                         const uint16_t position[3]);
qv_status qv_order_position(uint16_t position[3], const qv_order *order, const uint16_t size[3],
                            uint64_t index);

/*
 * The bytes of the voxels of one level. `record` lets them lie between other things, as in a file
 * that keeps a voxel's colour and its bytes side by side.
 */
typedef struct qv_attenuation {
    qv_address records;    /* bytes of the voxel with index 0 */
    uint64_t bytes;        /* from there to the end of the last voxel's */
    const qv_order *order; /* null: linear */
    uint32_t directions;   /* a set, not empty */
    uint16_t size[3];      /* voxels of the level */
    uint16_t record;       /* from one voxel's bytes to the next one's; 0: as many as directions */
} qv_attenuation;

/* Bytes of such records, to the end of the last voxel's: 26 a voxel for all directions without
   gaps. 0 where size, set or record is out of range. attenuation->records and ->bytes are not
   read. */
uint64_t qv_attenuation_bytes(const qv_attenuation *attenuation);

/* Bytes of the sums that coarser levels are made of (`blocks` below), for a volume of this size:
   one uint32_t for each block of 2 x 2 x 2 voxels. 0 where an axis is out of range. */
uint64_t qv_blocks_bytes(const uint16_t size[3]);

/* The bytes of a voxel; null where it lies outside of the level, or the descriptor is wrong. */
qv_address qv_attenuation_at(const qv_attenuation *attenuation, const uint16_t position[3]);

/*
 * FreeVoxel attenuation (sections 2.1 and 3.1, equation 5): writes, for one direction of the set,
 * the transmittance of all voxels that lie between each voxel and the outside, without the
 * voxel itself. A voxel counts for the whole way to the next: one step of the direction in world
 * units, sqrt 2 and sqrt 3 included, where the volume has a unit distance; where that is 0, an
 * opacity holds for a step of any direction, as published. Takes time in proportion to the voxels.
 *
 * `to` and `bytes` are the memory that attenuation describes, whose own address and length are
 * not read; bytes of other directions stay, as does what lies between records. That may be the
 * volume's voxels themselves, all at the same place of a record, with strides of whole records.
 * blocks: null, or qv_blocks_bytes of memory for the sums that coarser levels are made of,
 * ceil(size / 2) on an axis, x fastest, which this direction overwrites.
 *
 * Depths add up in 64 bits; each byte is rounded once, to nearest, and within .51 of exact on lines
 * of up to 1000 unit distances, or 1000 voxels where there is none (.52 up to 4096). On longer ones
 * too, but for opacities of at most 30 / 65535: .59.
 * The domain must be that of the volume's fourth channel: qv_domain_extinction for opacity,
 * qv_domain_stored for extinction.
 * Returns QV_OK or QV_ERROR_NULL, an error of qv_volume_check, _STORAGE (domain), _UNIT (a step
 * outside 2^-12 .. 2^12 unit distances), _EXTINCTION (a step's depth 0, or 2^12 or more, at the
 * full value), _DIRECTION (not in the set, or a set that is empty or has unknown bits), _SIZE (not
 * the volume's), _ATTENUATION (record too short, or memory too small), _OVERLAP (the memory is also
 * the voxels', the palette's or that of blocks; or blocks' is the voxels' or the palette's).
 */
qv_status qv_attenuate(void *to, size_t bytes, uint32_t *blocks, const qv_attenuation *attenuation,
                       const qv_volume *volume, const qv_domain *domain, uint8_t direction);

/*
 * The hierarchy (section 3.2, equation 7): for one direction, the bytes of level 1, 2 .. 12, from
 * the sums that qv_attenuate has left in `blocks` for a volume of `size`: of each block the
 * geometric mean of its voxels' transmittance, which is the mean of their depths. No depth counts
 * as more than 64: so a voxel behind an opaque unit distance has a transmittance of 2^-64, and one
 * of eight leaves 2^-8 of its block's. Every level is made of the voxels' depths, not of rounded
 * bytes: within .51, or .59 as above. A block that reaches beyond the volume is the mean of what
 * lies inside. attenuation is that of the level. Returns QV_OK or QV_ERROR_NULL, _DIRECTION, _LEVEL
 * (0, or more than the size has), _SIZE (an axis out of range; attenuation->size is not the
 * level's), _ATTENUATION, _OVERLAP (of the two memories).
 *
 * The mean of a block's depths is more than its depth at the side where light leaves it, so that
 * thick blocks come out too dark. A level of a pyramid given to qv_attenuate as a volume has no
 * such loss.
 */
qv_status qv_attenuate_level(void *to, size_t bytes, const qv_attenuation *attenuation,
                             const uint32_t *blocks, const uint16_t size[3], uint8_t level,
                             uint8_t direction);

/* ---- Light from outside ------------------------------------------------------- */

/*
 * How light that comes from between the directions of the set is known. Either way the length of
 * the way through a voxel is accounted for, where the volume has a unit distance.
 */
typedef enum qv_interpolation {
    QV_BETWEEN_LIGHT = 0, /* between the transmittances of the three directions round it: best.
                             That bytes are rounded costs a picture up to 2 levels of 255 */
    QV_NEAREST = 1,       /* by the nearest direction of the set, as published but for lengths */
    QV_BETWEEN_DEPTHS = 2 /* between the depths of the three, in the logarithm. A byte of 0 counts
                             as a depth of 10; where all three are 0, nothing passes */
} qv_interpolation;

#define QV_LAMPS_MAX 4u

/* A directional light: far away, so that it falls on all voxels from one direction. */
typedef struct qv_lamp {
    int16_t direction[3]; /* to the light, in world axes, any length but 0 */
    uint16_t colour[3];   /* 65535 is 1 */
} qv_lamp;

/*
 * Light that falls on voxels, attenuated on its way as the voxels' bytes tell (section 4.3). A
 * voxel's colour is multiplied by ambient + the sum over lamps of colour * transmittance, at
 * most by 1.
 */
typedef struct qv_lighting {
    qv_lamp lamps[QV_LAMPS_MAX];
    uint8_t count;       /* of lamps that shine; 0 with ambient 0: as if ambient were 1 */
    uint16_t ambient[3]; /* 65535 is 1 */
} qv_lighting;

/*
 * Lights a block of a volume for qv_render: writes its voxels, tightly packed, x fastest, as
 * entries of the channels of the volume or of its palette, with lit colours. One pass over the
 * voxels, whatever the number of lamps. The volume's voxels may be overwritten where they are
 * such entries themselves and the block is all of it, tightly packed. attenuation is not read, and
 * may be null, where no lamp shines. interpolation is a qv_interpolation.
 * Colours are rounded to nearest; those of 8 bits are within .51 of exact for the bytes as they
 * are, those of 16 bits within 2. QV_BETWEEN_DEPTHS adds 2^-13 for each lamp. Returns QV_OK or
 * QV_ERROR_NULL, an error of qv_volume_check, _SIZE (also of the block, or the attenuation's is not
 * the volume's), _DIRECTION (the set is empty or has unknown bits, a lamp shines from between
 * directions of which one is not in it, or the interpolation is unknown), _ATTENUATION, _LIGHT
 * (more lamps than there can be, or a direction of length 0), _BUFFER, _OVERLAP (what is written is
 * also read, but for those voxels).
 */
qv_status qv_illuminate(void *voxels, size_t bytes, const qv_volume *volume,
                        const qv_attenuation *attenuation, const qv_lighting *lighting,
                        uint8_t interpolation, const qv_block *block);

/* ---- Splatting ---------------------------------------------------------------- */

/* One pixel's sums are 4: red, green, blue and opacity, levels of 8 bits with 16 fraction bits. */
#define QV_SUM_CHANNELS 4u

/*
 * What splats are added to: the sums of a rectangle of the frame, in rows from the top, without
 * gaps. Splats are cut at its edges, so a frame may be made in strips.
 * A sum stops at 2^32 - 1, that is at 257 times white, and qv_sums_read_out refuses it: stopped
 * sums do not depend on the order either.
 */
typedef struct qv_sums {
    uint32_t *sums;
    size_t count; /* numbers that the memory holds, at least QV_SUM_CHANNELS a pixel */
    qv_rect rect;
} qv_sums;

/*
 * How a splat enters the sums. The caller names one, and only that one is linked. The fields are
 * the library's own.
 */
typedef struct qv_splatting {
    void (*row)(uint32_t *sums, const uint16_t *weights, unsigned count, const uint32_t light[4]);
    uint8_t attenuated; /* whether the bytes towards the viewer are read */
} qv_splatting;

extern const qv_splatting qv_splatting_added; /* equation 10: any order, no leak */
extern const qv_splatting qv_splatting_over;  /* equation 9: back to front only; leaks where
                                                 splats overlap, kept for comparison */

/* A reconstruction kernel, integrated along the ray and over the pixel. The fields are the
   library's own. */
typedef struct qv_kernel {
    const uint16_t *integral;
    uint8_t halves; /* half its width in half voxels */
} qv_kernel;

extern const qv_kernel qv_kernel_linear;    /* 2 voxels wide */
extern const qv_kernel qv_kernel_quadratic; /* 3 voxels wide: smooth */

/* What a picture of splats shows. */
typedef struct qv_splat_scene {
    const qv_splatting *splatting;
    const qv_kernel *kernel;
    const qv_domain *domain; /* that of the volume's fourth channel, as in qv_attenuate */
    qv_address inside;       /* with an eye in the volume (qv_splat_eye): the bytes of its voxel, by
                                whose transmittance A_V that of all voxels is divided; so the error
                                of a byte grows by 1 / A_V. Else not read */
    uint32_t directions;     /* set of the bytes of all voxels */
    qv_angle field_of_view;  /* as in qv_perspective; 0: orthographic */
    uint8_t interpolation;   /* a qv_interpolation */
    uint8_t level;           /* the finest level to draw, 0 .. 12 */
    uint8_t coarsest;        /* the coarsest, level .. 12 */
    uint8_t background[4];   /* R, G, B (unweighted) and opacity */
    uint16_t detail;         /* width in pixels up to which a voxel of a level above the finest is
                                drawn instead of those that it is made of, Q8.8 */
    qv_lighting lighting;
    qv_view view;     /* its step is not read */
    qv_volume volume; /* level 0. Its voxels are not read, and may be null */
} qv_splat_scene;

/* Directions of a volume, and what light from anywhere counts of bytes; core/bearing.h. */
typedef struct qv_compass {
    uint32_t directions, side[3], inverse[8];
    uint8_t interpolation, any_length;
} qv_compass;

typedef struct qv_bearing {
    uint32_t share[3], scale[3];
    uint8_t slot[3], of_depths;
} qv_bearing;

/* A checked scene, ready to draw. Plain data: it may be copied, and holds no pointer into
   itself. Its fields are the library's own, core/splat.h. */
typedef struct qv_splats {
    qv_splat_scene scene;
    qv_compass compass;
    qv_bearing viewer, lamp[QV_LAMPS_MAX];
    int64_t across[3], down[3], ahead[3], eye[3], distance;
    uint32_t mantissa[4], factor, size[2], gain, length;
    int16_t exponent[4];
    uint8_t shift, drawn;
} qv_splats;

/*
 * The voxel of level 0 in which the eye of a scene lies. Returns 1, or 0 where it lies outside of
 * the volume, the scene is orthographic or a pointer null; then position is left.
 */
int qv_splat_eye(uint16_t position[3], const qv_splat_scene *scene);

/*
 * Checks a scene and makes a qv_splats of it. A voxel of the finest level must be 1/64 .. 4096
 * pixels wide and high, in perspective at the distance of the volume's centre.
 * Returns QV_OK or QV_ERROR_NULL (also without `inside` where an eye lies in the volume), _STORAGE
 * (also the domain's), _SIZE, _PALETTE, _SPACING, _UNIT and _EXTINCTION (as qv_attenuate, of a step
 * along all three axes), _VIEW,
 * _LEVEL, _LIGHT, _DIRECTION (a set that is empty or has unknown bits, or lacks a direction that
 * the viewer or a lamp wants; of QV_NEAREST, the nearest is more than 60 degrees off; an unknown
 * interpolation), _INSIDE (light may come to the eye by a direction whose byte in `inside` is 0).
 * After an error splats is as it was, or all 0; there is no room on a small stack for a second one.
 * The scene may be that of splats itself.
 */
qv_status qv_splat_init(qv_splats *splats, const qv_splat_scene *scene);

/* A voxel by itself, from wherever it came. */
typedef struct qv_freevoxel {
    qv_address voxel;       /* as the volume stores it; of level 1 and up, an entry of the channels
                               of the volume or of its palette; aligned as there */
    qv_address attenuation; /* its bytes, one for each direction of the set */
    uint16_t position[3];   /* on its level */
    uint8_t level;
} qv_freevoxel;

/*
 * Adds a voxel to the sums (equation 10): colour * opacity * transmittance, spread by the kernel.
 *
 * Of voxels of several levels it draws those of `coarsest` that are at most `detail` pixels wide
 * and high, of the voxels that make up the others those that are, and so on; of `level`, all that
 * remain. So each place is drawn once, whatever is offered in whatever order. What is not among
 * them, has no opacity or lies outside of the frame adds nothing; in perspective neither does what
 * is less than 1/64 or more than 4096 pixels wide, not half a voxel in front of the eye, or farther
 * from the frame's centre than the frame's width or height and the kernel's, as it is at the
 * distance of the volume's centre or for a voxel as wide as `detail`. (Nor what QV_NEAREST finds no
 * direction for within 60 degrees: qv_splat_init tries the corners of such a frame only.)
 *
 * The opacity is that of the voxel's depth along a step towards the viewer, and the weights of a
 * layer of voxels across the view sum to 1: exactly where the voxels' axes are the picture's, else
 * on average over the layer, within 5 % by the quadratic kernel and 35 % by the linear one. So
 * behind a face of a homogeneous medium nothing is lost or counted twice. (In perspective, cubes
 * more than 76 degrees off the axis bring too little.) The weights of one splat sum to its size
 * within 2^-14 pixel on each axis; each is within 2^-9 of the kernel's mean over the pixel, and
 * within 2^-12 for voxels up to a pixel wide.
 *
 * What a voxel brings to them is within 2^-15 of itself, 2^-18 of what it would bring in full light
 * (of QV_BETWEEN_DEPTHS, 2^-13) and 2^-16 level of exact for the bytes as they are. Opacities of 16
 * bits add 2^-18 level for each unit distance in a step beyond 4.
 * Returns QV_OK or QV_ERROR_NULL, _SIZE (no voxel of that level has this position), _LEVEL (more
 * than the volume has), _STRIDE (16-bit entry at an odd address), _RECT, _BUFFER (sums). Sums that
 * are full are told by qv_sums_read_out.
 */
qv_status qv_splat(const qv_sums *sums, const qv_splats *splats, const qv_freevoxel *voxel);

/*
 * Adds a block of voxels of one level from memory, back to front, as qv_splatting_over wants it.
 * `level` describes the voxels of that level (qv_pyramid_level; the volume itself for level 0).
 * attenuation may be null where the splatting reads none and no lamp shines. Returns QV_OK or
 * QV_ERROR_NULL, an error of qv_volume_check, _STORAGE (not that of the scene), _SIZE (also of the
 * block or of attenuation), _LEVEL, _DIRECTION (not the scene's set), _ATTENUATION, _RECT, _BUFFER,
 * _OVERLAP (the sums are also something that is read).
 */
qv_status qv_splat_block(const qv_sums *sums, const qv_splats *splats, const qv_volume *level,
                         const qv_attenuation *attenuation, uint8_t number, const qv_block *block);

/*
 * Adds voxels as they come: calls next, which fills in a voxel and returns 1, until it returns 0,
 * or a negative qv_status of the caller's. What the voxel points to must live until the next call.
 * Returns QV_OK, that status, or the first error of qv_splat; what came before it has been added.
 */
qv_status qv_splat_stream(const qv_sums *sums, const qv_splats *splats,
                          int (*next)(void *user, qv_freevoxel *voxel), void *user);

/* Sets sums to nothing; of qv_splatting_over, to the scene's background. QV_OK or QV_ERROR_NULL,
   _RECT, _BUFFER. */
qv_status qv_sums_clear(const qv_sums *sums, const qv_splats *splats);

/* Adds the sums of another part of the voxels, for the same rectangle. QV_OK or QV_ERROR_NULL,
   _RECT (also of two sizes), _BUFFER, _OVERLAP. */
qv_status qv_sums_add(const qv_sums *to, const qv_sums *from);

/*
 * The pass from sums to pixels: puts the background behind what was added, and stores the
 * rectangle. Opacity is at most 1, and colours are at most the opacity. Returns QV_OK or
 * QV_ERROR_NULL, _RECT, _BUFFER (of either), _OVERLAP, _SUMS (a sum is full).
 */
qv_status qv_sums_read_out(const qv_image *image, const qv_sums *sums, const qv_splats *splats);

#ifdef __cplusplus
}
#endif

#endif /* QVOL_H */
