# The same for a Cortex-M4, which has marches of its own.
set(processor cortex-m4)
include("${CMAKE_CURRENT_LIST_DIR}/cortex-m0.cmake")
