# Writes generated/frana_version.h. An unchanged header is not written, so that nothing is compiled again.
execute_process(COMMAND git -C ${FRANA_SOURCE} describe --always --dirty
  OUTPUT_VARIABLE FRANA_REVISION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT FRANA_REVISION)
  set(FRANA_REVISION "unknown")
endif()
configure_file(${FRANA_SOURCE}/tools/cmake/version.h.in ${FRANA_BINARY}/generated/frana_version.h @ONLY)
