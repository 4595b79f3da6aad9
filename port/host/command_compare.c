/*
 * command_compare.c - how far two pictures differ.
 */
#include "commands.h"
#include "error.h"
#include "json.h"
#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHANNELS_MOST  4
#define EXIT_DIFFERENT 1

struct difference {
    unsigned channels;
    unsigned most[CHANNELS_MOST];
    double rms[CHANNELS_MOST];
    uint64_t pixels;
    uint64_t equal; /* pixels with all channels within the tolerance */
};

static const char *channel_name(unsigned channels, unsigned channel)
{
    static const char *const names[CHANNELS_MOST + 1][CHANNELS_MOST] = {
        {""},
        {"grey"},
        {"grey", "alpha"},
        {"red", "green", "blue"},
        {"red", "green", "blue", "alpha"}};
    return names[channels][channel];
}

/* Pictures of different kinds have no difference that means anything. */
static void check_alike(const struct picture *a, const struct picture *b,
                        const struct settings *settings)
{
    if (a->width != b->width || a->height != b->height || a->channels != b->channels) {
        data_error(settings->operands[1], "size", "%u x %u x %u channels, not %u x %u x %u as %s",
                   b->width, b->height, b->channels, a->width, a->height, a->channels,
                   settings->operands[0]);
    }
}

/* 0 .. 255. */
static unsigned absolute_difference(uint8_t a, uint8_t b)
{
    return a > b ? (unsigned)(a - b) : (unsigned)(b - a);
}

static void measure(struct difference *difference, const struct picture *a, const struct picture *b,
                    double tolerance)
{
    uint64_t squares[CHANNELS_MOST] = {0, 0, 0, 0}; /* at most 2^16 * 2^30 */
    memset(difference, 0, sizeof *difference);
    difference->channels = a->channels;
    difference->pixels = (uint64_t)a->width * a->height;
    for (uint64_t pixel = 0; pixel < difference->pixels; pixel++) {
        unsigned largest = 0;
        for (unsigned c = 0; c < a->channels; c++) {
            uint64_t place = pixel * a->channels + c;
            unsigned off = absolute_difference(a->pixels[place], b->pixels[place]);
            squares[c] += off * off;
            difference->most[c] = off > difference->most[c] ? off : difference->most[c];
            largest = off > largest ? off : largest;
        }
        difference->equal += largest <= tolerance;
    }
    for (unsigned c = 0; c < a->channels; c++) {
        difference->rms[c] = sqrt((double)squares[c] / (double)difference->pixels);
    }
}

/* Alpha shows no difference: the picture stays opaque. */
static void write_difference(const struct picture *a, const struct picture *b,
                             const struct settings *settings)
{
    picture_writer *writer = picture_writer_by_name(settings->output);
    bool alpha = a->channels % 2 == 0;
    uint64_t bytes = (uint64_t)a->width * a->height * a->channels;
    struct picture picture;
    output out;
    picture_create(&picture, a->width, a->height, a->channels);
    for (uint64_t i = 0; i < bytes; i++) {
        double level = absolute_difference(a->pixels[i], b->pixels[i]) * settings->gain;
        bool is_alpha = alpha && i % a->channels == a->channels - 1;
        picture.pixels[i] = is_alpha || level > 255 ? 255 : (uint8_t)lround(level);
    }
    output_open(&out, settings->output);
    (writer != NULL ? writer : write_pam)(&out, &picture);
    output_commit(&out);
    free(picture.pixels);
}

static double equal_percent(const struct difference *difference)
{
    return 100 * (double)difference->equal / (double)difference->pixels;
}

static void print_text(const struct difference *difference)
{
    for (unsigned c = 0; c < difference->channels; c++) {
        printf("%-6s max %3u  rms %.4f\n", channel_name(difference->channels, c),
               difference->most[c], difference->rms[c]);
    }
    printf("equal  %.4f %% of %llu pixels\n", equal_percent(difference),
           (unsigned long long)difference->pixels);
}

static void write_report(const struct difference *difference, const char *name)
{
    struct json json;
    output out;
    output_open(&out, name);
    json_begin(&json, &out);
    json_array(&json, "channels");
    for (unsigned c = 0; c < difference->channels; c++) {
        json_object(&json, NULL);
        json_text(&json, "name", channel_name(difference->channels, c));
        json_integer(&json, "max", difference->most[c]);
        json_decimal(&json, "rms", difference->rms[c]);
        json_close(&json);
    }
    json_close(&json);
    json_unsigned(&json, "pixels", difference->pixels);
    json_unsigned(&json, "equal", difference->equal);
    json_end(&json);
    output_commit(&out);
}

/* What can be refused before anything is read. */
static void check_output(const struct settings *settings)
{
    const char *name = settings->output;
    if (name != NULL && !is_standard_stream(name) && picture_writer_by_name(name) == NULL) {
        usage_error("--output", "'%s' ends neither in .png nor in .pam", name);
    }
    if (name != NULL && settings->json != NULL && strcmp(name, settings->json) == 0) {
        usage_error("--json", "report and picture cannot both go to '%s'", name);
    }
}

/* Fails where there was a difference, as where a picture cannot be read. */
int command_compare(const struct settings *settings)
{
    struct picture a, b;
    struct difference difference;
    check_output(settings);
    picture_read(&a, settings->operands[0]);
    picture_read(&b, settings->operands[1]);
    check_alike(&a, &b, settings);
    measure(&difference, &a, &b, settings->tolerance);
    if (settings->output != NULL) {
        write_difference(&a, &b, settings);
    }
    if (settings->json != NULL) {
        write_report(&difference, settings->json);
    } else if (!settings->quiet &&
               !(settings->output != NULL && is_standard_stream(settings->output))) {
        print_text(&difference);
    }
    free(a.pixels);
    free(b.pixels);
    if (fflush(stdout) != 0) {
        system_error("standard output", NULL);
    }
    return difference.equal == difference.pixels ? EXIT_SUCCESS : EXIT_DIFFERENT;
}
