# Programs whose sizes are measured, each with one capability more than a ray caster's (size.h);
# "library" is all of the library at once. For any target: device.mk includes this file, and Makefile for the host.
#
#     $(OUT)/size_NAME.report    figures of one of them, see measure.sh
#     $(OUT)/sizes               those of all

SIZES := minimal perspective rays extinction dithering pyramid freevoxels everything
SIZE_COMMON := $(filter-out tests/size/configuration_%,$(wildcard tests/size/*.c))
$(foreach name,$(SIZES),$(eval \
	FIRMWARE_size_$(name) := tests/size/configuration_$(name).c $(SIZE_COMMON)))
TARGET_FIRMWARE += $(SIZES:%=size_%)

SIZE_REPORTS := $(patsubst %,$(OUT)/size_%.report,$(SIZES) library)
SIZE_TOOLS := $(addprefix toolchain/,size_report stack_report emulate) \
	$(addprefix tests/size/,measure.sh indirect_calls)

$(OUT)/sizes: $(SIZE_REPORTS)
	@cat $^ >$@

$(OUT)/size_%.report: $(OUT)/size_%.elf $(SIZE_TOOLS) | $(TARGET_EMULATOR_NEEDS)
	@echo "  GEN $@"
	@BUILD=$(BUILD) tests/size/measure.sh $(TARGET) $* $(if $(filter host,$(TARGET)),objdump,$(TARGET_CC:gcc=objdump)) >$@

SIZE_BYTES := $(if $(filter host,$(TARGET)),$(OUT)/size/port/bytes.o,$(filter \
	%/bytes.o,$(TARGET_PORT:%.c=$(OUT)/%.o)))

# Runs nowhere, so it may be larger than the target's flash.
$(OUT)/size_library.elf: $(LIBRARY) $(SIZE_BYTES)
	@echo "  LD  $@"
	@$(TARGET_CC) $(TARGET_CFLAGS) -nostdlib -Wl,-e,0,--defsym=__TEXT_REGION_LENGTH__=0x400000 \
		-Wl,--whole-archive $< -Wl,--no-whole-archive $(filter %.o,$^) \
		$(or $(TARGET_LDLIBS),-lgcc -lc -lgcc) -Wl,-Map,$(@:.elf=.map) -o $@

# On the host a program stands for a firmware: with memory functions of its own, which can be
# counted, and marks that measure nothing.
ifeq ($(TARGET),host)
SIZE_PORT := tests/bench/board_host.c port/bytes.c
SIZE_OBJECTS = $(patsubst %.c,$(OUT)/size/%.o,$(1) $(SIZE_PORT))

$(OUT)/size/%.o: %.c
	@mkdir -p $(@D)
	@echo "  CC  $<"
	@$(CC) -std=c99 $(WARNINGS) $(TARGET_CFLAGS) -fno-tree-loop-distribute-patterns \
		-Icore -Ifixedpoint -Iport -c $< -o $@

define link_size
$(OUT)/size_$(1).elf: $(call SIZE_OBJECTS,$(FIRMWARE_size_$(1))) $(LIBRARY)
	@echo "  LD  $$@"
	@$(CC) $(CFLAGS) -no-pie -Wl,--gc-sections,-Map,$$(@:.elf=.map) $$^ -o $$@
endef
$(foreach name,$(SIZES),$(eval $(call link_size,$(name))))
endif
