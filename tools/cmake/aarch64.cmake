# Cross build for aarch64 from Debian on another processor, as in tools/aarch64.sh: -DFRANA_SYSROOT=..., an arm64 root
# with the unpacked packages of tools/setup.sh. Tests of one rank run under qemu.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES FRANA_SYSROOT)
set(CMAKE_SYSROOT ${FRANA_SYSROOT})
set(CMAKE_FIND_ROOT_PATH ${FRANA_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(libraries ${FRANA_SYSROOT}/usr/lib/aarch64-linux-gnu)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${FRANA_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR} ${libraries}/pkgconfig:${FRANA_SYSROOT}/usr/share/pkgconfig)
set(MPI_C_COMPILER NOTFOUND CACHE STRING "")
set(MPI_C_HEADER_DIR ${libraries}/openmpi/include CACHE PATH "")
set(MPI_C_LIB_NAMES mpi CACHE STRING "")
set(MPI_mpi_LIBRARY ${libraries}/openmpi/lib/libmpi.so CACHE FILEPATH "")
set(MPIEXEC_EXECUTABLE mpiexec CACHE FILEPATH "")
set(CMAKE_EXE_LINKER_FLAGS_INIT
  "-Wl,--allow-shlib-undefined -Wl,-rpath-link,${libraries} -Wl,-rpath-link,${libraries}/openmpi/lib")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L ${FRANA_SYSROOT}
  -E LD_LIBRARY_PATH=/usr/lib/aarch64-linux-gnu/openmpi/lib -E OPAL_PREFIX=/usr
  -E OMPI_MCA_ess_singleton_isolated=1 -E OMPI_MCA_pmix=isolated -E OMPI_MCA_btl=self)
