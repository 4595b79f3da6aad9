# Cortex-M3, emulated as an Arm MPS2 board, whose memory holds anything.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := mps2-an385
TARGET_MEMORIES := mps2
TARGET_CPU := -mcpu=cortex-m3 -mthumb
TARGET_LEVELS := -O3
include toolchain/shared/cortex-m.mk
