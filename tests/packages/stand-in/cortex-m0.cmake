# A toolchain file as a project for a Cortex-M0 has one, and the board that its programs run on.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(board "${CMAKE_CURRENT_LIST_DIR}/../board")
if(NOT processor)
    set(processor cortex-m0)
endif()
set(CMAKE_C_FLAGS_INIT
    "-mcpu=${processor} -mthumb -Os -ffreestanding -fno-tree-loop-distribute-patterns")
set(CMAKE_ASM_FLAGS_INIT "-mcpu=${processor} -mthumb")
set(CMAKE_EXE_LINKER_FLAGS_INIT
    "-nostdlib -Wl,--gc-sections -T ${board}/board.ld -x c ${board}/board.c -x none")
set(CMAKE_C_STANDARD_LIBRARIES_INIT "-lgcc")
