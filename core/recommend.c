#include "qvol.h"

#include "recommend_table.h"

#define LEVEL        0x01010101u /* opacity of 1 / 255 */
#define LEAST_SLICES 64u
#define MOST_SLICES  ((uint32_t)LEAST_SLICES << (2u * (RECOMMEND_COLUMNS - 1u)))

/* What a channel holds, in the table's order: bits, or 8-bit levels with fraction bits. */
typedef enum { STATE_5, STATE_6, STATE_8, STATE_8_4, STATE_8_8, STATE_8_16, STATES } state;

FX_TABLE uint16_t bits_of[STATES] = {5, 6, 8, 12, 16, 24};

/* The states of frame buffers of 8 bits are levels with their residual as a fraction. */
static state state_of(uint8_t bits, uint8_t residual_bits)
{
    unsigned all = bits == 8 ? (unsigned)bits + residual_bits : bits, of = STATE_5;
    while (of < STATES && fx_table16(&bits_of[of]) != all)
        of++;
    return (state)of;
}

/* Row 0, and one more from 1 level on, from 4, 16 ... */
static unsigned row_of(uint32_t opacity)
{
    unsigned row = 0;
    while (row + 1u < RECOMMEND_ROWS && opacity >= LEVEL << 2u * row)
        row++;
    return row;
}

/* Column 0 for up to 64 slices, 1 for up to 256 ... */
static unsigned column_of(uint16_t slices)
{
    unsigned column = 0;
    while (slices > LEAST_SLICES << 2u * column)
        column++;
    return column;
}

static qv_advice advice_of(state of, unsigned row, uint8_t bits)
{
    if (of == STATE_8_16)
        return QV_ADVICE_ROUND;
    if (row >= fx_table16(&recommend_plain[of]))
        return QV_ADVICE_PLAIN;
    return bits == 8 && of != STATE_8 ? QV_ADVICE_RESIDUAL : QV_ADVICE_DITHER;
}

qv_status qv_recommend(qv_recommendation *recommendation, uint8_t bits, uint8_t residual_bits,
                       uint16_t slices, uint32_t opacity)
{
    state of = state_of(bits, residual_bits);
    if (!recommendation)
        return QV_ERROR_NULL;
    if (of == STATES || (residual_bits != 0 && residual_bits != 4 && residual_bits != 8))
        return QV_ERROR_SIZE;
    if (slices == 0 || slices > MOST_SLICES || opacity == 0)
        return QV_ERROR_SLICE;

    unsigned row = row_of(opacity), cell = of * RECOMMEND_ROWS + row;
    qv_advice advice = advice_of(of, row, bits);
    uint16_t fog = fx_table16(&recommend_fog[cell]); /* of any number of slices */
    uint16_t worst = fx_table16(&recommend_worst[cell * RECOMMEND_COLUMNS + column_of(slices)]);
    int dithers = advice == QV_ADVICE_DITHER || advice == QV_ADVICE_RESIDUAL;
    recommendation->advice = advice;
    recommendation->sequence = dithers ? qv_sequence_blocks : qv_sequence_rounded;
    recommendation->worst_fog = fog < worst ? fog : worst;
    recommendation->worst = worst;
    return QV_OK;
}
