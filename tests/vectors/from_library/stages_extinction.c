/*
 * stages_extinction.c - from opacity to depth and back: sections 28 to 31 and 47.
 */
#include "stages.h"

#include "fx_correct.h"
#include "fx_log.h"
#include "fx_log_table.h"
#include "fx_phi.h"
#include "fx_table.h"
#include "fx_wide.h"
#include "qvol.h"

/* ---- Depth ------------------------------------------------------------------ */

typedef struct depth_row {
    uint64_t t, w, n, index, gap, depth;
} depth_row;

/* What a number that is normalised to 2^31 and more lacks to its segment's end. */
static void find_segment(uint64_t *index, uint64_t *gap, uint64_t n)
{
    *index = (n >> 26) - 32u;
    *gap = 0x80000000u -
           fx_product_shift16((uint32_t)n, fx_table16(&log_reciprocal[(unsigned)*index]));
}

static unsigned depth_compute(void *columns)
{
    depth_row *row = columns;
    row->depth = fx_depth_of_transmittance((uint32_t)row->t);
    if (row->t == 0)
        return VECTOR_SATURATE;
    while (row->t << row->w < 0x80000000u)
        row->w++;
    row->n = row->t << row->w;
    find_segment(&row->index, &row->gap, row->n);
    return 0;
}

static void depth_draw(void *columns, vector_random *random)
{
    depth_row *row = columns;
    row->t = vector_bits(random, 1) ? vector_bits(random, 32) : vector_any(random, 32);
}

/* Powers of 2 and the borders of segments, and what is next to them. */
static void depth_edges(vector_set *set)
{
    for (unsigned bit = 0; bit < 32; bit++)
        for (uint64_t near = 0; near < 3; near++) {
            const depth_row row = {.t = ((uint64_t)1 << bit) + near - 1u};
            vector_add(set, &row, VECTOR_EDGE);
        }
    for (uint64_t segment = 33; segment < 65; segment++)
        for (uint64_t near = 0; near < 3; near++) {
            const depth_row row = {.t = (segment << 26) + near - 3u};
            vector_add(set, &row, VECTOR_EDGE);
        }
}

