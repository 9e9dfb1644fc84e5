# base/version.h values: version, git revision, compiler and flags.
execute_process(COMMAND git -C ${CMAKE_SOURCE_DIR} describe --always --dirty
  OUTPUT_VARIABLE FRANA_REVISION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT FRANA_REVISION)
  set(FRANA_REVISION "unknown")
endif()
string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
string(STRIP "${CMAKE_C_FLAGS} ${CMAKE_C_FLAGS_${type}} -march=${FRANA_ARCH}" FRANA_FLAGS)
set(FRANA_COMPILER "${CMAKE_C_COMPILER_ID} ${CMAKE_C_COMPILER_VERSION}")
configure_file(${CMAKE_SOURCE_DIR}/cmake/version.h.in ${CMAKE_BINARY_DIR}/generated/frana_version.h @ONLY)
include_directories(${CMAKE_BINARY_DIR}/generated)
