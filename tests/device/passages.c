/*
 * passages.c - qv_passage_under of the library, which may be a twin in assembly, beside the one in
 * C: millions of samples of random passages, those of impossible colours too.
 */
#define qv_passage_under qv_passage_under_in_c
#undef QV_PASSAGE_HEADER
#include "passage_under.c"
#undef qv_passage_under

#include "console.h"

void qv_passage_under(qv_passage *passage);

enum { EDGE = 4, VOXELS = EDGE * EDGE * EDGE, PASSAGES = 400000, SAMPLES_MOST = 12 };

static uint32_t words[VOXELS];

static uint32_t random_next(void)
{
    static uint32_t state = 2026;
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

/* Bits that are often all 0 or all 1. */
static uint32_t random_extreme(void)
{
    uint32_t bits = random_next();
    switch (random_next() >> 28) {
    case 0:
        return 0;
    case 1:
        return 0xFFFFFFFFu;
    case 2:
        return bits & random_next() & random_next();
    default:
        return bits;
    }
}

/* Opaque, clear, thin or any voxels; one of eight volumes has colours above opacities. */
static void random_voxels(void)
{
    uint32_t kind = random_next() >> 29;
    for (uint32_t i = 0; i < VOXELS; i++) {
        uint32_t opacity = kind < 2 ? random_next() & 3u : random_extreme() & 255u;
        uint32_t word = opacity;
        for (unsigned c = 0; c < 3; c++)
            word = word << 8 | (kind == 7 ? random_next() & 255u : random_next() % (opacity + 1u));
        words[i] = word; /* opacity is the highest byte */
    }
}

/* One axis: from the second voxel of four to the next one or the one before, at any sample; less
   than 1/16 voxel a sample, so that no other is reached. */
static void random_axis(qv_passage *passage, unsigned axis)
{
    uint32_t advance = 1u + (random_extreme() >> 5);
    passage->next[axis] = random_next() >> 30 == 0 ? 0 : (qv_offset)4 << (2u * axis);
    passage->place[axis] = random_extreme();
    passage->advance[axis] = advance;
    if (random_next() >> 31 == 0)
        return;
    passage->advance[axis] = 0u - advance;
    passage->step -= passage->next[axis];
}

static void random_passage(qv_passage *passage)
{
    passage->step = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        random_axis(passage, axis);
        passage->light[axis] = random_next() & 0xFFFFFFu;
    }
    passage->base = (qv_address)&words[1 + EDGE + EDGE * EDGE];
    passage->transmittance = random_next() >> 31 ? QV_UNDIMMED : random_extreme() % QV_UNDIMMED;
    passage->samples = 1u + random_next() % SAMPLES_MOST;
    passage->enough = QV_NOTHING;
    if (random_next() >> 31 == 0)
        passage->enough += (QV_WHOLE >> 16) * (random_next() >> 17);
    passage->skipped = random_next();
}

static int same(const qv_passage *a, const qv_passage *b)
{
    return a->light[0] == b->light[0] && a->light[1] == b->light[1] && a->light[2] == b->light[2] &&
           a->transmittance == b->transmittance && a->samples == b->samples &&
           a->skipped == b->skipped && a->enough == b->enough && a->step == b->step;
}

int main(void)
{
    uint32_t different = 0, samples = 0;
    for (uint32_t i = 0; i < PASSAGES; i++) {
        qv_passage passage, in_c;
        if (i % 64 == 0)
            random_voxels();
        random_passage(&passage);
        in_c = passage;
        samples += passage.samples;
        qv_passage_under(&passage);
        qv_passage_under_in_c(&in_c);
        samples -= passage.samples;
        different += !same(&passage, &in_c);
    }
    console_text("# ");
    console_decimal(samples);
    console_text(different == 0 ? " samples\nok" : " samples\nnot ok");
    console_text(" 1 - passages are what they are in C\n1..1\n");
    return different != 0;
}
