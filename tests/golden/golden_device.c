/*
 * golden_device.c - a set of golden scenes on a device: TAP on the console.
 */
#include "golden.h"
#include "golden_device.h"
#include "console.h"

static golden_memory memory;

static void print_result(bool passed, uint32_t place, uint32_t number, const golden_scene *golden)
{
    const char *word[GOLDEN_WORDS];
    golden_name(word, golden);
    console_text(passed ? "ok " : "not ok ");
    console_decimal(place + 1);
    console_text(" - golden ");
    console_decimal(number);
    for (unsigned i = 0; i < GOLDEN_WORDS; i++) {
        console_text(i == 0 ? ": " : ", ");
        console_text(word[i]);
    }
    console_text("\n");
}

static void print_difference(qv_status status, golden_way way, uint32_t checksum)
{
    console_text("# ");
    console_text(golden_way_name[way]);
    console_text(": ");
    if (status != QV_OK) {
        console_text("error ");
        console_decimal((uint32_t)-status);
    } else {
        console_hexadecimal(checksum);
    }
    console_text("\n");
}

static bool check_scene(const golden_scene *golden, uint32_t expected)
{
    bool passed = true;
    for (unsigned way = 0; way < GOLDEN_WAYS; way++) {
        uint32_t checksum = 0;
        qv_status status = golden->render(&checksum, &memory, golden, (golden_way)way);
        if (status == QV_OK && checksum == expected)
            continue;
        print_difference(status, (golden_way)way, checksum);
        passed = false;
    }
    return passed;
}

int golden_run(const golden_set *set)
{
    int failures = 0;
    for (uint32_t number = set->first; number < set->end; number++) {
        golden_scene golden;
        golden_describe(&golden, set, number);
        bool passed = check_scene(&golden, golden_checksums[number]);
        print_result(passed, number - set->first, number, &golden);
        failures += passed ? 0 : 1;
    }
    console_text("1..");
    console_decimal(set->end - set->first);
    console_text("\n");
    return failures;
}
