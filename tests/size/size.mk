# Programs whose sizes are measured, each with one capability more than a ray caster's (size.h);
# "library" is all of the library at once, for its deepest stack. For any target: device.mk includes
# this file.
#
#     $(OUT)/size_NAME.report    figures of one of them, see measure.sh
#     $(OUT)/sizes               those of all

SIZES := minimal perspective rays extinction dithering pyramid freevoxels everything
SIZE_COMMON := $(filter-out tests/size/configuration_%,$(wildcard tests/size/*.c))
$(foreach name,$(SIZES),$(eval \
	FIRMWARE_size_$(name) := tests/size/configuration_$(name).c $(SIZE_COMMON)))
TARGET_FIRMWARE += $(SIZES:%=size_%)

SIZE_REPORTS := $(patsubst %,$(OUT)/size_%.report,$(SIZES) $(if $(TARGET_COUNT),library))
SIZE_TOOLS := $(addprefix toolchain/,size_report stack_report emulate) \
	$(addprefix tests/size/,measure.sh indirect_calls)

$(OUT)/sizes: $(SIZE_REPORTS)
	@cat $^ >$@

$(OUT)/size_%.report: $(OUT)/size_%.elf $(SIZE_TOOLS) | $(TARGET_EMULATOR_NEEDS)
	@echo "  GEN $@"
	@BUILD=$(BUILD) tests/size/measure.sh $(TARGET) $* \
		$(if $(TARGET_COUNT),$(TARGET_CC:gcc=objdump)) >$@

# Runs nowhere, so it may be larger than the target's flash.
$(OUT)/size_library.elf: $(LIBRARY) $(filter %/bytes.o,$(DEVICE_OBJECTS))
	@echo "  LD  $@"
	@$(TARGET_CC) $(TARGET_CFLAGS) -nostdlib -static \
		-Wl,-e,0,--defsym=__TEXT_REGION_LENGTH__=0x400000 \
		-Wl,--whole-archive $< -Wl,--no-whole-archive $(filter %.o,$^) \
		$(or $(TARGET_LDLIBS),-lgcc -lc -lgcc) -Wl,-Map,$(@:.elf=.map) -o $@
