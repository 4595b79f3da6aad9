#include "search.h"

#include <string.h>

#define RANDOM_INPUTS 200000
#define OF_ONE_NUMBER 16 /* times as many */
#define STARTS        48
#define RANDOM_PLACES 8 /* of a number, each time */
#define BITS          64

/* An input on its way up. */
typedef struct climber {
    uint64_t input[SEARCH_NUMBERS];
    double size; /* of its error; -1 where there is none */
} climber;

typedef struct climb {
    const search *search;
    unsigned parameter;
    uint64_t random;
    climber starts[STARTS];
} climb;

uint64_t random64(uint64_t *state)
{
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/* 0 .. most, uniform but for what a remainder of 64 bits is off. */
static uint64_t random_to(uint64_t *state, uint64_t most)
{
    const uint64_t number = random64(state);
    return most == UINT64_MAX ? number : number % (most + 1);
}

static unsigned width_of(uint64_t most)
{
    unsigned width = 0;
    for (; most != 0; most >>= 1)
        width++;
    return width;
}

static double size_of(const climb *c, const uint64_t input[])
{
    const double error = c->search->error(input, c->parameter);
    return isnan(error) ? -1 : fabs(error);
}

/* Takes the place of the least start. */
static void keep(climb *c, const climber *found)
{
    size_t least = 0;
    for (size_t i = 1; i < STARTS; i++)
        if (c->starts[i].size < c->starts[least].size)
            least = i;
    if (found->size > c->starts[least].size)
        c->starts[least] = *found;
}

static void try_random(measured *m, climb *c)
{
    const search *s = c->search;
    const uint32_t inputs = s->numbers == 1 ? RANDOM_INPUTS * OF_ONE_NUMBER : RANDOM_INPUTS;
    for (uint32_t n = 0; n < inputs; n++) {
        climber tried;
        for (unsigned i = 0; i < s->numbers; i++) {
            tried.input[i] = random_to(&c->random, s->most[i]);
            if (n % 2 != 0 && s->most[i] != 0)
                tried.input[i] >>= random_to(&c->random, width_of(s->most[i]) - 1);
        }
        tried.size = size_of(c, tried.input);
        if (tried.size < 0)
            continue;
        if (measured_add(m, tried.size))
            s->tell(m, tried.input, c->parameter);
        keep(c, &tried);
    }
}

/* Moves a number, if the error grows by that. */
static int move(const climb *c, climber *at, unsigned i, uint64_t value)
{
    const uint64_t old = at->input[i];
    if (value > c->search->most[i] || value == old)
        return 0;
    at->input[i] = value;
    const double size = size_of(c, at->input);
    if (size > at->size) {
        at->size = size;
        return 1;
    }
    at->input[i] = old;
    return 0;
}

/* One round of moves of a number; sums modulo 2^64 are refused with what is above most. */
static int move_about(climb *c, climber *at, unsigned i)
{
    const uint64_t most = c->search->most[i];
    int moved = move(c, at, i, 0) | move(c, at, i, most);
    for (unsigned bit = 0; bit < BITS && most >> bit != 0; bit++) {
        moved |= move(c, at, i, at->input[i] + ((uint64_t)1 << bit));
        moved |= move(c, at, i, at->input[i] - ((uint64_t)1 << bit));
    }
    for (unsigned n = 0; n < RANDOM_PLACES; n++)
        moved |= move(c, at, i, random_to(&c->random, most));
    return moved;
}

static void climb_up(climb *c, climber *at)
{
    int moved = 1;
    while (moved) {
        moved = 0;
        for (unsigned i = 0; i < c->search->numbers; i++)
            moved |= move_about(c, at, i);
    }
}

void search_worst(measured *m, const search *s, unsigned parameter)
{
    static climb c;
    memset(&c, 0, sizeof c);
    c.search = s;
    c.parameter = parameter;
    for (size_t i = 0; i < STARTS; i++)
        c.starts[i].size = -1;
    try_random(m, &c);
    for (size_t i = 0; i < STARTS; i++) {
        climb_up(&c, &c.starts[i]);
        if (measured_is_worse(m, c.starts[i].size))
            s->tell(m, c.starts[i].input, parameter);
    }
}
