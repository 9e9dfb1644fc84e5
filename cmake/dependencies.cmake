# All libraries that frana uses, as one interface target.
find_package(MPI REQUIRED COMPONENTS C)
find_package(OpenMP COMPONENTS C)
find_package(PkgConfig REQUIRED)
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-openmpi)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)
pkg_check_modules(LAPACKE REQUIRED IMPORTED_TARGET lapacke)
pkg_check_modules(CYAML REQUIRED IMPORTED_TARGET libcyaml)
pkg_check_modules(YAML REQUIRED IMPORTED_TARGET yaml-0.1)
pkg_check_modules(CMOCKA REQUIRED IMPORTED_TARGET cmocka)
pkg_check_modules(PNG REQUIRED IMPORTED_TARGET libpng)
pkg_check_modules(TIFF REQUIRED IMPORTED_TARGET libtiff-4>=4.5)
pkg_check_modules(ZLIB REQUIRED IMPORTED_TARGET zlib)

add_library(frana_dependencies INTERFACE)
target_link_libraries(frana_dependencies INTERFACE MPI::MPI_C PkgConfig::HDF5 PkgConfig::FFTW PkgConfig::LAPACKE
  PkgConfig::CYAML PkgConfig::YAML PkgConfig::PNG PkgConfig::TIFF PkgConfig::ZLIB m)
