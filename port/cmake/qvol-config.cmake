include("${CMAKE_CURRENT_LIST_DIR}/qvol-targets.cmake")
