/*
 * golden_device.c - a set of golden scenes on a device. On the console a line for each scene: its
 * number and, for each way to render it, the checksum, or the status where the library refuses:
 *     3 1c7c5ef3 1c7c5ef3 error12
 *
 * tests/device/golden.sh compares them with golden.h. So neither what is expected nor the scenes'
 * names take memory of the device.
 */
#include "golden_device.h"
#include "console.h"

/* A slow machine does with the first of them. */
#ifndef GOLDEN_DEVICE_WAYS
#define GOLDEN_DEVICE_WAYS GOLDEN_WAYS
#endif

/* As the storages of voxels want it; an AVR aligns no type by itself. */
static golden_memory memory __attribute__((aligned(4)));
static golden_scene golden;

static void render(golden_way way)
{
    uint32_t checksum = 0;
    qv_status status = golden.render(&checksum, &memory, &golden, way);
    if (status == QV_OK) {
        console_text(" ");
        console_hexadecimal(checksum);
    } else {
        console_text(" error");
        console_decimal((uint32_t)-status);
    }
}

void golden_run(const golden_set *set)
{
    for (uint32_t number = set->first; number < set->end; number++) {
        golden_describe(&golden, set, number);
        if (!golden.mode->sampling) /* another program's */
            continue;
        console_decimal(number);
        for (unsigned way = 0; way < GOLDEN_DEVICE_WAYS; way++)
            render((golden_way)way);
        console_text("\n");
    }
}
