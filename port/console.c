/*
 * console.c - numbers as text.
 */
#include "console.h"

/* By subtraction: a division would link a helper of the compiler's that is not
   the library's, and blur what `make size` reports. */
void console_decimal(uint32_t number)
{
    static const uint32_t places[] = {1000000000, 100000000, 10000000, 1000000, 100000,
                                      10000,      1000,      100,      10,      1};
    enum { PLACES = sizeof places / sizeof *places };
    char digits[PLACES + 1];
    char *end = digits;
    for (unsigned i = 0; i < PLACES; i++) {
        char digit = '0';
        for (; number >= places[i]; number -= places[i])
            digit++;
        if (digit != '0' || end != digits || i == PLACES - 1)
            *end++ = digit;
    }
    *end = '\0';
    console_text(digits);
}

void console_hexadecimal(uint32_t number)
{
    char digits[9];
    for (unsigned i = 0; i < 8; i++)
        digits[i] = "0123456789abcdef"[(number >> (28 - 4 * i)) & 15u];
    digits[8] = '\0';
    console_text(digits);
}
