/*
 * functions_device.c - instructions of each fixed-point function: one measured region
 * (port/measure.h) for each, CALLS calls over its domain, the loop included; the
 * first region is the empty loop. Prints a line for each: name and checksum of the
 * results, which is the same on every machine.
 */
#include "fx_correct.h"
#include "fx_log.h"
#include "fx_phi.h"
#include "measure.h"
#include "console.h"

enum { CALLS = 256 };

/* A call of one function for the sample number i of 0 .. CALLS - 1. */
typedef uint32_t subject(uint32_t i);

static uint32_t nothing(uint32_t i)
{
    return i;
}

/* Depths in 0 .. 16, more of them low. */
static fx_depth depth_of(uint32_t i)
{
    return (fx_depth)(i * i) << 20;
}

static uint32_t transmittance(uint32_t i)
{
    return fx_transmittance(depth_of(i));
}

static uint32_t transmittance16(uint32_t i)
{
    return fx_transmittance16((i * i) << 12);
}

static uint32_t depth(uint32_t i)
{
    fx_depth depth_of_i = fx_depth_of_transmittance(i << 24);
    return (uint32_t)(depth_of_i >> 32) ^ (uint32_t)depth_of_i;
}

static uint32_t extinction16(uint32_t i)
{
    return fx_extinction_of_unorm16((fx_unorm16)(i << 8));
}

static uint32_t extinction8(uint32_t i)
{
    return fx_extinction_of_unorm8((fx_unorm8)i);
}

static uint32_t phi(uint32_t i)
{
    return fx_phi(depth_of(i));
}

static uint32_t correct_opacity(uint32_t i)
{
    return fx_correct_opacity((fx_unorm16)(i << 8), 0x6000);
}

static uint32_t correct_colour(uint32_t i)
{
    return fx_correct_colour((fx_unorm16)(i << 8), 0x6000);
}

/* The calls go through a pointer, so that no function dissolves in the loop. */
static uint32_t run(subject *function)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < CALLS; i++)
        sum = sum * 31u + function(i);
    return sum;
}

int main(void)
{
    static const struct {
        const char *name;
        subject *function;
    } subjects[] = {
        {"nothing", nothing},
        {"transmittance", transmittance},
        {"transmittance16", transmittance16},
        {"depth", depth},
        {"extinction16", extinction16},
        {"extinction8", extinction8},
        {"phi", phi},
        {"correct_opacity", correct_opacity},
        {"correct_colour", correct_colour},
    };
    for (unsigned i = 0; i < sizeof subjects / sizeof *subjects; i++) {
        measure_begin();
        uint32_t sum = run(subjects[i].function);
        measure_end();
        console_text(subjects[i].name);
        console_text(" ");
        console_decimal(sum);
        console_text("\n");
    }
    return 0;
}
