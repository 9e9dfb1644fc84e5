#!/usr/bin/env bash
# Libraries that are missing are named all at once when frana is configured: with Debian's package and the variable that
# points to them. HDF5 of another MPI is passed over, and so is the launcher of another.
# usage: missing.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/program/common.sh" "$@"
said() { # WORDS...: the message has them on one line; CMake breaks lines only between words
  tr -s ' \n' ' ' <err >words
  grep -qF -- "$*" words || { cat err; fail "it does not say: $*"; }
}
mkdir empty
roots=()
for name in HDF5 LAPACKE FFTW YAML CAIRO TIFF ZLIB CMOCKA; do roots+=("-D${name}_ROOT=$PWD/empty"); done
code 1 cmake -S "$source" -B nothing "${roots[@]}"
for name in HDF5 LAPACKE FFTW YAML CAIRO TIFF ZLIB CMOCKA; do said "-D${name}_ROOT=DIR"; done
for package in libhdf5-openmpi-dev libhdf5-mpich-dev liblapacke-dev libfftw3-dev libyaml-dev \
  libcairo2-dev libtiff-dev zlib1g-dev libcmocka-dev; do
  said "$package"
done
code 1 cmake -S "$source" -B untested -DBUILD_TESTING=OFF -DYAML_ROOT="$PWD/empty"
said "libyaml 0.1 or 0.2 (reads scenes): not found below YAML_ROOT = $PWD/empty"
! grep -q cmocka err || { cat err; fail "cmocka is asked for without the tests"; }
has() { # COMMANDS...: all are installed; `command -v` of several is content with one
  local name
  for name in "$@"; do command -v "$name" >/dev/null || return 1; done
}
if has mpicc.openmpi mpicc.mpich h5pcc.openmpi h5pcc.mpich mpiexec.mpich; then # both MPIs of Debian
  code 1 cmake -S "$source" -B other -DMPI_C_COMPILER=mpicc.openmpi -DMPIEXEC_EXECUTABLE="$(command -v mpiexec.mpich)" \
    -DHDF5_C_COMPILER_EXECUTABLE="$(command -v h5pcc.mpich)"
  said "is of mpich, but the library is of openmpi"
  said "was built with another MPI (the program would load libmpi.so.40 and libmpich.so.12)"
fi
# without pkg-config
code 0 cmake -S "$source" -B without -DBUILD_TESTING=OFF -DPKG_CONFIG_EXECUTABLE="$PWD/empty/pkg-config"
echo ok
