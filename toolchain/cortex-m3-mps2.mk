# Cortex-M3, emulated as an Arm MPS2 board, whose memory holds anything.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := mps2-an385
TARGET_MEMORIES := mps2
TARGET_CPU := -mcpu=cortex-m3 -mthumb
<<<<<<< HEAD
# Sampling of associated colours in assembly, see core/preweighted.h.
TARGET_CPU += -Iport/cortex-m -DQV_PASSAGE_HEADER='"passage_v7m.h"'
=======
TARGET_LEVELS := -O3
>>>>>>> 7b2effacf9987fc032a3cec48ef498a5b099c9c6
include toolchain/shared/cortex-m.mk
