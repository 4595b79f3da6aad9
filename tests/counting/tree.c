#include "tree.h"

static tree_number number(int64_t bits)
{
    tree_number n = {bits};
    return n;
}

static tree_number add(tree_number a, tree_number b)
{
    FX_COUNT(fx_additions);
    return number(a.bits + b.bits);
}

static tree_number subtract(tree_number a, tree_number b)
{
    FX_COUNT(fx_additions);
    return number(a.bits - b.bits);
}

static tree_number multiply(tree_number a, tree_number b)
{
    FX_COUNT(fx_multiplications);
    return number(a.bits * b.bits);
}

/* a + f * (b - a), with 8 fraction bits more: 1M 2A. */
static tree_number interpolate(tree_number a, tree_number b, uint8_t fraction)
{
    tree_number a_scaled = number(a.bits * 256);
    return add(a_scaled, multiply(number(fraction), subtract(b, a)));
}

/* Four interpolations in x, two in y, one in z. */
static tree_number tree(const tree_number corner[8], const uint8_t fraction[3])
{
    tree_number level[8];
    for (unsigned i = 0; i < 8; i++)
        level[i] = corner[i];
    for (unsigned axis = 0; axis < 3; axis++)
        for (unsigned i = 0; i < 4u >> axis; i++)
            level[i] = interpolate(level[2 * i], level[2 * i + 1], fraction[axis]);
    return level[0];
}

void tree_separate(tree_number result[4], uint8_t rgba[8][4], const uint8_t fraction[3])
{
    tree_number corner[8];
    for (unsigned c = 0; c < 4; c++) {
        for (unsigned i = 0; i < 8; i++)
            corner[i] = number(rgba[i][c]);
        result[c] = tree(corner, fraction);
    }
}

void tree_weighted(tree_number result[4], uint8_t rgba[8][4], const uint8_t fraction[3])
{
    tree_number corner[8];
    for (unsigned c = 0; c < 4; c++) {
        for (unsigned i = 0; i < 8; i++) {
            corner[i] = number(rgba[i][c]);
            if (c < 3)
                corner[i] = multiply(corner[i], number(rgba[i][3]));
        }
        result[c] = tree(corner, fraction);
    }
}
