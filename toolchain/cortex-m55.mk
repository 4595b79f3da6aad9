# Cortex-M55 with vector instructions of integers alone (Helium, MVE-I), emulated as an
# Arm MPS3 board. Vectors are passed in registers, hence the float ABI.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := mps3-an547
TARGET_CPU := -march=armv8.1-m.main+mve -mthumb -mfloat-abi=hard
TARGET_MARCH := helium.h
TARGET_MARCH_SOURCES := port/cortex-m/march_helium.S
include toolchain/shared/cortex-m.mk
