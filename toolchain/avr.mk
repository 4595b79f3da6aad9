# ATmega1284P, 8 bits: volumes lie in program memory.
TARGET_OPTIONS := -DQV_MEMORY_HEADER='"volume_flash.h"'
TARGET_GOLDEN :=
TARGET_BENCH_MODES := tests/bench/bench_modes_few.c
# All modes, in five programs.
TARGET_BENCHES := $(addprefix bench_,rgba8 rgba16 indexed8 indexed8_16 stored)
BENCH_rgba8 := ALL(rgba8), BENCH_MODE(associated8, preweighted)
BENCH_rgba16 := ALL(rgba16)
BENCH_indexed8 := ALL(indexed8)
BENCH_indexed8_16 := ALL(indexed8_16)
BENCH_stored := STORED(rgbt8), STORED(rgbt16), STORED(indexed8_t8), STORED(indexed8_t16)
# Of long code, and of a small volume.
$(TARGET_BENCHES:%=$(OUT)/%.elf): TARGET_LDFLAGS += -Wl,--defsym=volumes_begin=0x1A000
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
