# The part of ESP-IDF's build system that an application and a component of sources use: project()
# takes every folder of components/ and main/ and links NAME.elf, which begins in app_main.
macro(project name)
  _project(${name} LANGUAGES C ASM)
  file(GLOB folders "${CMAKE_SOURCE_DIR}/components/*" "${CMAKE_SOURCE_DIR}/main")
  foreach(folder ${folders})
    get_filename_component(COMPONENT_NAME "${folder}" NAME)
    add_subdirectory("${folder}" "esp-idf/${COMPONENT_NAME}")
  endforeach()
  file(WRITE "${CMAKE_BINARY_DIR}/project.c"
      "void app_main(void);\nint main(void) { app_main(); return 0; }\n")
  add_executable(${name}.elf "${CMAKE_BINARY_DIR}/project.c")
  target_link_libraries(${name}.elf main)
endmacro()

function(idf_component_register)
  cmake_parse_arguments(PARSE_ARGV 0 component "" ""
      "SRCS;INCLUDE_DIRS;PRIV_INCLUDE_DIRS;REQUIRES;PRIV_REQUIRES")
  if(component_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "idf_component_register: ${component_UNPARSED_ARGUMENTS}")
  endif()
  add_library(${COMPONENT_NAME} STATIC ${component_SRCS})
  target_include_directories(${COMPONENT_NAME}
      PUBLIC ${component_INCLUDE_DIRS} PRIVATE ${component_PRIV_INCLUDE_DIRS})
  target_compile_options(${COMPONENT_NAME} PRIVATE $<$<COMPILE_LANGUAGE:C>:-std=gnu17>
      -ffunction-sections -fdata-sections)
  target_link_libraries(${COMPONENT_NAME}
      PUBLIC ${component_REQUIRES} PRIVATE ${component_PRIV_REQUIRES})
endfunction()
