# qvol: an integer-only volume renderer. `make help` lists the targets.
#
# Variables: TARGET=host or a device, see toolchain/TARGETS.md; CC, CFLAGS, OPTIMISE=-O2,
# PREFIX=/usr/local, WITHOUT="png nifti nrrd mpi cmocka" (leave out what is installed).

.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
MAKEFLAGS += --no-builtin-rules

BUILD := build
TARGET ?= host
# Each device has a file of its own; what some share lies in toolchain/shared/.
DEVICES := $(sort $(patsubst toolchain/%.mk,%,$(wildcard toolchain/*.mk)))
OUT := $(BUILD)/$(TARGET)
PREFIX ?= /usr/local
LIBRARY := $(OUT)/libqvol.a
DIST := $(BUILD)/dist
AMALGAMATION := $(DIST)/amalgamation/qvol.c
QVOL := $(BUILD)/host/qvol
HOST_CC := $(CC)

WARNINGS := -pedantic -Wall -Wextra -Werror -Wconversion -Wsign-conversion -Wshadow -Wcast-qual \
	-Wmissing-prototypes -Wstrict-prototypes -Wundef -Wvla -Wdouble-promotion

ifeq ($(TARGET),host)
OPTIMISE ?= -O2
TARGET_CC := $(CC)
TARGET_AR := $(AR)
TARGET_CFLAGS = $(OPTIMISE) -ffunction-sections -fdata-sections $(CFLAGS)
else ifneq ($(filter $(TARGET),$(DEVICES)),)
include toolchain/$(TARGET).mk
ifeq ($(shell command -v $(TARGET_CC)),)
$(error $(TARGET) needs $(TARGET_CC); Debian's packages: $(TARGET_PACKAGES))
endif
else
$(error no target $(TARGET); there are: host $(DEVICES))
endif

# ---- The library: no package needed -----------------------------------------

LIBRARY_SOURCES := $(sort $(wildcard core/*.c fixedpoint/*.c))
# Marches of the target's own, see core/march.h; make MARCH= TARGET=... does with those in C.
MARCH ?= $(TARGET_MARCH)
ifneq ($(MARCH),)
MARCH_CFLAGS := -Iport -I$(TARGET_PORT_FOLDER) -DQV_MARCH_HEADER='"$(MARCH)"'
MARCH_OBJECTS := $(TARGET_MARCH_SOURCES:%.S=$(OUT)/%.o)
endif
# Passages likewise, see core/preweighted.h; make PASSAGE= TARGET=...
PASSAGE ?= $(TARGET_PASSAGE)
ifneq ($(PASSAGE),)
PASSAGE_CFLAGS := -I$(TARGET_PORT_FOLDER) -DQV_PASSAGE_HEADER='"$(PASSAGE)"'
endif
LIBRARY_OBJECTS := $(LIBRARY_SOURCES:%.c=$(OUT)/%.o) $(MARCH_OBJECTS)
LIBRARY_CFLAGS = -std=c99 $(WARNINGS) -MMD -MP -ffreestanding $(TARGET_CFLAGS) $(MARCH_CFLAGS) \
	$(PASSAGE_CFLAGS) -Icore -Ifixedpoint
ifneq ($(TARGET),host)
LIBRARY_CFLAGS += -fstack-usage
endif

.PHONY: all lib
ifeq ($(TARGET),host)
all: lib $(QVOL) ## the library and, for the host, the command qvol (default)
else
all: lib
endif

lib: $(LIBRARY) ## the library for TARGET: build/TARGET/libqvol.a

$(LIBRARY): $(LIBRARY_OBJECTS)
	@rm -f $@
	@echo "  AR  $@"
	@$(TARGET_AR) rcs $@ $^

# What is built depends on its options too. $(call remember,FILE,TEXT): FILE holds
# TEXT and changes only when TEXT does; make -n, help and clean write nothing.
QUIET_GOALS := $(filter help clean,$(MAKECMDGOALS))
QUIET_GOALS += $(findstring n,$(filter-out -%,$(firstword $(MAKEFLAGS))))
remember = $(if $(strip $(QUIET_GOALS)),$(wildcard $(1)),$(shell mkdir -p $(dir $(1)); \
	printf '%s\n' '$(subst ','\'',$(2))' | cmp -s - $(1) || \
	printf '%s\n' '$(subst ','\'',$(2))' > $(1))$(1))

OPTIONS := $(call remember,$(OUT)/options,$(TARGET_CC) $(LIBRARY_CFLAGS))

$(OUT)/core/%.o: core/%.c $(OPTIONS)
	@mkdir -p $(@D)
	@echo "  CC  $<"
	@$(TARGET_CC) $(LIBRARY_CFLAGS) -c $< -o $@

$(OUT)/fixedpoint/%.o: fixedpoint/%.c $(OPTIONS)
	@mkdir -p $(@D)
	@echo "  CC  $<"
	@$(TARGET_CC) $(LIBRARY_CFLAGS) -c $< -o $@

$(OUT)/%.o: %.S $(OPTIONS)
	@mkdir -p $(@D)
	@echo "  AS  $<"
	@$(TARGET_CC) $(TARGET_CFLAGS) -c $< -o $@

-include $(LIBRARY_OBJECTS:.o=.d)

# ---- What runs on the library -------------------------------------------------

ifeq ($(TARGET),host)
include port/host/host.mk
include port/mpi/mpi.mk
include tests/tests.mk
else
include toolchain/shared/device.mk
endif

.PHONY: firmware size bench
ifeq ($(TARGET),host)
firmware: ## firmware for a device: make firmware TARGET=cortex-m3
	@echo "make: name a device: make firmware TARGET=cortex-m3" >&2; exit 2
endif

# One of each processor.
SIZE_TARGETS := $(filter-out cortex-m3-mps2 avr-ram host-clang host-32,$(DEVICES))

.PHONY: size-lines size-update size-diff
size: ## bytes of code, tables, contexts and stack on each target, by what a program uses
	@tests/size/sizes.sh lines $(SIZE_TARGETS) >$(BUILD)/sizes
	@tests/size/sizes.sh table <$(BUILD)/sizes

size-lines:
	@tests/size/sizes.sh lines $(SIZE_TARGETS)

size-update: ## write tests/size/SIZES.md anew
	@tests/size/sizes.sh lines $(SIZE_TARGETS) >$(BUILD)/sizes
	tests/size/sizes.sh document <$(BUILD)/sizes >tests/size/SIZES.md

size-diff: ## sizes beside those of another revision: make size-diff REV=v0.1
	@tests/size/diff.sh "$(REV)" $(SIZE_TARGETS)

.PHONY: insns
insns: ## instructions a sample, a blended pixel and a ray on each target, and beside floats
	@tests/bench/insns.sh lines $(filter-out wasm32,$(SIZE_TARGETS)) >$(BUILD)/insns
	@tests/bench/insns.sh table <$(BUILD)/insns

bench: $(QVOL) ## instructions per sample on the devices, samples per second on the host
	tests/bench/bench.sh

# ---- The commands -------------------------------------------------------------

.PHONY: setup demo gallery picture papers test test-exhaustive test-devices
setup: ## install what demo, papers and test need (Debian, as root)
	@toolchain/setup

demo: setup ## pictures of a real MRI, and of a microcontroller drawing it: build/demo/
	@$(MAKE) -s --no-print-directory all
	@toolchain/demo

# On rv32imc's colour panel; PICTURE_TARGET=cortex-m3 has an OLED.
PICTURE_TARGET ?= rv32imc

picture: ## one picture, drawn by an emulated board: build/picture.png; needs its compiler and QEMU
	@$(MAKE) -s --no-print-directory TARGET=$(PICTURE_TARGET) $(BUILD)/$(PICTURE_TARGET)/picture.elf
	@BUILD=$(BUILD) toolchain/screenshot $(PICTURE_TARGET) $(BUILD)/$(PICTURE_TARGET)/picture.elf \
		$(BUILD)/picture.png
	@echo "  PNG $(BUILD)/picture.png"

gallery: setup ## a head turning on the panels of emulated boards, beside the host's: build/gallery/
	@toolchain/gallery $(BUILD)/gallery cortex-m3 rv32imc

papers: setup ## figures and numbers of the papers, recomputed: build/papers/
	@$(MAKE) -s --no-print-directory paper-programs
	@tests/papers/papers.sh

test: setup ## everything that is tested; ends with "N passed, N failed"
	@$(MAKE) --no-print-directory test-all

test-devices: setup ## the golden scenes on every target: a matrix
	@tests/run tests/device/golden.sh

test-exhaustive: ## every input of every fixed-point function: an hour or so
	@$(MAKE) --no-print-directory exhaustive

# ---- Installation ---------------------------------------------------------------

.PHONY: install
COMMANDS := $(if $(filter host,$(TARGET)),$(QVOL) $(MPI_COMMAND))

install: $(LIBRARY) $(COMMANDS) ## header, archive, pkg-config file, commands and their test vectors below PREFIX
	install -d "$(DESTDIR)$(PREFIX)/include" "$(DESTDIR)$(PREFIX)/lib/pkgconfig"
	install -m 644 core/qvol.h "$(DESTDIR)$(PREFIX)/include/qvol.h"
	install -m 644 $(LIBRARY) "$(DESTDIR)$(PREFIX)/lib/libqvol.a"
	version=$$(sed -n 's/^#define QV_VERSION  *"\(.*\)"/\1/p' core/qvol.h) && \
	sed -e "s|@PREFIX@|$(PREFIX)|" -e "s|@LIBDIR@|lib|" -e "s|@VERSION@|$$version|" \
		port/pkg-config/qvol.pc.in \
		> "$(DESTDIR)$(PREFIX)/lib/pkgconfig/qvol.pc"
ifeq ($(TARGET),host)
	install -d "$(DESTDIR)$(PREFIX)/bin"
	install -m 755 $(COMMANDS) "$(DESTDIR)$(PREFIX)/bin"
	install -d "$(DESTDIR)$(PREFIX)/share/qvol/vectors"
	install -m 644 tests/vectors/*.csv tests/vectors/*.tsv "$(DESTDIR)$(PREFIX)/share/qvol/vectors"
endif

# ---- Packages: port/README.md says how to take them home ------------------------------

.PHONY: dist amalgamation
dist: amalgamation ## a package for each ecosystem below build/dist/
	@toolchain/dist $(DIST) $(LIBRARY_SOURCES) $(wildcard port/*/march_*.S)

amalgamation: $(AMALGAMATION) ## the library as one header and one source: build/dist/amalgamation/

$(AMALGAMATION): toolchain/amalgamate $(LIBRARY_SOURCES) $(wildcard core/*.h fixedpoint/*.h)
	@echo "  GEN $@"
	@toolchain/amalgamate $(@D) $(LIBRARY_SOURCES)
	@cp LICENSE CHANGELOG.md $(@D)

# ---- Care -----------------------------------------------------------------------

C_FILES = $(shell find core fixedpoint port tests -name '*.[ch]')
SHELL_TOOLS := $(addprefix toolchain/,setup demo emulate dist) tests/run .ci/run

# What ports name headers in: static analysis takes none of these.
PORT_HEADERS := QV_MEMORY_HEADER FX_TABLE_HEADER QV_MARCH_HEADER QV_PASSAGE_HEADER

.PHONY: format lint readme clean help
format: ## lay out every C file by .clang-format
	clang-format -i $(C_FILES)

lint: ## layout, static analysis, shell scripts
	clang-format --dry-run --Werror $(C_FILES)
	cppcheck -j 2 --std=c99 --quiet --error-exitcode=1 --enable=warning,portability,performance \
		--inline-suppr --suppress=missingIncludeSystem $(PORT_HEADERS:%=-U%) \
		-Icore -Ifixedpoint core fixedpoint
	shellcheck -S warning $(SHELL_TOOLS) $$(find tests port -name '*.sh')

readme: ## write the figures of README.md anew
	tests/bench/readme.sh

# What scripts ask: make -s TARGET=... print-TARGET_CC
print-%:
	@echo "$($*)"

clean: ## remove everything built
	rm -rf $(BUILD)

help: ## this list
	@sed -n 's/^\([a-z-]*\):[^#]*## \(.*\)/\1|\2/p' $(MAKEFILE_LIST) | sort -u | \
		awk -F'|' '{ printf "  make %-16s %s\n", $$1, $$2 }'
