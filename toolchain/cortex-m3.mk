# Cortex-M3, emulated as a Stellaris LM3S6965 kit: 256 KB of flash, 64 KB of RAM
# and the one OLED panel that QEMU models on a Cortex-M.
TARGET_PACKAGES := gcc-arm-none-eabi qemu-system-arm
TARGET_BOARD := lm3s6965evb
TARGET_CPU := -mcpu=cortex-m3 -mthumb
include toolchain/shared/cortex-m.mk

# The head on the OLED: 205 KB of indices in flash.
TARGET_PANEL := oled
PANEL_OPTIONS := --size 128x64 --format grey4
HEAD_STORAGE := indexed8
HEAD_AZIMUTH := 97
SCAN_OPTIONS ?= --tf oled --reduce 3x4x3
PANEL_VIEW ?= --elevation 3 --zoom 1.75
