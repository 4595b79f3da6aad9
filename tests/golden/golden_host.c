/*
 * golden_host.c - the golden scenes on this machine, in TAP.
 *
 *     golden             checks the checksums of golden.h, how much of each
 *                        picture is covered, and its distance from the reference
 *     golden --update    prints a new golden.h
 */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "golden.h"
#include "paged.h"
#include "scenes.h"
#include "tally.h"

/* A picture that covers less may hide an error behind its background. */
#define LEAST_COVERAGE 0.2

/* Share of channels that must equal the reference, of associated colours in short numbers too;
   none may be off by more than one level. */
#define LEAST_EQUAL             0.99
#define LEAST_EQUAL_PREWEIGHTED 0.9

static golden_memory memory;
static unsigned tests, failures;

static void print_name(const golden_scene *golden)
{
    const char *word[GOLDEN_WORDS];
    golden_name(word, golden);
    for (unsigned i = 0; i < GOLDEN_WORDS; i++)
        printf("%s%s", i == 0 ? "" : ", ", word[i]);
}

static void print_result(bool passed, const char *what, uint32_t number, const golden_scene *golden)
{
    failures += passed ? 0 : 1;
    printf("%s %u - golden %" PRIu32 " %s: ", passed ? "ok" : "not ok", ++tests, number, what);
    print_name(golden);
    printf("\n");
}

/* ---- Checksums ------------------------------------------------------------ */

static void check_checksums(uint32_t number, const golden_scene *golden)
{
    bool passed = true;
    for (unsigned way = 0; way < GOLDEN_WAYS; way++) {
        uint32_t checksum = 0;
        qv_status status = golden->render(&checksum, &memory, golden, (golden_way)way);
        if (status == QV_OK && checksum == golden_checksums[number])
            continue;
        fprintf(stderr, "golden %" PRIu32 " %s: %s, %08" PRIx32 " instead of %08" PRIx32 "\n",
                number, golden_way_name[way], qv_status_text(status), checksum,
                golden_checksums[number]);
        passed = false;
    }
    print_result(passed, "checksums", number, golden);
}

/* ---- Through pages -------------------------------------------------------- */

/* The same checksum through every cache. */
static void check_pages(uint32_t number, const golden_scene *golden)
{
    bool passed = true;
    memory.change = golden_page;
    for (unsigned cache = 0; cache < GOLDEN_CACHES; cache++) {
        uint32_t checksum = 0;
        golden_choose_cache(cache, golden->mode);
        qv_status status = golden->render(&checksum, &memory, golden, GOLDEN_PIECES);
        if (status == QV_OK && checksum == golden_checksums[number] && golden_pages.reads > 0)
            continue;
        fprintf(stderr, "golden %" PRIu32 " through pages %u: %s, %08" PRIx32 "\n", number, cache,
                qv_status_text(status), checksum);
        passed = false;
    }
    memory.change = NULL;
    print_result(passed, "pages", number, golden);
}

/* ---- The picture itself --------------------------------------------------- */

/* The pixels as RGBA8888 without early termination. */
static bool render_rgba(uint8_t *pixels, size_t bytes, const qv_scene *scene, const qv_rect *rect)
{
    qv_scene complete = *scene;
    qv_context context;
    qv_image image = {pixels, bytes, (rect->right - rect->left) * 4, &qv_format_rgba8888};
    complete.termination = 0;
    return qv_init(&context, &complete) == QV_OK && qv_render(&image, &context, rect) == QV_OK;
}

/* Compares every pixel with the reference; returns the share of pixels in which
   the volume shows. */
static double compare(tally *difference, const uint8_t *pixels, const qv_scene *scene,
                      const golden_scene *golden)
{
    static const ref_mode modes[] = {
        [GOLDEN_NEAREST] = REF_NEAREST,
        [GOLDEN_SEPARATE] = REF_SEPARATE,
        [GOLDEN_WEIGHTED] = REF_WEIGHTED,
        [GOLDEN_PREWEIGHTED] = REF_WEIGHTED,
        [GOLDEN_CORRECTED] = REF_CORRECTED,
        [GOLDEN_EXTINCTION] = REF_EXTINCTION,
        [GOLDEN_BSPLINE_WEIGHTED] = REF_BSPLINE_WEIGHTED,
        [GOLDEN_BSPLINE_EXTINCTION] = REF_BSPLINE_EXTINCTION,
    };
    const qv_rect *rect = &golden->rect;
    unsigned covered = 0, count = 0;
    for (int32_t y = rect->top; y < rect->bottom; y++) {
        for (int32_t x = rect->left; x < rect->right; x++, count++) {
            ref_pixel expected;
            ref_render(&expected, scene, modes[golden->mode->family], x, y);
            tally_pixel(difference, &pixels[count * 4], &expected);
            covered += pixels[count * 4 + 3] > 0 ? 1 : 0;
        }
    }
    return (double)covered / count;
}

