# Cortex-M3, emulated as a Stellaris LM3S6965 kit: 256 KB of flash, 64 KB of RAM
# and the one OLED panel that QEMU models on a Cortex-M.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := lm3s6965evb
TARGET_CPU := -mcpu=cortex-m3 -mthumb
TARGET_SYSTICK_HZ := 12500000
include toolchain/shared/cortex-m.mk

# Firmware that only this board runs: the head on the OLED.
TARGET_FIRMWARE += head
