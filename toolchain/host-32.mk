# This machine with pointers of 32 bits.
TARGET_PACKAGES := gcc-12-multilib qemu-user
TARGET_LEVELS := -O0 -O3
TARGET_CC := gcc
TARGET_AR := ar
TARGET_CPU := -m32
TARGET_QEMU := qemu-i386
include toolchain/shared/linux.mk
