# What both AVR targets share: an ATmega1284P, simulated to the cycle: 8 bits, int of 16;
# 128 KB of flash, which holds tables and descriptors, and 16 KB of RAM. Start-up and
# memory functions are avr-libc's. A target sets TARGET_OPTIONS, which say
# where volumes lie, and TARGET_FIRMWARE, and includes this file.
TARGET_PACKAGES := gcc-avr avr-libc libsimavr-dev libelf-dev
TARGET_BOARD := atmega1284p
TARGET_CPU := -mmcu=$(TARGET_BOARD)
TARGET_LEVELS := -Os
TARGET_CC := avr-gcc
TARGET_AR := avr-ar

OPTIMISE ?= -Os
TARGET_CFLAGS := $(TARGET_CPU) $(OPTIMISE) -ffreestanding -ffunction-sections \
	-fdata-sections -Iport/avr -DFX_TABLE_HEADER='"flash_table.h"' $(TARGET_OPTIONS) $(CFLAGS)

TARGET_PORT_CFLAGS := -DF_CPU=16000000UL -Wa,-I$(OUT)
TARGET_PORT_FOLDER := port/avr
TARGET_BALL := port/avr/ball_flash.c
TARGET_PORT := $(addprefix $(TARGET_PORT_FOLDER)/,usart.c simulator.c) port/console.c port/crc32.c

TARGET_LDFLAGS := $(TARGET_CPU) -Wl,--gc-sections -T toolchain/$(TARGET_BOARD).ld
TARGET_SCRIPTS := toolchain/$(TARGET_BOARD).ld

TARGET_EMULATOR = $(AVR_SIMULATOR) $(TARGET_BOARD)
TARGET_EMULATOR_NEEDS = $(AVR_SIMULATOR)
TARGET_COUNT := out=
