# PowerPC, 32 bits: the most significant byte comes first.
TARGET_PACKAGES := gcc-powerpc-linux-gnu libc6-dev-powerpc-cross qemu-user
TARGET_CC := powerpc-linux-gnu-gcc
TARGET_AR := powerpc-linux-gnu-ar
# Constants are read-only, however small they are.
TARGET_CPU := -G0
TARGET_QEMU := qemu-ppc
TARGET_RUNNER := $(TARGET_QEMU)
include toolchain/shared/linux.mk
