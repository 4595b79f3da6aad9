# RISC-V, 32 bits, with multiplication and division, and compressed instructions.
TARGET_CPU := -march=rv32imc -mabi=ilp32
TARGET_EMULATED_CPU := rv32,a=off,f=off,d=off,h=off,s=off,u=off
# Marches, see core/march.h.
TARGET_MARCH := march_walk.h
TARGET_MARCH_SOURCES := port/riscv/march_rv32im.S
include toolchain/shared/riscv.mk

# The head in colour, shaded as it was classified: 1 MB of RGBA8.
TARGET_EMULATOR += -device bochs-display,romfile=
TARGET_PANEL := bochs_display
PANEL_OPTIONS := --size 320x240 --format bgra8888
HEAD_STORAGE := rgba8
HEAD_AZIMUTH := 130
SCAN_OPTIONS ?= --tf skin --mask $(SCAN:.nii.gz=bet.nii.gz) --mask-tf brain --shade \
	--azimuth $(HEAD_AZIMUTH) --elevation 14 --reduce 3
PANEL_VIEW ?= --elevation 14 --zoom 1.45 --background 0b1220
