/*
 * oled.c - SSD0323 on SSI0. Port C bit 7 chooses data (high) or command (low);
 * port D bit 0 selects the panel.
 *
 * Registers: LM3S6965 data sheet, chapters 6 (system control), 9 (GPIO) and
 * 14 (SSI). Commands: SSD0323 data sheet, section 9.
 */
#include "oled.h"

#define REGISTER(address) (*(volatile uint32_t *)(address))

#define RCGC1 REGISTER(0x400FE104u) /* clock gates of the serial ports */
#define RCGC2 REGISTER(0x400FE108u) /* clock gates of the GPIO ports */

#define SSI0_CR0  REGISTER(0x40008000u) /* frame format */
#define SSI0_CR1  REGISTER(0x40008004u) /* enable */
#define SSI0_DR   REGISTER(0x40008008u) /* data */
#define SSI0_SR   REGISTER(0x4000800Cu) /* status */
#define SSI0_CPSR REGISTER(0x40008010u) /* clock divider */

#define GPIO_C               0x40006000u
#define GPIO_D               0x40007000u
#define GPIO_DIRECTION(port) REGISTER((port) + 0x400u)
#define GPIO_DIGITAL(port)   REGISTER((port) + 0x51Cu)
/* A GPIO port's data register takes a mask of the pins from the address. */
#define GPIO_PINS(port, mask) REGISTER((port) + ((mask) << 2))

enum {
    RCGC1_SSI0 = 1 << 4,
    RCGC2_GPIO_C = 1 << 2,
    RCGC2_GPIO_D = 1 << 3,
    PIN_DATA = 1 << 7,
    PIN_SELECT = 1 << 0,
    CR0_8_BITS = 7,
    CR1_ENABLE = 2,
    SR_SEND_NOT_FULL = 2,
    SR_RECEIVED = 4,
    CLOCK_DIVIDER = 2,
};

enum {
    SET_COLUMNS = 0x15, /* then first and last, in pairs of pixels */
    SET_ROWS = 0x75,    /* then first and last */
    SET_REMAP = 0xA0,   /* then how memory maps to the panel */
    DISPLAY_ON = 0xAF,
    REMAP_NONE = 0x00, /* columns, nibbles and rows in rising order */
};

static void send(uint32_t byte)
{
    while ((SSI0_SR & SR_SEND_NOT_FULL) == 0)
        ;
    SSI0_DR = byte;
    while ((SSI0_SR & SR_RECEIVED) == 0)
        ;
    (void)SSI0_DR; /* the port receives as it sends; nobody wants that byte */
}

static void send_command(uint32_t byte)
{
    GPIO_PINS(GPIO_C, PIN_DATA) = 0;
    send(byte);
}

static void send_data(uint32_t byte)
{
    GPIO_PINS(GPIO_C, PIN_DATA) = PIN_DATA;
    send(byte);
}

void panel_start(void)
{
    RCGC1 |= RCGC1_SSI0;
    RCGC2 |= RCGC2_GPIO_C | RCGC2_GPIO_D;
    GPIO_DIRECTION(GPIO_C) |= PIN_DATA;
    GPIO_DIGITAL(GPIO_C) |= PIN_DATA;
    GPIO_DIRECTION(GPIO_D) |= PIN_SELECT;
    GPIO_DIGITAL(GPIO_D) |= PIN_SELECT;
    GPIO_PINS(GPIO_D, PIN_SELECT) = PIN_SELECT;
    SSI0_CR0 = CR0_8_BITS;
    SSI0_CPSR = CLOCK_DIVIDER;
    SSI0_CR1 = CR1_ENABLE;
    send_command(SET_REMAP);
    send_command(REMAP_NONE);
    send_command(DISPLAY_ON);
}

static void set_window(uint32_t top, uint32_t rows)
{
    send_command(SET_COLUMNS);
    send_command(0);
    send_command(PANEL_ROW_BYTES - 1);
    send_command(SET_ROWS);
    send_command(top);
    send_command(top + rows - 1);
}

void panel_rows(uint32_t top, const uint8_t *pixels, uint32_t rows)
{
    const uint8_t *end = pixels + rows * PANEL_ROW_BYTES;
    set_window(top, rows);
    while (pixels < end)
        send_data(*pixels++);
}
