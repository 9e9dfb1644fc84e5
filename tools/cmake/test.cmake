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
# in its own end. Threads that wait sleep, because there may be more of them than cores.
set(frana_mpi_environment
  OMPI_MCA_pml=ob1
  OMPI_MCA_odls_base_sigkill_timeout=1
  OMPI_MCA_rmaps_base_oversubscribe=1
  OMPI_MCA_hwloc_base_binding_policy=none
  OMPI_MCA_mpi_yield_when_idle=1
  OMP_WAIT_POLICY=passive
  OMPI_ALLOW_RUN_AS_ROOT=1
  OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1)
set(frana_test_environment ${frana_mpi_environment} ASAN_OPTIONS=detect_leaks=0)
# A process that runs alone starts in a third of the time without mpiexec and without Open MPI's daemon. All such
# processes have the same job number, so they must not make a folder for the job. Not for a process that starts mpiexec.
set(frana_alone_environment ${frana_test_environment} OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_pmix=isolated
  OMPI_MCA_orte_create_session_dirs=0)

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

# Tests with the label smoke, on one and two ranks: a quick look at a build of another kind (tools/builds.sh).
# The target smoke builds them.
set(frana_smoke base_test_signals base_test_par base_test_par_exchange base_test_par_ghost base_test_par_column
  base_test_par_pencil base_test_par_shared files_test_h5 files_test_store files_test_seal scene_test_scene
  fluid_poisson_test_poisson solid_contact_test_contact meshless_galerkin_test_elastic ibm_test_forcing
  coupling_test_step)
add_custom_target(smoke DEPENDS frana ${frana_smoke})

# Other machines, for which tests compile kernels once more: plain loops; two lanes; four; eight, with AVX-512's
# instructions as loops. <frana_MACHINE_flags>
set(frana_machines scalar)
set(frana_scalar_flags -DFRANA_SCALAR -Wno-psabi)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  list(APPEND frana_machines baseline avx2 avx512)
  set(frana_baseline_flags -march=x86-64 -Wno-psabi)
  set(frana_avx2_flags -march=x86-64-v3 -Wno-psabi)
  set(frana_avx512_flags -march=x86-64-v3 -Wno-psabi -include ${CMAKE_SOURCE_DIR}/tests/avx512.h)
endif()

# frana_test(fluid/test_pressure.c ROOM fluid RANKS 1 2 3 4 [LABELS nightly] [TIMEOUT 900])
# One executable of cmocka tests, run by ctest once for each number of ranks; on one rank without mpiexec.
function(frana_test source)
  cmake_parse_arguments(T "" "ROOM;TIMEOUT" "RANKS;LABELS" ${ARGN})
  string(REGEX REPLACE "^.*/(files|bench|study)/" "\\1/" name ${source}) # rooms that stand in another's folder
  string(REGEX REPLACE "[/.]" "_" name ${name})
  string(REGEX REPLACE "_c$" "" name ${name})
  add_executable(${name} ${CMAKE_SOURCE_DIR}/tests/${source})
  target_link_libraries(${name} PRIVATE frana_${T_ROOM} ${FRANA_CMOCKA})
  target_compile_definitions(${name} PRIVATE
    FRANA_SOURCE_DIR="${CMAKE_SOURCE_DIR}" FRANA_BINARY_DIR="${CMAKE_BINARY_DIR}")
  if(NOT T_RANKS)
    set(T_RANKS 1)
  endif()
  if(CMAKE_CROSSCOMPILING) # one rank, in the emulator
    foreach(n ${T_RANKS})
      add_test(NAME ${name}_${n} COMMAND ${name})
      set_tests_properties(${name}_${n} PROPERTIES TIMEOUT 3600 LABELS "${T_ROOM};${T_LABELS}")
      if(NOT n EQUAL 1)
        set_tests_properties(${name}_${n} PROPERTIES DISABLED TRUE)
      endif()
    endforeach()
    return()
  endif()
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 600)
  endif()
  foreach(n ${T_RANKS})
    if(n EQUAL 1)
      add_test(NAME ${name}_${n} COMMAND ${name})
      set(environment ${frana_alone_environment})
    else()
      frana_launch(${n})
      add_test(NAME ${name}_${n} COMMAND ${frana_launch} $<TARGET_FILE:${name}>)
      set(environment ${frana_test_environment})
    endif()
    set(labels ${T_ROOM} ${T_LABELS})
    if(name IN_LIST frana_smoke AND n LESS 3)
      list(APPEND labels smoke)
    endif()
    set_tests_properties(${name}_${n} PROPERTIES TIMEOUT ${T_TIMEOUT}${tenfold} LABELS "${labels}"
      PROCESSORS ${n} ENVIRONMENT "${environment}")
  endforeach()
endfunction()
