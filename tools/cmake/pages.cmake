# What the program knows of its sources. generated/frana_cases.h: where the cases are, for `frana init`.
# generated/frana_scene_page.h: docs/scene.md as an array of bytes, because `frana schema`, `frana keys` and
# `frana init` take the sentences on the keys from its tables.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/docs/scene.md)
file(READ ${CMAKE_SOURCE_DIR}/docs/scene.md page HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," page "${page}")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/frana_scene_page.h CONTENT
  "#pragma once\nstatic const unsigned char frana_scene_page[] = {@page@0};\n" @ONLY)
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/frana_cases.h CONTENT
  "#pragma once\n#define FRANA_CASES \"@CMAKE_SOURCE_DIR@/cases\"\n" @ONLY)
