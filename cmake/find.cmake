# Finds libraries on any system.
#
#   frana_find(NAME PC HEADER LIBRARY WHAT DEBIAN SOURCE [FUNCTION])
#                         sets FRANA_NAME to the target of a library: below NAME_ROOT if that variable is set (of CMake
#                         or the environment), else by pkg-config's module PC, else by header and library
#   frana_find_mpi()      CMake's FindMPI; sets FRANA_MPI to openmpi, mpich or nothing, and finds the launcher of that MPI
#   frana_find_hdf5()     a parallel HDF5 that was built with the same MPI: by pkg-config, else by CMake's FindHDF5
#   frana_find_lapacke()  LAPACKE in its own library, or in the one that CMake's FindLAPACK finds (OpenBLAS)
#   frana_find_end()      ends the configuration if anything is missing, with one paragraph for each
include(CheckCSourceCompiles)
find_package(PkgConfig QUIET)

set(frana_missing "")
# frana_find_lacks(WHAT WHY DEBIAN HINT): notes that a library is missing.
macro(frana_find_lacks what why debian hint)
  string(APPEND frana_missing "\n\n${what}: ${why}.\n    Debian: apt-get install ${debian}\n    elsewhere: ${hint}")
endmacro()

# frana_find_root(NAME): the value of NAME_ROOT, a CMake variable or else one of the environment, in frana_root.
macro(frana_find_root name)
  set(frana_root "")
  if(${name}_ROOT)
    set(frana_root "${${name}_ROOT}")
  elseif(DEFINED ENV{${name}_ROOT})
    set(frana_root "$ENV{${name}_ROOT}")
  endif()
endmacro()

# frana_find_pc(NAME MODULE): sets frana_target to pkg-config's target, or to nothing.
macro(frana_find_pc name module)
  set(frana_target "")
  if(PKG_CONFIG_FOUND)
    pkg_check_modules(FRANA_PC_${name} QUIET IMPORTED_TARGET "${module}")
    if(FRANA_PC_${name}_FOUND)
      set(frana_target PkgConfig::FRANA_PC_${name})
    endif()
  endif()
endmacro()

# frana_find_files(NAME HEADER LIBRARY): sets frana_target to a target of a header and a library, or to nothing.
macro(frana_find_files name header library)
  set(frana_target "")
  if(frana_root)
    set(where PATHS ${frana_root} NO_DEFAULT_PATH)
  else()
    set(where "")
  endif()
  find_path(FRANA_${name}_INCLUDE ${header} ${where} PATH_SUFFIXES include)
  find_library(FRANA_${name}_LIBRARY NAMES ${library} ${where} PATH_SUFFIXES lib lib64 lib/${CMAKE_LIBRARY_ARCHITECTURE})
  mark_as_advanced(FRANA_${name}_INCLUDE FRANA_${name}_LIBRARY)
  if(FRANA_${name}_INCLUDE AND FRANA_${name}_LIBRARY)
    set(frana_target frana_found_${name})
    if(NOT TARGET ${frana_target})
      add_library(${frana_target} INTERFACE IMPORTED)
      target_include_directories(${frana_target} INTERFACE ${FRANA_${name}_INCLUDE})
      target_link_libraries(${frana_target} INTERFACE ${FRANA_${name}_LIBRARY})
    endif()
  endif()
endmacro()

macro(frana_find name module header library what debian source)
  frana_find_root(${name})
  set(frana_target "")
  if(NOT frana_root)
    frana_find_pc(${name} "${module}")
  endif()
  if(NOT frana_target)
    frana_find_files(${name} ${header} ${library})
  endif()
  set(why "not found")
  if(frana_root)
    string(APPEND why " below ${name}_ROOT = ${frana_root}")
  endif()
  if(frana_target AND NOT "${ARGN}" STREQUAL "") # the version is seen by a function that older ones lack
    frana_find_links(FRANA_${name}_HAS_${ARGN} "#include <${header}>\nint main(void) { return !${ARGN}(); }"
      ${frana_target})
    if(NOT FRANA_${name}_HAS_${ARGN})
      set(frana_target "")
      set(why "found one that is too old")
    endif()
  endif()
  set(FRANA_${name} ${frana_target})
  if(NOT frana_target)
    frana_find_lacks("${what}" "${why}" ${debian} "-D${name}_ROOT=DIR, or its folder in CMAKE_PREFIX_PATH or \
PKG_CONFIG_PATH\n    its source: ${source}")
  endif()
endmacro()

# frana_find_links(RESULT PROGRAM LIBRARY...): whether a program compiles and links with the libraries. Kept in the
# cache under RESULT until the libraries change.
macro(frana_find_links result program)
  if(NOT "${${result}_WITH}" STREQUAL "${ARGN}")
    unset(${result} CACHE)
    set(${result}_WITH "${ARGN}" CACHE INTERNAL "")
  endif()
  set(CMAKE_REQUIRED_LIBRARIES ${ARGN})
  set(CMAKE_REQUIRED_QUIET ON)
  check_c_source_compiles("${program}" ${result})
  unset(CMAKE_REQUIRED_LIBRARIES)
  unset(CMAKE_REQUIRED_QUIET)
