# A TIMEOUT ends a test that hangs. It is many times what the test takes, so that a busy machine does not miss it; under
# the sanitizers ten times that: TIMEOUT 900${tenfold}.
set(tenfold "")
if(FRANA_SANITIZE)
  set(tenfold 0)
endif()

# Environment of tests on several ranks, as Open MPI takes it; MPICH needs none.
# frana_test_environment also for the sanitizers, because Open MPI leaks memory.
# With pml=ob1 no drivers of networks are asked, one of which sleeps for 0.2 s at every start. When a rank has ended
# with another exit code than 0, mpiexec sleeps for the timeout before it kills the others; with 0 s it often fails
# in its own end. Threads that wait sleep, because there may be more of them than cores. hwloc's plugins, for GPUs and
# XML, are loaded at every start for nothing: a tenth of its time.
set(frana_mpi_environment
  OMPI_MCA_pml=ob1
  OMPI_MCA_odls_base_sigkill_timeout=1
  OMPI_MCA_rmaps_base_oversubscribe=1
  OMPI_MCA_hwloc_base_binding_policy=none
  OMPI_MCA_mpi_yield_when_idle=1
  OMP_WAIT_POLICY=passive
  HWLOC_PLUGINS_PATH=/none
  OMPI_ALLOW_RUN_AS_ROOT=1
  OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1)
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

# Rooms whose <room>_once_<n> have the label smoke: a quick look at a build of another kind (tools/builds.sh). The
# target smoke builds them; smoke_base builds those of base and files alone, the only rooms that call MPI and HDF5.
set(frana_smoke base files ibm)
add_custom_target(smoke DEPENDS frana test_base test_files test_ibm)
add_custom_target(smoke_base DEPENDS test_base test_files)
# What all <room>_once_<n> and the programs of single files need: neither kernels for other machines nor measurements.
add_custom_target(once DEPENDS frana)
# What nightly tests alone need, and measurements: not in `all`. ./test.sh --nightly builds them.
add_custom_target(nightly)
function(frana_nightly)
  set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies(nightly ${ARGN})
endfunction()
# Tests spend their time in the library; to optimise their own code takes longer than it saves.
set(frana_test_options $<$<CONFIG:Release>:-O1> $<$<CONFIG:Debug>:-O0>)

include(CheckCSourceCompiles)
# Other machines, for which tests compile kernels once more: plain loops; two lanes; four; eight, with AVX-512's
# instructions as loops. <frana_MACHINE_flags>
set(frana_machines scalar)
set(frana_scalar_flags -DFRANA_SCALAR -Wno-psabi $<$<CONFIG:Release>:-O1>) # half the time of -O3
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  list(APPEND frana_machines baseline avx2 avx512)
  set(frana_baseline_flags -march=x86-64 -Wno-psabi)
  set(frana_avx2_flags -march=x86-64-v3 -Wno-psabi)
  set(frana_avx512_flags -march=x86-64-v3 -Wno-psabi -include ${CMAKE_SOURCE_DIR}/tests/avx512.h
    $<$<CONFIG:Release>:-O1>) # -O3 unrolls the loops for a minute
