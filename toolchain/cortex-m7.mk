# Cortex-M7 with DSP instructions, emulated as an Arm MPS2 board.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := mps2-an500
TARGET_MEMORIES := mps2
TARGET_CPU := -mcpu=cortex-m7 -mthumb -mfloat-abi=soft
include toolchain/shared/cortex-m.mk
