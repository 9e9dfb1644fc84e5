# Tests of the run folder's files.
frana_test(base/test_vtkhdf.c ROOM base RANKS 1 2 3 4)

set(files_environment "OMPI_MCA_rmaps_base_oversubscribe=1;OMPI_MCA_hwloc_base_binding_policy=none;OMPI_MCA_mpi_yield_when_idle=1;OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;ASAN_OPTIONS=detect_leaks=0")

# A real VTK reader looks at what three ranks wrote. Debian's own Python has VTK's modules.
find_program(FRANA_VTK_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH)
add_executable(base_test_vtkhdf_sample ${CMAKE_SOURCE_DIR}/tests/base/test_vtkhdf_sample.c)
target_link_libraries(base_test_vtkhdf_sample PRIVATE frana_base)
add_test(NAME base_vtk_writes COMMAND ${MPIEXEC_EXECUTABLE} --allow-run-as-root --oversubscribe -n 3
  $<TARGET_FILE:base_test_vtkhdf_sample> ${CMAKE_BINARY_DIR}/files/vtk_sample)
add_test(NAME base_vtk_reads COMMAND ${FRANA_VTK_PYTHON} ${CMAKE_SOURCE_DIR}/tests/base/vtk_reads.py
  ${CMAKE_BINARY_DIR}/files/vtk_sample)
set_tests_properties(base_vtk_writes PROPERTIES FIXTURES_SETUP vtk_sample PROCESSORS 3 TIMEOUT 60${tenfold} LABELS base
  ENVIRONMENT "${files_environment}")
set_tests_properties(base_vtk_reads PROPERTIES FIXTURES_REQUIRED vtk_sample TIMEOUT 60${tenfold} LABELS base)

frana_test(base/test_store.c ROOM base RANKS 1 2 3 4)
frana_test(base/test_seal.c ROOM base RANKS 1 2 3)
frana_test(base/test_table.c ROOM base RANKS 1 3)
frana_test(base/test_folder.c ROOM base RANKS 1 3)
frana_test(base/test_folder_hold.c ROOM base RANKS 1 3)
target_link_options(base_test_folder_hold PRIVATE LINKER:--wrap=die_all,--wrap=fcntl)
frana_test(base/test_log.c ROOM base RANKS 1 2)
frana_test(base/test_signals.c ROOM base RANKS 1 2 3 4)

# A disk that says no: exit code 4, and nothing finished is harmed.
foreach(program test_store_full test_table_full)
  add_executable(base_${program} ${CMAKE_SOURCE_DIR}/tests/base/${program}.c)
  target_link_libraries(base_${program} PRIVATE frana_base)
endforeach()
set(files_launch_1) # by itself
set(files_launch_3 ${MPIEXEC_EXECUTABLE} --allow-run-as-root --oversubscribe -n 3)
foreach(n 1 3)
  add_test(NAME base_disk_full_${n} COMMAND ${FRANA_VTK_PYTHON} ${CMAKE_SOURCE_DIR}/tests/base/disk_full.py
    $<TARGET_FILE:base_test_store_full> $<TARGET_FILE:base_test_table_full> ${CMAKE_BINARY_DIR}/files/disk_full_${n} ${files_launch_${n}})
  set_tests_properties(base_disk_full_${n} PROPERTIES PROCESSORS ${n} TIMEOUT 120${tenfold} LABELS base
    ENVIRONMENT "${files_environment}")
endforeach()
