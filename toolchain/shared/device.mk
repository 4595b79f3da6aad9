# Firmware of a device target. The Makefile includes this file where TARGET is a
# device, after the target's own file.
#
# It needs from the Makefile:
#     BUILD      top of everything built (build)
#     OUT        what is built for the target ($(BUILD)/$(TARGET))
#     LIBRARY    the library's archive, with a rule to make it
#     QVOL       the command (for the volume in the head's flash)
#     WARNINGS   the warning options of every C file
#     HOST_CC    the compiler of this machine (for the emulator's plugin)
# It offers:
#     firmware            every firmware of the target: TARGET_FIRMWARE
#     $(OUT)/NAME.elf     one of them, with its link map beside it
#     emulator            prints what runs a firmware, for toolchain/emulate
#     $(COUNT_PLUGIN)     the emulator's counting plugin
#     $(AVR_SIMULATOR)    the emulator of AVR
# What turns on boards with a panel is in toolchain/shared/head.mk.

COUNT_PLUGIN := $(BUILD)/emulator/count.so
AVR_SIMULATOR := $(BUILD)/emulator/avr

# Sources of each firmware beside the port and the library.
TARGET_BENCH_MODES ?= tests/bench/bench_modes.c
FIRMWARE_bench := tests/bench/bench_device.c $(TARGET_BENCH_MODES)
# Where the flash holds a part of all modes at a time: programs that hold BENCH_PART each.
TARGET_BENCHES ?= bench
BENCH_PARTS := $(patsubst bench_%,%,$(filter bench_%,$(TARGET_BENCHES)))
$(foreach part,$(BENCH_PARTS),$(eval FIRMWARE_bench_$(part) := tests/bench/bench_device.c \
	tests/bench/bench_modes.$(part).c))
FIRMWARE_float := tests/bench/float_device.c
FIRMWARE_functions := tests/bench/functions_device.c
FIRMWARE_marches := tests/device/marches.c
FIRMWARE_passages := tests/device/passages.c
FIRMWARE_blends := tests/bench/blends_device.c
TARGET_BALL ?= port/ball_flash.c
BALL_IN_FLASH := $(TARGET_BALL) port/ball.c
FIRMWARE_ball := port/firmware_ball.c $(BALL_IN_FLASH)
FIRMWARE_pages := port/firmware_pages.c $(BALL_IN_FLASH)
FIRMWARE_freevoxels := tests/bench/freevoxels_device.c $(BALL_IN_FLASH)
ifdef TARGET_PANEL
TARGET_FIRMWARE += head picture
ON_PANEL := port/panel_show.c $(TARGET_PORT_FOLDER)/$(TARGET_PANEL).c
FIRMWARE_picture := port/firmware_picture.c $(ON_PANEL) $(BALL_IN_FLASH)
FIRMWARE_head := port/firmware_head.c $(ON_PANEL) $(OUT)/head.c
endif

# What the target's own marches compute beside what C does.
TARGET_FIRMWARE += $(if $(MARCH),marches)

# A program for each set of golden scenes, or for the part of a set whose voxels are of some
# storages, where the flash holds no more: SET or SET.PART in TARGET_GOLDEN.
TARGET_GOLDEN ?= steps lengths bsplines slices splats preweighted
GOLDEN_PARTS := direct8 direct16 indexed8 indexed16 narrow wide
STORAGES_narrow := DIRECT8|INDEXED8
STORAGES_wide := DIRECT16|INDEXED16
GOLDEN_ON_DEVICE := golden_device.c scenes.c volume.c render.c
GOLDEN_slices := render_slices.c
GOLDEN_splats := draw_splats.c render_splats.c
golden_sources = $(addprefix tests/golden/,$(GOLDEN_ON_DEVICE) $(GOLDEN_$(basename $(1))) \
	golden_$(basename $(1))_device.c set_$(1).c)
$(foreach set,$(TARGET_GOLDEN),$(eval FIRMWARE_golden_$(set) := $(call golden_sources,$(set))))
TARGET_FIRMWARE += $(TARGET_GOLDEN:%=golden_%)

DEVICE_CFLAGS = -std=c99 $(WARNINGS) -MMD -MP $(TARGET_CFLAGS) $(MARCH_CFLAGS) $(TARGET_PORT_CFLAGS) \
	-Icore -Ifixedpoint -Iport -I$(TARGET_PORT_FOLDER) -I$(OUT)
DEVICE_OBJECTS := $(TARGET_PORT:%.c=$(OUT)/%.o)
DEVICE_OPTIONS := $(call remember,$(OUT)/device-options,$(TARGET_CC) $(DEVICE_CFLAGS) $(TARGET_LDFLAGS))

include tests/size/size.mk

# Objects of sources in the tree, and of generated ones, which lie in $(OUT).
objects = $(patsubst %.c,$(OUT)/%.o,$(1:$(OUT)/%=%))

.PHONY: firmware golden
firmware: $(TARGET_FIRMWARE:%=$(OUT)/%.elf)

