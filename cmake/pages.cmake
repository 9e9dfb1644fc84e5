# What the program knows of the sources. generated/frana_cases.h: where the cases are, for `frana init`.
# docs/scene.md as an array of bytes, generated/frana_scene_page.h: `frana schema` and `frana keys` take the sentences on
# the keys from its tables.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/scene.md)
file(READ ${CMAKE_SOURCE_DIR}/docs/scene.md page HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," page "${page}")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/frana_scene_page.h CONTENT
  "#pragma once\nstatic const char frana_scene_page[] = {@page@0};\n" @ONLY)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/frana_cases.h CONTENT
  "#pragma once\n#define FRANA_CASES \"@CMAKE_SOURCE_DIR@/cases\"\n" @ONLY)