static void check_coverage(uint32_t number, const golden_scene *golden, double coverage)
{
    if (coverage < LEAST_COVERAGE)
        fprintf(stderr, "golden %" PRIu32 " covers only %.3f of its picture\n", number, coverage);
    print_result(coverage >= LEAST_COVERAGE, "coverage", number, golden);
}

static void check_picture(uint32_t number, const golden_scene *golden)
{
    static uint8_t pixels[64 * 64 * 4];
    qv_scene scene;
    tally with_background = {0}, alone = {0};
    bool made = golden_make(&scene, &memory, golden) == QV_OK &&
                render_rgba(pixels, sizeof pixels, &scene, &golden->rect);
    if (made)
        (void)compare(&with_background, pixels, &scene, golden);
    memset(scene.background, 0, sizeof scene.background);
    made = made && render_rgba(pixels, sizeof pixels, &scene, &golden->rect);
    double coverage = made ? compare(&alone, pixels, &scene, golden) : 0;
    tally_add(&alone, &with_background);
    check_coverage(number, golden, coverage);
    double least =
        golden->mode->family == GOLDEN_PREWEIGHTED ? LEAST_EQUAL_PREWEIGHTED : LEAST_EQUAL;
    bool near = made && alone.worst <= 1 && tally_share(&alone) >= least;
    if (!near)
        tally_print("golden", &alone);
    print_result(near, "reference", number, golden);
}

/* Of FreeVoxels: the scene without background, as RGBA8888 without gaps. The accuracy tests
   compare such pictures with the reference. */
static void check_freevoxels(uint32_t number, const golden_scene *golden)
{
    golden_scene alone = *golden;
    const qv_rect *rect = &golden->rect;
    unsigned count = (unsigned)((rect->right - rect->left) * (rect->bottom - rect->top));
    unsigned covered = 0;
    uint32_t checksum;
    alone.format = GOLDEN_RGBA8888;
    alone.padding = 0;
    memset(alone.background, 0, sizeof alone.background);
    bool made = golden->render(&checksum, &memory, &alone, GOLDEN_WHOLE) == QV_OK;
    for (unsigned i = 0; made && i < count; i++)
        covered += memory.pixels[i * 4 + 3] > 0 ? 1 : 0;
    check_coverage(number, golden, (double)covered / count);
}

/* ---- The sets of scenes --------------------------------------------------- */

static const golden_set *const sets[] = {&golden_steps,  &golden_lengths,    &golden_bsplines,
                                         &golden_slices, &golden_freevoxels, &golden_preweighted};

enum { SETS = sizeof sets / sizeof *sets };

/* Every choice as one bit: format, content, layout, projection. */
static uint32_t choices(const golden_scene *golden)
{
    unsigned projection = golden->field_of_view == 0 ? 0 : 1;
    uint32_t set = UINT32_C(1) << golden->format;
    set |= UINT32_C(1) << (9 + golden->content);
    set |= UINT32_C(1) << (14 + golden->layout);
    set |= UINT32_C(1) << (18 + projection);
    return set;
}

/* Whether a set has each of its modes, and all other choices. */
static bool is_complete(const golden_set *set)
{
    uint32_t seen = 0;
    for (uint32_t number = set->first; number < set->end; number++) {
        golden_scene golden;
        golden_describe(&golden, set, number);
        seen |= choices(&golden);
    }
    return seen == (UINT32_C(1) << 20) - 1 && set->end - set->first >= set->mode_count;
}

/* The levels of the pyramids: between two everywhere, and rising with the distance. */
static bool levels_occur(void)
{
    bool blended = false, rising = false;
    for (unsigned i = 0; i < SETS; i++) {
        for (uint32_t number = sets[i]->first; number < sets[i]->end; number++) {
            golden_scene golden;
            golden_describe(&golden, sets[i], number);
            blended = blended || golden.level % 256 != 0;
            rising = rising || golden.level_distance != 0;
        }
    }
    return blended && rising;
}

/* Where a choice stands in a table of slices, as one bit; none has the bit after the
   last. */
static uint32_t blend_bit(const golden_blend *blend)
{
    const golden_blends *of = golden_slices.blends;
    return UINT32_C(1) << (blend ? (uint32_t)(blend - of->blend) : of->count);
}

static uint32_t dither_bits(const qv_dither *dither)
{
    const golden_blends *of = golden_slices.blends;
    uint32_t set = UINT32_C(1) << (dither->still ? 9 : 10);
    for (unsigned i = 0; i < GOLDEN_SEQUENCES; i++)
        set |= dither->sequence == of->sequence[i] ? UINT32_C(1) << i : 0;
    for (unsigned i = 0; i < GOLDEN_TECHNIQUES; i++)
        set |= dither->technique == of->technique[i] ? UINT32_C(1) << (4 + i) : 0;
    return set;
}