golden: $(TARGET_GOLDEN:%=$(OUT)/golden_%.elf)

$(OUT)/port/%.o: port/%.c $(DEVICE_OPTIONS)
	@mkdir -p $(@D)
	@echo "  CC  $<"
	@$(TARGET_CC) $(DEVICE_CFLAGS) -c $< -o $@

$(OUT)/tests/%.o: tests/%.c $(DEVICE_OPTIONS)
	@mkdir -p $(@D)
	@echo "  CC  $<"
	@$(TARGET_CC) $(DEVICE_CFLAGS) -c $< -o $@

define compile_golden_part
$(OUT)/tests/golden/set_%.$(1).o: tests/golden/set_%.c $(DEVICE_OPTIONS)
	@mkdir -p $$(@D)
	@echo "  CC  $$< $(1)"
	@$(TARGET_CC) $(DEVICE_CFLAGS) -D'GOLDEN_STORAGES=$(or $(STORAGES_$(1)),$(2))' -c $$< -o $$@
endef
$(foreach part,$(GOLDEN_PARTS),$(eval $(call compile_golden_part,$(part),$(shell echo $(part) | tr a-z A-Z))))

define compile_bench_part
$(OUT)/tests/bench/bench_modes.$(1).o: tests/bench/bench_modes.c $(DEVICE_OPTIONS)
	@mkdir -p $$(@D)
	@echo "  CC  $$< $(1)"
	@$(TARGET_CC) $(DEVICE_CFLAGS) -D'BENCH_MODES=$$(BENCH_$(1))' -c $$< -o $$@
endef
$(foreach part,$(BENCH_PARTS),$(eval $(call compile_bench_part,$(part))))

$(OUT)/%.o: $(OUT)/%.c $(DEVICE_OPTIONS)
	@echo "  CC  $<"
	@$(TARGET_CC) $(DEVICE_CFLAGS) -c $< -o $@

define link_firmware
$(OUT)/$(1).elf: $(call objects,$(FIRMWARE_$(1))) $(DEVICE_OBJECTS) $(LIBRARY) $(TARGET_SCRIPTS)
	@echo "  LD  $$@"
	@$(TARGET_CC) $$(TARGET_LDFLAGS) -Wl,-Map,$$(@:.elf=.map) $$(filter %.o,$$^) $(LIBRARY) \
		$(TARGET_LDLIBS) -o $$@
-include $(patsubst %.o,%.d,$(call objects,$(FIRMWARE_$(1))))
endef
$(foreach name,$(sort $(TARGET_FIRMWARE) $(TARGET_BENCHES)),$(eval $(call link_firmware,$(name))))
-include $(DEVICE_OBJECTS:.o=.d)

# ---- The ball in flash ----------------------------------------------------------

# Of the library, what qv_attenuate calls: all of it takes long to compile.
BALL_WRITE := $(BUILD)/device/ball_write
BALL_SOURCES := port/ball.c $(addprefix tests/device/,ball_make.c ball_host.c ball_write.c) \
	$(patsubst %,core/%.c,attenuate attenuation direction domain_extinction layout order \
	order_linear overlap thickness volume) $(wildcard fixedpoint/*.c)

$(BALL_WRITE): $(BALL_SOURCES) port/ball.h tests/device/ball_make.h $(wildcard core/*.h fixedpoint/*.h)
	@mkdir -p $(@D)
	@echo "  CC  $@"
	@$(HOST_CC) -std=c99 $(WARNINGS) -O2 -Icore -Ifixedpoint -Iport $(BALL_SOURCES) -o $@

$(OUT)/ball.volume: $(BALL_WRITE)
	@mkdir -p $(@D)
	@echo "  GEN $@"
	@$< $@

$(TARGET_BALL:%.c=$(OUT)/%.o): $(OUT)/ball.volume

# ---- The turning head ---------------------------------------------------------------

ifdef TARGET_PANEL
include toolchain/shared/head.mk
endif

# ---- The emulators ----------------------------------------------------------------

# What toolchain/emulate runs; with REPORT=FILE it counts what is measured (port/measure.h).
# Their building is told on stderr, since scripts read what this prints.
.PHONY: emulator
emulator: $(TARGET_EMULATOR_NEEDS)
	@echo "$(TARGET_EMULATOR) $(if $(REPORT),$(or $(TARGET_COUNT),$(error nothing counts on $(TARGET)))$(REPORT))"

$(COUNT_PLUGIN): tests/emulator/count.c
	@mkdir -p $(@D)
	@echo "  CC  $<" >&2
	@$(HOST_CC) -std=c99 $(WARNINGS) -O2 -fPIC -shared $< -o $@

$(AVR_SIMULATOR): tests/emulator/avr.c
	@mkdir -p $(@D)
	@echo "  CC  $<" >&2
	@$(HOST_CC) -std=c99 $(WARNINGS) -O2 $< -lsimavr -lelf -o $@
