/*
 * usart.c - the console is the first serial port: 8 bits, no parity, 1 stop bit.
 */
#include "console.h"

#include <avr/io.h>

/* Divides the usual crystals, 8 and 16 MHz, exactly. */
#define BAUD 250000u

static void start(void)
{
    UBRR0 = F_CPU / (8u * BAUD) - 1u; /* 8 clocks a bit at double speed */
    UCSR0A = _BV(U2X0);
    UCSR0B = _BV(TXEN0);
}

void console_text(const char *text)
{
    if (!(UCSR0B & _BV(TXEN0)))
        start();
    for (; *text != '\0'; text++) {
        while (!(UCSR0A & _BV(UDRE0)))
            ;
        UDR0 = (uint8_t)*text;
    }
}
