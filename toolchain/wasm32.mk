# WebAssembly, run by Node.js: no C library; console and exit are functions of JavaScript.
TARGET_PACKAGES := clang lld llvm nodejs
TARGET_CC := clang
TARGET_AR := llvm-ar
TARGET_LEVELS := -O2
TARGET_CPU := --target=wasm32

OPTIMISE ?= -O2
TARGET_CFLAGS = $(TARGET_CPU) $(OPTIMISE) -ffreestanding -ffunction-sections -fdata-sections $(CFLAGS)

TARGET_EMULATOR := node port/wasm/run.mjs

TARGET_PORT_FOLDER := port/wasm
TARGET_PORT := port/wasm/console.c port/wasm/measure.c port/bytes.c port/console.c port/crc32.c

TARGET_LDFLAGS := $(TARGET_CPU) -nostdlib -Wl,--no-entry,--export=main,--gc-sections

TARGET_FIRMWARE := functions blends
