# ATmega1284P, 8 bits: volumes lie in program memory.
TARGET_OPTIONS := -DQV_MEMORY_HEADER='"volume_flash.h"'
TARGET_GOLDEN :=
TARGET_BENCH_MODES := tests/bench/bench_modes_few.c
TARGET_FIRMWARE := bench float functions blends planet ball pages freevoxels
include toolchain/shared/avr.mk

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
