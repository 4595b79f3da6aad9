# RISC-V, 32 bits, with multiplication and division, and compressed instructions.
TARGET_CPU := -march=rv32imc -mabi=ilp32
TARGET_EMULATED_CPU := rv32,a=off,f=off,d=off,h=off,s=off,u=off
include toolchain/shared/riscv.mk
