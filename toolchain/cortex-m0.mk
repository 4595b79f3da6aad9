# Cortex-M0, emulated as a BBC micro:bit: 256 KB of flash, 16 KB of RAM, no
# 32x32->64 multiplication, no unaligned access, no division instruction.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := microbit
TARGET_CPU := -mcpu=cortex-m0 -mthumb
TARGET_MARCH_SOURCES := port/cortex-m/march_thumb1.S
TARGET_PASSAGE := passage_v6m.h
include toolchain/shared/cortex-m.mk