/* Every blend, every blend of chunks and none, every sequence and technique. */
static bool slices_occur(void)
{
    const golden_set *set = &golden_slices;
    uint32_t blends = 0, fronts = 0, dithers = 0;
    for (uint32_t number = set->first; number < set->end; number++) {
        golden_scene golden;
        golden_describe(&golden, set, number);
        blends |= blend_bit(golden.slices.blend);
        fronts |= blend_bit(golden.slices.front);
        dithers |= dither_bits(&golden.slices.dither);
    }
    return blends == blend_bit(NULL) - 1 &&
           fronts == (((UINT32_C(1) << GOLDEN_FRONTS) - 1) | blend_bit(NULL)) &&
           dithers == (UINT32_C(1) << 11) - 1;
}

/* What a scene of FreeVoxels chooses, each choice as one bit. */
static uint32_t splat_bits(const golden_splatting *splats)
{
    const golden_splats *of = golden_freevoxels.splats;
    uint32_t set = UINT32_C(1) << (splats->how - of->splat);
    for (unsigned i = 0; i < GOLDEN_ORDERS; i++)
        set |= splats->order == of->order[i] ? UINT32_C(1) << (5 + i) : 0;
    set |= UINT32_C(1) << (8 + splats->interpolation);
    set |= UINT32_C(1) << (splats->rebuilt ? 11 : 12);
    set |= UINT32_C(1) << (splats->coarsest > splats->level ? 13 : 14);
    set |= UINT32_C(1) << (splats->directions == 0 ? 15 : 16);
    set |= UINT32_C(1) << (splats->lighting.count == 0 ? 17 : 18);
    return set;
}

static bool splats_occur(void)
{
    const golden_set *set = &golden_freevoxels;
    uint32_t seen = 0;
    for (uint32_t number = set->first; number < set->end; number++) {
        golden_scene golden;
        golden_describe(&golden, set, number);
        seen |= splat_bits(&golden.splats);
    }
    return seen == (UINT32_C(1) << 19) - 1;
}

static void check_choices(void)
{
    bool all = levels_occur() && slices_occur() && splats_occur();
    for (unsigned i = 0; i < SETS; i++)
        all = all && is_complete(sets[i]);
    failures += all ? 0 : 1;
    printf("%s %u - golden scenes: every choice occurs\n", all ? "ok" : "not ok", ++tests);
}

/* ---- golden.h ------------------------------------------------------------- */

static bool print_checksum(uint32_t *sum, const golden_set *set, uint32_t number)
{
    golden_scene golden;
    uint32_t checksum;
    golden_describe(&golden, set, number);
    qv_status status = golden.render(&checksum, &memory, &golden, GOLDEN_WHOLE);
    if (status != QV_OK) {
        fprintf(stderr, "golden %" PRIu32 ": %s\n", number, qv_status_text(status));
        return false;
    }
    *sum += checksum;
    printf("    0x%08" PRIx32 "u, /* %" PRIu32 " ", checksum, number);
    print_name(&golden);
    printf(" */\n");
    return true;
}

/* On stderr, the sums that example S37 of the specification gives. */
static int update(void)
{
    uint32_t sum = 0;
    printf("/*\n * golden.h - CRC-32 of each golden scene: written by `make golden-update`.\n"
           " *\n * A new value here is a new picture, and a new version of tests/SPEC.md.\n */\n"
           "#ifndef GOLDEN_H\n#define GOLDEN_H\n\n#include \"scenes.h\"\n\n"
           "static const uint32_t golden_checksums[GOLDEN_SCENES] = {\n");
    for (unsigned i = 0; i < SETS; i++) {
        for (uint32_t number = sets[i]->first; number < sets[i]->end; number++)
            if (!print_checksum(&sum, sets[i], number))
                return 1;
        fprintf(stderr, "sum of the first %" PRIu32 ": 0x%08" PRIX32 "\n", sets[i]->end, sum);
    }
    printf("};\n\n#endif /* GOLDEN_H */\n");
    return 0;
}

int main(int count, char **arguments)
{
    if (count == 2 && strcmp(arguments[1], "--update") == 0)
        return update();
    for (unsigned i = 0; i < SETS; i++) {
        for (uint32_t number = sets[i]->first; number < sets[i]->end; number++) {
            golden_scene golden;
            golden_describe(&golden, sets[i], number);
            check_checksums(number, &golden);
            if (!golden.splats.how && golden_is_paged(golden.mode))
                check_pages(number, &golden);
            if (golden.splats.how)
                check_freevoxels(number, &golden);
            else
                check_picture(number, &golden);
        }
    }
    check_choices();
    printf("1..%u\n", tests);
    return failures == 0 ? 0 : 1;
}
