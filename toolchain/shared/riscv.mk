# What all RISC-V targets of 32 bits share. A target sets TARGET_CPU and
# TARGET_EMULATED_CPU, and includes this file.
TARGET_PACKAGES := gcc-riscv64-unknown-elf qemu-system-misc
TARGET_BOARD := virt
TARGET_CC := riscv64-unknown-elf-gcc
TARGET_AR := riscv64-unknown-elf-ar

TARGET_EMULATOR := qemu-system-riscv32 -M $(TARGET_BOARD) -cpu $(TARGET_EMULATED_CPU) -bios none

TARGET_PORT_FOLDER := port/riscv
TARGET_PORT := $(addprefix port/riscv/,startup.c measure.c)

include toolchain/shared/firmware.mk
