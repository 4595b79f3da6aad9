# Cortex-M0, emulated as a BBC micro:bit: 256 KB of flash, 16 KB of RAM, no
# 32x32->64 multiplication, no unaligned access, no division instruction.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := microbit
TARGET_CPU := -mcpu=cortex-m0 -mthumb
include toolchain/shared/cortex-m.mk
