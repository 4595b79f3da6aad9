# What all targets share that run without an operating system in QEMU, with console
# and exit by semihosting. A family sets TARGET_CC, TARGET_AR, TARGET_EMULATOR,
# TARGET_PORT_FOLDER and TARGET_PORT, and includes this file; its folder holds
# machine.h. The memories of the board are in toolchain/$(TARGET_MEMORIES).ld.

# Optimisation of the library and the firmware: make OPTIMISE=-O3 TARGET=...
OPTIMISE ?= -Os
TARGET_CFLAGS = $(TARGET_CPU) $(OPTIMISE) -ffreestanding -ffunction-sections -fdata-sections $(CFLAGS)

# bytes.c defines memcpy and memset: their loops must stay loops.
TARGET_PORT_CFLAGS += -fno-tree-loop-distribute-patterns -Wa,-I$(OUT)
TARGET_PORT += $(addprefix port/,memories.c bytes.c semihosting.c stack.c console.c crc32.c)

TARGET_MEMORIES ?= $(TARGET_BOARD)
TARGET_SCRIPTS := toolchain/$(TARGET_MEMORIES).ld toolchain/firmware.ld
TARGET_LDFLAGS := $(TARGET_CPU) -nostdlib -Wl,--gc-sections -Ltoolchain -T toolchain/$(TARGET_MEMORIES).ld
TARGET_LDLIBS := -lgcc

TARGET_EMULATOR_NEEDS = $(COUNT_PLUGIN)
TARGET_COUNT = -plugin $(COUNT_PLUGIN),out=

# Levels of optimisation that the golden scenes are tested at.
TARGET_LEVELS ?= -Os -O2

TARGET_FIRMWARE := bench float functions blends ball pages freevoxels
