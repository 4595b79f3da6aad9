# The smallest RISC-V: 16 registers, no multiplication, no division; compressed instructions.
TARGET_CPU := -march=rv32ec -mabi=ilp32e
# Its multiplications are loops: -O2 would take a minute more.
TARGET_LEVELS := -Os
TARGET_EMULATED_CPU := rv32,i=off,e=on,m=off,a=off,f=off,d=off,h=off,s=off,u=off
include toolchain/shared/riscv.mk