endif()
# By day the plain loops, and the widest vectors where this build's own kernels have not got them.
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
#     <room>_on_<n>         all files of the room that run on n ranks: one start of MPI. On 1 and 2 ranks, and on 3
#                           those that have no version for 2. On 2 with the label sanitized: .ci/run has the same files
#                           on two ranks under the sanitizers; the others are in <room>_on_2_long
#     <room>_on_<n>_also    with the label nightly: on 2 those that compute a number for long, the others on 3
#     <room>_on_4           all files, with the label nightly
#     <room>_on_1_thorough  (of a program of its own <name>_1_thorough)
#                           with the label nightly: the files that take some of their combinations by day (check_skips
#                           of tests/check.h) take all of them, with FRANA_THOROUGH in the environment; so do all _also
#     <room>_once_<n>       each file once, on 2 ranks or on 1, but for those that compute for long: for the build with
#                           the sanitizers and for builds of other kinds, with the label single
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
    add_dependencies(once ${name})
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
      if(NOT 2 IN_LIST T_RANKS)
        set_property(GLOBAL APPEND PROPERTY frana_tests_of_${T_ROOM}_not_on_2 ${name})
      endif()
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
  add_dependencies(once test_${room})
  foreach(n 1 2 3 4 5)
    get_property(on GLOBAL PROPERTY frana_tests_of_${room}_on_${n})
    if(n EQUAL 3) # odd divisions: those that have no version for 2 are looked at always, the others at night
      get_property(never GLOBAL PROPERTY frana_tests_of_${room}_not_on_2)
      set(always ${on})
      foreach(name ${on})
        if(NOT name IN_LIST never)
          list(REMOVE_ITEM always ${name})
        endif()
      endforeach()
      frana_together(${room} 3 "" "" ${always})
      list(REMOVE_ITEM on ${always})
      frana_together(${room} 3 _also nightly ${on})
    elseif(n EQUAL 2)
      set(numbers "")
      foreach(name ${on})
        if(name IN_LIST frana_numbers)
          list(APPEND numbers ${name})
        endif()
      endforeach()
      list(REMOVE_ITEM on ${frana_numbers})
      set(long ${on})
      list(REMOVE_ITEM on ${frana_long})
      if(on)
        list(REMOVE_ITEM long ${on})
      endif()
      frana_together(${room} 2 "" sanitized ${on})
      frana_together(${room} 2 _long "" ${long})
      frana_together(${room} 2 _also nightly ${numbers})
      frana_once(${room} 2 ${on})
    elseif(n EQUAL 1)
      frana_together(${room} 1 "" "" ${on})
      get_property(skip GLOBAL PROPERTY frana_tests_of_${room}_skip)
      frana_together(${room} 1 _thorough nightly ${skip})
      get_property(on_2 GLOBAL PROPERTY frana_tests_of_${room}_on_2)
      get_property(first GLOBAL PROPERTY frana_tests_of_${room}_compare)
      if(on_2)
        list(REMOVE_ITEM on ${on_2})
      endif()
      if(first)
        list(REMOVE_ITEM on ${first})
        list(REMOVE_ITEM first ${frana_long})
      endif()
      list(REMOVE_ITEM on ${frana_long})
      frana_once(${room} 1 ${on})
      frana_once(${room}_first 1 ${first})
    elseif(n GREATER 3)
      frana_together(${room} ${n} "" nightly ${on})
    endif()
  endforeach()
endfunction()

# These files compute a number for long, the same on two ranks; shorter files compare one rank with two.
set(frana_numbers ibm_test_array ibm_test_planes ibm_test_couette ibm_test_feedback coupling_interface_test_inside
  coupling_medium_test_direction coupling_load_test_free_body coupling_load_test_inner_fluid fluid_test_channel
  fluid_momentum_test_diffusion cracks_test_pores solid_test_wave solid_test_damping solid_step_test_stable
  solid_force_test_sweep_soft solid_step_test_quasi_static solid_step_test_balance coupling_control_test_settle)
# These compute for long. Others cover their code as well, and `./test.sh --sanitize` has them.
set(frana_long ${frana_numbers} postproc_data_test_plate postproc_test_post coupling_control_test_steady
  coupling_control_test_rollback coupling_load_test_plug fluid_test_ranks meshless_galerkin_test_bend)

# <room>_first: files that compare, on two ranks, with what they write on one
function(frana_once group n)
  if(NOT ARGN)
    return()
  endif()
  string(REPLACE "_first" "" room ${group})
  set(labels ${room} single)
  if(room IN_LIST frana_smoke)
    list(APPEND labels smoke)
  endif()
  frana_test_on(${group}_once_${n} ${n} "${labels}" 1200 $<TARGET_FILE:test_${room}> ${ARGN})
  if(n EQUAL 2) # longest: first
    set_tests_properties(${room}_once_2 PROPERTIES FIXTURES_REQUIRED first_results_of_${room} COST 50)
  elseif(NOT group STREQUAL room)
    set_tests_properties(${group}_once_1 PROPERTIES FIXTURES_SETUP first_results_of_${room})
  endif()
endfunction()

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
  if(n EQUAL 1 AND NOT suffix)
    set_tests_properties(${name} PROPERTIES FIXTURES_SETUP results_of_${room})
  else()
    set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED results_of_${room})
  endif()
endfunction()
