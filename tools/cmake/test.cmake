# A TIMEOUT ends a test that hangs. It is many times what the test takes, so that a busy machine does not miss it; under
# the sanitizers ten times that: TIMEOUT 900${tenfold}.
set(tenfold "")
if(FRANA_SANITIZE)
  set(tenfold 0)
endif()

# Environment of tests on several ranks: tests/mpi.env. Threads that wait sleep, because there may be more of them than
# cores. frana_test_environment also for the sanitizers, because Open MPI leaks memory.
file(STRINGS ${CMAKE_SOURCE_DIR}/tests/mpi.env frana_mpi_environment REGEX "^[A-Z]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/mpi.env)
list(APPEND frana_mpi_environment OMP_WAIT_POLICY=passive)
set(frana_test_environment ${frana_mpi_environment} ASAN_OPTIONS=detect_leaks=0)

# frana_launch(N): sets frana_launch to the words that start N ranks; MPIEXEC_PREFLAGS are the user's, after mpiexec.
if(FRANA_LAUNCHER STREQUAL openmpi)
  set(frana_launch_options --allow-run-as-root --oversubscribe)
endif()
macro(frana_launch n)
  set(frana_launch ${MPIEXEC_EXECUTABLE} ${frana_launch_options} ${MPIEXEC_PREFLAGS} ${MPIEXEC_NUMPROC_FLAG} ${n})
endmacro()
# The scripts call mpiexec. Where that is another one, a folder ahead of PATH holds one that is the library's.
file(REMOVE_RECURSE ${CMAKE_BINARY_DIR}/tests/bin)
set(frana_test_path "")
if(NOT CMAKE_CROSSCOMPILING)
  execute_process(COMMAND sh -c "command -v mpiexec" OUTPUT_VARIABLE in_path OUTPUT_STRIP_TRAILING_WHITESPACE)
  get_filename_component(in_path "${in_path}" REALPATH)
  get_filename_component(ours "${MPIEXEC_EXECUTABLE}" REALPATH)
  if(NOT in_path STREQUAL ours)
    file(WRITE ${CMAKE_BINARY_DIR}/tests/bin/mpiexec "#!/bin/sh\nexec '${MPIEXEC_EXECUTABLE}' \"$@\"\n")
    file(CHMOD ${CMAKE_BINARY_DIR}/tests/bin/mpiexec
      PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    set(frana_test_path "set(ENV{PATH} \"${CMAKE_BINARY_DIR}/tests/bin:\$ENV{PATH}\")\n")
  endif()
endif()

# frana_wrap(TEST FUNCTION...): calls of these functions in the library come to the test's __wrap_FUNCTION. The linker
# does so with static libraries alone: with BUILD_SHARED_LIBS the test is built and does not run.
function(frana_wrap name)
  list(TRANSFORM ARGN PREPEND --wrap=)
  list(JOIN ARGN "," wrapped)
  target_link_options(${name} PRIVATE "LINKER:${wrapped}")
  if(BUILD_SHARED_LIBS)
    get_property(tests DIRECTORY PROPERTY TESTS)
    list(FILTER tests INCLUDE REGEX "^${name}(_[0-9])?$")
    if(tests)
      set_tests_properties(${tests} PROPERTIES DISABLED TRUE)
    endif()
  endif()
endfunction()

# Rooms whose tests on 1 and 2 ranks have the label smoke: a quick look at a build of another kind (tools/builds.sh).
# The target smoke builds them.
set(frana_smoke base files ibm)
add_custom_target(smoke DEPENDS frana test_base test_files test_ibm)
# What nightly tests alone need, and measurements: not in `all`. ./test.sh --nightly builds them.
add_custom_target(nightly)
function(frana_nightly)
  set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies(nightly ${ARGN})
endfunction()
# Tests spend their time in the library: to optimise their own code more than a little takes longer than it saves.
# gcc's -Og warns of what it does not see.
set(frana_test_options $<$<CONFIG:Release>:-Og> $<$<CONFIG:Debug>:-O0>
  $<$<C_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-clobbered>)

include(CheckCSourceCompiles)
# Other machines, for which tests compile kernels once more: plain loops; two lanes; four; eight, with AVX-512's
# instructions as loops. <frana_MACHINE_flags>
# Vectors as loops are many statements: -O3 takes minutes for them, -O1 twice as long as -Og, which sees less of what is
# initialised. One function serves all kinds of kernels (solid/force/segment.h).
set(frana_soon $<$<CONFIG:Release>:-Og> -DFRANA_KERNELS_ONCE $<$<C_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
set(frana_machines scalar)
set(frana_scalar_flags -DFRANA_SCALAR -Wno-psabi ${frana_soon})
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  list(APPEND frana_machines baseline avx2 avx512)
  set(frana_baseline_flags -march=x86-64 -Wno-psabi)
  set(frana_avx2_flags -march=x86-64-v3 -Wno-psabi)
  set(frana_avx512_flags -march=x86-64-v3 -Wno-psabi -include ${CMAKE_SOURCE_DIR}/tests/avx512.h ${frana_soon})
endif()
# By day the plain loops, and the widest vectors, in double precision, where this build's own kernels have not got them.
set(frana_machines_by_day scalar)
set(CMAKE_REQUIRED_FLAGS "${CMAKE_C_FLAGS}")
if(FRANA_ARCH)
  string(APPEND CMAKE_REQUIRED_FLAGS " -march=${FRANA_ARCH}")
endif()
check_c_source_compiles("#ifndef __AVX512F__\n#error narrower\n#endif\nint main(void) { return 0; }" FRANA_HAS_AVX512)
unset(CMAKE_REQUIRED_FLAGS)
if(NOT FRANA_HAS_AVX512)
  list(APPEND frana_machines_by_day avx512)
endif()

# frana_test(fluid/test_pressure.c ROOM fluid RANKS 1 2 3 4 [LABELS nightly] [TIMEOUT 900])
# A file of cmocka tests, with a main of its own. Its name is the file's path: fluid_test_pressure.
#
# All files of a room are linked to one program, build/tests/test_<room>, which runs the files that its arguments name,
# one after the other in one process. It goes on after a file that fails. ctest has
#     <room>_on_2           all files that run on two ranks
#     <room>_on_1           those that do not, and those that write what is compared with two ranks
#     <room>_on_1_long      those that compute for long, on two ranks at night (frana_long)
#     <room>_on_3           those that have no version for two
#     <room>_on_<n>_also    with the label nightly: the others on 1, 2 and 3
#     <room>_on_4, _on_5    all files, with the label nightly
#     <room>_on_1_thorough  (of a program of its own <name>_1_thorough)
#                           with the label nightly: the files that take some of their combinations by day (check_skips
#                           of tests/check.h) take all of them, with FRANA_THOROUGH in the environment; so do all _also
#     <name>_<n>            one file on n ranks, for whoever works on it, with the label single
# A file with the label nightly is in no group. A file whose functions are wrapped (frana_wrap), that counts what its
# process has done, or whose results other programs compare with (PROGRAM) is a program of its own; if it runs on 2
# ranks, it runs on more at night. The <name>_<n> of both have no label single.
function(frana_test source)
  cmake_parse_arguments(T "PROGRAM" "ROOM;TIMEOUT" "RANKS;LABELS" ${ARGN})
  string(REGEX REPLACE "^.*/(files|bench|study)/" "\\1/" name ${source}) # rooms that stand in another's folder
  string(REGEX REPLACE "[/.]" "_" name ${name})
  string(REGEX REPLACE "_c$" "" name ${name})
  if(NOT T_RANKS)
    set(T_RANKS 1)
  endif()
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 600)
  endif()
  file(STRINGS ${CMAKE_SOURCE_DIR}/tests/${source} skips REGEX "check_skips")
  if(T_PROGRAM)
    add_executable(${name} ${CMAKE_SOURCE_DIR}/tests/${source})
    target_link_libraries(${name} PRIVATE frana_${T_ROOM} ${FRANA_CMOCKA})
    target_compile_definitions(${name} PRIVATE ${frana_test_places})
    target_compile_options(${name} PRIVATE ${frana_test_options})
    set(command $<TARGET_FILE:${name}>)
    set(single "")
  else()
    set_property(GLOBAL APPEND PROPERTY frana_tests_of_${T_ROOM} ${name})
    set_property(GLOBAL PROPERTY frana_source_of_${name} ${CMAKE_SOURCE_DIR}/tests/${source})
    set(command $<TARGET_FILE:test_${T_ROOM}> ${name})
    set(single "")
    if(NOT "nightly" IN_LIST T_LABELS)
      set(single single)
      foreach(n ${T_RANKS})
        set_property(GLOBAL APPEND PROPERTY frana_tests_of_${T_ROOM}_on_${n} ${name})
      endforeach()
      file(STRINGS ${CMAKE_SOURCE_DIR}/tests/${source} compares REGEX "one_rank_expects|fopen.path, .rb.")
      if(compares)
        set_property(GLOBAL APPEND PROPERTY frana_tests_of_${T_ROOM}_compare ${name})
      endif()
      if(skips AND 1 IN_LIST T_RANKS)
        set_property(GLOBAL APPEND PROPERTY frana_tests_of_${T_ROOM}_skip ${name})
      endif()
    endif()
  endif()
  if(T_PROGRAM AND skips) # alone, because others read what it writes
    frana_test_on(${name}_1_thorough 1 "${T_ROOM};nightly" ${T_TIMEOUT} ${command})
    set_property(TEST ${name}_1_thorough APPEND PROPERTY ENVIRONMENT FRANA_THOROUGH=1)
    set_tests_properties(${name}_1_thorough PROPERTIES RUN_SERIAL TRUE)
  endif()
  foreach(n ${T_RANKS})
    set(labels ${T_ROOM} ${T_LABELS} ${single})
    if(T_PROGRAM AND n GREATER 2 AND 2 IN_LIST T_RANKS)
      list(APPEND labels nightly)
    endif()
    frana_test_on(${name}_${n} ${n} "${labels}" ${T_TIMEOUT} ${command})
  endforeach()
endfunction()

set(frana_test_places FRANA_SOURCE_DIR="${CMAKE_SOURCE_DIR}" FRANA_BINARY_DIR="${CMAKE_BINARY_DIR}")

# A test of ctest: the command on n ranks; on one rank without mpiexec.
function(frana_test_on name n labels timeout)
  if(CMAKE_CROSSCOMPILING) # one rank, in the emulator
    add_test(NAME ${name} COMMAND ${ARGN})
    set_tests_properties(${name} PROPERTIES TIMEOUT 3600 LABELS "${labels}")
    if(NOT n EQUAL 1)
      set_tests_properties(${name} PROPERTIES DISABLED TRUE)
    endif()
    return()
  endif()
  if(n EQUAL 1)
    add_test(NAME ${name} COMMAND ${ARGN})
  else()
    frana_launch(${n})
    add_test(NAME ${name} COMMAND ${frana_launch} ${ARGN})
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${timeout}${tenfold} LABELS "${labels}" PROCESSORS ${n}
    ENVIRONMENT "${frana_test_environment}")
  if(n GREATER 2) # first: once others run, so many processors are free at the end alone
    set_tests_properties(${name} PROPERTIES COST 100)
  endif()
endfunction()

# To be called once for each room, after all its frana_test: the room's program, and its tests of ctest.
function(frana_tests_of room)
  get_property(names GLOBAL PROPERTY frana_tests_of_${room})
  if(NOT names)
    return()
  endif()
  set(declarations "")
  set(entries "")
  set(sources "")
  foreach(name ${names})
    get_property(source GLOBAL PROPERTY frana_source_of_${name})
    list(APPEND sources ${source})
    string(APPEND declarations "int ${name}_main(int argc, char **argv);\n")
    string(APPEND entries "    {\"${name}\", ${name}_main},\n")
    set_source_files_properties(${source} PROPERTIES
      COMPILE_DEFINITIONS "main=${name}_main;par_begin=together_begin;par_end=together_end"
      COMPILE_OPTIONS "-Wno-missing-prototypes;${frana_test_options}")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${room}_tests.h CONTENT
    "${declarations}static const struct test all_tests[] = {\n${entries}};\n" @ONLY)
  add_executable(test_${room} ${CMAKE_SOURCE_DIR}/tests/together.c ${sources})
  target_compile_definitions(test_${room} PRIVATE ${frana_test_places} TESTS_OF_THE_ROOM="${room}_tests.h")
  target_include_directories(test_${room} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
  target_link_libraries(test_${room} PRIVATE frana_${room} ${FRANA_CMOCKA})
  get_property(compare GLOBAL PROPERTY frana_tests_of_${room}_compare)
  get_property(skip GLOBAL PROPERTY frana_tests_of_${room}_skip)
  foreach(n 1 2 3 4 5)
    get_property(on_${n} GLOBAL PROPERTY frana_tests_of_${room}_on_${n})
  endforeach()
  frana_without(short_on_1 "${on_1}" "${frana_long}")
  frana_without(twice "${compare}" "${frana_long}")
  frana_without(once "${short_on_1}" "${on_2}")
  frana_without(short_on_2 "${on_2}" "${frana_long}")
  frana_without(only_on_3 "${on_3}" "${on_2}")
  set(by_day_on_1 ${once} ${twice})
  list(REMOVE_DUPLICATES by_day_on_1)
  frana_without(also_on_1 "${short_on_1}" "${by_day_on_1}")
  frana_without(long_on_1 "${on_1}" "${short_on_1}")
  frana_without(also_on_2 "${on_2}" "${short_on_2}")
  frana_without(also_on_3 "${on_3}" "${only_on_3}")
  frana_together(${room} 1 "" "" ${by_day_on_1})
  frana_together(${room} 1 _long "" ${long_on_1})
  frana_together(${room} 1 _also nightly ${also_on_1})
  frana_together(${room} 1 _thorough nightly ${skip})
  frana_together(${room} 2 "" "" ${short_on_2})
  frana_together(${room} 2 _also nightly ${also_on_2})
  frana_together(${room} 3 "" "" ${only_on_3})
  frana_together(${room} 3 _also nightly ${also_on_3})
  frana_together(${room} 4 "" nightly ${on_4})
  frana_together(${room} 5 "" nightly ${on_5})
  if(room IN_LIST frana_smoke)
    foreach(n 1 2)
      if(TEST ${room}_on_${n})
        set_property(TEST ${room}_on_${n} APPEND PROPERTY LABELS smoke)
      endif()
    endforeach()
  endif()
endfunction()

# Sets `rest` to what is in `names` and not in `others`.
function(frana_without rest names others)
  if(names AND others)
    list(REMOVE_ITEM names ${others})
  endif()
  set(${rest} ${names} PARENT_SCOPE)
endfunction()

# By day on one rank, at night on two as well: these files compute for long, and two ranks that share cores with other
# tests take up to six times as long. Files that compare two ranks with one (one_rank.h, tests/*/test_*ranks.c), and
# the program's tests, show by day that ranks change nothing.
set(frana_long ibm_test_array ibm_test_planes ibm_test_couette ibm_test_feedback coupling_interface_test_inside
  coupling_medium_test_direction coupling_load_test_free_body coupling_load_test_inner_fluid fluid_test_channel
  fluid_momentum_test_diffusion cracks_test_pores solid_test_wave solid_test_damping solid_step_test_stable
  solid_force_test_sweep_soft solid_step_test_quasi_static solid_step_test_balance solid_step_test_relax
  coupling_control_test_settle fluid_momentum_test_stage coupling_interface_test_leaving coupling_control_test_watch
  coupling_control_test_watch_fluid coupling_load_test_reaction coupling_control_test_steady
  coupling_control_test_rollback coupling_medium_test_intrinsic coupling_test_state coupling_load_test_plug
  coupling_control_test_probe_energy solid_contact_test_implicit solid_force_test_dilatation
  solid_force_test_dilatation_known solid_geometry_test_compound solid_bonds_test_materials solid_bonds_test_interface
  solid_measure_test_intensity solid_measure_test_kirsch solid_test_fracture_energy meshless_arrange_test_arrange
  meshless_galerkin_test_crack)

# Some files compare with what they wrote on one rank.
function(frana_together room n suffix label)
  if(NOT ARGN)
    return()
  endif()
  set(name ${room}_on_${n}${suffix})
  set(labels ${room} ${label})
  frana_test_on(${name} ${n} "${labels}" 1200 $<TARGET_FILE:test_${room}> ${ARGN})
  if("nightly" IN_LIST labels)
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT FRANA_THOROUGH=1)
  endif()
  if(n EQUAL 1 AND suffix MATCHES "^(|_long)$")
    set_tests_properties(${name} PROPERTIES FIXTURES_SETUP results_of_${room})
  else()
    set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED results_of_${room})
  endif()
endfunction()
