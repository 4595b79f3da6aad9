# Cortex-M55 with vector instructions of integers alone (Helium, MVE-I), emulated as an
# Arm MPS3 board. Vectors are passed in registers, hence the float ABI.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := mps3-an547
TARGET_CPU := -march=armv8.1-m.main+mve -mthumb -mfloat-abi=hard
# Marches of vectors, see core/march.h; associated colours in assembly, core/preweighted.h.
TARGET_CPU += -Iport/cortex-m -DQV_MARCH_HEADER='"helium.h"' -DQV_PASSAGE_HEADER='"passage_v7m.h"'
include toolchain/shared/cortex-m.mk

# What its vectors compute beside what C does.
TARGET_FIRMWARE += marches
