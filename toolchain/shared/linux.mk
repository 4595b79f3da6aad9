# What all targets share that are programs of a Linux machine: this one, or one that QEMU
# translates. A target sets TARGET_CC, TARGET_AR, TARGET_CPU, TARGET_QEMU and
# TARGET_PACKAGES, and includes this file. The library is freestanding all the same.
TARGET_LEVELS ?= -O2
OPTIMISE ?= -O2
TARGET_CFLAGS = $(TARGET_CPU) $(OPTIMISE) -fno-pie -ffreestanding -ffunction-sections -fdata-sections \
	$(CFLAGS)

# QEMU runs what this machine cannot, and counts.
TARGET_EMULATOR = $(if $(REPORT),$(TARGET_QEMU),$(TARGET_RUNNER))
TARGET_EMULATOR_NEEDS = $(COUNT_PLUGIN)
TARGET_COUNT = -plugin $(COUNT_PLUGIN),out=

TARGET_PORT_FOLDER := port/linux
# Memory functions of our own, as on a board, can be counted; the C library's are chosen at start-up.
TARGET_PORT_CFLAGS := $(if $(filter clang,$(TARGET_CC)),,-fno-tree-loop-distribute-patterns) -Wa,-I$(OUT)
TARGET_PORT := $(addprefix port/linux/,console.c measure.c) $(addprefix port/,bytes.c console.c crc32.c)

TARGET_LDFLAGS := $(TARGET_CPU) -static -Wl,--gc-sections

TARGET_FIRMWARE := bench float functions blends ball freevoxels
