/*
 * command_info.c - what a volume is, and how its values are spread.
 */
#include "commands.h"
#include "error.h"
#include "report_freevoxel.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BINS      256
#define BARS      16
#define BAR_WIDTH 50

struct spread {
    double low, high;
    uint64_t counts[BINS]; /* equal parts of low .. high */
    uint64_t values;       /* those that are numbers */
};

static const double shares[] = {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};

#define SHARES (sizeof shares / sizeof shares[0])

/* Halves, since high - low may exceed the largest double. */
static unsigned bin_of(const struct spread *spread, double value)
{
    double span = spread->high / 2 - spread->low / 2;
    double share = span > 0 ? (value / 2 - spread->low / 2) / span : 0;
    return share < 1 ? (unsigned)(share * BINS) : BINS - 1;
}

/* Two passes: the range makes the bins. Values that are no numbers do not count. */
static void measure(struct spread *spread, const struct scan *scan)
{
    uint64_t count = scan->bytes / element_bytes(scan->type);
    if (!scan_range(scan, &spread->low, &spread->high)) {
        data_error(scan->file, "data", "no value is a number");
    }
    for (uint64_t place = 0; place < count; place++) {
        double value = scan_value(scan, place);
        if (isfinite(value)) {
            spread->counts[bin_of(spread, value)]++;
            spread->values++;
        }
    }
}

/* Upper edge of the bin in which the share is reached. */
static double percentile(const struct spread *spread, double share)
{
    uint64_t sum = 0;
    unsigned bin = 0;
    while (bin < BINS - 1 && (double)(sum + spread->counts[bin]) < share * (double)spread->values) {
        sum += spread->counts[bin++];
    }
    return spread->low + (spread->high / BINS - spread->low / BINS) * (bin + 1);
}

/* Values in one sixteenth of the range. */
static uint64_t bar(const struct spread *spread, unsigned index)
{
    uint64_t sum = 0;
    for (unsigned i = 0; i < BINS / BARS; i++) {
        sum += spread->counts[index * (BINS / BARS) + i];
    }
    return sum;
}

static void print_bars(const struct spread *spread)
{
    static const char stars[] = "**************************************************";
    for (unsigned i = 0; i < BARS; i++) {
        double share = (double)bar(spread, i) / (double)spread->values;
        double edge = spread->low + (spread->high / BARS - spread->low / BARS) * i;
        printf("%14.6g  %5.1f %%  %.*s\n", edge, 100 * share, (int)lround(share * BAR_WIDTH),
               stars);
    }
}

static void print_text(const struct scan *scan, const struct spread *spread)
{
    char orientation[4];
    scan_orientation_text(scan, orientation);
    printf("file         %s\n", scan->file);
    printf("format       %s\n", scan->format);
    printf("size         %u x %u x %u\n", scan->size[0], scan->size[1], scan->size[2]);
    printf("type         %s\n", choice_name(element_names, (int)scan->type));
    printf("spacing      %g x %g x %g\n", scan->spacing[0], scan->spacing[1], scan->spacing[2]);
    printf("orientation  %s\n", scan->oriented ? orientation : "unknown");
    if (scan->levels != NULL) {
        printf("levels       %llu bytes\n", (unsigned long long)scan->level_bytes);
    }
    if (element_is_classified(scan->type)) {
        return;
    }
    printf("values       %g * stored + %g\n", scan->slope, scan->offset);
    printf("range        %g .. %g\n", spread->low, spread->high);
    printf("percentiles ");
    for (size_t i = 0; i < SHARES; i++) {
        printf(" %g%%:%g", 100 * shares[i], percentile(spread, shares[i]));
    }
    printf("\n");
    print_bars(spread);
}

/* All 256 bins; the text shows them in sixteens. */
static void report_spread(struct json *json, const struct spread *spread)
{
    int64_t counts[BINS];
    for (unsigned i = 0; i < BINS; i++) {
        counts[i] = (int64_t)spread->counts[i];
    }
    json_decimal(json, "low", spread->low);
    json_decimal(json, "high", spread->high);
    json_object(json, "percentiles");
    for (size_t i = 0; i < SHARES; i++) {
        char key[16];
        snprintf(key, sizeof key, "%g", 100 * shares[i]);
        json_decimal(json, key, percentile(spread, shares[i]));
    }
    json_close(json);
    json_integers(json, "histogram", counts, BINS);
}

static void write_report(const struct settings *settings, const struct scan *scan,
                         const struct spread *spread)
{
    struct json json;
    output out;
    output_open(&out, settings->json);
    json_begin(&json, &out);
    report_input(&json, scan);
    if (!element_is_classified(scan->type)) {
        report_spread(&json, spread);
    }
    json_end(&json);
    output_commit(&out);
}

static void write_freevoxel_report(const struct settings *settings,
                                   const struct freevoxel_file *file)
{
    struct json json;
    output out;
    output_open(&out, settings->json);
    json_begin(&json, &out);
    report_freevoxel_file(&json, file);
    json_end(&json);
    output_commit(&out);
}

static void tell_freevoxel_file(const struct settings *settings)
{
    struct freevoxel_file file;
    freevoxel_file_open(&file, settings->operands[0]);
    if (settings->json != NULL) {
        write_freevoxel_report(settings, &file);
    } else {
        print_freevoxel_file(&file);
    }
    freevoxel_file_close(&file);
}

int command_info(const struct settings *settings)
{
    struct scan scan;
    struct spread spread = {0};
    bool raw = settings->raw.size[0] != 0 || settings->raw.type != 0;
    if (!raw && freevoxel_file_is(settings->operands[0])) {
        tell_freevoxel_file(settings);
        finish_output();
    }
    input_read(&scan, settings->operands[0], &settings->raw);
    if (!element_is_classified(scan.type)) {
        measure(&spread, &scan);
    }
    if (settings->json != NULL) {
        write_report(settings, &scan, &spread);
    } else {
        print_text(&scan, &spread);
    }
    scan_free(&scan);
    finish_output();
}
