# What all Cortex-M targets share. A target sets TARGET_BOARD, TARGET_CPU and
# TARGET_PACKAGES, and includes this file.
TARGET_CC := arm-none-eabi-gcc
TARGET_AR := arm-none-eabi-ar

# Every instruction takes 2^8 ns, so that timers count instructions and nothing
# depends on the speed of this machine.
TARGET_EMULATOR := qemu-system-arm -M $(TARGET_BOARD) -icount shift=8,sleep=off

TARGET_PORT_FOLDER := port/cortex-m
TARGET_PORT := $(addprefix port/cortex-m/,startup.c measure.c)

# Armv6-M, and Armv8-M without its main extension, compute with the 16-bit instructions of Thumb.
THUMB1 := $(filter -mcpu=cortex-m0% -mcpu=cortex-m1% -mcpu=cortex-m23%,$(TARGET_CPU))

# Marches (core/march.h): of a header, with what it needs in assembly.
TARGET_MARCH ?= march_walk.h
TARGET_MARCH_SOURCES ?= port/cortex-m/march_$(if $(THUMB1),thumb1,thumb2).S

# Sampling of associated colours in assembly (core/preweighted.h).
TARGET_PASSAGE ?= passage_$(if $(THUMB1),v6m,v7m).h

include toolchain/shared/firmware.mk

# What its assembly computes beside what C does.
TARGET_FIRMWARE += passages
