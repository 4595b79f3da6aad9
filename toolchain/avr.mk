# ATmega1284P, simulated to the cycle: 8 bits, int of 16; 128 KB of flash, which holds the
# tables, 16 KB of RAM. Start-up and memory functions are avr-libc's.
TARGET_PACKAGES := gcc-avr avr-libc libsimavr-dev libelf-dev
TARGET_BOARD := atmega1284p
TARGET_CC := avr-gcc
TARGET_AR := avr-ar

OPTIMISE ?= -Os
TARGET_CFLAGS := -mmcu=$(TARGET_BOARD) $(OPTIMISE) -ffreestanding -ffunction-sections \
	-fdata-sections -Iport/avr -DFX_TABLE_HEADER='"flash_table.h"' $(CFLAGS)

TARGET_PORT_CFLAGS := -DF_CPU=16000000UL
TARGET_PORT_FOLDER := port/avr
TARGET_PORT := $(addprefix $(TARGET_PORT_FOLDER)/,usart.c simulator.c) port/console.c

TARGET_LDFLAGS := -mmcu=$(TARGET_BOARD) -Wl,--gc-sections

TARGET_FIRMWARE := functions