static const vector_field depth_fields[] = {
    {"t", 1, 'i', "u32.32", "transmittance, 2^32 - 1 is 1"},
    {"w", 1, 'm', "u5",
     "the least integer >= 0 with t * 2^w >= 2^31; this and the rest 0 for t = 0"},
    {"n", 1, 'm', "u32.32", "t * 2^w"},
    {"index", 1, 'm', "u5", "floor(n / 2^26) - 32"},
    {"gap", 1, 'm', "u32.31", "2147483648 - floor(n * log_reciprocal[index] / 65536)"},
    {"depth", 1, 'o', "u64.32",
     "64 * 2^32 where t = 0, else w * 2^32 + 2 ((log_depth[index] + hi(64 gap, 0x05C5527A + hi(64 "
     "gap, 0x001711A2 + floor(0x8117 * floor(64 gap / 65536) / 65536)))) mod 2^32)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_depth = {
    .name = "depth",
    .section = "28",
    .title = "the depth of a transmittance",
    .rounding = "products of hi to nearest, ties upwards; all else is cut",
    .saturation = "64 for t = 0",
    .fields = depth_fields,
    .columns = VECTOR_COLUMNS(depth_row),
    .seed = 28,
    .random_rows = 500,
    .edges = depth_edges,
    .draw = depth_draw,
    .compute = depth_compute,
};

/* ---- Extinction of stored opacity ------------------------------------------- */

typedef struct extinction_row {
    uint64_t a16, a8, ext16, ext8;
} extinction_row;

static unsigned extinction_compute(void *columns)
{
    extinction_row *row = columns;
    row->ext16 = fx_extinction_of_unorm16((fx_unorm16)row->a16);
    row->ext8 = fx_extinction_of_unorm8((fx_unorm8)row->a8);
    return row->a16 == 65535 || row->a8 == 255 ? VECTOR_SATURATE : 0;
}

static void extinction_draw(void *columns, vector_random *random)
{
    extinction_row *row = columns;
    row->a16 = vector_any(random, 16);
    row->a8 = vector_bits(random, 8);
}

/* Every opacity of 8 bits; of 16 bits those and the first and the last ones. */
static void extinction_edges(vector_set *set)
{
    for (uint64_t v = 0; v < 256; v++) {
        const extinction_row row = {.a16 = 257 * v, .a8 = v};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (uint64_t v = 1; v < 33; v++) {
        const extinction_row row = {.a16 = v % 2 ? v : 65535 - v / 2, .a8 = v};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field extinction_fields[] = {
    {"a16", 1, 'i', "unorm16", "opacity"},
    {"a8", 1, 'i', "unorm8", "opacity"},
    {"ext16", 1, 'o', "u32.24", "floor((D(65537 (65535 - a16)) + 128) / 256)"},
    {"ext8", 1, 'o', "u32.24", "round(2^24 * -log2(1 - a8 / 255)), 64 * 2^24 for 255"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_extinction = {
    .name = "extinction",
    .section = "28",
    .title = "the extinction of a stored opacity",
    .rounding = "to nearest, ties upwards",
    .saturation = "64 for full opacity",
    .fields = extinction_fields,
    .columns = VECTOR_COLUMNS(extinction_row),
    .seed = 2808,
    .random_rows = 250,
    .edges = extinction_edges,
    .draw = extinction_draw,
    .compute = extinction_compute,
};

/* ---- Reciprocal ------------------------------------------------------------- */

typedef struct reciprocal_row {
    uint64_t v, w, n, index, gap, reciprocal;
} reciprocal_row;

static unsigned reciprocal_compute(void *columns)
{
    reciprocal_row *row = columns;
    row->reciprocal = fx_reciprocal((uint32_t)row->v);
    row->n = row->v == 0x80000000u ? UINT32_MAX : 2 * row->v;
    for (; row->n < 0x80000000u; row->n *= 2)
        row->w++;
    find_segment(&row->index, &row->gap, row->n);
    return row->v == 0x80000000u ? VECTOR_SATURATE : 0;
}

static void reciprocal_draw(void *columns, vector_random *random)
{
    reciprocal_row *row = columns;
    row->v = (uint64_t)vector_between(random, 1 << 27, INT64_C(1) << 31);
    row->v >>= vector_bits(random, 2);
    if (row->v < 1 << 27)
        row->v += 1 << 27;
}

static void reciprocal_edges(vector_set *set)
{
    for (uint64_t segment = 32; segment < 65; segment++)
        for (unsigned shift = 0; shift < 4; shift++) {
            uint64_t v = (segment << 25 >> shift) + (segment == 64 ? 0 : segment % 3);
            const reciprocal_row row = {.v = v < 1 << 27 ? 1 << 27 : v};
            vector_add(set, &row, VECTOR_EDGE);
        }
}

static const vector_field reciprocal_fields[] = {
    {"v", 1, 'i', "u32.31", "2^27 .. 2^31"},
    {"w", 1, 'm', "u5", "the least integer >= 0 with min(2 v, 2^32 - 1) * 2^w >= 2^31"},
    {"n", 1, 'm', "u32.32", "min(2 v, 2^32 - 1) * 2^w"},
    {"index", 1, 'm', "u5", "floor(n / 2^26) - 32"},
    {"gap", 1, 'm', "u32.31", "2147483648 - floor(n * log_reciprocal[index] / 65536)"},
    {"reciprocal", 1, 'o', "u32.27",
     "floor(shift16(m, log_reciprocal[index]) / 2^(3-w)), with m = 2^31 + gap + floor(hi(2^31 + "
     "gap, hi(64 gap, 64 gap)) / 1024)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_reciprocal = {
    .name = "reciprocal",
    .section = "28",
    .title = "a reciprocal",
    .rounding = "products of hi to nearest, ties upwards; all else is cut",
    .saturation = "2 v at 2^32 - 1",
    .fields = reciprocal_fields,
    .columns = VECTOR_COLUMNS(reciprocal_row),
    .seed = 2827,
    .random_rows = 400,
    .edges = reciprocal_edges,
    .draw = reciprocal_draw,
    .compute = reciprocal_compute,
};

/* ---- phi -------------------------------------------------------------------- */

typedef struct phi_row {
    uint64_t x, phi;
} phi_row;

static unsigned phi_compute(void *columns)
{
    phi_row *row = columns;
    row->phi = fx_phi(row->x);
    return 0;
}

static void phi_draw(void *columns, vector_random *random)
{
    phi_row *row = columns;
    row->x = vector_bits(random, 1) ? vector_bits(random, 38) : vector_any(random, 64);
}

/* The borders of segments in each octave. */
static void phi_edges(vector_set *set)
{
    for (uint64_t octave = 0; octave < 8; octave++)
        for (uint64_t eighth = 0; eighth < 24; eighth++) {
            uint64_t start = octave == 0 ? 0 : (uint64_t)1 << (32 + octave);
            uint64_t width = (uint64_t)1 << (octave == 0 ? 30 : 29 + octave);
            const phi_row row = {.x = start + eighth / 3 * width + (eighth % 3)};
            vector_add(set, &row, VECTOR_EDGE);
        }
    for (unsigned bit = 1; bit < 64; bit++) {
        const phi_row row = {.x = ((uint64_t)1 << bit) - 1u};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Found by search: here a table entry or a constant that is off by 1 shows. */
static void phi_added(vector_set *set)
{
    static const uint64_t firsts[] = {
        9364965632,   8728738248,   11134019323,  12823445366,  12042043694,  14443416748,
        15449746869,  15042895918,  16535494400,  19641201884,  23206935841,  23412660460,
        22648611421,  22011395015,  26924438392,  28976097758,  30547957559,  41953711438,
        39946552364,  46298440556,  45980339242,  44172649935,  43739020356,  50645697621,
        48385171768,  53543477379,  51627143029,  59625094507,  56711075983,  62253107863,
        63615358397,  66925629526,  67068125099,  72324318249,  68786513770,  71347306418,
        84853625293,  80024550569,  89589029370,  99720408783,  98615136892,  96065560352,
        110369373643, 104957700281, 113569616617, 120633910505, 132674211936, 132043300886,
        145707534461, 155995374485, 176705821416, 192704214034, 200277452257, 189258118850,
        211310392635, 232537142705, 231395170118, 237187766508, 224688643808, 246916383673};
    vector_add_firsts(set, firsts, sizeof firsts / sizeof firsts[0]);
}

static const vector_field phi_fields[] = {{"x", 1, 'i', "u64.32", "depth in base 2"},
                                          {"phi", 1, 'o', "u32.31", "phi(x) of section 29"},
                                          {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_phi = {
    .name = "phi",
    .section = "29",
    .title = "what makes light of extinction-weighted colour",
    .rounding = "hi to nearest, ties upwards; the last shift too; all else is cut",
    .saturation = "the table's octave at 5",
    .fields = phi_fields,
    .columns = VECTOR_COLUMNS(phi_row),
    .seed = 29,
    .random_rows = 800,
    .edges = phi_edges,
    .added = phi_added,
    .draw = phi_draw,
    .compute = phi_compute,
};

/* ---- Correction ------------------------------------------------------------- */

typedef struct correct_row {
    uint64_t a, ratio, depth, scaled, opacity, factor;
} correct_row;

static unsigned correct_compute(void *columns)
{
    correct_row *row = columns;
    row->depth = fx_depth_of_unorm16((fx_unorm16)row->a);
    row->scaled = fx_depth_scale(row->depth, (uint32_t)row->ratio);
    row->opacity = fx_correct_opacity((fx_unorm16)row->a, (uint32_t)row->ratio);
    row->factor = fx_correct_colour((fx_unorm16)row->a, (uint32_t)row->ratio);
    return row->a == 65535 ? VECTOR_SATURATE : 0;
}

static void correct_draw(void *columns, vector_random *random)
{
    correct_row *row = columns;
    row->a = vector_any(random, 16);
    row->ratio = (uint64_t)vector_between(random, 4096, vector_bits(random, 1) ? 1 << 20 : 1 << 17);
}

static void correct_edges(vector_set *set)
{
    static const uint64_t opacities[] = {0, 1, 2, 32767, 32768, 65533, 65534, 65535};
    static const uint64_t ratios[] = {4096, 65535, 65536, 65537, 1048576};
    for (unsigned i = 0; i < 40; i++) {
        const correct_row row = {.a = opacities[i % 8], .ratio = ratios[i / 8]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field correct_fields[] = {
    {"a", 1, 'i', "unorm16", "opacity for the stored distance"},
    {"ratio", 1, 'i', "u32.16", "k: new distance by the stored one, 4096 .. 2^20"},
    {"depth", 1, 'm', "u64.32", "D(65537 (65535 - a))"},
    {"scaled", 1, 'm', "u64.32", "scale(depth, ratio) of section 30"},
    {"opacity", 1, 'o', "unorm16", "correct(a, ratio)"},
    {"factor", 1, 'o', "u32.27", "factor(a, ratio)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_correct = {
    .name = "correct",
    .section = "30",
    .title = "an opacity for another distance, and the factor of its colour",
    .rounding = "opacity to nearest, ties upwards; products cut but for hi",
    .saturation = "65535 and 2^27 for full opacity",
    .fields = correct_fields,
    .columns = VECTOR_COLUMNS(correct_row),
    .seed = 30,
    .random_rows = 400,
    .edges = correct_edges,
    .draw = correct_draw,
    .compute = correct_compute,
};

/* ---- Number of slices ------------------------------------------------------- */

typedef struct slices_row {
    uint64_t o32, slices, wanted, depth, thinner;
} slices_row;

static unsigned slices_compute(void *columns)
{
    slices_row *row = columns;
    row->depth = fx_depth_of_opacity((uint32_t)row->o32);
    row->thinner =
        fx_correct_slices((uint32_t)row->o32, (uint32_t)row->slices, (uint32_t)row->wanted);
    return row->thinner == UINT32_MAX ? VECTOR_SATURATE : 0;
}

static void slices_draw(void *columns, vector_random *random)
{
    slices_row *row = columns;
    row->o32 = vector_any(random, 32);
    row->slices = vector_any(random, 16) | 1u;
    row->wanted = vector_bits(random, 2) ? vector_any(random, 12) + 1u : vector_any(random, 31);
    row->wanted += row->wanted == 0;
}

static void slices_edges(vector_set *set)
{
    static const uint64_t opacities[] = {0, 1, 50529, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF};
    static const uint64_t numbers[] = {1, 2, 3, 65535, 0x7FFFFFFF};
    for (unsigned i = 0; i < 6 * 20; i++) {
        const slices_row row = {
            .o32 = opacities[i % 6], .slices = numbers[i / 6 % 4], .wanted = numbers[i / 24]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field slices_fields[] = {
    {"o32", 1, 'i', "u32.32", "opacity of a slice, 2^32 - 1 is 1"},
    {"slices", 1, 'i', "u16", "N: how many it is for, not 0"},
    {"wanted", 1, 'i', "u31", "M: how many there are, not 0"},
    {"depth", 1, 'm', "u64.32", "D(2^32 - 1 - o32)"},
    {"thinner", 1, 'o', "u32.32",
     "o32 where slices = wanted or o32 = 2^32 - 1, else 2 x - floor(x / 2^31), with x = 2^31 - "
     "T(floor(floor(2^32 slices / wanted) * depth / 2^32))"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_slices = {
    .name = "slices",
    .section = "47",
    .title = "an opacity for another number of slices",
    .rounding = "as those of D and T; products are cut",
    .saturation = "2^32 - 1 stays",
    .fields = slices_fields,
    .columns = VECTOR_COLUMNS(slices_row),
    .seed = 47,
    .random_rows = 250,
    .edges = slices_edges,
    .draw = slices_draw,
    .compute = slices_compute,
};
