/*
 * settings_slices.c - the options of rendering slice by slice.
 */
#include "settings_slices.h"
#include "error.h"

#include <math.h>
#include <stddef.h>

/* The library's ranges. */
#define SLICES_MOST  65535
#define PERIOD_LEAST 2
#define PERIOD_MOST  64
#define SLOPE_LEAST  (1.0 / QV_ONE_Q16)
#define SLOPE_MOST   16

#define PERIOD_DEFAULT 32  /* of the paper's figures, unless it says otherwise */
#define CUTOFF_DEFAULT 255 /* above which no opacity lies */
#define BRICKS_MOST    64  /* an axis: all of them are counted in 32 bits */

static const choice compositing_names[] = {{"rays", 0}, {"slices", 1}, {NULL, 0}};

const choice framebuffer_names[] = {
    {"8", 8}, {"12", 12}, {"16", 16}, {"24", 24}, {"565", FRAMEBUFFER_565}, {NULL, 0},
};

const choice dither_names[] = {
    {"none", DITHER_NONE},         {"random", DITHER_RANDOM},
    {"ordered", DITHER_ORDERED},   {"bump", DITHER_BUMP},
    {"rounding", DITHER_ROUNDING}, {"feedback", DITHER_FEEDBACK},
    {"auto", DITHER_AUTO},         {NULL, 0},
};

/* Rounded to nearest, as without dither, is not one to be asked for. */
const choice sequence_names[] = {
    {"golden", SEQUENCE_GOLDEN},
    {"hash", SEQUENCE_HASH},
    {"blocks", SEQUENCE_BLOCKS},
    {NULL, 0},
};

static const choice table_names[] = {
    {"opacity", TABLE_OPACITY}, {"colour", TABLE_COLOUR}, {NULL, 0}};

static const choice residual_names[] = {{"4", 4}, {"8", 8}, {NULL, 0}};

/* ---- Setters ---------------------------------------------------------------- */

void set_compositing(struct settings *settings, const char *option, const char *value)
{
    settings->slices.wanted = choose(option, value, compositing_names) != 0;
}

void set_framebuffer(struct settings *settings, const char *option, const char *value)
{
    settings->slices.framebuffer = choose(option, value, framebuffer_names);
}

void set_dither(struct settings *settings, const char *option, const char *value)
{
    settings->slices.dither = choose(option, value, dither_names);
}

void set_residual(struct settings *settings, const char *option, const char *value)
{
    settings->slices.residual = (unsigned)choose(option, value, residual_names);
}

void set_sequence(struct settings *settings, const char *option, const char *value)
{
    settings->slices.sequence = choose(option, value, sequence_names);
}

void set_period(struct settings *settings, const char *option, const char *value)
{
    settings->slices.period = (unsigned)integer_between(option, value, PERIOD_LEAST, PERIOD_MOST);
}

static bool is_slope(double slope)
{
    return slope >= SLOPE_LEAST && slope <= SLOPE_MOST;
}

void set_slope(struct settings *settings, const char *option, const char *value)
{
    double *slope = settings->slices.slope;
    if (read_decimals(value, ',', 1, slope)) {
        settings->slices.slopes = 1;
        slope[1] = slope[0];
    } else if (read_decimals(value, ',', 2, slope)) {
        settings->slices.slopes = 2;
    }
    if (settings->slices.slopes == 0 || !is_slope(slope[0]) || !is_slope(slope[1])) {
        usage_error(option, "'%s' is neither A nor A,B, each above 0 and at most %d", value,
                    SLOPE_MOST);
    }
}

void set_cutoff(struct settings *settings, const char *option, const char *value)
{
    settings->slices.cutoff = (unsigned)integer_between(option, value, 1, 255);
}

void set_frame(struct settings *settings, const char *option, const char *value)
{
    settings->slices.frame = (uint32_t)integer_between(option, value, 0, UINT32_MAX);
    settings->slices.frame_given = true;
}

void set_still(struct settings *settings, const char *option, const char *value)
{
    (void)option;
    (void)value;
    settings->slices.still = true;
}

void set_chunk(struct settings *settings, const char *option, const char *value)
{
    settings->slices.chunk = (uint32_t)integer_between(option, value, 1, SLICES_MOST);
}

void set_slices(struct settings *settings, const char *option, const char *value)
{
    settings->slices.count = (uint32_t)integer_between(option, value, 1, SLICES_MOST);
}

void set_bricks(struct settings *settings, const char *option, const char *value)
{
    if (!read_sizes(value, 3, BRICKS_MOST, settings->slices.bricks)) {
        usage_error(option, "'%s' is not XxYxZ, each 1 to %d", value, BRICKS_MOST);
    }
}

void set_dither_table(struct settings *settings, const char *option, const char *value)
{
    settings->dither_table = choose(option, value, table_names);
}

/* ---- What they need --------------------------------------------------------- */

int settings_framebuffer(const struct settings *settings)
{
    return settings->slices.framebuffer != 0 ? settings->slices.framebuffer : 8;
}

int settings_dither(const struct settings *settings)
{
    if (settings->slices.dither != DITHER_BY_FRAMEBUFFER) {
        return settings->slices.dither;
    }
    return settings_framebuffer(settings) == 24 ? DITHER_NONE : DITHER_ROUNDING;
}

unsigned settings_residual(const struct settings *settings)
{
    bool feedback = settings->slices.dither == DITHER_FEEDBACK;
    return settings->slices.residual == 0 && feedback ? 8 : settings->slices.residual;
}

