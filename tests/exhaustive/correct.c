/*
 * Correction of every opacity, for ratios from 1/16 to 16 that lie within 1/256 of
 * each other, and colour factors.
 */
#include "check.h"
#include "correct_exact.h"

static void every_opacity(void **state)
{
    static long double logarithm[65536];
    correct_errors errors = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
    unsigned count = 0;
    (void)state;

    for (uint32_t a = 0; a < 65535; a++)
        logarithm[a] = correct_logarithm(a);
    for (uint32_t ratio = FX_RATIO_LEAST; ratio <= FX_RATIO_GREATEST; ratio += ratio / 256) {
        for (uint32_t a = 0; a < 65536; a++)
            correct_measure(&errors, a, logarithm[a], ratio);
        count++;
    }
    printf("# %u ratios\n", count);
    correct_judge(&errors);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_opacity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
