# Values of base/version.h: version, git revision, compiler and flags. The revision is read at every build.
string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
get_directory_property(options COMPILE_OPTIONS)
list(FILTER options EXCLUDE REGEX "^-W|^-march=")
string(REPLACE ";" " " options "${options}")
if(FRANA_ARCH)
  set(options "${options} -march=${FRANA_ARCH}")
endif()
string(STRIP "${CMAKE_C_FLAGS} ${CMAKE_C_FLAGS_${type}} ${options}" flags)
add_custom_target(frana_version
  COMMAND ${CMAKE_COMMAND} -DFRANA_SOURCE=${CMAKE_SOURCE_DIR} -DFRANA_BINARY=${CMAKE_BINARY_DIR}
    -DPROJECT_VERSION=${PROJECT_VERSION} "-DFRANA_COMPILER=${CMAKE_C_COMPILER_ID} ${CMAKE_C_COMPILER_VERSION}"
    "-DFRANA_FLAGS=${flags}" -P ${CMAKE_SOURCE_DIR}/tools/cmake/version_write.cmake
  BYPRODUCTS ${CMAKE_BINARY_DIR}/generated/frana_version.h VERBATIM
  COMMENT "the version")
include_directories(${CMAKE_BINARY_DIR}/generated)
