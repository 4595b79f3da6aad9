/*
 * corners.c - the entries of a cell, by hand and at random.
 */
#include "corners.h"

void set_weights(uint64_t w[8], const uint64_t f[3])
{
    const fx_fraction fraction[3] = {fx_fraction_of((uint32_t)f[0]), fx_fraction_of((uint32_t)f[1]),
                                     fx_fraction_of((uint32_t)f[2])};
    fx_weight weight[8];
    qv_weights(weight, fraction);
    for (unsigned q = 0; q < 8; q++)
        w[q] = fx_weight_bits(weight[q]);
}

void set_corners(corners *to, uint64_t channel[4][8], unsigned storage)
{
    for (unsigned q = 0; q < 8; q++) {
        for (unsigned c = 0; c < 4; c++) {
            to->narrow[q][c] = (uint8_t)channel[c][q];
            to->wide[q][c] = (uint16_t)channel[c][q];
        }
        to->at[q] = qv_channel_bytes(storage) == 1 ? to->narrow[q] : (qv_address)to->wide[q];
    }
}

static uint64_t full_of(unsigned bits)
{
    return ((uint64_t)1 << bits) - 1u;
}

void draw_corners(uint64_t f[3], uint64_t channel[4][8], vector_random *random, unsigned bits)
{
    unsigned kind = (unsigned)vector_bits(random, 2);
    for (unsigned axis = 0; axis < 3; axis++)
        f[axis] = kind == 1 ? vector_any(random, 8) : vector_bits(random, 8);
    for (unsigned c = 0; c < 4; c++)
        for (unsigned q = 0; q < 8; q++)
            channel[c][q] = kind == 1 ? vector_any(random, bits) : vector_bits(random, bits);
    for (unsigned q = 0; q < 8 && kind >= 2; q++)
        channel[3][q] = kind == 3 ? full_of(bits) : vector_bits(random, 1) * channel[3][q];
}

void corner_edges(vector_set *set, unsigned bits, add_corners *add)
{
    static const uint64_t places[3][3] = {{0, 0, 0}, {255, 255, 255}, {85, 170, 3}};
    const uint64_t values[4] = {0, 1, full_of(bits) / 2 + 1, full_of(bits)};
    for (unsigned place = 0; place < 3; place++)
        for (unsigned all = 0; all < 4; all++)
            for (unsigned one = 0; one < 4; one++) {
                uint64_t channel[4][8];
                for (unsigned i = 0; i < 32; i++)
                    channel[i / 8][i % 8] = values[all];
                channel[3][2 * place + 1] = values[one];
                add(set, places[place], channel);
            }
}

void lone_corners(vector_set *set, unsigned bits, add_corners *add)
{
    static const uint64_t place[3] = {77, 128, 200};
    for (unsigned lone = 0; lone < 8; lone++) {
        uint64_t channel[4][8];
        for (unsigned i = 0; i < 32; i++)
            channel[i / 8][i % 8] = i < 24 ? full_of(bits) - i : 0;
        channel[3][lone] = full_of(bits) / 2 + lone;
        add(set, place, channel);
    }
}