endmacro()

macro(frana_find_mpi)
  # the launcher beside the compiler's wrapper: mpiexec.mpich beside mpicc.mpich
  if(MPI_C_COMPILER AND NOT MPIEXEC_EXECUTABLE)
    get_filename_component(frana_wrapper ${MPI_C_COMPILER} NAME)
    find_program(frana_wrapper_path NAMES ${MPI_C_COMPILER})
    mark_as_advanced(frana_wrapper_path)
    get_filename_component(frana_wrapper_folder ${frana_wrapper_path} DIRECTORY)
    if(frana_wrapper MATCHES "^mpicc(.*)$")
      find_program(MPIEXEC_EXECUTABLE NAMES mpiexec${CMAKE_MATCH_1} mpirun${CMAKE_MATCH_1}
        PATHS ${frana_wrapper_folder} NO_DEFAULT_PATH)
    endif()
  endif()
  find_package(MPI QUIET COMPONENTS C)
  set(FRANA_MPI "")
  if(NOT MPI_C_FOUND)
    frana_find_lacks("MPI (Open MPI, MPICH or one of its kin)" "no C library found"
      "libopenmpi-dev openmpi-bin, or libmpich-dev mpich"
      "its mpicc in PATH, or -DMPI_C_COMPILER=/where/it/is/mpicc")
  else()
    frana_find_links(FRANA_MPI_IS_OPENMPI "#include <mpi.h>\n#ifndef OPEN_MPI\n#error\n#endif\nint main(void) { return 0; }"
      MPI::MPI_C)
    frana_find_links(FRANA_MPI_IS_MPICH "#include <mpi.h>\n#if !defined MPICH_VERSION && !defined I_MPI_VERSION\n#error\n\
#endif\nint main(void) { return 0; }" MPI::MPI_C)
    if(FRANA_MPI_IS_OPENMPI)
      set(FRANA_MPI openmpi)
    elseif(FRANA_MPI_IS_MPICH)
      set(FRANA_MPI mpich)
    endif()
  endif()
  # Which MPI the launcher belongs to: a rank that another MPI's launcher starts runs alone.
  set(FRANA_LAUNCHER "")
  if(MPIEXEC_EXECUTABLE AND NOT CMAKE_CROSSCOMPILING)
    execute_process(COMMAND ${MPIEXEC_EXECUTABLE} --version OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE code)
    if(said MATCHES "Open MPI|OpenRTE|prterun|PRRTE")
      set(FRANA_LAUNCHER openmpi)
    elseif(said MATCHES "HYDRA|Intel")
      set(FRANA_LAUNCHER mpich)
    endif()
  endif()
  if(FRANA_MPI AND FRANA_LAUNCHER AND NOT FRANA_MPI STREQUAL FRANA_LAUNCHER)
    frana_find_lacks("The launcher of MPI" "${MPIEXEC_EXECUTABLE} is of ${FRANA_LAUNCHER}, but the library is of \
${FRANA_MPI}: each rank would run alone" "openmpi-bin or mpich" "-DMPIEXEC_EXECUTABLE=/where/it/is/mpiexec, of the \
library's MPI")
  elseif(BUILD_TESTING AND MPI_C_FOUND AND NOT MPIEXEC_EXECUTABLE)
    frana_find_lacks("The launcher of MPI (the tests alone; not needed with -DBUILD_TESTING=OFF)" "no mpiexec found"
      "openmpi-bin or mpich" "-DMPIEXEC_EXECUTABLE=/where/it/is/mpiexec")
  endif()
endmacro()

# frana_find_try_hdf5(FROM TARGET): takes the HDF5 of a target if it is parallel and of the same MPI; else its reason is
# added to frana_tried.
function(frana_find_try_hdf5 from target)
  set(program ${CMAKE_BINARY_DIR}/CMakeFiles/frana_hdf5)
  file(WRITE ${program}.c "#include <mpi.h>\n#include <hdf5.h>\n"
    "int main(void) {\n#ifdef H5_HAVE_PARALLEL\n    return H5Pset_fapl_mpio(0, MPI_COMM_WORLD, MPI_INFO_NULL) < 0;\n"
    "#else\n    return frana_serial_hdf5();\n#endif\n}\n")
  try_compile(links ${CMAKE_BINARY_DIR}/CMakeFiles/frana_hdf5_try SOURCES ${program}.c
    LINK_LIBRARIES ${target} MPI::MPI_C OUTPUT_VARIABLE said COPY_FILE ${program} COPY_FILE_ERROR copied)
  set(why "")
  if(said MATCHES "frana_serial_hdf5")
    set(why "is serial")
  elseif(NOT links)
    file(WRITE ${program}.log "${said}")
    set(why "does not compile and link (${program}.log)")
  elseif(NOT CMAKE_CROSSCOMPILING) # two MPIs in one program
    execute_process(COMMAND ldd ${program} OUTPUT_VARIABLE libraries ERROR_QUIET)
    string(REGEX MATCHALL "lib(mpi|mpich)[.]so[.][0-9]+" mpis "${libraries}")
    list(REMOVE_DUPLICATES mpis)
    list(LENGTH mpis count)
    if(count GREATER 1)
      list(JOIN mpis " and " mpis)
      set(why "was built with another MPI (the program would load ${mpis})")
    endif()
  endif()
  if(why)
    set(frana_tried "${frana_tried}; that of ${from} ${why}" PARENT_SCOPE)
  else()
    set(FRANA_HDF5 ${target} PARENT_SCOPE)
    message(STATUS "HDF5: by ${from}")
  endif()
