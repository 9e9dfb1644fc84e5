# cmake --install and CPack: the program, manual pages made from its --help, completion, scenes and documentation. All
# places are relative to the prefix, and the program finds its data from its own place, so the tree can be moved.
include(GNUInstallDirs)
if(NOT DEFINED CMAKE_INSTALL_RPATH_USE_LINK_PATH)
  set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON) # libraries of modules are found without the module
endif()
set_target_properties(frana PROPERTIES INSTALL_RPATH_USE_LINK_PATH ${CMAKE_INSTALL_RPATH_USE_LINK_PATH})
install(TARGETS frana RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH up /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR}/frana)
  set_target_properties(frana PROPERTIES INSTALL_RPATH "$ORIGIN/${up}")
  get_property(rooms GLOBAL PROPERTY frana_rooms)
  set_target_properties(${rooms} PROPERTIES INSTALL_RPATH "$ORIGIN"
    INSTALL_RPATH_USE_LINK_PATH ${CMAKE_INSTALL_RPATH_USE_LINK_PATH})
  install(TARGETS ${rooms} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/frana)
endif()

# The manual pages are written when they are installed, by the program that is installed.
if(NOT CMAKE_CROSSCOMPILING)
  install(CODE "
    execute_process(COMMAND \"${CMAKE_SOURCE_DIR}/tools/man.sh\" \"$<TARGET_FILE:frana>\" \"${CMAKE_BINARY_DIR}/man\"
      RESULT_VARIABLE code ERROR_VARIABLE said)
    if(code)
      message(WARNING \"no manual pages: frana --help does not run here: \${said}\")
    endif()")
  install(DIRECTORY ${CMAKE_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
endif()
if(EXISTS ${CMAKE_SOURCE_DIR}/tools/completion/frana.bash)
  install(FILES tools/completion/frana.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
    RENAME frana)
endif()

# All scenes with their sources and references, as in cases/; and those of `frana init` under the names it uses.
install(DIRECTORY cases/ DESTINATION ${CMAKE_INSTALL_DATADIR}/frana/cases FILES_MATCHING
  PATTERN "*.yaml" PATTERN "*.md" PATTERN "*.csv" PATTERN "*.sh" PATTERN "*.awk" PATTERN "results" EXCLUDE)
if(EXISTS ${CMAKE_SOURCE_DIR}/program/init.c)
  file(STRINGS program/init.c lines REGEX "{\"[a-z_0-9]+\", \"[a-z_0-9/]+[.]yaml\"}")
  foreach(line ${lines})
    string(REGEX MATCH "{\"([a-z_0-9]+)\", \"([a-z_0-9/]+[.]yaml)\"}" scene "${line}")
    install(FILES cases/${CMAKE_MATCH_2} DESTINATION ${CMAKE_INSTALL_DATADIR}/frana/examples
      RENAME ${CMAKE_MATCH_1}.yaml)
  endforeach()
endif()
# Module files for Environment Modules (Tcl) and Lmod (Lua, which it prefers). They find the tree from their own place.
set(modules tools/packaging/modulefiles)
install(FILES ${modules}/frana.tcl DESTINATION ${CMAKE_INSTALL_DATADIR}/modulefiles/frana RENAME ${PROJECT_VERSION})
install(FILES ${modules}/frana.lua DESTINATION ${CMAKE_INSTALL_DATADIR}/modulefiles/frana RENAME ${PROJECT_VERSION}.lua)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_PACKAGE_NAME frana)
set(CPACK_PACKAGE_VENDOR "the frana authors")
set(CPACK_PACKAGE_CONTACT "the frana authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "fracture of solids in a flow, by peridynamics and direct simulation")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR TGZ)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(FRANA_MPI STREQUAL mpich)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS mpich)
else()
  set(CPACK_DEBIAN_PACKAGE_DEPENDS openmpi-bin)
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS gnuplot-nox)
if(BUILD_SHARED_LIBS)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR})
endif()
include(CPack)
