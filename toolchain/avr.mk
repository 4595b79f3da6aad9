# ATmega1284P, simulated to the cycle: 8 bits, int of 16; 128 KB of flash, which holds tables
# and volumes, 16 KB of RAM. Start-up and memory functions are avr-libc's.
TARGET_PACKAGES := gcc-avr avr-libc libsimavr-dev libelf-dev
TARGET_BOARD := atmega1284p
TARGET_CC := avr-gcc
TARGET_AR := avr-ar

OPTIMISE ?= -Os
TARGET_CFLAGS := -mmcu=$(TARGET_BOARD) $(OPTIMISE) -ffreestanding -ffunction-sections \
	-fdata-sections -Iport/avr -DFX_TABLE_HEADER='"flash_table.h"' \
	-DQV_MEMORY_HEADER='"volume_flash.h"' $(CFLAGS)

TARGET_PORT_CFLAGS := -DF_CPU=16000000UL -Wa,-I$(OUT)
TARGET_PORT_FOLDER := port/avr
TARGET_BALL := port/avr/ball_flash.c
TARGET_PORT := $(addprefix $(TARGET_PORT_FOLDER)/,usart.c simulator.c) port/console.c port/crc32.c

TARGET_LDFLAGS := -mmcu=$(TARGET_BOARD) -Wl,--gc-sections -T toolchain/$(TARGET_BOARD).ld
TARGET_SCRIPTS := toolchain/$(TARGET_BOARD).ld

TARGET_EMULATOR = $(AVR_SIMULATOR) $(TARGET_BOARD)
TARGET_EMULATOR_NEEDS = $(AVR_SIMULATOR)
TARGET_COUNT := out=

TARGET_FIRMWARE := functions blends planet ball pages freevoxels

# ---- The planet in flash ----------------------------------------------------------

FIRMWARE_planet := $(addprefix port/avr/,firmware_planet.c planet_flash.c)
PLANET_WRITE := $(BUILD)/device/planet_write

$(PLANET_WRITE): $(addprefix tests/device/,planet_write.c planet.c planet_make.h) port/avr/planet.h
	@mkdir -p $(@D)
	@echo "  CC  $@"
	@$(HOST_CC) -std=c99 $(WARNINGS) -O2 -Icore -Ifixedpoint -Iport/avr \
		$(filter %.c,$^) fixedpoint/fx_dither.c -o $@

$(OUT)/planet.volume: $(PLANET_WRITE)
	@mkdir -p $(@D)
	@echo "  GEN $@"
	@$< $@

$(OUT)/port/avr/planet_flash.o: $(OUT)/planet.volume
