# Cortex-M33 with DSP instructions, emulated as an Arm MPS2 board.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := mps2-an505
TARGET_CPU := -mcpu=cortex-m33 -mthumb -mfloat-abi=soft
include toolchain/shared/cortex-m.mk
