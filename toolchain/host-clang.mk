# This machine, by clang.
TARGET_PACKAGES := clang qemu-user
TARGET_LEVELS := -O0 -Os -O2 -O3
TARGET_CC := clang
TARGET_AR := ar
TARGET_QEMU := qemu-$(shell uname -m)
include toolchain/shared/linux.mk
