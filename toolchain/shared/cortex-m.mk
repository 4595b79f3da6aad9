# What all Cortex-M targets share. A target sets TARGET_BOARD, TARGET_CPU,
# TARGET_SYSTICK_HZ and TARGET_PACKAGES, and includes this file.
TARGET_CC := arm-none-eabi-gcc
TARGET_AR := arm-none-eabi-ar

# Every instruction takes 2^8 ns, so that timers count instructions and nothing
# depends on the speed of this machine.
TARGET_EMULATOR := qemu-system-arm -M $(TARGET_BOARD) -icount shift=8,sleep=off

TARGET_PORT_FOLDER := port/cortex-m
TARGET_PORT := $(addprefix port/cortex-m/,startup.c systick.c oled.c measure.c)
TARGET_PORT_CFLAGS := -DSYSTICK_HZ=$(TARGET_SYSTICK_HZ)u

include toolchain/shared/firmware.mk
