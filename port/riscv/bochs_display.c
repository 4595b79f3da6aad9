/*
 * bochs_display.c - finds its two memories a place, tells it its size, and copies rows.
 *
 * Registers: PCI Local Bus 3.0, 6.1 (configuration space); QEMU's docs/specs/standard-vga.rst
 * (the Bochs display's).
 */
#include "bochs_display.h"

#define REGISTER16(address) (*(volatile uint16_t *)(address))
#define REGISTER32(address) (*(volatile uint32_t *)(address))

#define CONFIGURATION 0x30008000u /* of slot 1 on the board's PCI bus 0 */
#define PIXELS        0x40000000u /* in the board's window for PCI memory */
#define CONTROL       0x41000000u

/* Of the configuration space. */
enum { PCI_COMMAND = 0x04, PCI_PIXELS = 0x10, PCI_CONTROL = 0x18 };
enum { COMMAND_MEMORY = 2 };

/* Numbers of the 16-bit registers that set the picture. */
enum { FIRST_REGISTER = 0x500 };
enum { WIDTH = 1, HEIGHT = 2, PIXEL_BITS = 3, ENABLE = 4, ROW_PIXELS = 6 };
enum { ENABLED = 0x01, LINEAR = 0x40 };

static void set(uint32_t number, uint32_t value)
{
    REGISTER16(CONTROL + FIRST_REGISTER + 2u * number) = (uint16_t)value;
}

void panel_start(void)
{
    REGISTER32(CONFIGURATION + PCI_PIXELS) = PIXELS;
    REGISTER32(CONFIGURATION + PCI_CONTROL) = CONTROL;
    REGISTER32(CONFIGURATION + PCI_COMMAND) |= COMMAND_MEMORY;
    set(ENABLE, 0); /* the size changes while it is off */
    set(WIDTH, PANEL_WIDTH);
    set(HEIGHT, PANEL_HEIGHT);
    set(PIXEL_BITS, 32);
    set(ROW_PIXELS, PANEL_WIDTH);
    set(ENABLE, ENABLED | LINEAR);
}

void panel_rows(uint32_t top, const uint8_t *pixels, uint32_t rows)
{
    volatile uint8_t *to = (volatile uint8_t *)(PIXELS + top * PANEL_ROW_BYTES);
    for (const uint8_t *end = pixels + rows * PANEL_ROW_BYTES; pixels < end; pixels++)
        *to++ = *pixels;
}
