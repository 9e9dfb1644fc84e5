# All libraries that frana uses, as one interface target. What is missing is reported at once, at the end, with Debian's
# name of its package and the variable that points to it (docs/install.md).
include(tools/cmake/find.cmake)

frana_find_mpi()
find_package(OpenMP COMPONENTS C) # optional: threads within a rank
frana_find_hdf5()
frana_find_lapacke()
frana_find(FFTW fftw3 fftw3.h fftw3 "FFTW 3 in double precision (the Poisson solver)" libfftw3-dev
  "https://www.fftw.org")
frana_find(YAML yaml-0.1 yaml.h yaml "libyaml 0.1 or 0.2 (reads scenes)" libyaml-dev "https://pyyaml.org/wiki/LibYAML")
frana_find(CAIRO cairo-svg>=1.16 cairo-svg.h cairo "cairo 1.16 with PNG, SVG and PDF (pictures of frana post)"
  libcairo2-dev "https://www.cairographics.org")
frana_find(TIFF libtiff-4>=4.5 tiffio.h tiff "libtiff 4.5 or later (images of voxels)" libtiff-dev
  "http://www.libtiff.org" TIFFOpenOptionsAlloc)
frana_find(ZLIB zlib zlib.h z "zlib 1.2 (images of voxels)" zlib1g-dev "https://zlib.net")
if(BUILD_TESTING)
  frana_find(CMOCKA cmocka cmocka.h cmocka "cmocka 1.1 (the tests alone; not needed with -DBUILD_TESTING=OFF)"
    libcmocka-dev "https://cmocka.org")
endif()
frana_find_end()

add_library(frana_dependencies INTERFACE)
target_link_libraries(frana_dependencies INTERFACE MPI::MPI_C ${FRANA_HDF5} ${FRANA_FFTW} ${FRANA_LAPACKE}
  ${FRANA_YAML} ${FRANA_CAIRO} ${FRANA_TIFF} ${FRANA_ZLIB} m)
