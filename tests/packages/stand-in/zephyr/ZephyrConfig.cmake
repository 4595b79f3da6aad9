# The part of Zephyr's build system that an application and a module of sources use. As Zephyr's
# does, this makes the target app, enters the module, and links zephyr/zephyr.elf.
project(Zephyr-Kernel LANGUAGES C ASM)
include("${CMAKE_BINARY_DIR}/zephyr/module.cmake")

add_library(zephyr_interface INTERFACE)
add_library(app STATIC)
target_link_libraries(app PRIVATE zephyr_interface)

macro(zephyr_library_named name)
  set(ZEPHYR_CURRENT_LIBRARY ${name})
  add_library(${name} STATIC)
  target_link_libraries(${name} PRIVATE zephyr_interface)
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANGUAGE:C>:-std=c99> -ffunction-sections -fdata-sections)
  set_property(GLOBAL APPEND PROPERTY ZEPHYR_LIBS ${name})
endmacro()

function(zephyr_library_sources)
  target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()

function(zephyr_include_directories)
  foreach(folder ${ARGN})
    get_filename_component(path "${folder}" ABSOLUTE)
    target_include_directories(zephyr_interface INTERFACE "${path}")
  endforeach()
endfunction()

add_subdirectory("${module}" "${CMAKE_BINARY_DIR}/modules/module")

file(WRITE "${CMAKE_BINARY_DIR}/empty.c" "extern int nothing;\n")
add_executable(zephyr_final "${CMAKE_BINARY_DIR}/empty.c")
get_property(libraries GLOBAL PROPERTY ZEPHYR_LIBS)
target_link_libraries(zephyr_final app ${libraries})
set_target_properties(zephyr_final PROPERTIES OUTPUT_NAME zephyr.elf
    RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/zephyr")