void settings_alpha(qv_dither *dither, const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    for (unsigned i = 0; i < 2; i++) {
        double slope = s->slopes != 0 ? s->slope[i] : 1;
        dither->slope[i] = (uint32_t)lround(slope * QV_ONE_Q16);
    }
    dither->period = (uint8_t)(s->period != 0 ? s->period : PERIOD_DEFAULT);
    dither->cutoff = (uint8_t)(s->cutoff != 0 ? s->cutoff : CUTOFF_DEFAULT);
}

static void check_compositing(const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    const char *need = "--compositing slices";
    const struct option_need needs[] = {
        {"--framebuffer", s->framebuffer != 0, s->wanted, need},
        {"--dither", s->dither != DITHER_BY_FRAMEBUFFER, s->wanted, need},
        {"--residual", s->residual != 0, s->wanted, need},
        {"--sequence", s->sequence != SEQUENCE_BY_DITHER, s->wanted, need},
        {"--period", s->period != 0, s->wanted, need},
        {"--slope", s->slopes != 0, s->wanted, need},
        {"--cutoff", s->cutoff != 0, s->wanted, need},
        {"--frame", s->frame_given, s->wanted, need},
        {"--still", s->still, s->wanted, need},
        {"--chunk", s->chunk != 0, s->wanted, need},
        {"--slices", s->count != 0, s->wanted, need},
        {"--bricks", s->bricks[0] != 0, s->wanted, need},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
}

/* What a dither reads: each would be ignored by the others. */
static void check_dither(const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    int framebuffer = settings_framebuffer(settings);
    int dither = settings_dither(settings);
    bool bumped = dither == DITHER_BUMP && s->slopes != 0;
    bool of_period = dither == DITHER_RANDOM || dither == DITHER_ORDERED || bumped;
    bool of_opacity = of_period || dither == DITHER_BUMP;
    const struct option_need needs[] = {
        {"--dither", of_opacity, framebuffer == 8 || framebuffer == FRAMEBUFFER_565,
         "--framebuffer 8 or 565: it makes opacities of 8 bits"},
        {"--dither", dither == DITHER_FEEDBACK, framebuffer == 8, "--framebuffer 8"},
        {"--residual", s->residual != 0, dither == DITHER_FEEDBACK || dither == DITHER_AUTO,
         "--dither feedback or auto"},
        {"--residual", s->residual != 0, framebuffer == 8, "--framebuffer 8"},
        {"--sequence", s->sequence != SEQUENCE_BY_DITHER,
         dither == DITHER_RANDOM || dither == DITHER_ROUNDING || dither == DITHER_FEEDBACK ||
             (dither == DITHER_BUMP && !bumped),
         "--dither random, rounding, feedback, or bump without --slope"},
        {"--period", s->period != 0, of_period, "--dither random, ordered, or bump with --slope"},
        {"--slope", s->slopes != 0, of_opacity, "--dither random, ordered or bump"},
        {"--slope", s->slopes == 2, bumped, "--dither bump: the others have one slope"},
        {"--cutoff", s->cutoff != 0, of_period, "--dither random, ordered, or bump with --slope"},
        {"--frame", s->frame_given, dither != DITHER_NONE, "a --dither"},
        {"--still", s->still, dither != DITHER_NONE, "a --dither"},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
}

static void check_order(const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    int framebuffer = settings_framebuffer(settings);
    int dither = settings_dither(settings);
    bool front = !settings_back_to_front(settings);
    const struct option_need needs[] = {
        {"--order", front, framebuffer == 8 || framebuffer == 16 || framebuffer == 24,
         "back-to-front, or --framebuffer 8, 16 or 24"},
        {"--order", front, dither == DITHER_NONE || dither == DITHER_ROUNDING,
         "back-to-front, or --dither none or rounding"},
        {"--chunk", s->chunk != 0, !front, "--order back-to-front"},
        {"--bricks", s->bricks[0] != 0, !front, "--order back-to-front"},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
}

static void check_parts(const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    bool keeps_opacity = settings_framebuffer(settings) != FRAMEBUFFER_565;
    const char *need = "another --framebuffer: 565 keeps no opacity";
    const struct option_need needs[] = {
        {"--chunk", s->chunk != 0, keeps_opacity, need},
        {"--bricks", s->bricks[0] != 0, keeps_opacity, need},
        {"--background", settings->background[3] == 0, keeps_opacity, need},
        {"--level", settings->level_given, s->bricks[0] == 0, "a volume without --bricks"},
        {"--step", settings->step_given, s->count == 0, "no --slices, which chooses it"},
        {"--phase", settings->phase_given, s->count == 0, "no --slices, which chooses it"},
        {"--slices", s->count != 0, settings->perspective <= 0, "a view without --perspective"},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
}

/* Of classify. */
static void check_table(const struct settings *settings)
{
    const struct slice_settings *s = &settings->slices;
    bool table = settings->dither_table != TABLE_NONE;
    const struct option_need needs[] = {
        {"--dither-table", table, settings_want_array(settings), "an output that ends in .c or .h"},
        {"--dither-table", table, !settings->extinction_given, "opacity: no --extinction"},
        {"--dither-table", table,
         settings->storage == 0 || settings->storage == QV_STORAGE_INDEXED8, "--storage indexed8"},
        {"--period", s->period != 0, table, "--dither-table"},
        {"--slope", s->slopes != 0, table, "--dither-table"},
        {"--slope", s->slopes == 2, false, "a single slope: a table has one"},
        {"--cutoff", s->cutoff != 0, table, "--dither-table"},
    };
    settings_refuse(needs, sizeof needs / sizeof needs[0]);
}

void settings_check_slices(const struct settings *settings, int groups)
{
    if ((groups & GROUP_TABLE) != 0) {
        check_table(settings);
        return;
    }
    check_compositing(settings);
    if (settings->slices.wanted) {
        check_dither(settings);
        check_order(settings);
        check_parts(settings);
    }
}
