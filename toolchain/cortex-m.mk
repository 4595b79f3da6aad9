# What all Cortex-M targets share. A target sets TARGET_BOARD, TARGET_CPU,
# TARGET_SYSTICK_HZ and TARGET_PACKAGES, and includes this file.
TARGET_CC := arm-none-eabi-gcc
TARGET_AR := arm-none-eabi-ar

# Optimisation of the library and the firmware: make OPTIMISE=-O3 TARGET=...
OPTIMISE ?= -Os
TARGET_CFLAGS := $(TARGET_CPU) $(OPTIMISE) -ffreestanding -ffunction-sections -fdata-sections $(CFLAGS)

# bytes.c defines memcpy and memset: their loops must stay loops.
TARGET_PORT_CFLAGS := -fno-tree-loop-distribute-patterns -DSYSTICK_HZ=$(TARGET_SYSTICK_HZ)u -Wa,-I$(OUT)
TARGET_PORT_FOLDER := port/cortex-m
TARGET_PORT := $(addprefix $(TARGET_PORT_FOLDER)/,startup.c bytes.c semihosting.c stack.c \
	systick.c oled.c measure.c) port/console.c port/crc32.c

TARGET_LDFLAGS := $(TARGET_CPU) -nostdlib -Wl,--gc-sections -Ltoolchain \
	-T toolchain/$(TARGET_BOARD).ld
TARGET_LDLIBS := -lgcc
TARGET_SCRIPTS := toolchain/$(TARGET_BOARD).ld toolchain/cortex-m.ld

TARGET_FIRMWARE := golden_steps golden_lengths golden_bsplines golden_slices golden_splats bench \
	functions blends ball freevoxels
