# Firmware of a device target. The Makefile includes this file where TARGET is a
# device, after the target's own file.
#
# It needs from the Makefile:
#     BUILD      top of everything built (build)
#     OUT        what is built for the target ($(BUILD)/$(TARGET))
#     LIBRARY    the library's archive, with a rule to make it ($(OUT)/libqvol.a)
#     WARNINGS   the warning options of every C file
#     HOST_CC    the compiler of this machine (for the emulator's plugin)
# It offers:
#     firmware            every firmware of the target
#     $(OUT)/NAME.elf     one of them, with its link map beside it
#     $(COUNT_PLUGIN)     the emulator's counting plugin

FIRMWARE := golden bench size_orthographic size_perspective
COUNT_PLUGIN := $(BUILD)/emulator/count.so

# Sources of each firmware beside the port and the library.
FIRMWARE_size_orthographic := $(addprefix port/cortex-m/,firmware_size.c firmware_size_orthographic.c)
FIRMWARE_size_perspective := $(addprefix port/cortex-m/,firmware_size.c firmware_size_perspective.c)
FIRMWARE_golden := tests/golden/golden_device.c tests/golden/scenes.c tests/golden/volume.c \
	tests/golden/render.c
FIRMWARE_bench := tests/bench/bench_device.c

DEVICE_CFLAGS = -std=c99 $(WARNINGS) -MMD -MP $(TARGET_CFLAGS) $(TARGET_PORT_CFLAGS) \
	-Icore -Iport -Iport/cortex-m
DEVICE_OBJECTS := $(TARGET_PORT:%.c=$(OUT)/%.o)

.PHONY: firmware
firmware: $(FIRMWARE:%=$(OUT)/%.elf)

$(OUT)/port/%.o: port/%.c
	@mkdir -p $(@D)
	$(TARGET_CC) $(DEVICE_CFLAGS) -c $< -o $@

$(OUT)/tests/%.o: tests/%.c
	@mkdir -p $(@D)
	$(TARGET_CC) $(DEVICE_CFLAGS) -c $< -o $@

define link_firmware
$(OUT)/$(1).elf: $(FIRMWARE_$(1):%.c=$(OUT)/%.o) $(DEVICE_OBJECTS) $(LIBRARY)
	$(TARGET_CC) $(TARGET_LDFLAGS) -Wl,-Map,$$(@:.elf=.map) $$(filter %.o,$$^) $(LIBRARY) \
		$(TARGET_LDLIBS) -o $$@
-include $(FIRMWARE_$(1):%.c=$(OUT)/%.d)
endef
$(foreach name,$(FIRMWARE),$(eval $(call link_firmware,$(name))))
-include $(DEVICE_OBJECTS:.o=.d)

$(COUNT_PLUGIN): tests/emulator/count.c
	@mkdir -p $(@D)
	$(HOST_CC) -std=c99 $(WARNINGS) -O2 -fPIC -shared $< -o $@