endfunction()

macro(frana_find_hdf5)
  set(FRANA_HDF5 "")
  set(frana_tried "")
  frana_find_root(HDF5)
  if(MPI_C_FOUND)
    if(NOT frana_root AND NOT HDF5_C_COMPILER_EXECUTABLE)
      foreach(module hdf5-${FRANA_MPI} hdf5-mpi hdf5)
        string(MAKE_C_IDENTIFIER ${module} key)
        if(NOT FRANA_HDF5)
          frana_find_pc(${key} ${module})
          if(frana_target)
            frana_find_try_hdf5("pkg-config ${module}" ${frana_target})
          endif()
        endif()
      endforeach()
    endif()
    if(NOT FRANA_HDF5 AND NOT CMAKE_CROSSCOMPILING)
      if(NOT frana_root AND FRANA_MPI)
        find_program(HDF5_C_COMPILER_EXECUTABLE NAMES h5pcc.${FRANA_MPI} h5pcc)
      endif()
      set(HDF5_PREFER_PARALLEL ON)
      find_package(HDF5 QUIET COMPONENTS C)
      if(HDF5_FOUND AND TARGET hdf5::hdf5)
        frana_find_try_hdf5("CMake's FindHDF5 (${HDF5_C_LIBRARIES})" hdf5::hdf5)
      endif()
    endif()
    if(NOT FRANA_HDF5)
      frana_find_lacks("HDF5 1.10 or later, parallel, built with the same MPI" "none found${frana_tried}"
        "libhdf5-openmpi-dev (with Open MPI) or libhdf5-mpich-dev (with MPICH)"
        "-DHDF5_ROOT=DIR, or -DHDF5_C_COMPILER_EXECUTABLE=/where/it/is/h5pcc, or a module that sets PKG_CONFIG_PATH\n\
    its source: https://www.hdfgroup.org, configured with HDF5_ENABLE_PARALLEL")
    endif()
  endif()
endmacro()

macro(frana_find_lapacke)
  set(FRANA_LAPACKE "")
  frana_find_root(LAPACKE)
  frana_find_files(LAPACKE lapacke.h "lapacke;openblas")
  set(program "#include <lapacke.h>
    int main(void) { double a = 1, w = 0; return LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'N', 'U', 1, &a, 1, &w); }")
  set(why "not found")
  if(frana_target)
    set(why "${FRANA_LAPACKE_LIBRARY} does not link")
    frana_find_links(FRANA_LAPACKE_ALONE "${program}" ${frana_target})
    if(FRANA_LAPACKE_ALONE)
      set(FRANA_LAPACKE ${frana_target})
    endif()
  elseif(FRANA_LAPACKE_INCLUDE)
    set(frana_target frana_found_LAPACKE)
    add_library(${frana_target} INTERFACE IMPORTED)
    target_include_directories(${frana_target} INTERFACE ${FRANA_LAPACKE_INCLUDE})
  endif()
  if(frana_target AND NOT FRANA_LAPACKE) # with a static LAPACKE, or one inside of LAPACK's library
    find_package(LAPACK QUIET)
    if(LAPACK_FOUND)
      frana_find_links(FRANA_LAPACKE_WITH_LAPACK "${program}" ${frana_target} LAPACK::LAPACK)
      if(FRANA_LAPACKE_WITH_LAPACK)
        set(FRANA_LAPACKE ${frana_target} LAPACK::LAPACK)
      endif()
    endif()
  endif()
  if(NOT FRANA_LAPACKE)
    frana_find_lacks("LAPACK with its C interface LAPACKE (lapacke.h)" "${why}" "liblapacke-dev libopenblas-serial-dev"
      "-DLAPACKE_ROOT=DIR, of LAPACK or OpenBLAS; for LAPACK itself what CMake's FindLAPACK takes, as BLA_VENDOR\n\
    its source: https://github.com/OpenMathLib/OpenBLAS, which holds both")
  endif()
endmacro()

macro(frana_find_end)
  if(frana_missing)
    message(FATAL_ERROR "These are needed and missing.${frana_missing}\n\nMore in docs/install.md. After a change of \
modules configure in an empty folder: cmake --fresh, or another -B.")
  endif()
endmacro()
