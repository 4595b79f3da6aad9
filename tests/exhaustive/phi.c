/*
 * phi at every position that its table can be read at: 2^32 of each octave. That it
 * never rises is looked at everywhere; so the error, which is at every 256th, can be
 * no greater between them than at them by more than phi falls there, 2^-26.
 */
#include "check.h"
#include "deviation.h"
#include "fx_phi.h"
#include "phi_exact.h"

#define WHOLE ((fx_depth)1 << 32)

/* Depths from .. to in steps of the table's positions. */
static void look(deviation *d, fx_depth from, fx_depth to, unsigned step)
{
    uint32_t last = fx_phi(from - (from != 0));
    for (fx_depth depth = from; depth <= to; depth += step) {
        const uint32_t phi = fx_phi(depth);
        if (phi > last)
            fail_msg("rises at %ju", (uintmax_t)depth);
        last = phi;
        if (depth % (256u * step) == 0)
            deviation_add(d, phi, ldexpl(phi_exact(depth), 31));
    }
}

static void every_position(void **state)
{
    deviation d = {0, 0, 0, 0};
    (void)state;
    look(&d, 0, 2 * WHOLE, 2);
    for (unsigned octave = 1; octave < 6; octave++)
        look(&d, WHOLE << octave, 2 * WHOLE << octave, 1u << octave);
    deviation_print(&d, "phi, units of 2^-16", 32768);
    assert_true(ldexp(d.worst, -15) <= .02);
}

/* From 32 on all octaves read the same row, shifted. */
static void later_octaves(void **state)
{
    (void)state;
    for (fx_depth depth = 32 * WHOLE; depth < 64 * WHOLE; depth += 65521)
        for (unsigned octave = 1; octave <= 26; octave++) {
            const uint32_t phi = fx_phi(depth), shifted = fx_phi(depth << octave);
            const uint32_t low = phi >> octave;
            if (shifted < low || shifted > low + 1)
                fail_msg("%ju << %u", (uintmax_t)depth, octave);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_position),
        cmocka_unit_test(later_octaves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
