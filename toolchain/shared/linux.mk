# What all targets share that are programs of a Linux machine: this one, or one that QEMU
# translates. A target sets TARGET_CC, TARGET_AR, TARGET_CPU, TARGET_QEMU and
# TARGET_PACKAGES, and includes this file. The library is freestanding all the same.
TARGET_LEVELS ?= -O2
OPTIMISE ?= -O2
TARGET_CFLAGS = $(TARGET_CPU) $(OPTIMISE) -ffreestanding -ffunction-sections -fdata-sections $(CFLAGS)

# QEMU runs what this machine cannot, and counts.
TARGET_EMULATOR = $(if $(REPORT),$(TARGET_QEMU),$(TARGET_RUNNER))
TARGET_EMULATOR_NEEDS = $(COUNT_PLUGIN)
TARGET_COUNT = -plugin $(COUNT_PLUGIN),out=

TARGET_PORT_FOLDER := port/linux
TARGET_PORT_CFLAGS := -Wa,-I$(OUT)
TARGET_PORT := $(addprefix port/linux/,console.c measure.c) port/console.c port/crc32.c

TARGET_LDFLAGS := $(TARGET_CPU) -static -Wl,--gc-sections

TARGET_FIRMWARE := bench functions blends ball freevoxels
