# This machine, by GCC: what TARGET=host is, as devices are built.
TARGET_PACKAGES := gcc qemu-user
TARGET_LEVELS := -O0 -Os -O2 -O3
TARGET_CC := gcc
TARGET_AR := ar
TARGET_QEMU := qemu-$(shell uname -m)
include toolchain/shared/linux.mk
